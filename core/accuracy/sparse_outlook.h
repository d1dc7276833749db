#pragma once

#include <vector>

#include "core/render/frame.h"

namespace lacuna {

/// What sparse casting of a view would come to, told by the whole picture of it: the cast pixels are the picture's own,
/// so which tiles are cast again and how far the others are off need no rendering. Exact where the plan that casts
/// draws this very picture and no effect follows, but for blocks that reach over the right and the lower edge (what is
/// cast beyond them is taken for the last pixel); else an estimate.
class SparseOutlook {
public:
    /// @param k  every k-th pixel is cast, at least 2
    /// @param pixel_mm  of the view; steps in depth are judged as the renderer does
    /// Cost: two passes over the pixels.
    SparseOutlook(const Frame& picture, const glm::dvec3& background, int k, double pixel_mm);

    /// Share of the picture's rays that are cast, the first pass and the tiles cast again.
    double share(double gradient) const;
    /// Largest difference of any channel left, in 1/255; infinite for NaN.
    double error(double gradient) const;
    /// The widest gradient (0..1) whose error is at most this; below 0: none.
    double widest(double error) const;

private:
    struct Tile {
        double difference = 0;  ///< of the corners of the blocks it touches, the largest
        double error = 0;       ///< where it is not cast again
    };
    std::vector<Tile> tiles_;
    double cast_ = 0, pixels_ = 0;
};

}  // namespace lacuna
