// Emission-absorption ray casting of whole-number voxels, a group of 16x16 pixels a work-item: raycast_ea.cl's
// pictures, with the samples of its marching loop, and their gradients, from blocks (block.clh). Buffers as there, but
// `lut` has red, green, blue and opacity an entry.
#define LACUNA_ALIGNED 1
#include "shared/ray_params.h"
#include "include/packet.clh"
#include "include/volume.clh"
#include "include/ray.clh"
#include "include/carry.clh"
#include "include/classify.clh"
#include "include/shapes.clh"
#include "include/shade.clh"
#include "include/adaptive.clh"
#define BLOCK_COPIES (i == 0 ? copied : 0)
#include "include/output.clh"
#include "include/ea.clh"
#include "include/block.clh"
#include "include/group.clh"

typedef struct {
    int unused;
} Idle;
#define IS_IDLE(state, cell_class, structure, cell) MASK((cell_class) == (VI)(CELL_NONE))
#include "include/skip.clh"
#include "include/span.clh"

#define GRADIENTS_AT_A_TIME 4

typedef struct {
    uint samples, skipped, reads;  // counted with LACUNA_COUNT
    VI left_off;
} Work;

typedef struct {
    Group group;
    Composite states[GROUP_PACKETS];
    int until[GROUP_PACKETS];  // no need to ask the structure again before this sample
    Work works[GROUP_PACKETS];
} March;

/// From sample k of packet i on the first that may show something, as far as the slab's end; a packet that cannot show
/// any more ends there.
INLINE int skip_idle(constant RayParams* p, March* m, int i, Structure s, int k) {
    Group* g = &m->group;
    const Rays* r = &g->rays[i];
    const Idle idle = {0};
    while (k < g->stop[i] && k >= m->until[i]) {
        const VI live = MASK(r->end > (VI)(k)) & still_clear(&m->states[i], (VF)(p->min_transmittance));
        if (!any_lane(live)) {
            g->end[i] = g->stop[i] = k;
            break;
        }
        const Skip skip = next_sample(p, r, s, &idle, k, g->end[i], live);
        COUNT(m->works[i].reads += skip.reads; m->works[i].skipped += jumped(r, live, k, skip.next);)
        k = skip.next;
        m->until[i] = skip.until;
    }
    return k;
}

/// What the table's entry, 16 indices in memory, says of a sample.
INLINE Classified look_up(constant RayParams* p, global const float4* lut, VF value, const VI* entry, VI here,
                          VF3* color) {
    const volatile uint* const at = (const volatile uint*)entry;
    SIXTEEN_BYTES(global, lut, at, red, green, blue, opacity);
    color->x = AS_FLOAT(red);
    color->y = AS_FLOAT(green);
    color->z = AS_FLOAT(blue);
    Classified s;
    const VI inside = in_ranges(p, value, &s.row);
    s.value = value;
    s.entry = (VI)(0);
    s.opacity = AS_FLOAT(opacity);
    s.shown = here & inside & MASK(s.opacity > (VF)(0.0f));
    return s;
}

/// Takes packet i through its samples of the slab. @param entries  of the block, or 0: none was worth it
INLINE void march_packet(global const voxel_t* volume, constant RayParams* p, March* m, int i, Structure structure,
                         global const float4* lut, const ulong* entries, const Block* block SAMPLE_GRADIENT_ARG) {
    Group* g = &m->group;
    const Rays* r = &g->rays[i];
    const VF zero = (VF)(0.0f), floor_t = (VF)(p->min_transmittance);
    const VF first = TO_FLOAT(r->first), last = TO_FLOAT(r->end - 1);
    Composite* const state = &m->states[i];
    Rays held;
    int k = g->next[i];
    if (entries) held = held_inside(r, k, g->stop[i], block);
    while ((k = skip_idle(p, m, i, structure, k)) < g->stop[i]) {
        // Loop after loop: a look-up waits for its address, and the processor sees no further than three samples.
        const int count = min(min(m->until[i], g->stop[i]) - k, BLOCK_SAMPLES);
        VI place[BLOCK_SAMPLES];  // of the cell, then of the table's entry
        VF3 fraction[BLOCK_SAMPLES];
        VF value[BLOCK_SAMPLES];
        VI row;
        if (entries) find_cells(block, &held, k, count, place, fraction);
        for (int j = 0; j < count; ++j) {
            if (entries) {
                value[j] = block_value(entries, (const volatile uint*)&place[j], &fraction[j]);
            } else {
                const VF3 at = ray_at(r, (VF)((float)(k + j)));
                fetch_ahead(volume, p, r, at);
                value[j] = sample_volume(volume, p, at);
            }
            in_ranges(p, value[j], &row);
            place[j] = lut_index(p, value[j], row);
        }
        int goes_on = 1;
        if (!NEEDS_GRADIENT(p)) {
            for (int j = 0; j < count && goes_on; ++j, ++k) {
                const VI here = MASK(r->first <= (VI)(k)) & MASK(r->end > (VI)(k)) & still_clear(state, floor_t);
                COUNT(m->works[i].samples += sum_lanes(counted(here));)
                VF3 color;
                const Classified sample = look_up(p, lut, value[j], &place[j], here, &color);
                if (!any_lane(sample.shown)) continue;
                add_sample(p, r, k, &sample, color, zero, zero, state SAMPLE_GRADIENT);
                goes_on = any_lane(MASK(r->end > (VI)(k)) & still_clear(state, floor_t));
            }
        } else {
            for (int j = 0; j < count && goes_on;) {
                // A few gradients at a time, some perhaps for nothing: rays may end before.
                const int batch = min(count - j, entries ? GRADIENTS_AT_A_TIME : 1);
                Classified sample[GRADIENTS_AT_A_TIME];
                VF3 color[GRADIENTS_AT_A_TIME], slope[GRADIENTS_AT_A_TIME], fraction_there[GRADIENTS_AT_A_TIME];
                VI cell[GRADIENTS_AT_A_TIME];
                uint shown = 0;
                for (int b = 0; b < batch; ++b) {
                    const VI here = MASK(r->first <= (VI)(k + b)) & MASK(r->end > (VI)(k + b));
                    sample[b] = look_up(p, lut, value[j + b], &place[j + b], here, &color[b]);
                    shown |= any_lane(sample[b].shown & still_clear(state, floor_t)) ? 1u << b : 0;
                }
                if (shown && entries) {
                    for (int b = 0; b < batch; ++b) {
                        const VF own = clamp_of((VF)((float)(k + b)), first, last);
                        cell[b] = block_cell(block, clamp_position(p, ray_at(&held, own)), &fraction_there[b]);
                    }
                    for (int b = 0; b < batch; ++b)
                        if (shown >> b & 1)
                            slope[b] =
                                block_gradient(entries, block, (const volatile uint*)&cell[b], &fraction_there[b]);
                } else if (shown) {
                    slope[0] = gradient(volume, p, ray_at(r, (VF)((float)k)));
                }
                for (int b = 0; b < batch && goes_on; ++b, ++k) {
                    const VI clear = still_clear(state, floor_t);
                    COUNT(const VI here = MASK(r->first <= (VI)(k)) & MASK(r->end > (VI)(k)) & clear;)
                    COUNT(m->works[i].samples += sum_lanes(counted(here));)
                    if (!(shown >> b & 1)) continue;
                    sample[b].shown &= clear;
                    VF magnitude;
                    const VF cosine = facing(p, r, slope[b], &magnitude);
                    add_sample(p, r, k, &sample[b], color[b], cosine, magnitude, state SAMPLE_GRADIENT);
                    goes_on = any_lane(MASK(r->end > (VI)(k)) & still_clear(state, floor_t));
                }
                j += batch;
            }
        }
        if (!goes_on) g->end[i] = g->stop[i] = k;
    }
    g->next[i] = k;
}

