#include "tests/cli/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace lacuna::test {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void become_program(const std::vector<std::string>& words, const Surroundings& surroundings, int out,
                                 int err) {
    for (const auto& [name, value] : surroundings.environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (surroundings.file_size_limit > 0) {
        const rlimit limit{rlim_t(surroundings.file_size_limit), rlim_t(surroundings.file_size_limit)};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_DFL);  // as a shell leaves it: the program must cope
        ::signal(SIGHUP, SIG_DFL);   // tests may run under nohup
    }
    const int in = ::open("/dev/null", O_RDONLY);
    ::dup2(in, STDIN_FILENO);
    if (!surroundings.standard_output.empty()) out = ::open(surroundings.standard_output.c_str(), O_WRONLY);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    std::vector<char*> arguments{const_cast<char*>(LACUNA_PROGRAM)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(LACUNA_PROGRAM, arguments.data());
    ::_exit(127);
}

/// Reads both pipes to their ends.
void drain(int out, int err, Outcome& outcome) {
    pollfd pipes[2] = {{out, POLLIN, 0}, {err, POLLIN, 0}};
    std::string* texts[2] = {&outcome.out, &outcome.err};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
        ::poll(pipes, 2, -1);
        for (int i = 0; i < 2; ++i) {
            if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
            char bytes[4096];
            const ssize_t n = ::read(pipes[i].fd, bytes, sizeof bytes);
            if (n > 0)
                texts[i]->append(bytes, std::size_t(n));
            else
                pipes[i].fd = -1;
        }
    }
}

}  // namespace

int Outcome::error_lines() const { return int(std::count(err.begin(), err.end(), '\n')); }

Outcome lacuna(const std::vector<std::string>& words, const Surroundings& surroundings) {
    int out[2], err[2];
    if (::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) become_program(words, surroundings, out[1], err[1]);
    ::close(out[1]);
    ::close(err[1]);
    std::thread signaller;
    if (surroundings.signal != 0)
        signaller = std::thread([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(surroundings.signal_after_ms));
            ::kill(child, surroundings.signal);  // the child is not reaped before this thread ends
        });
    Outcome outcome;
    drain(out[0], err[0], outcome);
    if (signaller.joinable()) signaller.join();
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(out[0]);
    ::close(err[0]);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

Surroundings without_opencl(const fs::path& folder) {
    Surroundings without;
    without.environment = {{"OCL_ICD_VENDORS", folder.string()}};
    return without;
}

ProgramTest::ProgramTest() {
    std::string pattern = (fs::temp_directory_path() / "lacuna-cli-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
}

ProgramTest::~ProgramTest() {
    std::error_code ec;
    fs::remove_all(folder_, ec);
}

std::vector<std::string> ProgramTest::files() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool runs(const std::string& command, std::string& said) {
    said.clear();
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    char text[512];
    while (pipe && std::fgets(text, sizeof text, pipe)) said += text;
    return pipe && ::pclose(pipe) == 0;
}

void expect_failure(const Outcome& outcome, int status, const std::string& part) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("lacuna: ")) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

void expect_no_room(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    const std::size_t last =
        outcome.err.size() < 2 ? std::string::npos : outcome.err.rfind('\n', outcome.err.size() - 2);
    const std::string line = outcome.err.substr(last == std::string::npos ? 0 : last + 1);
    EXPECT_TRUE(line.starts_with("lacuna: Cannot write ")) << outcome.err;
}

std::string bytes_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace lacuna::test
