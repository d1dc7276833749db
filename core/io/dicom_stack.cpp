#include "core/io/dicom_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/error.h"

namespace lacuna::dicom {

namespace {

constexpr double k_even_share = 0.02;       // of the step: slices nearer to their plane than this are on it
constexpr double k_exact_share = 1e-3;      // of the step: below, the deviation is the rounding of decimal strings
constexpr double k_duplicate_share = 0.01;  // of the step: nearer neighbours are the same slice twice
constexpr double k_duplicate_px = 0.02;     // of the smaller pixel side: no scanner's step is as short, ...
constexpr double k_rounding_mm = 0.01;      // ... and no two ways to write one position differ by more
constexpr double k_shear_px = 0.1;          // drift within the plane that is worth resampling
constexpr double k_exact_px = 0.01;
constexpr int k_most_planes_a_slice = 4;  // bounds what gaps and uneven steps may blow a stack up to

/// The median of the gaps wider than `least`; 0 if there is none.
double usual_gap(std::span<const double> along, double least) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < along.size(); ++i)
        if (along[i] - along[i - 1] > least) gaps.push_back(along[i] - along[i - 1]);
    if (gaps.empty()) return 0;
    const auto middle = gaps.begin() + std::ptrdiff_t((gaps.size() - 1) / 2);
    std::nth_element(gaps.begin(), middle, gaps.end());
    return *middle;
}

/// Least-squares line position = a + step * plane; sets step and worst distance.
void fit_line(std::span<const double> along, StepFit& fit) {
    const double n = double(along.size());
    double mean_p = 0, mean_a = 0, pp = 0, pa = 0;
    for (std::size_t i = 0; i < along.size(); ++i) {
        mean_p += fit.planes[i] / n;
        mean_a += along[i] / n;
    }
    for (std::size_t i = 0; i < along.size(); ++i) {
        pp += (fit.planes[i] - mean_p) * (fit.planes[i] - mean_p);
        pa += (fit.planes[i] - mean_p) * (along[i] - mean_a);
    }
    fit.step_mm = pa / pp;
    for (std::size_t i = 0; i < along.size(); ++i)
        fit.worst_mm = std::max(fit.worst_mm, std::abs(along[i] - mean_a - (fit.planes[i] - mean_p) * fit.step_mm));
}

std::string mm_text(double mm) { return fmt::format("{:.4g} mm", mm); }

}  // namespace

namespace {

/// Fits the step `base`, or a multiple of it between slices that are missing.
StepFit fit_step(std::span<const double> along, std::span<const std::optional<int>> instances, double base,
                 double duplicate_limit) {
    StepFit fit;
    int wide_gaps = 0, gaps = 0;
    bool confirmed = instances.size() == along.size();
    fit.planes.push_back(0);
    for (std::size_t i = 1; i < along.size(); ++i) {
        const double gap = along[i] - along[i - 1];
        const bool same = gap <= duplicate_limit;
        const double steps = same ? 0 : std::max(1.0, std::round(gap / base));
        fit.duplicates += same;
        gaps += !same;
        wide_gaps += steps > 1;
        if (!(fit.planes.back() + steps < 1e8)) return StepFit{base, {}, gap, fit.duplicates, 0};
        confirmed =
            confirmed && instances[i] && instances[i - 1] && std::abs(*instances[i] - *instances[i - 1]) == int(steps);
        fit.planes.push_back(fit.planes.back() + int(steps));
    }
    fit_line(along, fit);
    fit.missing = fit.planes.back() - gaps;
    const bool too_many = wide_gaps > 1 && wide_gaps * 3 > gaps && !confirmed;
    if (!(fit.worst_mm <= k_even_share * fit.step_mm) || too_many) fit.planes.clear();
    return fit;
}

}  // namespace

double same_position_mm(const std::optional<glm::dvec2>& spacing_mm) {
    constexpr double k_exact = 1e-6;
    if (!spacing_mm) return k_exact;
    return std::max(k_exact, std::min(k_rounding_mm, k_duplicate_px * std::min(spacing_mm->x, spacing_mm->y)));
}

