// A brick of a volume that is cast brick by brick (LACUNA_CARRY): its place in the whole.
#ifndef LACUNA_SHARED_BRICK_H
#define LACUNA_SHARED_BRICK_H

#include "shared/base.h"

#define LACUNA_CARRY_PLANES 8   /* numbers carried a ray from brick to brick */

typedef struct {
    s_float shift[3];      // the brick's first stored voxel, in the volume's voxel coordinates
    s_float lo[3], hi[3];  // samples at lo <= position < hi are this brick's; +-3e38 on the volume's own sides
    s_int first_x;         // pixel column at which a launch starts
} BrickParams;
SHARED_CHECK(BrickParams, 40);

#endif
