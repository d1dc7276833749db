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

typedef struct {
    int unused;
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) MASK((cell_class) == (VI)(CELL_NONE))
#include "include/skip.clh"
#include "include/span.clh"

#if LACUNA_GRADIENT_OPACITY
#define GRADIENT_ARGS , global const float* restrict gradient_factor SHAPE_ARGS
/// Opacity of one step from that per unit distance and the gradient's factor: 1-(1-a f)^(step/unit).
INLINE VF faded(constant RayParams* p, global const float* factors, VF opacity, VF magnitude, VI row) {
    VF scale = (VF)(p->grad_scale[0]), exponent = (VF)(p->exponent[0]);
    for (int i = 1; i <= p->row_count; ++i) {
        VI mine = MASK(row == (VI)(i));
        scale = mine ? (VF)(p->grad_scale[i]) : scale;
        exponent = mine ? (VF)(p->exponent[i]) : exponent;
    }
    VF entry = min_of(magnitude * scale, (VF)(1023.0f));
    entry = MASK(entry == entry) ? entry : (VF)(0.0f);
    VF clear = 1.0f - opacity * gather_float(factors, row * (VI)(1024) + TO_INT(entry + 0.5f));
    return 1.0f - exp2(exponent * log2(max_of(clear, (VF)(1e-30f))));
}
#else
#define GRADIENT_ARGS
#endif

#if LACUNA_RUNS
#if LACUNA_GRADIENT_OPACITY
#if LACUNA_SHAPES
#define RUN_GRADIENT_ARG , global const float* gradient_factor, global const float* shapes
#define RUN_GRADIENT , gradient_factor, shapes
#else
#define RUN_GRADIENT_ARG , global const float* gradient_factor
#define RUN_GRADIENT , gradient_factor
#endif
#else
#define RUN_GRADIENT_ARG
#define RUN_GRADIENT
#endif
/// Composites a homogeneous run, samples k .. k+count-1 of one value, in one step: A = 1-(1-a)^n, C = c A (Es et al.
/// 2006). The gradient inside is that at the run's first sample with LACUNA_RUN_GRADIENT, else zero. A lane takes part with those of its own samples that lie in the run, and stops,
/// as sample by sample, at the first one behind which it is opaque enough.
INLINE void add_run(constant RayParams* p, global const float* lut_opacity, global const uint* lut_color, const Rays* r,
                    int k, int count, VF value, VI class_row, VF magnitude, VF cosine, VF floor_t, VF3* c, VF* clear,
                    VF* depth RUN_GRADIENT_ARG) {
    const VF zero = (VF)(0.0f);
    VI row, inside = in_ranges(p, value, &row);
#if LACUNA_CLASSES
    row = MASK(class_row != (VI)(0)) ? class_row : row;
#endif
    VI entry = lut_index(p, value, row);
    VF opacity = gather_float(lut_opacity, entry);
    VF3 color = unpack_color(gather_uint(lut_color, entry));
#if LACUNA_GRADIENT_OPACITY
    BY_SHAPES(value, magnitude, row, &opacity, &color);
    opacity = faded(p, gradient_factor, opacity, magnitude, row);
#endif
    VI first = max_of_int(r->first, (VI)(k)), samples = min_of_int(r->end, (VI)(k + count)) - first;
    VI shown = inside & MASK(opacity > zero) & MASK(samples > (VI)(0)) & MASK(*clear >= floor_t) & MASK(*clear > zero);
    if (!any_lane(shown)) return;
    shade(p, cosine, &color);
    VF per_sample = log2(max_of(1.0f - opacity, (VF)(1e-30f)));
    VF n = TO_FLOAT(samples);
    // The sample at which transmittance first falls below the limit is still added; those behind it are not.
    VF limit = max_of(floor_t, (VF)(1e-30f));
    VF last = floor(log2(limit / *clear) / per_sample) + 1.0f;
    n = min_of(max_of(last, (VF)(1.0f)), n);
    VF left = *clear * exp2(n * per_sample);
    VF half_way = ceil(log2(0.5f / *clear) / per_sample);   // samples until opacity exceeds 1/2
    half_way = MASK(exp2(half_way * per_sample) * *clear < (VF)(0.5f)) ? half_way : half_way + 1.0f;
    VI crosses = shown & MASK(*clear >= (VF)(0.5f)) & MASK(left < (VF)(0.5f));
    *depth = crosses ? fma(TO_FLOAT(first) + half_way - 1.0f, (VF)(p->step_mm), r->t0_mm) : *depth;
    VF weight = shown ? *clear - left : zero;
    c->x = fma(weight, color.x, c->x);
    c->y = fma(weight, color.y, c->y);
    c->z = fma(weight, color.z, c->z);
    *clear = shown ? left : *clear;
}
#endif

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
    const VF zero = (VF)(0.0f), one = (VF)(1.0f), floor_t = (VF)(p->min_transmittance);
    VF3 c = {zero, zero, zero};
    VF clear = one, depth = (VF)(INFINITY);   // clear: transmittance so far
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)
    ADAPTIVE_STATE
