// Isosurface ray casting (scene.h, `iso`): the first turn of the iso measure, refined in its bracket, one gradient.
// A ray remembers only where it turned; all rays of a packet are refined and shaded together at the end.
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/carry.clh"
#include "include/classify.clh"
#include "include/shade.clh"
#include "include/gradient.clh"
#include "include/adaptive.clh"
#include "include/surface.clh"
#include "include/output.clh"
#include "include/launch.clh"

typedef struct {
    VI inside;     // lanes that came in through an open cut and have not left the object yet
} Idle;
#if LACUNA_CLASSES   /* a hidden voxel ends the object: rays inside it take every sample */
#define IS_IDLE(state, cell_class, structure, cell) (MASK((cell_class) == (VI)(CELL_NONE)) & ~(state)->inside)
#else
#define IS_IDLE(state, cell_class, structure, cell) \
    MASK((cell_class) == ((state)->inside ? (VI)(CELL_ALL) : (VI)(CELL_NONE)))
#endif
#include "include/skip.clh"
#include "include/span.clh"

INLINE VF measure_at(global const voxel_t* volume, constant RayParams* p, const Rays* r, VF k) {
    return iso_measure(p, sample_volume(volume, p, ray_at(r, k)));
}

/// The root of the measure in the bracket [a, b] (fractional samples, measures ga, gb of opposite sign): refine 1
/// bisection, 2 regula falsi with the Illinois modification (Dowell & Jarratt 1971), 3 Newton, 4 regula falsi as published
/// by Lesar (2015), which stalls at one end of a convex stretch.
INLINE VF refine_hit(global const voxel_t* volume, constant RayParams* p, const Rays* r, VF a, VF b, VF ga, VF gb) {
    VF estimate = p->refine == 1 ? 0.5f * (a + b) : b - gb * (b - a) / (gb - ga);
    const VF half_one = (VF)(0.5f);
    const int falsi = p->refine == 2 || p->refine == 4;
    if (falsi && p->refine_steps == 0) return b;
    VI kept = (VI)(0);      // regula falsi: which end stayed last time, -1 a, 1 b
    VI astray = (VI)(0);    // Newton: left the bracket, the midpoint stands
    // The secant above is regula falsi's first estimate: one evaluation less than its steps.
    const int steps = falsi ? p->refine_steps - 1 : p->refine_steps;
    for (int i = 0; i < steps; ++i) {
        if (p->refine == 3) {
            VF width = (VF)(0.1f);
            VF g = measure_at(volume, p, r, estimate);
            VF slope = (measure_at(volume, p, r, estimate + width) - measure_at(volume, p, r, estimate - width)) *
                       (0.5f / 0.1f);
            VF next = estimate - g / slope;
            VI good = MASK(next >= a) & MASK(next <= b);   // false for NaN
            estimate = astray ? estimate : (good ? next : half_one * (a + b));
            astray |= ~good;
            continue;
        }
        VF g = measure_at(volume, p, r, estimate);
        VI with_b = MASK((g >= (VF)(0.0f)) == (gb >= (VF)(0.0f)));
        const VI halves = p->refine == 2 ? (VI)(-1) : (VI)(0);
        ga = (halves & with_b & MASK(kept == (VI)(-1))) ? ga * half_one : ga;
        gb = (halves & ~with_b & MASK(kept == (VI)(1))) ? gb * half_one : gb;
        b = with_b ? estimate : b;
        gb = with_b ? g : gb;
        a = with_b ? a : estimate;
        ga = with_b ? ga : g;
        kept = with_b ? (VI)(-1) : (VI)(1);
        VF secant = b - gb * (b - a) / (gb - ga);
        VI good = MASK(secant >= a) & MASK(secant <= b);
        estimate = falsi ? (good ? secant : half_one * (a + b)) : half_one * (a + b);
    }
    return estimate;
}

kernel void raycast_iso(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                        global float4* restrict out_color, global float* restrict out_depth
                        CLASS_ARGS GRADIENT_FIELD_ARGS ADAPTIVE_ARGS STRUCTURE_ARGS COUNTER_ARGS CARRY_ARGS LAUNCH_ARGS) {
    const int x0 = PIXEL_X0, y0 = PIXEL_Y0;
    if (x0 >= p->out_stride || y0 >= p->height) return;
    SPAN_STATE(p, x0, y0);
    if (MEETS_NOTHING) {
        const VF none = (VF)(0.0f);
        const VF3 black = {none, none, none};
        store_packet(p, out_color, out_depth, x0, y0, black, none, (VF)(INFINITY));
        return;
    }
    Rays r = CAST_RAYS(p, x0, y0);
    CARRY(if (!meets_brick(&r)) return;)
    const VF zero = (VF)(0.0f);
    const VI kept = keeps_length(&r);
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)
    ADAPTIVE_STATE

    // The entry itself: inside the object there, the ray hits the volume's side or the cap, or goes on (open cut).
    // Where the structure knows the entry's cell to be empty no voxel needs to be read.
    VF3 entry_at = ray_at(&r, r.enter);
    VF entry_value = (VF)(-INFINITY);
    if (any_lane(kept & ENTERS_HERE(&r) & ~SURELY_EMPTY(p, &r, STRUCTURE, r.enter)))
        entry_value = SEEN(sample_volume(volume, p, entry_at), entry_at);
    VI starts_inside = kept & ENTERS_HERE(&r) & MASK(iso_measure(p, entry_value) >= zero);
    VI face_hit = starts_inside & MASK(r.entry != (VI)(ENTRY_OPEN));
    Idle state = {starts_inside & ~face_hit};

    VI done = face_hit | ~kept;
