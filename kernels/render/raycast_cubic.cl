// Isosurface by exact intersection (scene.h, `iso`, refinement `cubic`): every cell between voxels that the kept ray
// crosses is asked for the first root of its cubic, so the sample distance decides nothing but how often the structure
// is asked. With ranges, RayParams holds the merged intervals of values inside the object.
#define LACUNA_SEGMENTS 1
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/classify.clh"
#include "include/shade.clh"
#include "include/gradient.clh"
#include "include/adaptive.clh"
#include "include/cubic.clh"
#include "include/surface.clh"
#include "include/output.clh"
#include "include/launch.clh"

typedef struct {
    VI inside;     // lanes that came in through an open cut and have not left the object yet
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) \
    MASK((cell_class) == ((state)->inside ? (VI)(CELL_ALL) : (VI)(CELL_NONE)))
#include "include/skip.clh"

/// The values at which a ray turns: at or below `low`, at or above `high`.
typedef struct {
    VF low, high;
} Turn;

INLINE Turn turn_of(constant RayParams* p, VF value, VI inside) {
    const VF none = (VF)(INFINITY);
    Turn t = {-none, none};
#if LACUNA_RANGES
    for (int i = 0; i < p->range_count; ++i) {
        const VF lo = (VF)(p->range[i][0]), hi = (VF)(p->range[i][1]);
        VI here = MASK(value >= lo) & MASK(value <= hi);
        // Inside: the first values beyond the interval. Outside: the ends of its neighbours.
        t.low = (inside & here) ? nextafter(lo, -none) : t.low;
        t.high = (inside & here) ? nextafter(hi, none) : t.high;
        t.low = (~inside & MASK(hi < value)) ? max_of(t.low, hi) : t.low;
        t.high = (~inside & MASK(lo > value)) ? min_of(t.high, lo) : t.high;
    }
#else
    t.low = inside ? nextafter((VF)(p->iso), -none) : t.low;
    t.high = inside ? none : (VF)(p->iso);
#endif
    return t;
}

/// First crossing of the plane in front of a cell along one axis, in samples.
INLINE VF plane_ahead(VI cell, VF delta, VF base, VF inverse) {
    return (TO_FLOAT(cell - MASK(delta > (VF)(0.0f))) - base) * inverse;
}
INLINE VI first_cell(VF at, float last) { return TO_INT(clamp_of(floor(at), (VF)(-1.0f), (VF)(last))); }
INLINE VI advanced(VI cell, VI crosses, VF delta, float last) {
    VI next = cell + (crosses & (MASK(delta > (VF)(0.0f)) ? (VI)(1) : (VI)(-1)));
    return min_of_int(max_of_int(next, (VI)(-1)), (VI)((int)last));
}

kernel void raycast_cubic(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                          global float4* restrict out_color, global float* restrict out_depth
                          GRADIENT_FIELD_ARGS STRUCTURE_ARGS COUNTER_ARGS LAUNCH_ARGS) {
    const int x0 = PIXEL_X0, y0 = PIXEL_Y0;
    if (x0 >= p->out_stride || y0 >= p->height) return;
    Rays r = make_rays(p, x0, y0);
    const VF zero = (VF)(0.0f);
    const VI kept = keeps_length(&r), never = (VI)(0x7fffffff);
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)

    VF entry_value = sample_volume(volume, p, ray_at(&r, r.enter));
    VI starts_inside = kept & MASK(iso_measure(p, entry_value) >= zero);
    VI face_hit = starts_inside & MASK(r.entry != (VI)(ENTRY_OPEN));
    Idle state = {starts_inside & ~face_hit};
    Turn turn = turn_of(p, entry_value, state.inside);
    VI fresh = MASK(entry_value != entry_value);   // behind a NaN: the next finite cell starts anew

    // Segment k of a ray is what it keeps of [k, k+1].
    r.first = TO_INT(floor(clamp_of(r.enter, (VF)(-1.0f), (VF)(1.0e9f))));
    r.end = kept ? TO_INT(ceil(clamp_of(r.leave, (VF)(-1.0f), (VF)(1.0e9f)))) : (VI)(-1);
    VI done = face_hit | ~kept, surface_hit = (VI)(0);
    VF hit_at = r.enter;
    int k = min_lane(done ? never : r.first);
    const int end = max_lane(done ? (VI)(-1) : r.end);
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & ~done;
        if (!any_lane(live)) break;
        const Skip skip = next_sample(p, &r, STRUCTURE, &state, k, end, live);
        // What is skipped ends with sample next - 1: between it and the next other cells may lie.
        const int from = skip.next > k ? skip.next - 1 : k, to = max(skip.next, skip.until);
        COUNT(reads += skip.reads; skipped += jumped(&r, live, k, from);)
