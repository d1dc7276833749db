// The leaping kernel of Frey & Ertl 2009: emission-absorption of a 16-bit volume of densities and leap voxels, one
// nearest look-up a step; every ray leaps on its own. Trilinear outside of regions, one colour over the whole length of
// a leap, cut off at the ray's end. No shading.
//   LACUNA_LEAPING 1  confirmed: only a top bit, of the nearest voxel or in the trilinear neighbourhood, says "region"
//   2  published: two consecutive equal samples do; from then on nearest, until a look-up differs
//   LACUNA_LEAP_NAN 1: the density 32767 is NaN
//   leap_volume  u16, see core/accel/leap_volume.h; RayParams.cells its size         lut_*, out_*  as raycast_ea.cl
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/classify.clh"
#include "include/output.clh"
#include "include/launch.clh"

#define LEAP_BIT ((VI)(0x8000))
#define LEAP_LENGTH ((VI)(0x7fff))
#define UNKNOWN ((VF)(-1.0f))    /* no density has this code */

INLINE VI nearest_entry(global const ushort* entries, constant RayParams* p, VF3 at) {
    at = clamp_position(p, at);
    VI index = (TO_INT(at.z + 0.5f) * (VI)(p->cells[1]) + TO_INT(at.y + 0.5f)) * (VI)(p->cells[0]) +
               TO_INT(at.x + 0.5f);
#define LOAD(s) (int)*BYTES_AT(ushort, entries, index, s)
    return (VI)(EACH_LANE(LOAD));
#undef LOAD
}

/// Samples the value of a leap voxel is good for, the one at hand included.
INLINE VI leap_samples(constant RayParams* p, VI entry) {
    return (VI)(1) + TO_INT(TO_FLOAT(entry & LEAP_LENGTH) * p->leap_samples);
}

/// Two neighbours along x, mixed; *bits gathers what either holds.
INLINE VF mixed_pair(global const ushort* entries, VI index, VF t, VI wide, VI* bits, VI* bad) {
#define LOAD(s) as_int(vload2(0, BYTES_AT(ushort, entries, index, s)))
    VI pair = (VI)(EACH_LANE(LOAD));
#undef LOAD
    VI lo = pair & (VI)(0xffff), hi = wide ? (pair >> 16) & (VI)(0xffff) : lo;
    *bits |= lo | hi;
#if LACUNA_LEAP_NAN
    *bad |= MASK(lo == LEAP_LENGTH) | MASK(hi == LEAP_LENGTH);
#endif
    return mix_of(TO_FLOAT(lo), TO_FLOAT(hi), t);
}

/// Trilinear density (a code), NaN where one of the eight is; *leaps: lanes whose neighbourhood holds a leap voxel.
INLINE VF trilinear_code(global const ushort* entries, constant RayParams* p, VF3 at, VI* leaps) {
    at = clamp_position(p, at);
    const int nx = p->cells[0], ny = p->cells[1], nz = p->cells[2];
    VI x = min_of_int(TO_INT(at.x), (VI)(max(nx - 2, 0))), y = min_of_int(TO_INT(at.y), (VI)(max(ny - 2, 0)));
    VI z = min_of_int(TO_INT(at.z), (VI)(max(nz - 2, 0)));
    VF fx = at.x - TO_FLOAT(x), fy = at.y - TO_FLOAT(y), fz = at.z - TO_FLOAT(z);
    VI index = (z * (VI)(ny) + y) * (VI)(nx) + x;
    const int sy = ny > 1 ? nx : 0, sz = nz > 1 ? nx * ny : 0;
    const VI wide = (VI)(nx > 1 ? -1 : 0);
    VI bits = (VI)(0), bad = (VI)(0);
    VF a = mixed_pair(entries, index, fx, wide, &bits, &bad);
    VF b = mixed_pair(entries, index + (VI)(sy), fx, wide, &bits, &bad);
    VF c = mixed_pair(entries, index + (VI)(sz), fx, wide, &bits, &bad);
    VF d = mixed_pair(entries, index + (VI)(sz + sy), fx, wide, &bits, &bad);
    *leaps = MASK((bits & LEAP_BIT) != (VI)(0));
    VF code = mix_of(mix_of(a, b, fy), mix_of(c, d, fy), fz);
#if LACUNA_LEAP_NAN
    code = bad ? (VF)(NAN) : code;
#endif
    return code;
}

/// The density of the region in which the lanes of `who` stand at fractional sample k: that of the first guard ahead.
/// Needed only where a ray begins inside a region (a cut, an eye in the volume): all others met a guard before.
INLINE VF guard_ahead(global const ushort* entries, constant RayParams* p, const Rays* r, VF k, VI who) {
    VF code = UNKNOWN;
    while (any_lane(who)) {
        VI entry = nearest_entry(entries, p, ray_at(r, k));
        VI guard = who & MASK((entry & LEAP_BIT) == (VI)(0));
        code = guard ? TO_FLOAT(entry) : code;
        who &= ~guard;
        k += TO_FLOAT(leap_samples(p, entry));   // beyond the volume positions are clamped to its border: guards
    }
    return code;
}

