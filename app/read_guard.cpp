#include "app/read_guard.h"

#include "core/base/error.h"
#include "core/io/dicom_reader.h"

namespace lacuna::cli {

void check_not_read(const std::string& read, const std::vector<std::filesystem::path>& targets) {
    namespace fs = std::filesystem;
    for (const fs::path& target : targets) {
        std::error_code ec;
        if (target.empty() || !fs::is_regular_file(target, ec)) continue;
        const bool is_read = fs::exists(read, ec) && fs::equivalent(target, read, ec);
        // Of a folder that is read any image counts.
        if (is_read || looks_like_dicom(target))
            throw Error(Errc::bad_usage, target.string() + " would be written over " +
                                             (is_read ? "what is read" : "a DICOM file") + "; name another file.");
    }
}

}  // namespace lacuna::cli
