#include "core/accuracy/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/accuracy/truth.h"
#include "core/base/deadline.h"
#include "core/base/names.h"
#include "core/base/stopwatch.h"

namespace lacuna {

namespace {

constexpr NameTable<FrontError, 3> k_front_names{
    {{FrontError::max, "max"}, {FrontError::mean, "mean"}, {FrontError::flip, "flip"}}};

// Of the time limit, so much may be over when the reference was held against finer ones, and when all plans were drawn
// for the first time.
constexpr double k_reference_share = 0.3, k_warm_share = 0.6;
constexpr const char* k_no_time = "Not measured: the time set for this run was over.";

/// The q-quantile of values, linear between them.
double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    const double at = q * double(values.size() - 1);
    const auto i = std::size_t(at);
    return i + 1 < values.size() ? std::lerp(values[i], values[i + 1], at - double(i)) : values[i];
}

ImageError worst(const ImageError& a, const ImageError& b) {
    return {a.reference,
            std::max(a.max, b.max),
            std::max(a.mean, b.mean),
            glm::max(a.channel_max, b.channel_max),
            glm::max(a.channel_mean, b.channel_mean),
            std::min(a.psnr, b.psnr),
            std::min(a.ssim, b.ssim),
            std::max(a.flip, b.flip),
            std::max(a.pixels_over_budget, b.pixels_over_budget)};
}

SurfaceError worst(const SurfaceError& a, const SurfaceError& b) {
    return {std::max(a.max_voxels, b.max_voxels),
            std::max(a.mean_voxels, b.mean_voxels),
            std::max(a.rms_voxels, b.rms_voxels),
            std::max(a.both, b.both),
            std::max(a.missed, b.missed),
            std::max(a.false_hits, b.false_hits),
            std::max(a.over_one_voxel, b.over_one_voxel)};
}

ProjectionError worst(const ProjectionError& a, const ProjectionError& b) {
    return {std::max(a.max_undershoot, b.max_undershoot), std::max(a.mean_undershoot, b.mean_undershoot),
            std::max(a.max_overshoot, b.max_overshoot), std::max(a.pixels, b.pixels)};
}

bool projects_extremes(const Scene& scene) {
    return !scene.color_by_tf && scene.effects.empty() &&
           (scene.mode == ViewMode::mip || scene.mode == ViewMode::lmip || scene.mode == ViewMode::minip);
}

class Sweeper {
public:
    Sweeper(Engine& engine, const SweepScene& scene, const SweepOptions& options, const JobContext& job)
        : engine_(engine), scene_(scene), options_(options), job_(job) {}

    SceneResult run() {
        if (scene_.views.empty()) throw Error(Errc::bad_usage, "A sweep needs at least one view.");
        result_.name = scene_.name;
        result_.command = scene_.command;
        std::vector<Candidate> found = candidates(scene_.scene, scene_.step, options_.extent);
        for (const Candidate& candidate : found) {
            SweepPoint& point = result_.points.emplace_back();
            point.plan = candidate.plan;
            point.refused = candidate.refused;
        }
        if (draw_truths(found.front().plan)) {
            measure_reference(found.front().plan.plan, job_.part(0.05, 0.15));
            warm_up(job_.part(0.15, 0.55));
            take_times(job_.part(0.55, 1));
        } else {
            result_.of_reference.unmeasured = k_no_time;
            for (SweepPoint& point : result_.points)
                if (point.refused.empty()) point.refused = k_no_time;
        }
        std::stable_partition(result_.points.begin(), result_.points.end(),
                              [](const SweepPoint& p) { return p.refused.empty(); });
        mark_front(result_.points, options_.front);
        return std::move(result_);
    }

private:
    Scene shown(std::size_t view, ViewMode mode) const {
        Scene scene = scene_.scene;
        scene.camera = scene_.views[view];
        scene.mode = mode;
        return scene;
    }
    RenderResult draw(std::size_t view, const ModePlan& plan, const Deadline& until) {
        return engine_.render(shown(view, plan.mode), plan.plan, {until.token()});
    }
    /// @return seconds from now until this share of the time limit is over
    double left_s(double share) const { return share * options_.time_limit_s - watch_.ms() * 1e-3; }

