// Everything a ray-casting kernel needs beside its buffers.
#ifndef LACUNA_SHARED_RAY_PARAMS_H
#define LACUNA_SHARED_RAY_PARAMS_H

#include "shared/base.h"

#define LACUNA_MAX_CUTS 12       /* six planes and the six sides of a box */
#define LACUNA_MAX_RANGES 8
#define LACUNA_MAX_LEVELS 18    /* of a tree over up to 2^17 voxels an axis */
#define LACUNA_MAX_ROWS 9        /* transfer-function rows: the scene's own, then one a segmentation range */

typedef struct {
    // The ray of pixel (x, y) starts at origin + x*origin_dx + y*origin_dy and runs along
    // dir + x*dir_dx + y*dir_dy, normalised in mm. All in voxel coordinates (centres at whole numbers).
    s_float origin[3], origin_dx[3], origin_dy[3];
    s_float dir[3], dir_dx[3], dir_dy[3];
    s_float spacing[3];          // mm per voxel
    s_float t_min_mm;            // rays start here: 0 for perspective, far behind for orthographic
    s_float depth_bias_mm;       // added to a ray parameter to give the depth from the ray's true origin
    s_float step_mm;             // distance between samples

    s_float last[3];             // n - 1: positions are clamped to [0, last]
    s_int size[3];               // voxels stored an axis, at least 2 (a single layer is stored twice)
    s_uint stride_y, stride_z;   // voxels from one row, slice, to the next

    s_int width, height;         // picture, pixels
    s_int out_stride;            // pixels a row in the output buffers, a multiple of the packet's width

    s_int cut_count;
    s_float cut[LACUNA_MAX_CUTS][4];     // keeps a*x + b*y + c*z + d >= 0, voxel coordinates
    s_int cut_cap[LACUNA_MAX_CUTS];      // 1: grey values on the cut face

    s_int range_count;
    s_float range[LACUNA_MAX_RANGES][2]; // closed value ranges that are visible; none: all values
    s_int lut_size;                      // entries a transfer-function row
    s_float lut_scale[LACUNA_MAX_ROWS], lut_lo[LACUNA_MAX_ROWS];   // entry = (value - lo)*scale, clamped
    s_float grad_scale[LACUNA_MAX_ROWS]; // gradient-opacity entry = magnitude*scale, clamped
    s_float exponent[LACUNA_MAX_ROWS];   // step over unit distance: opacity correction when it cannot be tabulated

    s_float iso;
    s_int refine, refine_steps;          // 0 none, 1 bisection, 2 regula falsi (Illinois), 3 Newton, 4 plain
                                         // regula falsi
    s_int shading;                       // 0 none, 1 Lambert, 2 Phong
    s_float surface_color[3];
    s_float min_transmittance;           // EA stops below it
    s_float window_lo, window_scale;     // grey = (value - lo) * scale
    s_int color_by_tf;
    s_float lmip_threshold;

    s_int cells[3];                      // macro-cells an axis
    s_int cell_shift;                    // log2 of voxels a cell edge
    s_float cell_size;                   // the same as a number
    s_float exit_margin;                 // samples closer to a cell's far face than this count as beyond it
    // Trees (octree, pyramid): level 0 is the finest.
    s_int level_base[LACUNA_MAX_LEVELS];     // where a level starts: its first node (octree), its first byte (pyramid)
    s_int level_nodes[LACUNA_MAX_LEVELS][2]; // nodes along x and y stored a level
    s_int top_level;                         // coarsest level worth asking; -1: none is
    s_int cell_gaps;                         // pyramid: a ray can be inside the object, so full cells can be idle too
    // Leaping: samples a unit of a leap value, and samples to leave off; value = leap_lo + code * leap_scale.
    s_int row_count;                         // transfer-function rows beyond the first: ranges, then region classes
    s_float leap_samples, leap_margin, leap_lo, leap_scale;
} RayParams;
SHARED_CHECK(RayParams, 916);

#endif
