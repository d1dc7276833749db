// Emission-absorption by pre-integrated segments (scene.h, `ea`, integration `preintegrated`; Engel, Kraus & Ertl 2001):
// between two samples the value is taken to change linearly, and what that segment shows comes from tables over its two
// values (core/render/segment_tables.h).
//   segment_opacity  float a (front, back) pair of nodes: opacity of one step   segment_color  11-11-10 bit colour of it
//   segment_visible  uint a node: visible bins in front of it                   segment_axis   {value of node 0, nodes a unit}
#define LACUNA_SEGMENTS 1
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/classify.clh"
#include "include/shade.clh"
#include "include/gradient.clh"
#include "include/adaptive.clh"
#include "include/output.clh"
#include "include/launch.clh"

typedef struct {
    int unused;
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) MASK((cell_class) == (VI)(CELL_NONE))
#include "include/skip.clh"

#define NODES LACUNA_SEGMENT_NODES

/// Node coordinate of a value, which may lie beyond the table; 0 for NaN.
INLINE VF node_of(global const float* axis, VF value) {
    VF node = (value - axis[0]) * axis[1];
#if LACUNA_VOXEL == 4
    node = MASK(node == node) ? node : (VF)(0.0f);
#endif
    return node;
}

INLINE VF in_table(VF node) { return clamp_of(node, (VF)(0.0f), (VF)((float)(NODES - 1))); }

/// Opacity of a share of the way on which a whole step has `opacity`.
INLINE VF opacity_of_share(VF opacity, VF share) {
    return 1.0f - exp2(share * log2(max_of(1.0f - opacity, (VF)(1e-30f))));
}

/// Opacity of a step and the colour it shows, between the nodes; colours weigh by their opacity.
INLINE VF look_up(global const float* opacities, global const uint* colors, VF front, VF back, VI f, VI b, VF3* color) {
    VI at = f * (VI)(NODES) + b;
    VF tf = front - TO_FLOAT(f), tb = back - TO_FLOAT(b);
    VF w00 = (1.0f - tf) * (1.0f - tb) * gather_float(opacities, at);
    VF w01 = (1.0f - tf) * tb * gather_float(opacities, at + 1);
    VF w10 = tf * (1.0f - tb) * gather_float(opacities, at + (VI)(NODES));
    VF w11 = tf * tb * gather_float(opacities, at + (VI)(NODES + 1));
    VF3 c00 = unpack_color(gather_uint(colors, at)), c01 = unpack_color(gather_uint(colors, at + 1));
    VF3 c10 = unpack_color(gather_uint(colors, at + (VI)(NODES))), c11 = unpack_color(gather_uint(colors, at + (VI)(NODES + 1)));
    VF opacity = w00 + w01 + w10 + w11, share = 1.0f / max_of(opacity, (VF)(1e-20f));
    color->x = (w00 * c00.x + w01 * c01.x + w10 * c10.x + w11 * c11.x) * share;
    color->y = (w00 * c00.y + w01 * c01.y + w10 * c10.y + w11 * c11.y) * share;
    color->z = (w00 * c00.z + w01 * c01.z + w10 * c10.z + w11 * c11.z) * share;
    return opacity;
}

/// Where a segment's values leave the table only a share of its way lies within; before and behind that the value
/// changes, but what it is drawn as does not. @param front, back  nodes as they are; f, b  the same, within the table
INLINE void add_ends(global const float* opacities, global const uint* colors, VF front, VF back, VF f, VF b,
                     VF* opacity, VF3* color) {
    VF way = back - front, inverse = 1.0f / (MASK(way == (VF)(0.0f)) ? (VF)(1.0f) : way);
    VI parted = MASK(f != b);   // wholly beyond: the table's end stands for all of it
    VI at_f = TO_INT(f) * (VI)(NODES + 1), at_b = TO_INT(b) * (VI)(NODES + 1);
    VF within = opacity_of_share(*opacity, (b - f) * inverse);
    VF before = opacity_of_share(gather_float(opacities, at_f), (f - front) * inverse);
    VF behind = opacity_of_share(gather_float(opacities, at_b), (back - b) * inverse);
    VF3 c_f = unpack_color(gather_uint(colors, at_f)), c_b = unpack_color(gather_uint(colors, at_b));
    VF w = (1.0f - before) * within, w_b = (1.0f - before) * (1.0f - within) * behind;
    VF whole = before + w + w_b, share = 1.0f / max_of(whole, (VF)(1e-20f));
    color->x = parted ? (before * c_f.x + w * color->x + w_b * c_b.x) * share : color->x;
    color->y = parted ? (before * c_f.y + w * color->y + w_b * c_b.y) * share : color->y;
    color->z = parted ? (before * c_f.z + w * color->z + w_b * c_b.z) * share : color->z;
    *opacity = parted ? whole : *opacity;
}

