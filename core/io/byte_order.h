#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace lacuna {

namespace byte_order_detail {
template <class Word, Word (*turned)(Word)>
void swap_all(std::span<std::byte> bytes) {
    for (std::size_t at = 0; at + sizeof(Word) <= bytes.size(); at += sizeof(Word)) {
        Word w;
        std::memcpy(&w, &bytes[at], sizeof(Word));
        w = turned(w);
        std::memcpy(&bytes[at], &w, sizeof(Word));
    }
}
inline std::uint16_t turned16(std::uint16_t w) { return __builtin_bswap16(w); }
inline std::uint32_t turned32(std::uint32_t w) { return __builtin_bswap32(w); }
inline std::uint64_t turned64(std::uint64_t w) { return __builtin_bswap64(w); }
}  // namespace byte_order_detail

/// Puts the bytes of every word of 2, 4 or 8 bytes the other way round; those of one byte stay.
inline void swap_words(std::span<std::byte> bytes, std::size_t word) {
    using namespace byte_order_detail;
    if (word == 2) swap_all<std::uint16_t, turned16>(bytes);
    if (word == 4) swap_all<std::uint32_t, turned32>(bytes);
    if (word == 8) swap_all<std::uint64_t, turned64>(bytes);
}

}  // namespace lacuna