#if LACUNA_CARRY
    global float* const slot = carry_slot(p, carry, x0, y0);
    if (carry_begun(slot)) {
        c.x = LOAD_PLANE(slot, 1);
        c.y = LOAD_PLANE(slot, 2);
        c.z = LOAD_PLANE(slot, 3);
        clear = LOAD_PLANE(slot, 4);
        depth = LOAD_PLANE(slot, 5);
    }
#endif

    VI capped = keeps_length(&r) & ENTERS_HERE(&r) & MASK(r.entry == (VI)(ENTRY_CAP));
    if (any_lane(capped)) {
        VF3 at = ray_at(&r, r.enter);
        VF value = SEEN(sample_volume(volume, p, at), at);
        VI row, inside = in_ranges(p, value, &row);
        row = CLASS_ROW(row, at);
        VI shown = capped & inside & MASK(gather_float(lut_opacity, lut_index(p, value, row)) > zero);
        VF grey = grey_of(p, value);
        c.x = shown ? grey : c.x;
        c.y = shown ? grey : c.y;
        c.z = shown ? grey : c.z;
        clear = shown ? zero : clear;
        depth = shown ? fma(r.enter, (VF)(p->step_mm), r.t0_mm) : depth;
    }

    const Idle idle = {0};
    COUNT(const VI first_of_all = r.first;)
    NARROW(p, &r);
    COUNT(skipped += sum_lanes((r.first - first_of_all) & MASK(r.first > first_of_all));)
    int k = min_lane(MASK(r.end > r.first) ? r.first : (VI)(0x7fffffff));
    const int end = max_lane(r.end);
    while (k < end) {
        VI live = MASK(r.end > (VI)(k)) & MASK(clear >= floor_t) & MASK(clear > zero);
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
                    CLASS_ROW((VI)(0), ray_at(&r, (VF)((float)k))), magnitude, cosine, floor_t,
                    &c, &clear, &depth RUN_GRADIENT);
            COUNT(skipped += sum_lanes(counted(live) * max_of_int(min_of_int((VI)(k + skip.run), r.end) - max_of_int((VI)(k), r.first), (VI)(0)));)
            k += skip.run;
            continue;
        }
#endif
        for (; k < skip.until; ++k) {
            VI here = MASK(r.first <= (VI)(k)) & MASK(r.end > (VI)(k)) & MASK(clear >= floor_t) & MASK(clear > zero);
            VF3 at = ray_at(&r, (VF)((float)k));
            fetch_ahead(volume, p, &r, at);
            VF value = SEEN(MARCH_SAMPLE(volume, p, at, here), at);
            COUNT(samples += sum_lanes(counted(here));)
            VI row, inside = in_ranges(p, value, &row);
            row = CLASS_ROW(row, at);
            VI entry = lut_index(p, value, row);
            VF opacity = gather_float(lut_opacity, entry);
            VI shown = here & inside & MASK(opacity > zero);
            if (!any_lane(shown)) continue;
            VF3 color = unpack_color(gather_uint(lut_color, entry));
#if LACUNA_GRADIENT_OPACITY
            VF magnitude, cosine = facing(p, &r, gradient(volume, p, ray_at(&r, (VF)((float)k))), &magnitude);
            BY_SHAPES(value, magnitude, row, &opacity, &color);
            opacity = faded(p, gradient_factor, opacity, magnitude, row);
            shade(p, cosine, &color);
#else
            if (p->shading != 0) {
                VF magnitude;
                shade(p, facing(p, &r, gradient(volume, p, ray_at(&r, (VF)((float)k))), &magnitude), &color);
            }
#endif
            VF weight = shown ? clear * opacity : zero;
            c.x = fma(weight, color.x, c.x);
            c.y = fma(weight, color.y, c.y);
            c.z = fma(weight, color.z, c.z);
            VF left = clear - weight;
            VI half_way = MASK(clear >= (VF)(0.5f)) & MASK(left < (VF)(0.5f));
            depth = half_way ? fma((VF)((float)k), (VF)(p->step_mm), r.t0_mm) : depth;
            clear = left;
            if (!any_lane(MASK(r.end > (VI)(k)) & MASK(clear >= floor_t) & MASK(clear > zero))) break;
        }
    }
    COUNT(skipped += LEFT_OFF(MASK(clear >= floor_t) & MASK(clear > zero));)
#if LACUNA_CARRY
    carry_begin(slot);
    STORE_PLANE(slot, 1, c.x);
    STORE_PLANE(slot, 2, c.y);
    STORE_PLANE(slot, 3, c.z);
    STORE_PLANE(slot, 4, clear);
    STORE_PLANE(slot, 5, depth);
#endif
    store_packet(p, out_color, out_depth, x0, y0, c, one - clear, depth + p->depth_bias_mm);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
