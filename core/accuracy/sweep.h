#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/candidates.h"
#include "core/accuracy/image_error.h"
#include "core/accuracy/mode_error.h"
#include "core/render/engine.h"
#include "core/volume/samples.h"

namespace lacuna {

/// What a sweep draws again and again.
struct SweepScene {
    std::string name;
    Scene scene;                ///< its camera is replaced by each of the views
    std::vector<Camera> views;  ///< at least one
    double step = 0.5;          ///< of the reference, in smallest voxel spacings
    std::string command = {};   ///< what renders the first view, for the record
    /// Makes the built-in sample the volume is, for its closed form; null where it is none.
    std::function<AnalyticSample(const JobContext&)> sample = nullptr;
};

/// Which error the Pareto front weighs against time.
enum class FrontError { max, mean, flip };
std::string_view name_of(FrontError error);
/// @throws Error(bad_usage) listing the known names
FrontError parse_front_error(std::string_view text);

struct SweepOptions {
    SweepExtent extent = SweepExtent::full;
    int rounds = 5;  ///< times every plan is measured, all in turn
    double time_limit_s =
        std::numeric_limits<double>::infinity();  ///< what is not measured by then is left in its middle and says so
    FrontError front = FrontError::max;
    bool closed_form = true;  ///< hold the reference against a sample's formula, too; seconds a scene
};

/// One plan measured on one scene, or the reason why not.
struct SweepPoint {
    ModePlan plan;
    std::string refused = {};                        ///< empty: measured
    double ms = 0;                                   ///< a frame: mean over the views, median over the rounds
    double ms_low = 0, ms_high = 0;                  ///< quartiles over the rounds
    double build_ms = 0;                             ///< all structures, from nothing
    std::size_t bytes = 0;                           ///< they hold after the view that needs most
    ImageError error;                                ///< of the worst view, number by number
    std::optional<SurfaceError> surface = {};        ///< iso, likewise
    std::optional<ProjectionError> projection = {};  ///< mip, lmip, minip, likewise
    bool on_front = false;  ///< no other plan is both as fast and as exact, one of them strictly more
};

/// How wrong the reference of a scene is itself, on a smaller picture of the first view.
struct ReferenceErrors {
    glm::ivec2 size{0};
    std::optional<ImageError> device;       ///< against the same samples in double precision
    std::optional<ImageError> fine;         ///< against a 16 times finer step in double precision
    std::optional<ImageError> closed_form;  ///< against the sample's formula; none where it has no colours
    std::optional<SurfaceError> closed_form_surface;
    std::string unmeasured =
        {};  ///< why what is missing above was not measured, where that is not for want of a formula
};

struct SceneResult {
    std::string name, reference, command;
    ReferenceErrors of_reference;
    std::vector<SweepPoint> points;  ///< the reference first; refused ones last
    int rounds = 0;                  ///< finished
};

/// Measures a scene's candidates. Each is first drawn from nothing (for the build, the error and to warm up); then
/// all are timed in turn, forth and back, one untimed frame before each visit's timed ones, so that a machine whose
/// speed wanders favours none.
/// @throws Error(cancelled); Error(bad_usage) for a scene without views or that cannot be drawn
SceneResult sweep(Engine& engine, const SweepScene& scene, const SweepOptions& options, const JobContext& job = {});

/// The error of a point that the front weighs.
double front_error(const SweepPoint& point, FrontError error);
/// Marks the points no other beats; refused ones and those whose error or time is not finite never are.
void mark_front(std::vector<SweepPoint>& points, FrontError error);

}  // namespace lacuna
