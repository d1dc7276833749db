#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace lacuna {

/// What kind of failure an Error reports. `bad_usage` maps to exit status 2, `cancelled` to 130, all others to 1.
enum class Errc {
    cancelled,      ///< the caller asked to stop; nothing went wrong
    bad_usage,      ///< the words of the call are off (flag, range of a parameter)
    bad_input,      ///< the data given cannot be what it claims to be
    unsupported,    ///< well-formed, but not something this program can do
    out_of_memory,  ///< host or device memory would not suffice
    kernel_build,   ///< an OpenCL program did not compile; about() holds the build log
    device,         ///< an OpenCL device failed or gave wrong answers
    io              ///< the operating system refused to read or write
};

/// The one exception type that leaves core. what() is one sentence a user can act on: what, where, what to do.
class Error : public std::runtime_error {
public:
    Error(Errc code, const std::string& sentence, std::string about = {})
        : runtime_error(sentence), code_(code), about_(std::make_shared<const std::string>(std::move(about))) {}

    Errc code() const noexcept { return code_; }
    /// The file, tag, device or build log concerned; may be empty.
    const std::string& about() const noexcept { return *about_; }

private:
    Errc code_;
    std::shared_ptr<const std::string> about_;
};

}  // namespace lacuna
