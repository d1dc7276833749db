#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/io/pacs.h"

namespace lacuna::dicom {

/// A storage SCP for the time of one C-MOVE: listens on the server's receiver.address and port from construction to
/// destruction, takes associations from the server's AE title to this program's alone, several at a time; all others
/// are refused, those who say nothing hung up on after the server's time. Destruction closes the port, breaks off what
/// is still open and waits for its threads.
class PacsReceiving {
public:
    struct Callbacks {
        /// A file for the next object, which is written while it comes. Called by several threads.
        std::function<std::filesystem::path()> new_file;
        /// An object has come, of so many bytes (none: the disk ran full); false: it is not to be kept. Called by one
        /// thread at a time, of its own. The file is the callee's.
        std::function<bool(const std::filesystem::path& file, std::optional<std::uint64_t> bytes)> on_object;
        /// Nothing has come for the server's time, nor alive() been called. Called once, from another thread.
        std::function<void()> on_silence;
    };
    /// @throws Error(io) naming address and port where they cannot be listened on; Error(bad_usage) for TLS without a
    /// certificate
    PacsReceiving(const PacsServer& server, Callbacks callbacks);
    ~PacsReceiving();
    PacsReceiving(const PacsReceiving&) = delete;
    PacsReceiving& operator=(const PacsReceiving&) = delete;

    /// The server has shown that it lives.
    void alive();
    /// The AE titles of the last one that was refused, "CALLING to CALLED"; empty: nobody was.
    std::string refused() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lacuna::dicom