#if LACUNA_CARRY
    global float* const slot = carry_slot(p, carry, x0, y0);
    const int begun = carry_begun(slot);
    if (begun) {
        state.inside |= CARRIED_INT(LOAD_PLANE(slot, 1));
        done |= CARRIED_INT(LOAD_PLANE(slot, 2));
    }
#endif
    VI hit_at = (VI)(-1);
    // The measure at the hit and one sample before it, but in `unknown` lanes, whose run of samples began with the hit.
    VF ga = zero, gb = zero;
    VI unknown = (VI)(0);
    COUNT(const VI first_of_all = r.first;)
    NARROW(p, &r);
    COUNT(skipped += sum_lanes((r.first - first_of_all) & MASK(r.first > first_of_all) & ~done);)
    int k = min_lane((MASK(r.end > r.first) & ~done) ? r.first : (VI)(0x7fffffff));
    const int end = max_lane(done ? (VI)(0) : r.end);
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & ~done;
        if (!any_lane(live)) break;
        const Skip skip = next_sample(p, &r, STRUCTURE, &state, k, end, live);
        COUNT(reads += skip.reads; skipped += jumped(&r, live, k, skip.next);)
        k = skip.next;
        VF last = zero;   // the measure at k - 1
        const VI earliest = max_of_int(r.first, (VI)(k));
        for (; k < skip.until; ++k) {
            VI here = MASK(r.first <= (VI)(k)) & MASK(r.end > (VI)(k)) & ~done;
            VF3 sample_at = ray_at(&r, (VF)((float)k));
            fetch_ahead(volume, p, &r, sample_at);
            VF g = SEEN(iso_measure(p, MARCH_SAMPLE(volume, p, sample_at, here)), sample_at);
            COUNT(samples += sum_lanes(counted(here));)
            VI turned = here & ((state.inside & MASK(g < zero)) | (~state.inside & MASK(g >= zero)));
            state.inside &= ~(here & MASK(g != g));   // after a NaN the ray counts as outside
            if (any_lane(turned)) {
                hit_at = turned ? (VI)(k) : hit_at;
                ga = turned ? last : ga;
                gb = turned ? g : gb;
                unknown |= turned & (NEAREST_MAY_SERVE ? (VI)(-1) : MASK(earliest == (VI)(k)));
                done |= turned;
                if (!any_lane(MASK(r.end > (VI)(k)) & ~done)) break;
            }
            last = g;
        }
    }

    COUNT(skipped += LEFT_OFF(~done & r.hits_box);)
    VI surface_hit = MASK(hit_at >= (VI)(0)), any_hit = surface_hit | face_hit;
    VF at = r.enter;
    VF3 c = {zero, zero, zero};
    if (any_lane(surface_hit)) {
        VF b = TO_FLOAT(hit_at);
        VF a = max_of(b - 1.0f, r.enter);
        if (any_lane(unknown)) {
            const VF before = SEEN(measure_at(volume, p, &r, a), ray_at(&r, a));
            ga = unknown ? before : ga;
            if (NEAREST_MAY_SERVE) gb = measure_at(volume, p, &r, b);
        }
        VF estimate = p->refine == 0 ? b : refine_hit(volume, p, &r, a, b, ga, gb);
        at = surface_hit ? (MASK(ga == ga) ? estimate : b) : at;   // no bracket behind a NaN sample
    }
    if (any_lane(any_hit))
        c = surface_color(p, &r, gradient(volume, p, ray_at(&r, at)), any_hit, face_hit, entry_value);
    VF depth = any_hit ? fma(at, (VF)(p->step_mm), r.t0_mm) + p->depth_bias_mm : (VF)(INFINITY);
    VF alpha = any_hit ? (VF)(1.0f) : zero;
#if LACUNA_CARRY
    if (begun) {   // a ray hits in one brick
        c.x = any_hit ? c.x : LOAD_PLANE(slot, 3);
        c.y = any_hit ? c.y : LOAD_PLANE(slot, 4);
        c.z = any_hit ? c.z : LOAD_PLANE(slot, 5);
        alpha = any_hit ? alpha : LOAD_PLANE(slot, 6);
        depth = any_hit ? depth : LOAD_PLANE(slot, 7);
    }
    carry_begin(slot);
    STORE_PLANE(slot, 1, AS_FLOAT(state.inside));
    STORE_PLANE(slot, 2, AS_FLOAT(done));
    STORE_PLANE(slot, 3, c.x);
    STORE_PLANE(slot, 4, c.y);
    STORE_PLANE(slot, 5, c.z);
    STORE_PLANE(slot, 6, alpha);
    STORE_PLANE(slot, 7, depth);
#endif
    store_packet(p, out_color, out_depth, x0, y0, c, alpha, depth);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
