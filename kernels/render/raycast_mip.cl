// The maximum-intensity family (scene.h): LACUNA_PROJECTION 0 mip, 1 minip, 2 mean, 3 lmip. Grey through the window or
// the transfer function's colour; a ray without a counted sample leaves the background.
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/carry.clh"
#include "include/classify.clh"
#include "include/adaptive.clh"
#include "include/output.clh"
#include "include/launch.clh"

#define MIP 0
#define MINIP 1
#define MEAN 2
#define LMIP 3

typedef struct {
    VF best;       // largest (smallest) value so far; -inf (+inf) before the first
    VI rising;     // lmip: at or above the threshold, the local maximum not passed yet
    VF threshold;
} Idle;

#if LACUNA_PROJECTION == MINIP
#define CANNOT_WIN(state, s, cell) MASK(cell_least(s, cell) >= (state)->best)
#elif LACUNA_PROJECTION == MEAN
#define CANNOT_WIN(state, s, cell) ((VI)(0))
#elif LACUNA_PROJECTION == LMIP
#define CANNOT_WIN(state, s, cell) lmip_cannot_win(state, cell_most(s, cell))
INLINE VI lmip_cannot_win(const Idle* state, VF largest) {
    return ~state->rising & MASK(largest <= state->best) & MASK(largest < state->threshold);
}
#else
#define CANNOT_WIN(state, s, cell) MASK(cell_most(s, cell) <= (state)->best)
#endif
#define IS_IDLE(state, cell_class, structure, cell) \
    (MASK((cell_class) == (VI)(CELL_NONE)) | CANNOT_WIN(state, structure, cell))
#include "include/skip.clh"
#include "include/beam.clh"

kernel void raycast_mip(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                        global const uint* restrict lut_color,
                        global float4* restrict out_color, global float* restrict out_depth
                        CLASS_ARGS ADAPTIVE_ARGS STRUCTURE_ARGS COUNTER_ARGS CARRY_ARGS LAUNCH_ARGS) {
    const int x0 = PIXEL_X0, y0 = PIXEL_Y0;
    if (x0 >= p->out_stride || y0 >= p->height) return;
    Rays r = CAST_RAYS(p, x0, y0);
    CARRY(if (!meets_brick(&r)) return;)
    const VF zero = (VF)(0.0f);
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)
    ADAPTIVE_STATE
    Idle state = {(VF)(LACUNA_PROJECTION == MINIP ? INFINITY : -INFINITY), (VI)(0), (VF)(p->lmip_threshold)};
    VI best_at = (VI)(0), found = (VI)(0), done = (VI)(0), best_row = (VI)(0);
    VF sum = zero, compensation = zero;   // Kahan: thousands of samples in single precision
    VI counted_samples = (VI)(0);
#if LACUNA_CARRY
    global float* const slot = carry_slot(p, carry, x0, y0);
    if (carry_begun(slot)) {
        found = CARRIED_INT(LOAD_PLANE(slot, 1));
#if LACUNA_PROJECTION == MEAN
        sum = LOAD_PLANE(slot, 2);
        compensation = LOAD_PLANE(slot, 3);
        counted_samples = CARRIED_INT(LOAD_PLANE(slot, 4));
#else
        state.best = LOAD_PLANE(slot, 2);
        best_at = CARRIED_INT(LOAD_PLANE(slot, 3));
        state.rising = CARRIED_INT(LOAD_PLANE(slot, 4));
        done = CARRIED_INT(LOAD_PLANE(slot, 5));
#endif
    }
#endif

    int k = min_lane(MASK(r.end > r.first) ? r.first : (VI)(0x7fffffff));
    const int end = max_lane(r.end);
#if LACUNA_BEAM
    int beam_reads = 0;
    Beam beam;
    make_beam(p, &r, STRUCTURE, k, end, &beam, &beam_reads);
    const VF reach = beam_reach(volume, p, &r, &beam, end);
    COUNT(reads += beam_reads;)
#endif
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & ~done;
        if (!any_lane(live)) break;
#if LACUNA_BEAM
        const Skip skip = beam_next(&beam, state.best, reach, k, end, live);
#else
        const Skip skip = next_sample(p, &r, STRUCTURE, &state, k, end, live);
#endif
        COUNT(reads += skip.reads; skipped += jumped(&r, live, k, skip.next);)
        k = skip.next;
        for (; k < skip.until; ++k) {
            VI here = MASK(r.first <= (VI)(k)) & MASK(r.end > (VI)(k)) & ~done;
            VF3 at = ray_at(&r, (VF)((float)k));
            fetch_ahead(volume, p, &r, at);
            VF value = SEEN(MARCH_SAMPLE(volume, p, at, here), at);
            COUNT(samples += sum_lanes(counted(here));)
            VI row, counts = here & in_ranges(p, value, &row);
#if LACUNA_PROJECTION == MEAN
            VF term = (counts ? value : zero) - compensation;
            VF next = sum + term;
            compensation = (next - sum) - term;
            sum = next;
            counted_samples += counted(counts);
            found |= counts;
#else
#if LACUNA_PROJECTION == LMIP
            VI passed = counts & state.rising & MASK(value < state.best);
            done |= passed;
            counts &= ~passed;
            state.rising |= counts & MASK(value >= state.threshold);
#endif
            VI better = counts & (LACUNA_PROJECTION == MINIP ? MASK(value < state.best) : MASK(value > state.best));
            better |= counts & ~found;
            state.best = better ? value : state.best;
            best_at = better ? (VI)(k) : best_at;
            found |= counts;
#if LACUNA_PROJECTION == LMIP
            if (!any_lane(MASK(r.end > (VI)(k)) & ~done)) break;
#endif
#endif
        }
    }
#if LACUNA_CARRY
    carry_begin(slot);
    STORE_PLANE(slot, 1, AS_FLOAT(found));
#if LACUNA_PROJECTION == MEAN
    STORE_PLANE(slot, 2, sum);
    STORE_PLANE(slot, 3, compensation);
    STORE_PLANE(slot, 4, AS_FLOAT(counted_samples));
#else
    STORE_PLANE(slot, 2, state.best);
    STORE_PLANE(slot, 3, AS_FLOAT(best_at));
    STORE_PLANE(slot, 4, AS_FLOAT(state.rising));
    STORE_PLANE(slot, 5, AS_FLOAT(done));
#endif
#endif
#if LACUNA_PROJECTION == MEAN
    state.best = sum / TO_FLOAT(max_of_int(counted_samples, (VI)(1)));
#endif
    VF grey = grey_of(p, state.best);
    VF3 c = {grey, grey, grey};
    if (p->color_by_tf) {
        in_ranges(p, state.best, &best_row);
        c = unpack_color(gather_uint(lut_color, lut_index(p, state.best, best_row)));
    }
    c.x = found ? c.x : zero;
    c.y = found ? c.y : zero;
    c.z = found ? c.z : zero;
    VF depth = depth_at(p, &r, TO_FLOAT(best_at)) + p->depth_bias_mm;
    depth = (found & (VI)(LACUNA_PROJECTION == MEAN ? 0 : -1)) ? depth : (VF)(INFINITY);
    store_packet(p, out_color, out_depth, x0, y0, c, found ? (VF)(1.0f) : zero, depth);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
