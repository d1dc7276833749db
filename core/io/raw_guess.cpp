#include "core/io/raw_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/io/random_access_file.h"
#include "core/io/raw_roughness.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t k_piece = std::uint64_t(64) << 20;
constexpr std::int64_t k_longest_row = 16384, k_longest_column = 16384, k_most_slices = 65536;
constexpr std::uint64_t k_largest_header = 1 << 20;
constexpr std::size_t k_most_guesses = 8;

// All in bits a byte of delta code, against which the content speaks.
constexpr double k_worse_family = 0.7;  // word sizes this much rougher than the best are not followed up
// What makes one guess e times as likely: k_share of what the best gains over chance, and k_noise of what the mean of
// so many differences is uncertain by.
constexpr double k_share = 0.02, k_noise = 0.1;
constexpr double k_depth_bonus = 0.25;  // for each bit by which a row's length matches better than one beside it
constexpr double k_name_bonus = 0.6, k_name_type_bonus = 0.25, k_header_bonus = 0.4;
constexpr double k_usual_header_cost = 0.1, k_odd_header_cost = 0.2, k_one_slice_cost = 0.5;
constexpr double k_aspect_cost = 0.02;    // for each doubling of an aspect ratio beyond 2, of slices beyond 4
constexpr double k_unknown_cost = -0.01;  // "none of these" against an arrangement at random

struct Family {
    RawWords words;
    double bits_a_byte = 0;
};

struct Candidate {
    RawWords words;
    glm::i64vec3 size{0};
    std::uint64_t offset = 0;
    double cost = 0;
    double row_gain = 0, slice_gain = 0;  ///< bits a voxel by which rows and slices match better than at random
    bool named = false, in_header = false;
};

/// The file's facts every step needs.
struct Subject {
    fs::path file;
    std::uint64_t bytes = 0;
    RawNameHints hints;
    std::vector<std::byte> head, piece;
};

Subject read_subject(const fs::path& file, const JobContext& job) {
    const RandomAccessFile in(file);
    Subject subject{file, in.bytes(), raw_name_hints(file.filename().string()), {}, {}};
    subject.head.resize(std::size_t(std::min<std::uint64_t>(64, in.bytes())));
    subject.head.resize(in.read(0, subject.head));
    const std::uint64_t size = std::min(k_piece, in.bytes()), from = (in.bytes() - size) / 2 & ~std::uint64_t(15);
    subject.piece.resize(std::size_t(size));
    constexpr std::uint64_t k_chunk = 4 << 20;
    std::uint64_t have = 0;
    while (have < size) {
        const auto want =
            std::span(subject.piece).subspan(std::size_t(have), std::size_t(std::min(k_chunk, size - have)));
        const std::size_t got = in.read(from + have, want);
        have += got;
        job.checkpoint(std::size_t(have), std::size_t(size));
        if (got < want.size()) break;  // the file became shorter meanwhile
    }
    subject.piece.resize(std::size_t(have));
    return subject;
}

/// Bytes of the piece before its first word, if words end where the file does.
std::size_t phase_of(const Subject& subject) {
    const std::uint64_t from = (subject.bytes - std::min(k_piece, subject.bytes)) / 2 & ~std::uint64_t(15);
    return std::size_t((subject.bytes - from) % 4);
}

bool fits_hints(const RawNameHints& hints, RawWords words) {
    if (hints.big_endian && size_of(words.type) > 1 && *hints.big_endian != words.big_endian) return false;
    if (hints.type) return *hints.type == words.type;
    return !hints.bits || std::size_t(*hints.bits) == 8 * size_of(words.type);
}

/// The word sizes and byte orders worth following, smoothest first; each with the sign under which it is smoother.
std::vector<Family> families(const Subject& subject, const RawRoughness& roughness) {
    std::vector<Family> found;
    const auto add = [&](VoxelType type, bool big) {
        found.push_back({{type, big}, roughness.of_neighbours({type, big})});
    };
    // Bytes with a sign are so rare that only a name makes them believable.
    add(subject.hints.type == VoxelType::i8 ? VoxelType::i8 : VoxelType::u8, false);
    for (const bool big : {false, true}) {
        const bool sign = subject.hints.type == VoxelType::i16 ||
                          (subject.hints.type != VoxelType::u16 && roughness.words_have_sign(big));
        add(sign ? VoxelType::i16 : VoxelType::u16, big);
        add(VoxelType::f32, big);
    }
    std::erase_if(found, [](const Family& f) { return !std::isfinite(f.bits_a_byte); });
    std::stable_sort(found.begin(), found.end(),
                     [](const Family& a, const Family& b) { return a.bits_a_byte < b.bits_a_byte; });
    const double best = found.front().bits_a_byte;
    std::erase_if(found, [&](const Family& f) {
        return f.bits_a_byte > best + k_worse_family && !(subject.hints.type && fits_hints(subject.hints, f.words));
    });
    return found;
}

