#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "core/base/error.h"
#include "core/io/volume_reader.h"

namespace lacuna {

std::string voxel_sha256(const Volume& volume, const JobContext& job) {
    static_assert(std::endian::native == std::endian::little, "the digest is defined on little-endian voxels");
    const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1)
        throw Error(Errc::unsupported, "The system's cryptography library does not offer SHA-256.");
    constexpr std::size_t k_chunk = std::size_t(4) << 20;
    for (std::size_t at = 0; at < volume.bytes(); at += k_chunk) {
        job.checkpoint(at, volume.bytes());
        EVP_DigestUpdate(context.get(), volume.data() + at, std::min(k_chunk, volume.bytes() - at));
    }
    job.check();
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned size = 0;
    EVP_DigestFinal_ex(context.get(), digest, &size);
    std::string hex;
    for (unsigned i = 0; i < size; ++i)
        for (const int nibble : {digest[i] >> 4, digest[i] & 15}) hex += "0123456789abcdef"[nibble];
    return hex;
}

}  // namespace lacuna
