// Emission-absorption ray casting (scene.h, `ea`): front to back, opacity corrected for the step, early termination.
//   volume     voxels, x fastest                         lut_opacity  float a table entry: opacity of one step, or with
//   lut_color  11-11-10 bit colour a table entry                      LACUNA_GRADIENT_OPACITY per unit distance
//   gradient_factor  1024 floats a row (only then)       color/depth  see output.clh
//   shapes     see shapes.clh (only with LACUNA_SHAPES, which goes with LACUNA_GRADIENT_OPACITY)
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/carry.clh"
#include "include/classify.clh"
#include "include/shapes.clh"
#include "include/shade.clh"
#include "include/gradient.clh"
#include "include/adaptive.clh"
#include "include/output.clh"
#include "include/launch.clh"
#include "include/ea.clh"

typedef struct {
    int unused;
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) MASK((cell_class) == (VI)(CELL_NONE))
#include "include/skip.clh"
#include "include/span.clh"

kernel void raycast_ea(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                       global const float* restrict lut_opacity, global const uint* restrict lut_color,
                       global float4* restrict out_color, global float* restrict out_depth
                       GRADIENT_ARGS CLASS_ARGS GRADIENT_FIELD_ARGS ADAPTIVE_ARGS STRUCTURE_ARGS COUNTER_ARGS CARRY_ARGS LAUNCH_ARGS) {
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
    const VF zero = (VF)(0.0f), floor_t = (VF)(p->min_transmittance);
    Composite state = nothing_yet();
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)
    ADAPTIVE_STATE
#if LACUNA_CARRY
    global float* const slot = carry_slot(p, carry, x0, y0);
    if (carry_begun(slot)) {
        state.c.x = LOAD_PLANE(slot, 1);
        state.c.y = LOAD_PLANE(slot, 2);
        state.c.z = LOAD_PLANE(slot, 3);
        state.clear = LOAD_PLANE(slot, 4);
        state.depth = LOAD_PLANE(slot, 5);
    }
#endif

    const VI capped = keeps_length(&r) & ENTERS_HERE(&r) & MASK(r.entry == (VI)(ENTRY_CAP));
    if (any_lane(capped)) {
        const VF3 at = ray_at(&r, r.enter);
        const VF value = SEEN(sample_volume(volume, p, at), at);
        add_cap(p, lut_opacity, &r, value, capped, CLASS_ROW((VI)(0), at), &state);
    }

    const Idle idle = {0};
    COUNT(const VI first_of_all = r.first;)
    NARROW(p, &r);
    COUNT(skipped += sum_lanes((r.first - first_of_all) & MASK(r.first > first_of_all));)
    int k = min_lane(MASK(r.end > r.first) ? r.first : (VI)(0x7fffffff));
    const int end = max_lane(r.end);
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & still_clear(&state, floor_t);
        if (!any_lane(live)) break;
        const Skip skip = next_sample(p, &r, STRUCTURE, &idle, k, end, live);
        COUNT(reads += skip.reads; skipped += jumped(&r, live, k, skip.next);)
        k = skip.next;
#if LACUNA_RUNS
        if (skip.run > 1) {
            VF magnitude = zero, cosine = zero;
#if LACUNA_RUN_GRADIENT
            cosine = facing(p, &r, gradient(volume, p, ray_at(&r, (VF)((float)k))), &magnitude);
#endif
            add_run(p, lut_opacity, lut_color, &r, k, min(skip.run, end - k), skip.run_value,
                    CLASS_ROW((VI)(0), ray_at(&r, (VF)((float)k))), magnitude, cosine, floor_t, &state SAMPLE_GRADIENT);
            COUNT(skipped += sum_lanes(counted(live) * max_of_int(min_of_int((VI)(k + skip.run), r.end) - max_of_int((VI)(k), r.first), (VI)(0)));)
            k += skip.run;
            continue;
        }
#endif
        for (; k < skip.until; ++k) {
            VI here = MASK(r.first <= (VI)(k)) & MASK(r.end > (VI)(k)) & still_clear(&state, floor_t);
            VF3 at = ray_at(&r, (VF)((float)k));
            fetch_ahead(volume, p, &r, at);
            VF value = SEEN(MARCH_SAMPLE(volume, p, at, here), at);
            COUNT(samples += sum_lanes(counted(here));)
            const Classified sample = classify(p, lut_opacity, value, here, CLASS_ROW((VI)(0), at));
            if (!any_lane(sample.shown)) continue;
            const VF3 color = unpack_color(gather_uint(lut_color, sample.entry));
            VF magnitude = zero, cosine = zero;
            if (NEEDS_GRADIENT(p)) cosine = facing(p, &r, gradient(volume, p, ray_at(&r, (VF)((float)k))), &magnitude);
            add_sample(p, &r, k, &sample, color, cosine, magnitude, &state SAMPLE_GRADIENT);
            if (!any_lane(MASK(r.end > (VI)(k)) & still_clear(&state, floor_t))) break;
        }
    }
    COUNT(skipped += LEFT_OFF(still_clear(&state, floor_t));)
#if LACUNA_CARRY
    carry_begin(slot);
    STORE_PLANE(slot, 1, state.c.x);
    STORE_PLANE(slot, 2, state.c.y);
    STORE_PLANE(slot, 3, state.c.z);
    STORE_PLANE(slot, 4, state.clear);
    STORE_PLANE(slot, 5, state.depth);
#endif
    store_packet(p, out_color, out_depth, x0, y0, state.c, 1.0f - state.clear, state.depth + p->depth_bias_mm);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
