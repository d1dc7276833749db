#pragma once

#include <vector>

#include "core/render/camera.h"

namespace lacuna {

/// The views of a full turn about the vertical axis, evenly spread, the first one as it is. @pre views >= 1
std::vector<Camera> full_turn(const Camera& first, int views);

}  // namespace lacuna
