#include "core/regions/topology.h"

#include <algorithm>
#include <array>

#include "core/regions/neighbourhood.h"

namespace lacuna::topology {

namespace {

using Pair = std::uint64_t;
Pair make_pair(std::uint32_t a, std::uint32_t b) { return Pair(a) << 32 | b; }
std::uint32_t first_of(Pair pair) { return std::uint32_t(pair >> 32); }
std::uint32_t second_of(Pair pair) { return std::uint32_t(pair); }

/// Pairs met over and over, kept few: a small cache drops most repeats, a sort the rest whenever the list has doubled.
class PairSet {
public:
    void add(Pair pair) {
        Pair& recent = recent_[(pair * 0x9E3779B97F4A7C15ull) >> 52];
        if (recent == pair) return;
        recent = pair;
        pairs_.push_back(pair);
        if (pairs_.size() < limit_) return;
        sort_unique();
        limit_ = std::max(limit_, 2 * pairs_.size());
    }
    void sort_unique() {
        std::sort(pairs_.begin(), pairs_.end());
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }
    std::vector<Pair> pairs_;

private:
    std::array<Pair, 4096> recent_{};
    std::size_t limit_ = 1 << 18;
};

/// Everything that is no candidate, as pieces joined while rows pass by. Piece 0 is the outside.
class Pieces {
public:
    static constexpr std::uint32_t k_none = 0xFFFFFFFFu;

    explicit Pieces(std::size_t ids) : meets_outside_(ids, 0) { add(); }

    std::uint32_t add() {
        parent_.push_back(std::uint32_t(parent_.size()));
        only_.push_back(0);
        return parent_.back();
    }
    std::uint32_t find(std::uint32_t piece) {
        while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
        return piece;
    }
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        if (a == b) return a;
        if (b < a) std::swap(a, b);
        parent_[b] = a;
        if (only_[b]) touch(a, only_[b]);
        return a;
    }
    /// A piece (or the outside) lies beside a candidate region.
    void touch(std::uint32_t piece, std::uint32_t region) {
        const Pair pair = make_pair(piece, region);
        if (pair == last_touch_) return;  // the rows round a run mostly repeat each other
        last_touch_ = pair;
        piece = find(piece);
        if (piece == 0)
            meets_outside_[region] = 1;
        else if (only_[piece] == 0)
            only_[piece] = region;
        else if (only_[piece] != region)
            more_.add(make_pair(piece, region));
    }
    void touch_regions(std::uint32_t a, std::uint32_t b) { regions_.add(make_pair(std::min(a, b), std::max(a, b))); }

    std::vector<std::uint32_t> count_cavities();

private:
    std::vector<Pair> edges_of_graph(std::vector<std::uint32_t>& cavities);

