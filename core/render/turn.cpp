#include "core/render/turn.h"

namespace lacuna {

std::vector<Camera> full_turn(const Camera& first, int views) {
    std::vector<Camera> turn;
    for (int i = 0; i < views; ++i) {
        turn.push_back(first);
        turn.back().azimuth_deg += 360.0 * i / views;
    }
    return turn;
}

}  // namespace lacuna