    /// @return whether the time sufficed for all views
    bool draw_truths(const ModePlan& reference) {
        const Plan& plan = reference.plan;
        result_.reference = fmt::format("structure {}, ert {:g}, step {:g}, sampler {}, on the device measured",
                                        name_of(plan.structure), plan.ert, plan.step, name_of(plan.sampler));
        check(shown(0, scene_.scene.mode));
        const Deadline until(job_.stop, left_s(1));
        try {
            for (std::size_t view = 0; view < scene_.views.size(); ++view) {
                truths_.emplace_back(draw(view, reference, until).frame, scene_.scene.background);
                job_.part(0, 0.05).checkpoint(view + 1, scene_.views.size());
            }
        } catch (const Error& error) {
            if (!until.ended(error)) throw;
            return false;
        }
        return true;
    }

    /// What a view's picture is off by, added to the point.
    void compare_view(SweepPoint& point, std::size_t view, const Frame& frame) const {
        const TruePicture& truth = truths_[view];
        const Scene& scene = scene_.scene;
        ImageError error = truth.compare(frame);
        error.reference = result_.reference;
        point.error = view == 0 ? error : worst(point.error, error);
        if (scene.mode == ViewMode::iso && point.plan.mode == ViewMode::iso) {
            const SurfaceError surface =
                compare_surfaces(frame, truth.frame(), scene.volume.geometry().smallest_spacing_mm());
            point.surface = point.surface ? worst(*point.surface, surface) : surface;
        }
        if (projects_extremes(scene)) {
            const ProjectionError projection =
                compare_projections(frame, truth.frame(), scene.window, scene.mode == ViewMode::minip);
            point.projection = point.projection ? worst(*point.projection, projection) : projection;
        }
    }

    void warm_up(const JobContext& job) {
        const Deadline until(job_.stop, left_s(k_warm_share));
        std::size_t done = 0;
        for (SweepPoint& point : result_.points) {
            job.checkpoint(done++, result_.points.size());
            if (!point.refused.empty()) continue;
            try {
                engine_.drop_caches();
                for (std::size_t view = 0; view < scene_.views.size(); ++view) {
                    const RenderResult drawn = draw(view, point.plan, until);
                    std::size_t bytes = 0;  // held now: other views may have added to a structure
                    for (const auto& [name, made] : drawn.build) {
                        point.build_ms += made.ms;
                        bytes += made.bytes;
                    }
                    point.bytes = std::max(point.bytes, bytes);
                    compare_view(point, view, drawn.frame);
                }
            } catch (const Error& error) {
                if (error.code() == Errc::cancelled && !until.ended(error)) throw;
                point.refused = until.ended(error) ? k_no_time : error.what();
            }
        }
    }

    /// One visit: the mean time of the views, after an untimed frame.
    double visit(const ModePlan& plan, const Deadline& until) {
        draw(0, plan, until);
        double sum = 0;
        for (std::size_t view = 0; view < scene_.views.size(); ++view) sum += draw(view, plan, until).frame.ms;
        return sum / double(scene_.views.size());
    }

    void take_times(const JobContext& job) {
        std::vector<SweepPoint*> measured;
        for (SweepPoint& point : result_.points)
            if (point.refused.empty()) measured.push_back(&point);
        std::vector<std::vector<double>> times(measured.size());
        const std::size_t total = measured.size() * std::size_t(options_.rounds);
        const Deadline until(job_.stop, left_s(1));
        try {
            for (std::size_t done = 0; done < total; ++done) {
                const std::size_t round = done / measured.size(), k = done % measured.size();
                const std::size_t i = round % 2 ? measured.size() - 1 - k : k;
                times[i].push_back(visit(measured[i]->plan, until));
                job.checkpoint(done + 1, total);
            }
        } catch (const Error& error) {
            if (!until.ended(error)) throw;
        }
        result_.rounds = measured.empty() ? 0 : options_.rounds;
        for (std::size_t i = 0; i < measured.size(); ++i) {
            result_.rounds = std::min(result_.rounds, int(times[i].size()));
            SweepPoint& point = *measured[i];
            if (times[i].empty()) {
                point.refused = k_no_time;
                continue;
            }
            point.ms = quantile(times[i], 0.5);
            point.ms_low = quantile(times[i], 0.25);
            point.ms_high = quantile(times[i], 0.75);
        }
    }