std::vector<std::int64_t> divisors(std::uint64_t n, std::int64_t most) {
    std::vector<std::int64_t> found;
    for (std::uint64_t i = 1; i * i <= n; ++i) {
        if (n % i != 0) continue;
        if (std::int64_t(i) <= most) found.push_back(std::int64_t(i));
        if (n / i != i && std::int64_t(n / i) <= most) found.push_back(std::int64_t(n / i));
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Mean code lengths by lag of one family, each measured once.
class LagTable {
public:
    LagTable(const RawRoughness& roughness, RawWords words) : roughness_(roughness), words_(words) {
        double sum = 0;
        // Distances no scanner's rows have: what voxels differ by that have nothing to do with each other.
        const std::int64_t longest = std::max<std::int64_t>(2, std::min<std::int64_t>(longest_lag(), 40000));
        for (std::int64_t i = 1; i <= 16; ++i) sum += roughness_.at_lag(words_, 1 + longest * (2 * i - 1) / 33);
        at_random_ = sum / 16;
        neighbour_ = roughness_.at_lag(words_, 1);
    }
    std::int64_t longest_lag() const { return roughness_.longest_lag(size_of(words_.type)); }
    double at_random() const { return at_random_; }
    double neighbour() const { return neighbour_; }
    RawWords words() const { return words_; }

    void measure(const std::set<std::int64_t>& lags, const JobContext& job) {
        std::vector<std::int64_t> wanted;
        for (const std::int64_t lag : lags)
            if (lag >= 1 && lag <= longest_lag() && !table_.contains(lag)) wanted.push_back(lag);
        const std::vector<double> found = roughness_.at_lags(words_, wanted, job);
        for (std::size_t i = 0; i < wanted.size(); ++i) table_[wanted[i]] = found[i];
    }
    /// Measured lags only; the others count as unrelated.
    double operator[](std::int64_t lag) const {
        const auto at = table_.find(lag);
        return at == table_.end() ? at_random_ : at->second;
    }
    /// How much better voxels match at a lag than one `step` to either side of it.
    double depth(std::int64_t lag, std::int64_t step) const {
        return std::min((*this)[lag - step], (*this)[lag + step]) - (*this)[lag];
    }

private:
    const RawRoughness& roughness_;
    RawWords words_;
    std::map<std::int64_t, double> table_;
    double at_random_ = 0, neighbour_ = 0;
};

/// Header lengths of which sizes are tried: Analyze and NIfTI, three or four numbers, blocks of tapes and disks.
constexpr std::uint64_t k_usual_headers[] = {12, 16, 24, 32, 64, 128, 256, 348, 352, 512, 1024, 2048, 4096, 8192};

bool usual_header(std::uint64_t bytes) {
    return std::find(std::begin(k_usual_headers), std::end(k_usual_headers), bytes) != std::end(k_usual_headers);
}

/// Sizes that fill the file to the byte behind a header of so many bytes.
void add_filling_sizes(const Subject& subject, std::uint64_t header, LagTable& table, std::vector<Candidate>& out,
                       std::set<std::int64_t>& lags) {
    const std::size_t word = size_of(table.words().type);
    if (subject.bytes <= 2 * header || (subject.bytes - header) % word != 0) return;
    const std::uint64_t voxels = (subject.bytes - header) / word;
    const std::int64_t shortest = voxels > (1 << 15) ? 16 : 2;
    // Rows thirty times as long as columns: no detector's picture. With a header to explain, less odd shapes must do.
    const std::int64_t most_aspect = header == 0 ? 32 : 4;
    for (const std::int64_t x : divisors(voxels, k_longest_row)) {
        if (x < shortest) continue;
        for (const std::int64_t y : divisors(voxels / std::uint64_t(x), k_longest_column)) {
            const std::int64_t z = std::int64_t(voxels / std::uint64_t(x) / std::uint64_t(y));
            if (y < shortest || z > k_most_slices || std::max(x, y) > most_aspect * std::min(x, y)) continue;
            out.push_back({table.words(), {x, y, z}, header});
            lags.insert({x, x - 1, x + 1});
            if (z > 1) lags.insert({x * y});
        }
    }
}

void add_filling_sizes(const Subject& subject, LagTable& table, std::vector<Candidate>& out, const JobContext& job) {
    std::set<std::int64_t> lags;
    add_filling_sizes(subject, 0, table, out, lags);
    for (const std::uint64_t header : k_usual_headers) add_filling_sizes(subject, header, table, out, lags);
    table.measure(lags, job);
}

void add_if_it_fits(const Subject& subject, LagTable& table, glm::i64vec3 size, bool named, bool in_header,
                    std::vector<Candidate>& out, const JobContext& job) {
    const std::uint64_t word = size_of(table.words().type);
    if (std::min({size.x, size.y, size.z}) < 1 || std::max({size.x, size.y, size.z}) > 1'000'000) return;
    const double bytes = double(size.x) * double(size.y) * double(size.z) * double(word);
    if (!(bytes <= double(subject.bytes))) return;
    const std::uint64_t rest =
        subject.bytes - std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z) * word;
    if (rest > k_largest_header || double(rest) > bytes) return;
    table.measure({size.x, size.x - 1, size.x + 1, size.x * size.y}, job);
    Candidate candidate{table.words(), size, rest};
    candidate.named = named;
    candidate.in_header = in_header;
    out.push_back(candidate);
}

void add_named_sizes(const Subject& subject, LagTable& table, std::vector<Candidate>& out, const JobContext& job) {
    const auto& named = subject.hints.size;
    if (named.size() == 3) add_if_it_fits(subject, table, {named[0], named[1], named[2]}, true, false, out, job);
    if (named.size() != 2) return;
    const std::uint64_t slice = std::uint64_t(named[0]) * std::uint64_t(named[1]) * size_of(table.words().type);
    add_if_it_fits(subject, table, {named[0], named[1], subject.bytes / slice}, true, false, out, job);
}

/// Three numbers in a row among the first bytes, of which the product is the rest of the file.
void add_sizes_in_header(const Subject& subject, LagTable& table, std::vector<Candidate>& out, const JobContext& job) {
    const auto number = [&](std::size_t at, std::size_t bytes, bool big) {
        std::int64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            value |= std::int64_t(subject.head[at + (big ? bytes - 1 - i : i)]) << (8 * i);
        return value;
    };
    for (const std::size_t bytes : {2u, 4u})
        for (std::size_t at = 0; at + 3 * bytes <= subject.head.size(); at += 2)
            for (const bool big : {false, true}) {
                const glm::i64vec3 size(number(at, bytes, big), number(at + bytes, bytes, big),
                                        number(at + 2 * bytes, bytes, big));
                if (size.x < 2 || size.y < 2 || size.z < 1 || std::max({size.x, size.y, size.z}) > 65536) continue;
                const std::uint64_t all = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
                const std::uint64_t rest = subject.bytes - std::min(subject.bytes, all * size_of(table.words().type));
                if (rest >= at + 3 * bytes && rest <= 4096) add_if_it_fits(subject, table, size, false, true, out, job);
            }
}

double aspect_cost(const glm::i64vec3& size) {
    const double across = std::abs(std::log2(double(size.x) / double(size.y)));
    const double along = std::abs(std::log2(double(size.z) / double(std::max(size.x, size.y))));
    return k_aspect_cost * (std::max(0.0, across - 1) + std::max(0.0, along - 2));
}

void weigh(const Subject& subject, const LagTable& table, Candidate& c) {
    const double word = double(size_of(c.words.type));
    const double row = table[c.size.x], slice = c.size.z > 1 ? table[c.size.x * c.size.y] : row;
    c.row_gain = table.at_random() - row;
    c.slice_gain = c.size.z > 1 ? table.at_random() - slice : 0;
    c.cost = (table.neighbour() + row + slice) / 3 / word + aspect_cost(c.size);
    if (c.size.z == 1) c.cost += k_one_slice_cost;
    c.cost -= k_depth_bonus * std::max(0.0, table.depth(c.size.x, 1)) / word;
    if (c.offset > 0 && !c.in_header) c.cost += usual_header(c.offset) ? k_usual_header_cost : k_odd_header_cost;
    if (c.named) c.cost -= c.offset == 0 || c.in_header ? k_name_bonus : 0.5 * k_name_bonus;
    if (c.in_header) c.cost -= k_header_bonus;
    if (subject.hints.type || subject.hints.bits || subject.hints.big_endian)
        c.cost += fits_hints(subject.hints, c.words) ? -k_name_type_bonus : k_name_type_bonus;
}

double unknown_cost(const LagTable& table) {
    return (table.neighbour() + 2 * table.at_random()) / 3 / double(size_of(table.words().type)) + k_unknown_cost;
}

std::string order_name(bool big_endian) { return big_endian ? "big endian" : "little endian"; }

std::vector<std::string> reasons_for(const Subject& subject, const Candidate& c, const std::vector<Family>& all) {
    std::vector<std::string> said;
    if (c.named)
        said.push_back(c.offset == 0 ? "the file name states this size, and the length of the file fits it"
                                     : "the file name states this size");
    if (c.in_header) said.push_back("the first bytes of the file state this size");
    if (!c.named && c.offset == 0) said.push_back("the length of the file fits to the byte");
    if (c.offset > 0) said.push_back(fmt::format("{} bytes are left over for a header", c.offset));
    if (subject.hints.type && fits_hints(subject.hints, c.words)) said.push_back("the file name states this type");
    if (c.row_gain > 0.05) said.push_back(fmt::format("rows repeat after {} voxels", c.size.x));
    if (c.slice_gain > 0.05) said.push_back(fmt::format("slices repeat after {} rows", c.size.y));
    for (const Family& other : all) {
        if (size_of(other.words.type) != size_of(c.words.type) || other.words.big_endian == c.words.big_endian)
            continue;
        for (const Family& own : all)
            if (own.words.type == c.words.type && own.words.big_endian == c.words.big_endian &&
                other.bits_a_byte > own.bits_a_byte + 0.05)
                said.push_back("neighbours differ less in " + order_name(c.words.big_endian));
    }
    return said;
}

RawGuess as_guess(const Subject& subject, const Candidate& c) {
    RawGuess guess;
    guess.layout.file = subject.file;
    guess.layout.geometry.size = glm::ivec3(c.size);
    if (subject.hints.spacing_mm) {
        guess.layout.geometry.spacing = *subject.hints.spacing_mm;
        guess.layout.spacing_known = true;
    }
    guess.layout.type = c.words.type;
    guess.layout.big_endian = c.words.big_endian;
    guess.layout.offset = c.offset;
    return guess;
}

/// Sorts, removes what stands twice, and turns costs into confidences.
/// @param unknown  cost of "none of these"; @param noise  what costs are uncertain by
std::vector<RawGuess> ranked(const Subject& subject, std::vector<Candidate> candidates, double unknown, double noise,
                             const std::vector<Family>& all) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    std::vector<Candidate> kept;
    for (const Candidate& c : candidates)
        if (std::none_of(kept.begin(), kept.end(), [&](const Candidate& k) {
                return k.size == c.size && k.words.type == c.words.type && k.words.big_endian == c.words.big_endian &&
                       k.offset == c.offset;
            }))
            kept.push_back(c);
    double total = 0;
    if (kept.empty()) return {};
    const double best = std::min(kept.front().cost, unknown);
    const double temperature = std::max(1e-4, k_noise * noise + k_share * (unknown - best));
    const auto weight = [&](double cost) { return std::exp((best - cost) / temperature); };
    for (const Candidate& c : kept) total += weight(c.cost);
    total += weight(unknown);
    std::vector<RawGuess> guesses;
    for (std::size_t i = 0; i < std::min(kept.size(), k_most_guesses); ++i) {
        guesses.push_back(as_guess(subject, kept[i]));
        guesses.back().confidence = weight(kept[i].cost) / total;
        guesses.back().reasons = reasons_for(subject, kept[i], all);
    }
    return guesses;
}

}  // namespace

