#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/accuracy/view_facts.h"
#include "core/render/engine.h"

namespace lacuna {

/// What drawing costs on one device, measured there.
struct DeviceCosts {
    std::string device, driver, program;  ///< costs hold for exactly these
    double frame_ms = 0;                  ///< of a frame of next to nothing
    double ray_ns = 0;                    ///< a ray that is led through empty space at once
    double sample_ns = 0;                 ///< a trilinear sample that shows nothing
    double nearest_ns = 0;                ///< a nearest one
    double shown_ns = 0;                  ///< more, where it shows something
    double gradient_ns = 0;               ///< more, where that is shaded
    double read_ns = 0;                   ///< a look-up in a structure
    double sparse_pixel_ns = 0;           ///< a pixel of a sparse picture, less its rays
    friend bool operator==(const DeviceCosts&, const DeviceCosts&) = default;
};

/// Measures a device by eight small pictures of a synthetic volume, about a second once their kernels are compiled.
/// Costs are never below 0. @throws Error(cancelled)
DeviceCosts measure_costs(Engine& engine, const JobContext& job = {});

/// The costs in a line for people.
std::string describe(const DeviceCosts& costs);
/// {"device","driver","program","frame_ms",...}
std::string to_json(const DeviceCosts& costs);
/// @throws Error(bad_input) naming `where` for what is no such object, or has a cost that is not a number of at least 0
DeviceCosts device_costs_from_json(const std::string& json, const std::string& where);

/// The file a device's costs are kept in, in the user's cache folder (ProgramCache::default_folder); empty where there
/// is none.
std::filesystem::path costs_file(const std::string& device);
/// What was kept for this device, driver and program; none where nothing was, or for other versions of them.
std::optional<DeviceCosts> kept_costs(const std::string& device, const std::string& driver);

/// The costs kept for the engine's device, else (or where `anew`) measured now and kept; an unwritable cache is
/// tolerated. None for the reference renderer. @throws Error(cancelled)
std::optional<DeviceCosts> costs_of(Engine& engine, const JobContext& job = {}, bool anew = false);

/// Milliseconds a frame will take, from a view's facts and a device's costs; none for what they say nothing of: the
/// projections' pruning, shear-warp, published leaps. Pure. @param step the facts were measured at
std::optional<double> predicted_ms(const DeviceCosts& costs, const ViewFacts& facts, const Scene& scene,
                                   const Plan& plan, double step);

/// The same for a plan with sparse casting, from the time of the plan without and the share of rays it casts. Pure.
double predicted_sparse_ms(const DeviceCosts& costs, double pixels, double share, double every_pixel_ms);

}  // namespace lacuna