    /// The reference's own errors, on a picture small enough that the finest step costs seconds.
    void measure_reference(const Plan& plan, const JobContext& job) {
        if (scene_.scene.mode == ViewMode::shear_warp) return;
        const Deadline until(job_.stop, left_s(k_reference_share));
        try {
            hold_reference(plan, {until.token(), job.progress});
        } catch (const Error& error) {
            if (!until.ended(error)) throw;
            result_.of_reference.unmeasured = k_no_time;
        }
    }

    void hold_reference(const Plan& plan, const JobContext& job) {
        const ViewMode mode = scene_.scene.mode;
        Scene small = shown(0, mode);
        // Where time is short it is for the plans.
        const int smaller = options_.extent == SweepExtent::quick || std::isfinite(options_.time_limit_s) ? 8 : 4;
        small.size = glm::max(small.size / smaller, glm::min(small.size, glm::ivec2(48)));
        ReferenceErrors& errors = result_.of_reference;
        errors.size = small.size;
        const Frame frame = engine_.render(small, plan, {job.stop}).frame;
        const auto against = [&](Truth truth, const AnalyticSample* sample, const JobContext& part) {
            const TrueFrame made = render_truth(truth, small, plan, sample, part);
            ImageError error = compare(frame, made.frame, small.background);
            error.reference = made.reference;
            if (truth == Truth::closed_form && mode == ViewMode::iso)
                errors.closed_form_surface =
                    compare_surfaces(frame, made.frame, small.volume.geometry().smallest_spacing_mm());
            return made.has_colors ? std::optional(error) : std::nullopt;
        };
        errors.device = against(Truth::samples, nullptr, job.part(0, 0.1));
        errors.fine = against(Truth::fine, nullptr, job.part(0.1, 0.6));
        if (!scene_.sample || !options_.closed_form) return;
        try {
            const AnalyticSample sample = scene_.sample(job.part(0.6, 0.8));
            errors.closed_form = against(Truth::closed_form, &sample, job.part(0.8, 1));
        } catch (const Error& error) {
            if (error.code() != Errc::unsupported) throw;  // this mode has none
        }
    }

    Engine& engine_;
    const SweepScene& scene_;
    const SweepOptions& options_;
    const JobContext& job_;
    const Stopwatch watch_;
    std::deque<TruePicture> truths_;  // by view
    SceneResult result_;
};

}  // namespace

std::string_view name_of(FrontError error) { return name_in(k_front_names, error); }
FrontError parse_front_error(std::string_view text) { return parse_name(k_front_names, text, "error measure"); }

SceneResult sweep(Engine& engine, const SweepScene& scene, const SweepOptions& options, const JobContext& job) {
    return Sweeper(engine, scene, options, job).run();
}

double front_error(const SweepPoint& point, FrontError error) {
    switch (error) {
        case FrontError::mean:
            return point.error.mean;
        case FrontError::flip:
            return point.error.flip;
        case FrontError::max:
            break;
    }
    return point.error.max;
}

void mark_front(std::vector<SweepPoint>& points, FrontError error) {
    std::vector<SweepPoint*> order;
    for (SweepPoint& point : points) {
        point.on_front = false;
        if (point.refused.empty() && std::isfinite(front_error(point, error)) && std::isfinite(point.ms))
            order.push_back(&point);
    }
    std::sort(order.begin(), order.end(), [&](const SweepPoint* a, const SweepPoint* b) {
        const double ea = front_error(*a, error), eb = front_error(*b, error);
        return ea != eb ? ea < eb : a->ms < b->ms;
    });
    const SweepPoint* fastest = nullptr;
    for (SweepPoint* point : order) {
        const bool alike =
            fastest && point->ms == fastest->ms && front_error(*point, error) == front_error(*fastest, error);
        point->on_front = !fastest || point->ms < fastest->ms || alike;
        if (point->on_front) fastest = point;
    }
}

}  // namespace lacuna