StepFit find_step(std::span<const double> along, std::span<const std::optional<int>> instances, double same_mm) {
    const double base = usual_gap(along, same_mm);
    if (along.size() < 2 || base <= 0) {
        StepFit fit;
        fit.planes.assign(along.size(), 0);
        fit.duplicates = std::max(0, int(along.size()) - 1);
        return fit;
    }
    const double duplicate_limit = std::max(same_mm, k_duplicate_share * base);
    const StepFit usual = fit_step(along, instances, base, duplicate_limit);
    if (usual.uniform()) return usual;
    // Where most slices are missing the usual gap is a multiple of the step.
    double smallest = base;
    for (std::size_t i = 1; i < along.size(); ++i)
        if (along[i] - along[i - 1] > duplicate_limit) smallest = std::min(smallest, along[i] - along[i - 1]);
    const StepFit finest = fit_step(along, instances, smallest, duplicate_limit);
    return finest.uniform() ? finest : usual;
}

namespace {

class Planner {
public:
    Planner(std::span<const Frame> slices, glm::ivec2 size, std::span<const std::string> names)
        : slices_(slices), size_(size), names_(names) {}

    StackPlan plan() {
        const Frame& first = slices_.front();
        if (!first.spacing) warn("The slices name no pixel spacing; 1 mm is assumed.");
        spacing_ = first.spacing.value_or(glm::dvec2(1));
        if (!first.has_orientation) warn("The slices name no orientation; axial is assumed.");
        row_ = first.row;
        column_ = first.column;
        normal_ = glm::cross(row_, column_);
        collect_positions();
        drop_duplicates();
        measure_shifts();
        lay_planes();
        finish_grid();
        return std::move(plan_);
    }

private:
    void warn(std::string text, double error_mm = 0) { plan_.warnings.push_back({std::move(text), error_mm}); }
    const std::string& name(std::size_t used) const { return names_[plan_.order[used]]; }

    void collect_positions() {
        plan_.order.resize(slices_.size());
        std::iota(plan_.order.begin(), plan_.order.end(), std::size_t(0));
        const auto placed = std::count_if(slices_.begin(), slices_.end(), [](const Frame& s) { return !!s.position; });
        if (placed == std::ptrdiff_t(slices_.size())) {
            for (const Frame& s : slices_) positions_.push_back(*s.position);
        } else if (placed == 0) {
            assume_positions();
        } else {
            throw Error(Errc::bad_input, "Some slices name no position (ImagePositionPatient), others do; remove " +
                                             names_[0] + " or the like from the folder.");
        }
        std::sort(plan_.order.begin(), plan_.order.end(), [&](std::size_t a, std::size_t b) {
            const double da = along(a), db = along(b);
            return da != db ? da < db : a < b;
        });
    }

    double along(std::size_t slice) const { return glm::dot(positions_[slice], normal_); }

    /// Frames of one file have an order of their own; separate files without positions have none.
    void assume_positions() {
        for (const Frame& s : slices_)
            if (s.file != slices_.front().file)
                throw Error(Errc::bad_input,
                            "The slices name no position (ImagePositionPatient), so their order cannot be known; "
                            "open one of the files, or export the series with positions.");
        const double step = lone_step();
        warn("The image names no position; its corner is taken as the origin.");
        for (const Frame& s : slices_) positions_.push_back(normal_ * (step * s.number));
    }

    double lone_step() {
        if (lone_step_mm_ <= 0) lone_step_mm_ = named_step();
        return lone_step_mm_;
    }

    double named_step() {
        const Frame& s = slices_.front();
        if (s.step_mm > 0) return s.step_mm;
        if (s.thickness_mm > 0) return s.thickness_mm;
        warn("Nothing names the distance between slices; 1 mm is assumed.");
        return 1;
    }

    void drop_duplicates() {
        std::vector<double> all;
        for (const std::size_t s : plan_.order) all.push_back(along(s));
        const double same_mm = same_position_mm(slices_.front().spacing);
        const double limit = std::max(same_mm, k_duplicate_share * usual_gap(all, same_mm));
        std::vector<std::size_t> kept;
        for (const std::size_t s : plan_.order) {
            if (kept.empty() || along(s) - along(kept.back()) > limit) {
                kept.push_back(s);
                continue;
            }
            // Of several passes over the same positions the first one stays whole, in whatever order the files lie.
            const bool earlier = slices_[s].instance && slices_[kept.back()].instance &&
                                 *slices_[s].instance < *slices_[kept.back()].instance;
            plan_.duplicates.push_back(earlier ? std::exchange(kept.back(), s) : s);
        }
        plan_.order = std::move(kept);
        if (plan_.duplicates.empty()) return;
        std::string text =
            fmt::format("{} of {} slices repeat the position of another and are left out:", plan_.duplicates.size(),
                        slices_.size());
        for (std::size_t i = 0; i < plan_.duplicates.size() && i < 8; ++i)
            text += (i ? ", " : " ") + names_[plan_.duplicates[i]];
        warn(text + (plan_.duplicates.size() > 8 ? ", ..." : "."));
    }