kernel void raycast_ea_blocks(global const voxel_t* restrict volume, constant RayParams* p, const int first_row,
                              global const float* restrict lut_opacity, global const float4* restrict lut,
                              global float4* restrict out_color,
                              global float* restrict out_depth GRADIENT_ARGS STRUCTURE_ARGS COUNTER_ARGS) {
    const int x0 = (int)get_global_id(0) * GROUP_PIXELS, y0 = first_row + (int)get_global_id(1) * GROUP_PIXELS;
    ulong entries[BLOCK_ENTRIES + BLOCK_SLACK];
    Block block;
    March march;
    Group* const g = &march.group;
    for (int i = 0; i < GROUP_PACKETS; ++i) {
        const int x = x0 + GROUP_X(i), y = y0 + GROUP_Y(i);
        Rays* r = &g->rays[i];
        march.states[i] = nothing_yet();
        march.until[i] = 0;
        SPAN_STATE(p, x, y);
        if (MEETS_NOTHING) {
            r->first = r->end = (VI)(0);
            continue;
        }
        *r = make_rays(p, x, y);
        const VI capped = keeps_length(r) & MASK(r->entry == (VI)(ENTRY_CAP));
        if (any_lane(capped))
            add_cap(p, lut_opacity, r, sample_volume(volume, p, ray_at(r, r->enter)), capped, (VI)(0),
                    &march.states[i]);
        COUNT(const VI first_of_all = r->first;)
        NARROW(p, r);
        COUNT(march.works[i].samples = march.works[i].reads = 0;)
        COUNT(march.works[i].skipped = sum_lanes((r->first - first_of_all) & MASK(r->first > first_of_all));)
        COUNT(march.works[i].left_off = LEFT_OFF_LANES;)
    }
    const int in_slabs = settle_group(p, g);
    const int apron = NEEDS_GRADIENT(p) ? 1 : 0;

    int going = g->slabs > 0;
    COUNT(uint copied = 0;)
    for (int slab = 0; slab < g->slabs && going; ++slab) {
        begin_slab(g, slab);
        going = 0;
        uint wanted = 0;
        for (int i = 0; i < GROUP_PACKETS; ++i) {
            g->next[i] = skip_idle(p, &march, i, STRUCTURE, g->next[i]);
            if (g->next[i] < g->stop[i]) wanted |= 1u << i;
            going |= g->next[i] < g->end[i];
        }
        for (int part = 0; part < GROUP_PARTS && wanted; ++part) {
            const uint together = wanted & packets_of_part(part);
            const int filled = in_slabs && together ? fill_slab(volume, p, g, together, apron, entries, &block) : 0;
            if (in_slabs && part == 0 && !filled) continue;
            COUNT(copied += filled;)
            wanted &= ~together;
            for (int i = 0; i < GROUP_PACKETS; ++i)
                if (together >> i & 1)
                    march_packet(volume, p, &march, i, STRUCTURE, lut, filled ? entries : 0, &block SAMPLE_GRADIENT);
        }
    }
    for (int i = 0; i < GROUP_PACKETS; ++i) {
        const int x = x0 + GROUP_X(i), y = y0 + GROUP_Y(i);
        const Composite* s = &march.states[i];
        store_packet(p, out_color, out_depth, x, y, s->c, 1.0f - s->clear, s->depth + p->depth_bias_mm);
        COUNT(Work* work = &march.works[i];)
        COUNT(work->skipped += sum_lanes(work->left_off & still_clear(s, (VF)(p->min_transmittance)));)
        STORE_COUNTERS(p, x, y, sum_lanes(counted(g->rays[i].hits_box)), work->samples, work->skipped, work->reads);
    }
}
