#include <algorithm>

#include "core/accel/solid_bits.h"

namespace lacuna {

namespace {

/// One slice of bits, rows back to back, with a word of margin at both ends so that shifts need no special case.
struct SliceBits {
    SliceBits(int bit_columns, int bit_rows, int row_words)
        : columns(bit_columns), rows(bit_rows), words(row_words), data(std::size_t(rows) * std::size_t(words) + 2) {}
    std::uint64_t* row(int v) { return data.data() + 1 + std::size_t(v) * std::size_t(words); }
    std::size_t size() const { return data.size() - 2; }
    void fill() {
        std::fill(data.begin() + 1, data.end() - 1, ~std::uint64_t(0));
        mask();
    }
    /// Clears the bits beyond each row's end.
    void mask() {
        const std::uint64_t last = ~std::uint64_t(0) >> (words * 64 - columns);
        for (int v = 0; v < rows; ++v) row(v)[words - 1] &= last;
    }

    int columns, rows, words;
    std::vector<std::uint64_t> data;
};

/// Moves along u what can be reached from the slice before: a bit to itself and its neighbours on the lean's side(s).
/// Rows are handled as one run of words; what a shift carries over a row's end falls on a side bit or beyond the row.
void reach_along_u(SliceBits& from, SliceBits& to, int lean) {
    const std::uint64_t* in = from.row(0);
    std::uint64_t* out = to.row(0);
    const std::size_t n = from.size();
    if (lean > 0) {
        for (std::size_t i = 0; i < n; ++i) out[i] = in[i] | in[i] << 1 | *(in + i - 1) >> 63;
    } else if (lean < 0) {
        for (std::size_t i = 0; i < n; ++i) out[i] = in[i] | in[i] >> 1 | in[i + 1] << 63;
    } else {
        for (std::size_t i = 0; i < n; ++i)
            out[i] = in[i] | in[i] << 1 | in[i] >> 1 | *(in + i - 1) >> 63 | in[i + 1] << 63;
    }
}

/// Which bits of the next slice can be reached from those of this one. With `world` what lies beside the slice, on the
/// sides the region's rays enter through, reaches in too.
void reach(SliceBits& bits, SliceBits& scratch, const SliceDirection& direction, bool world) {
    const int lean_u = direction.u_lean, lean_v = direction.v_lean, rows = bits.rows;
    reach_along_u(bits, scratch, lean_u);
    if (world) {
        const std::uint64_t last = std::uint64_t(1) << ((bits.columns - 1) & 63);
        for (int v = 0; v < rows; ++v) {
            if (lean_u >= 0) scratch.row(v)[0] |= 1;
            if (lean_u <= 0) scratch.row(v)[bits.words - 1] |= last;
        }
    }
    const std::size_t n = bits.size(), words = std::size_t(bits.words);
    std::uint64_t* out = bits.row(0);
    const std::uint64_t* in = scratch.row(0);
    if (lean_v > 0) {
        std::copy(in, in + words, out);
        for (std::size_t i = words; i < n; ++i) out[i] = in[i] | in[i - words];
    } else {
        for (std::size_t i = 0; i + words < n; ++i) out[i] = in[i] | in[i + words];
        std::copy(in + n - words, in + n, out + n - words);
        if (lean_v == 0)
            for (std::size_t i = words; i < n; ++i) out[i] |= in[i - words];
    }
    if (world && lean_v >= 0) std::fill(out, out + words, ~std::uint64_t(0));
    if (world && lean_v <= 0) std::fill(out + n - words, out + n, ~std::uint64_t(0));
    bits.mask();
}

int slice_at(const SliceRows& slices, int k) { return slices.direction.from_low ? k : slices.slices - 1 - k; }

std::vector<std::uint64_t> seen_cells(const SliceRows& slices, const JobContext& job) {
    SliceBits seen(slices.columns + 1, slices.rows + 1, slices.cell_words), scratch = seen, any = seen, full = seen;
    std::vector<std::uint64_t> visible(seen.size() * std::size_t(slices.slices));
    seen.fill();
    for (int k = 0; k < slices.slices; ++k) {
        job.check();
        const int c = slice_at(slices, k);
        if (k > 0) reach(seen, scratch, slices.direction, true);
        for (int j = 0; j <= slices.rows; ++j) {
            slices.cells(j, c, any.row(j), full.row(j));
            slices.cut_cells(j, c, any.row(j), full.row(j));
        }
        std::uint64_t* out = visible.data() + std::size_t(c) * seen.size();
        std::uint64_t* potential = seen.row(0);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            out[i] = potential[i] & any.row(0)[i];
            potential[i] &= ~full.row(0)[i];
        }
    }
    return visible;
}

/// The local extraction behind open cuts: from inside the object any of its surface may be the first that is met.
std::vector<std::uint64_t> crossing_cells(const SliceRows& slices, const JobContext& job) {
    SliceBits any(slices.columns + 1, slices.rows + 1, slices.cell_words), full = any, scratch = any;
    SliceBits any_before = any, hollow_before = any;  // of the slice before, as far as they reach here
    SliceBits kept = any, far = any;                  // of which the cuts leave something; far behind capped cuts
    std::vector<std::uint64_t> visible(any.size() * std::size_t(slices.slices));
    hollow_before.fill();
    for (int k = 0; k < slices.slices; ++k) {
        job.check();
        const int c = slice_at(slices, k);
        kept.fill();
        far.fill();
        for (int j = 0; j <= slices.rows; ++j) {
            slices.cells(j, c, any.row(j), full.row(j));
            slices.cut_cells(j, c, kept.row(j), full.row(j));
            slices.far_from_caps(j, c, far.row(j));
        }
        if (k > 0) {
            reach(any_before, scratch, slices.direction, false);
            reach(hollow_before, scratch, slices.direction, false);
        }
        std::uint64_t* out = visible.data() + std::size_t(c) * any.size();
        for (std::size_t i = 0; i < any.size(); ++i) {
            const std::uint64_t one_solid = full.row(0)[i] & ~hollow_before.row(0)[i] & far.row(0)[i];
            out[i] = (any.row(0)[i] | any_before.row(0)[i]) & ~one_solid & kept.row(0)[i];
            any_before.row(0)[i] = any.row(0)[i];
            hollow_before.row(0)[i] = ~full.row(0)[i];
        }
        hollow_before.mask();
    }
    return visible;
}

}  // namespace

