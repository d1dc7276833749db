// Maximum and minimum intensity projection of whole-number voxels, a group of 16x16 pixels a work-item:
// raycast_mip.cl's pictures, from blocks (block.clh). With min-max macro-cells (LACUNA_STRUCTURE 1, else none) a slab
// is bounded by the cells around all the group's rays at once, by scalar arithmetic, and left out by the packets that
// cannot win there. The most promising slab is sampled first, so that what lies before it can be left out too.
#define LACUNA_ALIGNED 1
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/carry.clh"
#include "include/classify.clh"
#define BLOCK_COPIES (i == 0 ? search.copied : 0)
#include "include/output.clh"
#include "include/block.clh"
#include "include/group.clh"

typedef struct {
    int unused;
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) ((VI)(0))
#include "include/skip.clh"

// Oriented so that larger is better.
#if LACUNA_PROJECTION == 1
#define TOWARDS_BEST(v) (-(v))
#define CELL_BEST(range) (-(range).x)
#else
#define TOWARDS_BEST(v) (v)
#define CELL_BEST(range) ((range).y)
#endif

typedef struct {
    VF best, at;  // -INFINITY before the first; the sample
} Found;

/// The best value that the samples of a slab can have; -INFINITY where none can count.
INLINE float slab_bound(constant RayParams* p, Structure s, const Group* g, int slab, int* reads) {
#if LACUNA_STRUCTURE == 1
    int4 first, last;
    slab_box(p, g, slab, &first, &last);
    const int4 from = first >> p->cell_shift, to = last >> p->cell_shift;
    float bound = -INFINITY;
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y) {
            const int row = (z * p->cells[1] + y) * p->cells[0];
            for (int x = from.x; x <= to.x; ++x) {
#if LACUNA_RANGES
                if (s.cell_class[row + x] == CELL_NONE) continue;
#endif
                const float value = CELL_BEST(s.cell_range[row + x]);
                bound = value > bound ? value : bound;
            }
        }
    *reads += (to.x - from.x + 1) * (to.y - from.y + 1) * (to.z - from.z + 1);
    return bound;
#else
    return INFINITY;
#endif
}

/// The best of samples k .. stop-1 of a packet's rays, after what was found before. A ray without a sample there takes
/// one it has, or none.
/// @param fetch  what is asked for meanwhile
INLINE Found best_between(global const voxel_t* volume, constant RayParams* p, const Rays* r, int k, int stop,
                          const ulong* entries, const Block* b, Fetch* fetch, Found before) {
    const VI active = rays_between(r, k, stop);
    const VF least = TO_FLOAT(r->first), most = TO_FLOAT(r->end - 1);
    Found found = before;
    VI row;
    if (entries == 0) {
        for (; k < stop; ++k) {
            const VF3 at = ray_at(r, clamp_of((VF)((float)k), least, most));
            fetch_ahead(volume, p, r, at);
            const VF value = sample_volume(volume, p, at);
            const VI better = MASK(TOWARDS_BEST(value) > found.best) & in_ranges(p, value, &row);
            found.best = better ? TOWARDS_BEST(value) : found.best;
            found.at = better ? (VF)((float)k) : found.at;
        }
    } else {
        const Rays held = held_inside(r, k, stop, b);
        while (k < stop) {
            // In two loops: a look-up waits for its address, and the processor sees no further than three samples.
            VI cell[BLOCK_SAMPLES];
            VF3 fraction[BLOCK_SAMPLES];
            const int count = min(stop - k, BLOCK_SAMPLES);
            find_cells(b, &held, k, count, cell, fraction);
            for (int j = 0; j < count; ++j, ++k) {
                fetch_on(fetch);
                const VF value = block_value(entries, (const volatile uint*)&cell[j], &fraction[j]);
                const VI better = MASK(TOWARDS_BEST(value) > found.best) & in_ranges(p, value, &row);
                found.best = better ? TOWARDS_BEST(value) : found.best;
                found.at = better ? (VF)((float)k) : found.at;
            }
        }
    }
    found.at = max_of(found.at, least);
    found.best = active ? found.best : before.best;
    found.at = active ? found.at : before.at;
    return found;
}

/// What no ray of the packet needs to go below.
INLINE float needed(const Rays* r, VF best) { return min_of_lanes(MASK(r->end > r->first) ? best : (VF)(INFINITY)); }

typedef struct {
    Group group;
    Found found[GROUP_PACKETS];
    uint samples[GROUP_PACKETS], skipped[GROUP_PACKETS], copied;  // counted with LACUNA_COUNT
} Search;

