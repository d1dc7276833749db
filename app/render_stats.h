#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/image_error.h"
#include "core/accuracy/mode_error.h"
#include "core/render/engine.h"

namespace lacuna::cli {

/// What one frame took.
struct FrameRecord {
    double azimuth_deg = 0;
    double ms = 0;  ///< one warm frame, from the call to the pixels on the host
    Counters counters;
};

/// All that --stats writes.
struct RenderRecord {
    std::string device;
    std::map<std::string, BuildRecord> build;
    std::vector<FrameRecord> frames;
    std::optional<BrickCounts> bricks;          ///< of the last frame, where the plan has bricks
    std::optional<ImageError> error;            ///< the worst frame's, when verified
    double error_allowed = 1;                   ///< in 1/255, beyond which its pixels are counted
    std::optional<SurfaceError> surface;        ///< that frame's, iso
    std::optional<ProjectionError> projection;  ///< that frame's, mip, lmip, minip in grey
};

/// The contract's statistics as JSON.
std::string stats_json(const Scene& scene, const Plan& plan, const RenderRecord& record);

/// "max error 0.42/255, mean 0.01/255, PSNR 61.2 dB, SSIM 0.9998, FLIP 0.001, 0 pixels over 1/255; depth ...": over the
/// error budget where there was one.
/// @pre record.error
std::string error_text(const RenderRecord& record);

}  // namespace lacuna::cli