std::vector<RawGuess> guess_raw_layouts(const fs::path& file, const JobContext& job) {
    const Subject subject = read_subject(file, job.part(0, 0.2));
    if (subject.bytes == 0) return {};
    const RawRoughness roughness(subject.piece, phase_of(subject));
    const std::vector<Family> all = families(subject, roughness);
    std::vector<Candidate> candidates;
    double unknown = std::numeric_limits<double>::infinity(), noise = 0;
    for (std::size_t f = 0; f < all.size(); ++f) {
        const JobContext part =
            job.part(0.2 + 0.8 * double(f) / double(all.size()), 0.2 + 0.8 * double(f + 1) / double(all.size()));
        LagTable table(roughness, all[f].words);
        std::vector<Candidate> found;
        add_filling_sizes(subject, table, found, part);
        add_named_sizes(subject, table, found, part);
        add_sizes_in_header(subject, table, found, part);
        for (Candidate& c : found) weigh(subject, table, c);
        candidates.insert(candidates.end(), found.begin(), found.end());
        if (unknown_cost(table) < unknown) {
            unknown = unknown_cost(table);
            noise = table.at_random() / double(size_of(all[f].words.type)) /
                    std::sqrt(double(std::clamp<std::size_t>(roughness.places(), 1, 4000)));
        }
        part.checkpoint(1, 1);
    }
    return ranked(subject, std::move(candidates), unknown, noise, all);
}

}  // namespace lacuna
