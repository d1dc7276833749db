#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/base/job.h"

namespace lacuna {

/// A file written piece by piece beside its target; the target appears, whole, with commit() and not before.
class OutputFile {
public:
    /// @throws Error(io)
    explicit OutputFile(const std::filesystem::path& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// @throws Error(io) naming the target and the reason (disk full, file too large)
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    void commit();

private:
    [[noreturn]] void fail(int code) const;
    std::filesystem::path target_;
    AtomicFile file_;
    int fd_ = -1;
};

/// Writes all bytes, in pieces between which the job may be cancelled.
void write_plain(OutputFile& file, std::span<const std::byte> bytes, const JobContext& job = {});

/// Writes `head` followed by `bytes` as one gzip member; chunks are compressed in parallel (as pigz does: each ends on
/// a byte boundary, checksums are combined), so the bytes do not depend on the number of threads.
void write_gzip(OutputFile& file, std::span<const std::byte> head, std::span<const std::byte> bytes,
                const JobContext& job = {});

}  // namespace lacuna