#if LACUNA_RANGES
        if (from > k) fresh |= live;   // values may have moved from one gap between ranges to another behind a NaN
#endif
        k = to;
        VF t = max_of((VF)((float)from), r.enter), t_end = min_of((VF)((float)to), r.leave);
        VF3 start = ray_at(&r, t);
        VI cx = first_cell(start.x, p->last[0]), cy = first_cell(start.y, p->last[1]), cz = first_cell(start.z, p->last[2]);
        live = ~done & MASK(t < t_end);
        while (any_lane(live)) {
            VF tx = plane_ahead(cx, r.delta.x, r.base.x, r.inverse.x), ty = plane_ahead(cy, r.delta.y, r.base.y, r.inverse.y);
            VF tz = plane_ahead(cz, r.delta.z, r.base.z, r.inverse.z);
            VF t_out = min_of(min_of(tx, ty), min_of(tz, t_end));
            VI crossed = live & MASK(t_out > t);
            if (any_lane(crossed)) {
                CellVoxels cell = load_cell(volume, p, cx, cy, cz);
                COUNT(samples += sum_lanes(counted(crossed));)
                VI usable = crossed & ~cell.bad;
                state.inside &= ~(crossed & cell.bad);
                fresh |= crossed & cell.bad;
                VI worth = usable & (MASK(most_of(&cell) >= turn.high) | MASK(least_of(&cell) <= turn.low) | fresh);
                if (any_lane(worth)) {
                    VF3 at = ray_at(&r, t);
                    VF fx = clamp_of(at.x - TO_FLOAT(cx), zero, (VF)(1.0f)), fy = clamp_of(at.y - TO_FLOAT(cy), zero, (VF)(1.0f));
                    VF fz = clamp_of(at.z - TO_FLOAT(cz), zero, (VF)(1.0f));
                    VI anew = usable & fresh;
                    VF hit = (VF)(INFINITY);
                    if (any_lane(anew)) {
                        Cubic value = cubic_of(&cell, zero, fx, fy, fz, r.delta);
                        VI starts = anew & MASK(iso_measure(p, value.d) >= zero) & ~state.inside;
                        hit = starts ? zero : hit;
                        Turn found = turn_of(p, value.d, state.inside);
                        turn.low = anew ? found.low : turn.low;
                        turn.high = anew ? found.high : turn.high;
                        fresh &= ~anew;
                    }
                    const VF length = t_out - t;
                    if (any_lane(usable & MASK(most_of(&cell) >= turn.high))) {
                        VF reach = MASK(turn.high < (VF)(INFINITY)) ? turn.high : (VF)(3.0e38f);
                        hit = min_of(first_turn(cubic_of(&cell, reach, fx, fy, fz, r.delta), length), hit);
                    }
                    if (any_lane(usable & MASK(least_of(&cell) <= turn.low))) {
                        VF reach = MASK(turn.low > (VF)(-INFINITY)) ? turn.low : (VF)(-3.0e38f);
                        Cubic q = cubic_of(&cell, reach, fx, fy, fz, r.delta);
                        Cubic falling = {-q.a, -q.b, -q.c, -q.d};
                        hit = min_of(first_turn(falling, length), hit);
                    }
                    VI turned = usable & MASK(hit <= length);
                    hit_at = turned ? t + hit : hit_at;
                    surface_hit |= turned;
                    done |= turned;
                }
            }
            cx = advanced(cx, MASK(tx <= t_out), r.delta.x, p->last[0]);
            cy = advanced(cy, MASK(ty <= t_out), r.delta.y, p->last[1]);
            cz = advanced(cz, MASK(tz <= t_out), r.delta.z, p->last[2]);
            t = max_of(t, t_out);
            live &= ~done & MASK(t < t_end);
        }
    }

    VI any_hit = surface_hit | face_hit;
    VF3 c = {zero, zero, zero};
    if (any_lane(any_hit))
        c = surface_color(p, &r, gradient(volume, p, ray_at(&r, hit_at)), any_hit, face_hit, entry_value);
    VF depth = any_hit ? fma(hit_at, (VF)(p->step_mm), r.t0_mm) + p->depth_bias_mm : (VF)(INFINITY);
    store_packet(p, out_color, out_depth, x0, y0, c, any_hit ? (VF)(1.0f) : zero, depth);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
