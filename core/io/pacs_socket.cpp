#include "core/io/pacs_socket.h"

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <fcntl.h>
#include <openssl/err.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/base/error.h"

namespace lacuna::dicom {

namespace {

/// What both layers do with a socket, before it becomes a connection.
struct OnSocket {
    std::shared_ptr<SocketWatch> watch;
    std::function<void()> on_connection;
    void operator()(int socket) const {
        watch->watch(socket);
        if (on_connection) on_connection();
    }
};

/// In the clear, although DcmSCU and DcmSCP call every layer of one's own secure.
class WatchedLayer final : public DcmTransportLayer {
public:
    explicit WatchedLayer(OnSocket on_socket) : on_socket_(std::move(on_socket)) {}
    DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool) override {
        on_socket_(socket);
        return DcmTransportLayer::createConnection(socket, OFFalse);
    }

private:
    OnSocket on_socket_;
};

class WatchedTlsLayer final : public DcmTLSTransportLayer {
public:
    WatchedTlsLayer(T_ASC_NetworkRole as, OnSocket on_socket)
        : DcmTLSTransportLayer(as, nullptr, OFTrue), on_socket_(std::move(on_socket)) {}
    DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool secure) override {
        on_socket_(socket);
        return DcmTLSTransportLayer::createConnection(socket, secure);
    }

private:
    OnSocket on_socket_;
};

void need(const OFCondition& done, const std::string& fault) {
    if (done.bad()) throw Error(Errc::bad_usage, fault);
}

void show_certificate(DcmTLSTransportLayer& layer, const PacsTls& tls) {
    need(layer.setPrivateKeyFile(tls.key.c_str(), DCF_Filetype_PEM),
         "Cannot read a private key from " + tls.key.string() + "; it must be a PEM file without a password.");
    need(layer.setCertificateFile(tls.certificate.c_str(), DCF_Filetype_PEM),
         "Cannot read a certificate from " + tls.certificate.string() + "; it must be a PEM file.");
    if (!layer.checkPrivateKeyMatchesCertificate())
        throw Error(Errc::bad_usage, "The private key " + tls.key.string() + " does not belong to the certificate.");
}

}  // namespace

SocketWatch::~SocketWatch() {
    if (copy_ >= 0) ::close(copy_);
}

void SocketWatch::watch(int socket) {
    const std::lock_guard lock(mutex_);
    if (copy_ >= 0) ::close(copy_);
    copy_ = ::fcntl(socket, F_DUPFD_CLOEXEC, 0);
    if (down_) ::shutdown(copy_, SHUT_RDWR);
}

void SocketWatch::shut_down() {
    const std::lock_guard lock(mutex_);
    down_ = true;
    if (copy_ >= 0) ::shutdown(copy_, SHUT_RDWR);
}

std::unique_ptr<DcmTransportLayer> make_transport(const PacsTls& tls, bool accepts, std::shared_ptr<SocketWatch> watch,
                                                  std::function<void()> on_connection) {
    OnSocket on_socket{std::move(watch), std::move(on_connection)};
    if (!tls.on) return std::make_unique<WatchedLayer>(std::move(on_socket));
    auto layer = std::make_unique<WatchedTlsLayer>(accepts ? NET_ACCEPTOR : NET_REQUESTOR, std::move(on_socket));
    need(layer->setTLSProfile(TSP_Profile_BCP195_ND),
         "This system's TLS library does not offer the ciphers of BCP 195.");
    need(layer->activateCipherSuites(), "This system's TLS library does not offer the ciphers of BCP 195.");
    if (tls.trusted.empty())
        throw Error(Errc::bad_usage, "A secure connection needs the certificates to trust; name their PEM file.");
    need(layer->addTrustedCertificateFile(tls.trusted.c_str(), DCF_Filetype_PEM),
         "Cannot read trusted certificates from " + tls.trusted.string() + "; it must be a PEM file.");
    if (!tls.certificate.empty()) show_certificate(*layer, tls);
    if (accepts && tls.certificate.empty())
        throw Error(Errc::bad_usage,
                    "Receiving over a secure connection needs a certificate of this program's own; name its PEM file, "
                    "or retrieve by C-GET.");
    layer->setCertificateVerification(DCV_requireCertificate);
    ERR_clear_error();  // reading PEM files leaves its end behind, which would pass for a fault of a later read
    return layer;
}

std::string one_line(const char* text) {
    std::string line;
    for (; text && *text && line.size() < 200; ++text) line += *text >= ' ' && *text < 127 ? *text : ' ';
    return line;
}

ReadingAsBefore::ReadingAsBefore() : corrects_(dcmEnableAutomaticInputDataCorrection.get()) {}
ReadingAsBefore::~ReadingAsBefore() { dcmEnableAutomaticInputDataCorrection.set(corrects_); }

}  // namespace lacuna::dicom