/// Samples the present slab with the packets in `wanted`, a bit each, and leaves it behind with all. Slab `ahead` is
/// asked for meanwhile.
INLINE void search_slab(global const voxel_t* volume, constant RayParams* p, Search* s, uint wanted, int in_slabs,
                        ulong* entries, int ahead) {
    Group* g = &s->group;
    Block block;
    uint left = wanted;
    for (int part = 0; part < GROUP_PARTS && left; ++part) {
        const uint together = left & packets_of_part(part);
        const int filled = in_slabs && together ? fill_slab(volume, p, g, together, 0, entries, &block) : 0;
        if (in_slabs && part == 0 && !filled) continue;
        COUNT(s->copied += filled;)
        left &= ~together;
        Fetch fetch = {0};
        if (filled && part == 0 && ahead < g->slabs) {
            int samples = 0;
            for (int i = 0; i < GROUP_PACKETS; ++i) samples += together >> i & 1 ? g->stop[i] - g->next[i] : 0;
            fetch = fetch_slab(volume, p, g, ahead, samples);
        }
        for (int i = 0; i < GROUP_PACKETS; ++i)
            if (together >> i & 1)
                s->found[i] = best_between(volume, p, &g->rays[i], g->next[i], g->stop[i], filled ? entries : 0, &block,
                                           &fetch, s->found[i]);
    }
    for (int i = 0; i < GROUP_PACKETS; ++i) {
#if LACUNA_COUNT
        const Rays* r = &g->rays[i];
        const VI ends = min_of_int(r->end, (VI)(g->stop[i])), begins = max_of_int(r->first, (VI)(g->next[i]));
        const uint of_slab = (uint)sum_lanes(max_of_int(ends - begins, (VI)(0)));
        if (wanted >> i & 1)
            s->samples[i] += of_slab;
        else
            s->skipped[i] += of_slab;
#endif
        g->next[i] = g->stop[i];
    }
}

kernel void raycast_mip_blocks(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                               global const uint* restrict lut_color, global float4* restrict out_color,
                               global float* restrict out_depth STRUCTURE_ARGS COUNTER_ARGS) {
    const int2 origin = tiled_origin(first_row);
    const int x0 = origin.x, y0 = origin.y;
    const VF zero = (VF)(0.0f);
    const Found nothing = {(VF)(-INFINITY), zero};
    ulong entries[BLOCK_ENTRIES + BLOCK_SLACK];
    Search search;
    Group* const g = &search.group;
    for (int i = 0; i < GROUP_PACKETS; ++i) {
        g->rays[i] = make_rays(p, x0 + GROUP_X(i), y0 + GROUP_Y(i));
        search.found[i] = nothing;
        search.samples[i] = search.skipped[i] = 0;
    }
    search.copied = 0;
    const int in_slabs = settle_group(p, g);
    float bound[GROUP_SLABS], need[GROUP_PACKETS];
    int reads = 0, best_slab = 0;
    for (int slab = 0; slab < g->slabs; ++slab) {
        bound[slab] = in_slabs ? slab_bound(p, STRUCTURE, g, slab, &reads) : INFINITY;
        if (bound[slab] > bound[best_slab]) best_slab = slab;
    }

    Found early[GROUP_PACKETS];  // in the best slab
    if (g->slabs > 0) {
        int begun[GROUP_PACKETS];
        for (int i = 0; i < GROUP_PACKETS; ++i) begun[i] = g->next[i];
        if (best_slab > 0) {
            begin_slab(g, best_slab - 1);
            for (int i = 0; i < GROUP_PACKETS; ++i) g->next[i] = g->stop[i];
        }
        begin_slab(g, best_slab);
        uint wanted = 0;
        for (int i = 0; i < GROUP_PACKETS; ++i)
            wanted |= g->next[i] < g->stop[i] && bound[best_slab] > -INFINITY ? 1u << i : 0;
        search_slab(volume, p, &search, wanted, in_slabs, entries, 0);
        for (int i = 0; i < GROUP_PACKETS; ++i) {
            early[i] = search.found[i];
            need[i] = needed(&g->rays[i], early[i].best);
            search.found[i] = nothing;
            g->next[i] = begun[i];
        }
    }
    for (int slab = 0; slab < g->slabs; ++slab) {
        begin_slab(g, slab);
        if (slab == best_slab) {
            for (int i = 0; i < GROUP_PACKETS; ++i) {
                Found* f = &search.found[i];
                const VI better = MASK(early[i].best > f->best);
                f->best = better ? early[i].best : f->best;
                f->at = better ? early[i].at : f->at;
                g->next[i] = g->stop[i];
            }
        } else {
            // Before the best slab what equals its value comes first; behind it, too late.
            uint wanted = 0;
            for (int i = 0; i < GROUP_PACKETS; ++i) {
                const int can_win = slab < best_slab ? bound[slab] >= need[i] : bound[slab] > need[i];
                wanted |= g->next[i] < g->stop[i] && bound[slab] > -INFINITY && can_win ? 1u << i : 0;
            }
            search_slab(volume, p, &search, wanted, in_slabs, entries, slab + 1);
        }
        if (slab >= best_slab)
            for (int i = 0; i < GROUP_PACKETS; ++i) need[i] = needed(&g->rays[i], search.found[i].best);
    }

    for (int i = 0; i < GROUP_PACKETS; ++i) {
        const Rays* r = &g->rays[i];
        const VF value = TOWARDS_BEST(search.found[i].best);
        const VI shown = MASK(search.found[i].best > (VF)(-INFINITY));
        VF grey = grey_of(p, value);
        VF3 c = {grey, grey, grey};
        if (p->color_by_tf) {
            VI row;
            in_ranges(p, value, &row);
            c = unpack_color(gather_uint(lut_color, lut_index(p, value, row)));
        }
        c.x = shown ? c.x : zero;
        c.y = shown ? c.y : zero;
        c.z = shown ? c.z : zero;
        const VF depth = depth_at(p, r, search.found[i].at) + p->depth_bias_mm;
        const int x = x0 + GROUP_X(i), y = y0 + GROUP_Y(i);
        store_packet(p, out_color, out_depth, x, y, c, shown ? (VF)(1.0f) : zero, shown ? depth : (VF)(INFINITY));
        STORE_COUNTERS(p, x, y, sum_lanes(counted(r->hits_box)), search.samples[i], search.skipped[i],
                       i == 0 ? reads : 0);
    }
}
