#pragma once

#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/io/pacs.h"

// A real DICOM server on the loopback.
namespace lacuna::test {

/// A listening socket on a free port of the loopback.
class Listener {
public:
    Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(socket_, 8) != 0 ||
            ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
            throw std::runtime_error("no free port");
        port_ = ntohs(address.sin_port);
    }
    ~Listener() {
        if (socket_ >= 0) ::close(socket_);
    }
    int port() const { return port_; }
    int accept() const { return ::accept(socket_, nullptr, nullptr); }
    /// Wakes who waits in accept() and takes no more; the socket stays this one's until nobody can wait for it.
    void stop() const { ::shutdown(socket_, SHUT_RDWR); }

private:
    int socket_, port_ = 0;
};

inline int free_port() { return Listener().port(); }

inline PacsServer server_at(int port, const char* title = "PEER") {
    PacsServer server;
    server.host = "127.0.0.1";
    server.port = port;
    server.called_aet = title;
    server.timeout_s = 20;
    return server;
}

/// Debian's Orthanc on the loopback with a folder of its own; stopped at the end of the scope.
class Orthanc {
public:
    /// @param more  of its settings, each with a comma before it
    explicit Orthanc(const std::filesystem::path& folder, const std::string& more = "") : port_(free_port()) {
        const int http = free_port();
        std::ofstream(folder / "orthanc.json") << std::string(
            "{\"Name\":\"test\",\"StorageDirectory\":\"" + (folder / "db").string() + "\",\"IndexDirectory\":\"" +
            (folder / "db").string() + "\",\"DicomAet\":\"ORTHANC\",\"DicomPort\":" + std::to_string(port_) +
            ",\"HttpPort\":" + std::to_string(http) +
            ",\"HttpServerEnabled\":false,\"RemoteAccessAllowed\":false,\"DicomAlwaysAllowEcho\":true,"
            "\"DicomAlwaysAllowStore\":true,\"DicomAlwaysAllowFind\":true,\"DicomAlwaysAllowGet\":true,"
            "\"DicomAlwaysAllowMove\":true,"
            "\"DicomCheckCalledAet\":true,\"Plugins\":[]" +
            more + "}");
        const std::string config = (folder / "orthanc.json").string(), log = (folder / "log.txt").string();
        process_ = ::fork();
        if (process_ == 0) {
            (void)!::freopen(log.c_str(), "w", stdout);
            (void)!::freopen(log.c_str(), "w", stderr);
            ::execlp("Orthanc", "Orthanc", config.c_str(), nullptr);
            ::execl("/usr/sbin/Orthanc", "Orthanc", config.c_str(), nullptr);
            ::_exit(127);
        }
    }
    ~Orthanc() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);  // its folder goes with it
        ::waitpid(process_, nullptr, 0);
    }
    /// False: it does not run here.
    bool wait(const PacsServer& server) {
        for (int i = 0; i < 300; ++i) {
            int status = 0;
            if (::waitpid(process_, &status, WNOHANG) == process_) {
                process_ = 0;
                return false;
            }
            try {
                pacs_echo(server);
                return true;
            } catch (const Error&) {
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
            }
        }
        return false;
    }
    int port() const { return port_; }

private:
    int port_;
    pid_t process_ = -1;
};

inline bool orthanc_is_there() {
    return std::system("command -v Orthanc >/dev/null 2>&1 || test -x /usr/sbin/Orthanc") == 0;
}

/// Makes cert.pem with key.pem, and other.pem with other_key.pem; false: the openssl program is not installed.
inline bool make_certificates(const std::filesystem::path& folder) {
    const auto make = [&](const std::string& key, const std::string& certificate, const std::string& name) {
        const std::string call = "cd " + folder.string() + " && openssl req -x509 -newkey rsa:2048 -nodes -keyout " +
                                 key + " -out " + certificate + " -days 2 -subj /CN=" + name + " >/dev/null 2>&1";
        return std::system(call.c_str()) == 0;
    };
    return make("key.pem", "cert.pem", "localhost") && make("other_key.pem", "other.pem", "other");
}

/// Orthanc's settings for TLS with cert.pem, which it also trusts.
inline std::string orthanc_tls(const std::filesystem::path& folder) {
    const std::string base = folder.string();
    return ",\"DicomTlsEnabled\":true,\"DicomTlsCertificate\":\"" + base + "/cert.pem\",\"DicomTlsPrivateKey\":\"" +
           base + "/key.pem\",\"DicomTlsTrustedCertificates\":\"" + base + "/cert.pem\"";
}

}  // namespace lacuna::test