    void measure_shifts() {
        const glm::dvec3 start = positions_[plan_.order.front()];
        double low_u = 0, high_u = 0, low_v = 0, high_v = 0;
        for (const std::size_t s : plan_.order) {
            const glm::dvec3 d = positions_[s] - start;
            const glm::dvec2 px(glm::dot(d, row_) / spacing_.x, glm::dot(d, column_) / spacing_.y);
            plan_.along_mm.push_back(glm::dot(d, normal_));
            plan_.shift_px.push_back(px);
            low_u = std::min(low_u, px.x), high_u = std::max(high_u, px.x);
            low_v = std::min(low_v, px.y), high_v = std::max(high_v, px.y);
        }
        const glm::dvec2 drift(high_u - low_u, high_v - low_v);
        const double worst_px = std::max(drift.x, drift.y);
        plan_.sheared = worst_px > k_shear_px;
        if (plan_.sheared) {
            if (!(worst_px < 8192))
                throw Error(Errc::bad_input, "The slices lie too far apart within their plane (" +
                                                 mm_text(glm::length(drift * spacing_)) +
                                                 ") to belong to one volume; check ImagePositionPatient.");
            describe_shear();
            plan_.margin_px = -glm::ivec2(glm::floor(glm::dvec2(low_u, low_v) + 1e-6));
            size_ += plan_.margin_px + glm::ivec2(glm::ceil(glm::dvec2(high_u, high_v) - 1e-6));
        } else if (worst_px > k_exact_px) {
            warn("The slices drift within their plane by less than a tenth of a pixel; that is ignored.",
                 glm::length(drift * spacing_));
        }
    }

    /// Tilted gantry: the drift is proportional to the way along the normal. Its angle is positive when the slices
    /// move down their columns (or along their rows, if that is more) towards the normal.
    void describe_shear() {
        const double way = plan_.along_mm.back();
        const glm::dvec2 slope = plan_.shift_px.back() * spacing_ / way;
        double residual_mm = 0;
        for (std::size_t i = 0; i < plan_.order.size(); ++i)
            residual_mm = std::max(residual_mm, glm::length(plan_.shift_px[i] * spacing_ - slope * plan_.along_mm[i]));
        const double main = std::abs(slope.y) >= std::abs(slope.x) ? slope.y : slope.x;
        plan_.tilt_deg = std::atan(main) * 180 / 3.14159265358979323846;
        // Positions stay exact; half a pixel is what the nearest value beside padding may be off.
        const double error_mm = 0.5 * std::max(spacing_.x, spacing_.y);
        if (residual_mm <= error_mm)
            warn(fmt::format("The slices were taken with the gantry tilted by {:.2f} degrees; they are resampled to an "
                             "upright grid.",
                             plan_.tilt_deg),
                 error_mm);
        else
            warn(fmt::format("The slices are shifted within their planes by up to {}, unevenly; they are resampled to "
                             "an upright grid.",
                             mm_text(residual_mm + glm::length(slope) * way)),
                 error_mm);
    }

    void lay_planes() {
        if (plan_.order.size() < 2) {
            plan_.planes = {0};
            step_mm_ = lone_step();
            plan_.spacing_min_mm = plan_.spacing_max_mm = step_mm_;
            return;
        }
        plan_.spacing_min_mm = INFINITY;
        for (std::size_t i = 1; i < plan_.order.size(); ++i) {
            const double gap = plan_.along_mm[i] - plan_.along_mm[i - 1];
            plan_.spacing_min_mm = std::min(plan_.spacing_min_mm, gap);
            plan_.spacing_max_mm = std::max(plan_.spacing_max_mm, gap);
        }
        std::vector<std::optional<int>> instances;
        for (const std::size_t s : plan_.order) instances.push_back(slices_[s].instance);
        const StepFit fit = find_step(plan_.along_mm, instances, same_position_mm(slices_.front().spacing));
        if (fit.uniform())
            lay_even(fit);
        else
            lay_uneven();
    }