    Pair last_touch_ = 0;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> only_;          // per root: the first candidate beside it; most pieces have one alone
    PairSet more_;                             // (piece, candidate) beyond the first
    PairSet regions_;                          // (candidate, candidate)
    std::vector<std::uint8_t> meets_outside_;  // per id
};

/// Edges between nodes: 0 the outside, 1..ids-1 the candidates, from ids on the pieces with several neighbours. A piece
/// inside one candidate alone is a cavity at once and no node.
std::vector<Pair> Pieces::edges_of_graph(std::vector<std::uint32_t>& cavities) {
    const std::uint32_t ids = std::uint32_t(meets_outside_.size());
    for (Pair& pair : more_.pairs_) pair = make_pair(find(first_of(pair)), second_of(pair));
    more_.sort_unique();

    std::vector<Pair> edges = std::move(regions_.pairs_);
    for (std::uint32_t id = 1; id < ids; ++id)
        if (meets_outside_[id]) edges.push_back(make_pair(0, id));
    std::uint32_t node = ids;
    for (std::size_t i = 0; i < more_.pairs_.size();) {
        const std::uint32_t piece = first_of(more_.pairs_[i]);
        const std::uint32_t name = piece == 0 ? 0 : node++;
        if (piece != 0 && only_[piece]) edges.push_back(make_pair(name, only_[piece]));
        for (; i < more_.pairs_.size() && first_of(more_.pairs_[i]) == piece; ++i)
            edges.push_back(make_pair(name, second_of(more_.pairs_[i])));
        only_[piece] = 0;
    }
    for (std::uint32_t piece = 1; piece < parent_.size(); ++piece)
        if (parent_[piece] == piece && only_[piece]) ++cavities[only_[piece]];

    const std::size_t one_way = edges.size();
    for (std::size_t i = 0; i < one_way; ++i) edges.push_back(make_pair(second_of(edges[i]), first_of(edges[i])));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::vector<std::uint32_t> Pieces::count_cavities() {
    const std::uint32_t ids = std::uint32_t(meets_outside_.size());
    std::vector<std::uint32_t> cavities(ids, 0);
    const std::vector<Pair> edges = edges_of_graph(cavities);
    if (edges.empty()) return cavities;

    const std::size_t nodes = std::size_t(first_of(edges.back())) + 1;
    std::vector<std::size_t> next(nodes + 1, 0);
    for (const Pair edge : edges) ++next[first_of(edge) + 1];
    for (std::size_t i = 1; i <= nodes; ++i) next[i] += next[i - 1];
    const std::vector<std::size_t> end(next.begin() + 1, next.end());

    // Depth-first from the outside, without recursion; `low` is the earliest node a subtree reaches past its parent.
    std::vector<std::uint32_t> order(nodes, 0), low(nodes, 0), path{0};
    std::uint32_t clock = 1;
    order[0] = low[0] = clock;
    while (!path.empty()) {
        const std::uint32_t node = path.back();
        if (next[node] < end[node]) {
            const std::uint32_t other = second_of(edges[next[node]++]);
            if (order[other] == 0) {
                order[other] = low[other] = ++clock;
                path.push_back(other);
            } else if (path.size() < 2 || other != path[path.size() - 2]) {
                low[node] = std::min(low[node], order[other]);
            }
            continue;
        }
        path.pop_back();
        if (path.empty()) break;
        const std::uint32_t parent = path.back();
        low[parent] = std::min(low[parent], low[node]);
        if (parent > 0 && parent < ids && low[node] >= order[parent]) ++cavities[parent];
    }
    return cavities;
}

struct Run {
    std::int32_t first, last;
    std::uint32_t region;  // 0: no candidate, then `piece` counts
    std::uint32_t piece;
};
using Runs = std::vector<Run>;

void find_runs(const std::uint32_t* row, int width, const std::vector<std::uint8_t>& candidate, Runs& runs) {
    runs.clear();
    for (int x = 0; x < width;) {
        const std::uint32_t label = row[x];
        int last = x;
        while (last + 1 < width && row[last + 1] == label) ++last;
        const std::uint32_t region = candidate[label] ? label : 0;
        if (!runs.empty() && region == 0 && runs.back().region == 0)
            runs.back().last = last;
        else
            runs.push_back({x, last, region, Pieces::k_none});
        x = last + 1;
    }
}

/// Calls visit(run, other) for each run of `row` and each adjacent one of `other`.
template <class Visit>
void for_adjacent(Runs& row, const Runs& other, int reach, Visit visit) {
    std::size_t begin = 0;
    for (Run& run : row) {
        while (begin < other.size() && other[begin].last < run.first - reach) ++begin;
        for (std::size_t k = begin; k < other.size() && other[k].first <= run.last + reach; ++k) visit(run, other[k]);
    }
}

struct EarlierRow {
    const Runs* runs;
    int reach;
};

/// A run without a candidate beside a candidate, to be noted once the run has its piece.
struct Pending {
    const Run* run;
    std::uint32_t region;
};

void join_row(Runs& row, const std::vector<EarlierRow>& earlier, bool at_frame, int width, Pieces& pieces,
              std::vector<Pending>& pending) {
    pending.clear();
    for (const EarlierRow& e : earlier)
        for_adjacent(row, *e.runs, e.reach, [&](Run& run, const Run& other) {
            if (run.region != 0) {
                if (other.region == 0)
                    pieces.touch(other.piece, run.region);
                else if (run.region != other.region)
                    pieces.touch_regions(run.region, other.region);
            } else if (other.region != 0) {
                if (pending.empty() || pending.back().run != &run || pending.back().region != other.region)
                    pending.push_back({&run, other.region});
            } else if (run.piece == Pieces::k_none) {
                run.piece = other.piece;
            } else if (run.piece != other.piece) {
                run.piece = pieces.unite(run.piece, other.piece);
            }
        });
    for (Run& run : row) {
        const bool outside = at_frame || run.first == 0 || run.last == width - 1;
        if (run.region) {
            if (outside) pieces.touch(0, run.region);
            continue;
        }
        if (run.piece == Pieces::k_none) run.piece = outside ? 0 : pieces.add();
        if (outside) run.piece = pieces.unite(run.piece, 0);
    }
    for (const Pending& p : pending) pieces.touch(p.run->piece, p.region);
    for (std::size_t i = 1; i < row.size(); ++i) {
        const Run &a = row[i - 1], &b = row[i];
        if (a.region && b.region)
            pieces.touch_regions(a.region, b.region);
        else
            pieces.touch(a.region ? b.piece : a.piece, a.region ? a.region : b.region);
    }
}

}  // namespace

bool can_enclose(std::int64_t voxels, const glm::ivec3& extent, Connectivity connectivity) {
    // A wall without diagonal gaps round one voxel takes the whole 3x3x3 shell, one with them its six faces.
    const std::int64_t least = connectivity == Connectivity::c6 ? 26 : 6;
    return voxels >= least && extent.x >= 3 && extent.y >= 3 && extent.z >= 3;
}

std::vector<std::uint32_t> count_cavities(const std::uint32_t* labels, const glm::ivec3& size,
                                          const std::vector<std::uint8_t>& candidate, Connectivity connectivity,
                                          const JobContext& job) {
    if (std::find(candidate.begin(), candidate.end(), 1) == candidate.end())
        return std::vector<std::uint32_t>(candidate.size(), 0);

    const Connectivity complement = connectivity == Connectivity::c6 ? Connectivity::c26 : Connectivity::c6;
    const int same_slice = neighbourhood::reach_along_x(complement, -1, 0);
    const int straight = neighbourhood::reach_along_x(complement, 0, -1);
    const int diagonal = neighbourhood::reach_along_x(complement, 1, -1);
    Pieces pieces(candidate.size());
    std::vector<Runs> slice(std::size_t(size.y)), before(std::size_t(size.y));
    std::vector<EarlierRow> earlier;
    std::vector<Pending> pending;
    for (int z = 0; z < size.z; ++z) {
        std::swap(slice, before);
        for (int y = 0; y < size.y; ++y) {
            find_runs(labels + (std::int64_t(z) * size.y + y) * size.x, size.x, candidate, slice[y]);
            earlier.clear();
            if (y > 0) earlier.push_back({&slice[y - 1], same_slice});
            if (z > 0) earlier.push_back({&before[y], straight});
            if (z > 0 && diagonal >= 0 && y > 0) earlier.push_back({&before[y - 1], diagonal});
            if (z > 0 && diagonal >= 0 && y + 1 < size.y) earlier.push_back({&before[y + 1], diagonal});
            const bool at_frame = z == 0 || y == 0 || z == size.z - 1 || y == size.y - 1;
            join_row(slice[y], earlier, at_frame, size.x, pieces, pending);
        }
        job.checkpoint(std::size_t(z) + 1, std::size_t(size.z));
    }
    return pieces.count_cavities();
}

}  // namespace lacuna::topology
