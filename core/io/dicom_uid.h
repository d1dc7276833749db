#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A DICOM unique identifier that follows from a text: the same text gives the same UID, on any machine. Form 2.25
/// (PS3.5 B.2), a UUID of version 8 (RFC 9562: custom) filled from the text's SHA-256.
std::string derived_uid(std::string_view text);

}  // namespace lacuna