/// Composites `count` samples of one value from sample k on: A = 1-(1-a)^n, C = c A; stops as sample by sample would.
INLINE void add_samples(constant RayParams* p, global const float* lut_opacity, global const uint* lut_color,
                        const Rays* r, VI k, VI count, VF code, VI here, VF floor_t, VF3* c, VF* clear, VF* depth) {
    VF value = fma(code, (VF)(p->leap_scale), (VF)(p->leap_lo));
    VI row, inside = in_ranges(p, value, &row);
#if LACUNA_LEAP_NAN
    inside &= MASK(code == code);
#endif
    VI entry = lut_index(p, value, row);
    VF opacity = gather_float(lut_opacity, entry);
    VI shown = here & inside & MASK(opacity > (VF)(0.0f));
    if (!any_lane(shown)) return;
    VF3 color = unpack_color(gather_uint(lut_color, entry));
    VF left = *clear - *clear * opacity, half_way = (VF)(1.0f);
    VI many = shown & MASK(count > (VI)(1));
    if (any_lane(many)) {
        VF per_sample = log2(max_of(1.0f - opacity, (VF)(1e-30f))), n = TO_FLOAT(count);
        VF last = floor(log2(max_of(floor_t, (VF)(1e-30f)) / *clear) / per_sample) + 1.0f;
        n = min_of(max_of(last, (VF)(1.0f)), n);
        left = many ? *clear * exp2(n * per_sample) : left;
        VF half_at = ceil(log2(0.5f / *clear) / per_sample);
        half_at = MASK(exp2(half_at * per_sample) * *clear < (VF)(0.5f)) ? half_at : half_at + 1.0f;
        half_way = many ? half_at : half_way;
    }
    VI crosses = shown & MASK(*clear >= (VF)(0.5f)) & MASK(left < (VF)(0.5f));
    *depth = crosses ? fma(TO_FLOAT(k) + half_way - 1.0f, (VF)(p->step_mm), r->t0_mm) : *depth;
    VF weight = shown ? *clear - left : (VF)(0.0f);
    c->x = fma(weight, color.x, c->x);
    c->y = fma(weight, color.y, c->y);
    c->z = fma(weight, color.z, c->z);
    *clear = shown ? left : *clear;
}

kernel void raycast_leap(global const ushort* restrict leap_volume, constant RayParams* p, const int first_row,
                         global const float* restrict lut_opacity, global const uint* restrict lut_color,
                         global float4* restrict out_color, global float* restrict out_depth
                         COUNTER_ARGS LAUNCH_ARGS) {
    const int x0 = PIXEL_X0, y0 = PIXEL_Y0;
    if (x0 >= p->out_stride || y0 >= p->height) return;
    Rays r = make_rays(p, x0, y0);
    const VF zero = (VF)(0.0f), one = (VF)(1.0f), floor_t = (VF)(p->min_transmittance);
    VF3 c = {zero, zero, zero};
    VF clear = one, depth = (VF)(INFINITY);
    COUNT(uint samples = 0; uint skipped = 0; uint reads = 0;)

    VI capped = keeps_length(&r) & MASK(r.entry == (VI)(ENTRY_CAP));
    if (any_lane(capped)) {
        VI among;
        VF code = trilinear_code(leap_volume, p, ray_at(&r, r.enter), &among);
        among &= capped;
        if (any_lane(among)) code = among ? guard_ahead(leap_volume, p, &r, r.enter, among) : code;
        VF value = fma(code, (VF)(p->leap_scale), (VF)(p->leap_lo));
        VI row, inside = in_ranges(p, value, &row) & MASK(code == code);
        VI shown = capped & inside & MASK(gather_float(lut_opacity, lut_index(p, value, row)) > zero);
        VF grey = grey_of(p, value);
        c.x = c.y = c.z = shown ? grey : zero;
        clear = shown ? zero : one;
        depth = shown ? fma(r.enter, (VF)(p->step_mm), r.t0_mm) : depth;
    }

    VI k = r.first;
    VF code = UNKNOWN;        // of the sample before
    VI settled = (VI)(0);     // published: in a region, or fooled
    for (;;) {
        VI live = MASK(r.end > k) & MASK(clear >= floor_t) & MASK(clear > zero);
        if (!any_lane(live)) break;
        VF3 at = ray_at(&r, TO_FLOAT(k));
        VI entry = nearest_entry(leap_volume, p, at);
        COUNT(reads += sum_lanes(counted(live));)
        VI leaps = live & MASK((entry & LEAP_BIT) != (VI)(0)), known = leaps;
#if LACUNA_LEAPING == 2
        settled &= leaps | MASK(TO_FLOAT(entry) == code);   // the first look-up that differs: trilinear again
        known |= settled;
#endif
        VF now = code;
        if (any_lane(live & ~known)) {
            VI among;
            VF sampled = trilinear_code(leap_volume, p, at, &among);
            // A leap voxel in the neighbourhood: all of it is of one region, and so was the sample before.
            VI region = ~known & among;
            now = (known | region) ? now : sampled;
            known |= region;
        }
        VI lost = live & known & MASK(now == UNKNOWN);
        if (any_lane(lost)) now = lost ? guard_ahead(leap_volume, p, &r, TO_FLOAT(k), lost) : now;
#if LACUNA_LEAPING == 2
        settled |= MASK(now == code);
#endif
        VI count = leaps ? min_of_int(leap_samples(p, entry), r.end - k) : (VI)(1);
        COUNT(samples += sum_lanes(counted(live)); skipped += sum_lanes(live & (count - (VI)(1)));)
        add_samples(p, lut_opacity, lut_color, &r, k, count, now, live, floor_t, &c, &clear, &depth);
        code = live ? now : code;
        k += live ? count : (VI)(0);
    }
    store_packet(p, out_color, out_depth, x0, y0, c, one - clear, depth + p->depth_bias_mm);
    STORE_COUNTERS(p, x0, y0, sum_lanes(counted(r.hits_box)), samples, skipped, reads);
}
