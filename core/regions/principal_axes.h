#pragma once

#include <glm/glm.hpp>

namespace lacuna {

/// A symmetric 3x3 matrix by its six entries.
struct SymmetricMatrix {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

/// Its eigenvalues, largest first, by Jacobi rotations: full precision for equal and for vanishing ones too.
glm::dvec3 eigenvalues_descending(const SymmetricMatrix& matrix);

}  // namespace lacuna