std::vector<std::uint64_t> visible_voxel_bits(const SliceRows& slices, const JobContext& job) {
    SliceBits seen(slices.columns, slices.rows, slices.words), scratch = seen;
    std::vector<std::uint64_t> visible(seen.size() * std::size_t(slices.slices));
    std::vector<std::uint64_t> row_scratch(2 * std::size_t(slices.words));
    const auto words = std::size_t(slices.words);
    seen.fill();
    for (int k = 0; k < slices.slices; ++k) {
        job.check();
        const int c = slice_at(slices, k);
        if (k > 0) reach(seen, scratch, slices.direction, true);
        std::uint64_t* out = visible.data() + std::size_t(c) * seen.size();
        for (int v = 0; v < slices.rows; ++v, out += words) {
            const std::uint64_t* solid = slices.voxels(v, c, row_scratch.data());
            std::uint64_t* potential = seen.row(v);
            for (std::size_t w = 0; w < words; ++w) {
                out[w] = potential[w] & solid[w];
                potential[w] &= ~solid[w];
            }
        }
    }
    return visible;
}

std::vector<std::uint64_t> visible_cell_bits(const SliceRows& slices, const JobContext& job) {
    return slices.has_open_cut() ? crossing_cells(slices, job) : seen_cells(slices, job);
}

}  // namespace lacuna