kernel void raycast_segments(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                             global const float* restrict lut_opacity, global const uint* restrict lut_color,
                             global float4* restrict out_color, global float* restrict out_depth,
                             global const float* restrict segment_opacity, global const uint* restrict segment_color,
                             global const uint* restrict segment_visible, global const float* restrict segment_axis
                             GRADIENT_FIELD_ARGS STRUCTURE_ARGS COUNTER_ARGS LAUNCH_ARGS) {
    const int x0 = PIXEL_X0, y0 = PIXEL_Y0;
    if (x0 >= p->out_stride || y0 >= p->height) return;
    Rays r = make_rays(p, x0, y0);
    const VF zero = (VF)(0.0f), one = (VF)(1.0f), floor_t = (VF)(p->min_transmittance);
    const VI kept = keeps_length(&r), never = (VI)(0x7fffffff);
    VF3 c = {zero, zero, zero};
    VF clear = one, depth = (VF)(INFINITY);   // clear: transmittance so far
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)

    VI capped = kept & MASK(r.entry == (VI)(ENTRY_CAP));
    if (any_lane(capped)) {
        VF value = sample_volume(volume, p, ray_at(&r, r.enter));
        VI row, inside = in_ranges(p, value, &row);
        VI shown = capped & inside & MASK(gather_float(lut_opacity, lut_index(p, value, row)) > zero);
        VF grey = grey_of(p, value);
        c.x = c.y = c.z = shown ? grey : zero;
        clear = shown ? zero : one;
        depth = shown ? fma(r.enter, (VF)(p->step_mm), r.t0_mm) : depth;
    }

    // Segment k of a ray is what it keeps of [k, k+1].
    r.first = TO_INT(floor(clamp_of(r.enter, (VF)(-1.0f), (VF)(1.0e9f))));
    r.end = kept ? TO_INT(ceil(clamp_of(r.leave, (VF)(-1.0f), (VF)(1.0e9f)))) : (VI)(-1);
    const Idle idle = {0};
    int k = min_lane(kept ? r.first : never), held = -2;   // held: where `front` was taken
    const int end = max_lane(r.end);
    VF front = zero;
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & MASK(clear >= floor_t) & MASK(clear > zero);
        if (!any_lane(live)) break;
        const Skip skip = next_sample(p, &r, STRUCTURE, &idle, k, end, live);
        // What is skipped ends with sample next - 1: between it and the next other cells may lie.
        const int from = skip.next > k ? skip.next - 1 : k, to = min(max(skip.next, skip.until), end);
        COUNT(reads += skip.reads; skipped += jumped(&r, live, k, from);)
        k = to;
        for (int j = from; j < to; ++j) {
            VF a = max_of((VF)((float)j), r.enter), b = min_of((VF)((float)(j + 1)), r.leave);
            VI here = MASK(r.first <= (VI)(j)) & MASK(b > a) & MASK(clear >= floor_t) & MASK(clear > zero);
            if (held != j || any_lane(here & MASK(r.enter > (VF)((float)j)))) {
                front = sample_volume(volume, p, ray_at(&r, a));
                COUNT(samples += sum_lanes(counted(here));)
            }
            VF back = sample_volume(volume, p, ray_at(&r, b));
            COUNT(samples += sum_lanes(counted(here));)
            VF at_front = node_of(segment_axis, front), at_back = node_of(segment_axis, back);
            VF n_front = in_table(at_front), n_back = in_table(at_back);
            VI good = here & MASK(front == front) & MASK(back == back);
            front = back;
            held = j + 1;
            VI i_front = min_of_int(TO_INT(n_front), (VI)(NODES - 2)), i_back = min_of_int(TO_INT(n_back), (VI)(NODES - 2));
            VI bins = gather_uint(segment_visible, max_of_int(i_front, i_back) + 1) -
                      gather_uint(segment_visible, min_of_int(i_front, i_back));
            VI shown = good & MASK(bins > (VI)(0));
            if (!any_lane(shown)) continue;
            VF3 color;
            VF opacity = look_up(segment_opacity, segment_color, n_front, n_back, i_front, i_back, &color);
            if (any_lane(shown & (MASK(at_front != n_front) | MASK(at_back != n_back))))
                add_ends(segment_opacity, segment_color, at_front, at_back, n_front, n_back, &opacity, &color);
            VI cut_short = shown & MASK(b - a < (VF)(0.9999f));
            if (any_lane(cut_short)) {   // the same values over a shorter way: the same extinction a length
                opacity = cut_short ? opacity_of_share(opacity, b - a) : opacity;
            }
            if (p->shading != 0) {
                VF magnitude;
                shade(p, facing(p, &r, gradient(volume, p, ray_at(&r, 0.5f * (a + b))), &magnitude), &color);
            }
            VF weight = shown ? clear * opacity : zero;
            c.x = fma(weight, color.x, c.x);
            c.y = fma(weight, color.y, c.y);
            c.z = fma(weight, color.z, c.z);
            VF left = clear - weight;
            VI half_way = MASK(clear >= (VF)(0.5f)) & MASK(left < (VF)(0.5f));
            depth = half_way ? fma(0.5f * (a + b), (VF)(p->step_mm), r.t0_mm) : depth;
            clear = left;
        }
    }
    store_packet(p, out_color, out_depth, x0, y0, c, one - clear, depth + p->depth_bias_mm);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
