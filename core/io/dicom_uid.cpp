#include "core/io/dicom_uid.h"

#include <openssl/evp.h>

#include <algorithm>

#include "core/base/error.h"

namespace lacuna {

std::string derived_uid(std::string_view text) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned size = 0;
    if (EVP_Digest(text.data(), text.size(), digest, &size, EVP_sha256(), nullptr) != 1 || size < 16)
        throw Error(Errc::unsupported, "The system's cryptography library does not offer SHA-256.");
    digest[6] = static_cast<unsigned char>((digest[6] & 0x0f) | 0x80);  // version 8
    digest[8] = static_cast<unsigned char>((digest[8] & 0x3f) | 0x80);  // variant
    std::string decimal;  // of the 128-bit number, last digit first: long division by ten, byte by byte
    bool left = true;
    while (left) {
        unsigned remainder = 0;
        left = false;
        for (int i = 0; i < 16; ++i) {
            const unsigned value = remainder * 256 + digest[i];
            digest[i] = static_cast<unsigned char>(value / 10);
            remainder = value % 10;
            left = left || digest[i] != 0;
        }
        decimal += char('0' + remainder);
    }
    std::reverse(decimal.begin(), decimal.end());
    return "2.25." + decimal;
}

}  // namespace lacuna
