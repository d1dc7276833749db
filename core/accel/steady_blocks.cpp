#include "core/accel/steady_blocks.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

template <class Steady>
std::vector<std::uint8_t> mark(const MacrocellGrid& grid, Steady&& steady) {
    std::vector<std::uint8_t> blocks(grid.ranges.size());
    parallel_bands(0, std::int64_t(blocks.size()), 2 * thread_count(), [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) {
            const auto at = std::size_t(i);
            const ValueRange range{grid.ranges[at].x, grid.ranges[at].y};
            const bool bad = !grid.has_nan.empty() && grid.has_nan[at];
            blocks[at] = !bad && range.lo <= range.hi && steady(range);
        }
    });
    return blocks;
}

bool same(const ColorOpacity& a, const ColorOpacity& b) { return a.opacity == b.opacity && a.color == b.color; }

}  // namespace

PlateauTable::PlateauTable(const Classification& classes) {
    const auto add = [&](const TransferFunction& tf) {
        for (const TransferPoint& p : tf.points) ends_.push_back(p.value);
        if (!tf.is_2d()) return;
        for (const TransferShape& shape : tf.shapes) ends_.insert(ends_.end(), {shape.values().lo, shape.values().hi});
    };
    add(classes.tf);
    for (const SegmentationRange& r : classes.ranges) {
        if (r.tf) add(*r.tf);
        for (const double end : {r.range.lo, r.range.hi})
            if (std::isfinite(end)) ends_.push_back(end);
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    // Between two ends the classification is linear: level if it is so at two values.
    const auto level_at = [&](double a, double b) {
        const ColorOpacity at_a = classes.at(a), at_b = classes.at(b);
        if (!(at_a.opacity > 0) && !(at_b.opacity > 0)) return classes.range_of(a) == classes.range_of(b);
        // Within a shape, what is seen of a value also depends on the gradient, to an extent that differs by value.
        return classes.range_of(a) == classes.range_of(b) && same(at_a, at_b) && !classes.function_of(a).is_2d();
    };
    const double before = ends_.front(), behind = ends_.back();
    level_.push_back(
        level_at(before - std::max(1.0, std::fabs(before)), before - 2 * std::max(1.0, std::fabs(before))));
    for (std::size_t i = 1; i < ends_.size(); ++i) {
        const double a = ends_[i - 1], w = ends_[i] - a;
        level_.push_back(level_at(a + 0.25 * w, a + 0.75 * w));
    }
    level_.push_back(
        level_at(behind + std::max(1.0, std::fabs(behind)), behind + 2 * std::max(1.0, std::fabs(behind))));
    join(classes);
}

// A corner where nothing changes is no end: both sides, and the value itself, are drawn alike.
void PlateauTable::join(const Classification& classes) {
    std::vector<double> ends;
    std::vector<bool> level{level_.front()};
    const auto inside = [&](std::size_t piece) {  // a value of that piece
        if (piece == 0) return ends_.front() - std::max(1.0, std::fabs(ends_.front()));
        if (piece == ends_.size()) return ends_.back() + std::max(1.0, std::fabs(ends_.back()));
        return 0.5 * (ends_[piece - 1] + ends_[piece]);
    };
    for (std::size_t i = 0; i < ends_.size(); ++i) {
        const ColorOpacity a = classes.at(inside(i)), at = classes.at(ends_[i]), b = classes.at(inside(i + 1));
        const bool clear = !(a.opacity > 0) && !(at.opacity > 0) && !(b.opacity > 0);
        const bool one_function = classes.range_of(inside(i)) == classes.range_of(inside(i + 1)) &&
                                  classes.range_of(ends_[i]) == classes.range_of(inside(i));
        if (level_[i] && level_[i + 1] && (clear || (one_function && same(a, at) && same(at, b)))) continue;
        ends.push_back(ends_[i]);
        level.push_back(level_[i + 1]);
    }
    ends_ = std::move(ends);
    level_ = std::move(level);
}

bool PlateauTable::level(ValueRange range) const {
    const auto piece = std::upper_bound(ends_.begin(), ends_.end(), range.hi) - ends_.begin();
    return level_[std::size_t(piece)] && (piece == 0 || range.lo > ends_[std::size_t(piece - 1)]);
}

std::vector<std::uint8_t> steady_blocks_of_opacity(const MacrocellGrid& grid, const PlateauTable& table, double slack) {
    return mark(grid, [&](ValueRange r) { return table.level({r.lo - slack, r.hi + slack}); });
}

std::vector<std::uint8_t> steady_blocks_of_iso(const MacrocellGrid& grid, const VisibilityTable& inside, double slack) {
    return mark(grid, [&](ValueRange r) {
        return inside.query({r.lo - slack, r.hi + slack}) != VisibilityTable::Answer::some;
    });
}

std::vector<std::uint8_t> steady_blocks_of_values(const MacrocellGrid& grid, const VisibilityTable& shown,
                                                  double slack) {
    return mark(grid, [&](ValueRange r) {
        return r.lo == r.hi || shown.query({r.lo - slack, r.hi + slack}) == VisibilityTable::Answer::none;
    });
}

}  // namespace lacuna