    void check_plane_count(double planes) {
        const double most = k_most_planes_a_slice * double(plan_.order.size()) + 16;
        if (planes <= most) return;
        std::size_t widest = 1;
        for (std::size_t i = 1; i < plan_.order.size(); ++i)
            if (plan_.along_mm[i] - plan_.along_mm[i - 1] > plan_.along_mm[widest] - plan_.along_mm[widest - 1])
                widest = i;
        throw Error(Errc::bad_input,
                    fmt::format("The slices leave a gap of {} between {} and {}, where their usual step is {}; add the "
                                "missing slices or open the parts one by one.",
                                mm_text(plan_.along_mm[widest] - plan_.along_mm[widest - 1]), name(widest - 1),
                                name(widest), mm_text(usual_gap(plan_.along_mm, 0))));
    }

    void lay_even(const StepFit& fit) {
        check_plane_count(fit.planes.back() + 1);
        plan_.planes = fit.planes;
        step_mm_ = plan_.along_mm.back() / fit.planes.back();
        if (fit.worst_mm > k_exact_share * step_mm_)
            warn(fmt::format("The slices are not quite evenly spaced ({} to {}); an even step of {} is used.",
                             mm_text(plan_.spacing_min_mm), mm_text(plan_.spacing_max_mm), mm_text(step_mm_)),
                 fit.worst_mm);
        double widest = 0;
        for (std::size_t i = 1; i < fit.planes.size(); ++i) {
            const int from = fit.planes[i - 1] + 1, to = fit.planes[i];
            if (from >= to) continue;
            for (int p = from; p < to; ++p) plan_.missing.push_back(p);
            widest = std::max(widest, (to - from + 1) * step_mm_);
            if (!plan_.missing_text.empty()) plan_.missing_text += "; ";
            plan_.missing_text +=
                from + 1 == to ? fmt::format("slice {}", from) : fmt::format("slices {} to {}", from, to - 1);
            plan_.missing_text += fmt::format(" (counted from 0) between {} and {}", name(i - 1), name(i));
        }
        if (plan_.missing.empty()) return;
        warn(fmt::format("{} of {} slices missing, filled by interpolation: {}.", plan_.missing.size(),
                         fit.planes.back() + 1, plan_.missing_text),
             std::floor(widest / step_mm_ / 2 + 1e-6) * step_mm_);
    }

    /// No even step fits: the finest one that occurs, spread so that both ends are met.
    void lay_uneven() {
        const double way = plan_.along_mm.back();
        const double most = k_most_planes_a_slice * double(plan_.order.size());
        const double steps = std::clamp(std::round(way / plan_.spacing_min_mm), 1.0, most);
        step_mm_ = way / steps;
        planes_ = int(steps) + 1;
        double worst = 0;
        std::size_t at = 0;
        for (int p = 0; p < planes_; ++p) {
            const double here = p * step_mm_;
            while (at + 1 < plan_.along_mm.size() && plan_.along_mm[at + 1] <= here) ++at;
            const double after = plan_.along_mm[std::min(at + 1, plan_.along_mm.size() - 1)];
            worst = std::max(worst, std::min(std::abs(here - plan_.along_mm[at]), std::abs(after - here)));
        }
        warn(fmt::format("The slices are unevenly spaced ({} to {}); they are resampled to an even step of {}.",
                         mm_text(plan_.spacing_min_mm), mm_text(plan_.spacing_max_mm), mm_text(step_mm_)),
             worst);
    }

    void finish_grid() {
        GridGeometry& g = plan_.grid;
        g.size = glm::ivec3(size_, plan_.planes.empty() ? planes_ : plan_.planes.back() + 1);
        g.spacing = glm::dvec3(spacing_, step_mm_);
        g.direction = glm::dmat3(row_, column_, normal_);
        g.origin = positions_[plan_.order.front()] - row_ * (plan_.margin_px.x * spacing_.x) -
                   column_ * (plan_.margin_px.y * spacing_.y);
    }

    std::span<const Frame> slices_;
    glm::ivec2 size_;
    std::span<const std::string> names_;
    StackPlan plan_;
    std::vector<glm::dvec3> positions_;
    glm::dvec2 spacing_{1};
    glm::dvec3 row_{1, 0, 0}, column_{0, 1, 0}, normal_{0, 0, 1};
    double step_mm_ = 1, lone_step_mm_ = 0;
    int planes_ = 1;
};

}  // namespace

StackPlan plan_stack(std::span<const Frame> slices, glm::ivec2 size, std::span<const std::string> names) {
    return Planner(slices, size, names).plan();
}

}  // namespace lacuna::dicom
