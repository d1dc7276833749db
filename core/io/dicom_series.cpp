#include "core/io/dicom_series.h"

#include <algorithm>
#include <map>

#include "core/io/dicom_stack.h"

namespace lacuna::dicom {

namespace {

constexpr double k_same_axis = 1e-3;       // largest difference of two unit vectors taken as equal
constexpr double k_same_spacing = 1e-4;    // relative
constexpr std::size_t k_stray_slices = 2;  // so few slices beside a real stack are no volume of their own

struct Member {
    const File* file = nullptr;
    Frame slice;  // Frame::file indexes the input
};
using Group = std::vector<Member>;

bool same_spacing(const std::optional<glm::dvec2>& a, const std::optional<glm::dvec2>& b) {
    if (!a || !b) return !a && !b;
    return glm::all(glm::lessThanEqual(glm::abs(*a - *b), k_same_spacing * *a));
}

/// Whether two slices may lie in one stack, whatever their positions.
bool stackable(const Member& a, const Member& b) {
    const PixelFormat &p = a.file->pixels, &q = b.file->pixels;
    if (a.file->unsupported != b.file->unsupported) return false;
    if (a.file->fault.empty() != b.file->fault.empty())
        return true;  // a broken file stays with its series and is named
    return p.columns == q.columns && p.rows == q.rows && p.kind == q.kind && p.bits_allocated == q.bits_allocated &&
           a.slice.has_orientation == b.slice.has_orientation &&
           a.slice.position.has_value() == b.slice.position.has_value() &&
           glm::length(a.slice.row - b.slice.row) <= k_same_axis &&
           glm::length(a.slice.column - b.slice.column) <= k_same_axis &&
           same_spacing(a.slice.spacing, b.slice.spacing);
}

std::vector<Group> split_by_shape(const Group& series) {
    std::vector<Group> groups;
    for (const Member& member : series) {
        const auto fits = [&](const Group& g) { return stackable(g.front(), member); };
        auto at = std::find_if(groups.begin(), groups.end(), fits);
        if (at == groups.end()) at = groups.insert(groups.end(), Group());
        at->push_back(member);
        // The group's first member stands for it: a sound one, if there is one.
        if (!at->front().file->fault.empty() && member.file->fault.empty()) std::swap(at->front(), at->back());
    }
    return groups;
}

std::vector<double> positions_along_normal(const Group& group) {
    std::vector<double> along;
    const glm::dvec3 normal = group.front().slice.normal();
    for (const Member& m : group)
        if (m.slice.position) along.push_back(glm::dot(*m.slice.position, normal));
    std::sort(along.begin(), along.end());
    return along;
}

bool overlap(const std::vector<double>& a, const std::vector<double>& b) {
    return !a.empty() && !b.empty() && a.front() <= b.back() && b.front() <= a.back();
}

/// Some scanners give each rotation its own acquisition number, others two passes over the same body one series: so
/// acquisitions are parted only where the slices together are no regular stack and each acquisition's are.
std::vector<Group> split_by_acquisition(Group group) {
    std::map<std::string, Group> passes;
    for (const Member& m : group) passes[m.slice.acquisition].push_back(m);
    if (passes.size() < 2) return {std::move(group)};
    const auto all = positions_along_normal(group);
    const double same_mm = same_position_mm(group.front().slice.spacing);
    if (all.size() != group.size() || find_step(all, {}, same_mm).regular()) return {std::move(group)};
    bool overlapping = false, sound = true, regular = true;
    std::vector<Group> parts;
    std::vector<std::vector<double>> ranges;
    for (auto& [key, part] : passes) {
        const auto along = positions_along_normal(part);
        const StepFit fit = find_step(along, {}, same_mm);
        sound = sound && fit.duplicates == 0;
        regular = regular && fit.regular() && part.size() >= 3;
        for (const auto& other : ranges) overlapping = overlapping || overlap(along, other);
        ranges.push_back(along);
        parts.push_back(std::move(part));
    }
    if (overlapping ? sound : regular) return parts;
    return {std::move(group)};
}

bool is_colour(const Group& group) { return group.front().file->unsupported; }

std::string name_of_slice(const File& file, const Frame& slice, std::size_t frames) {
    return frames > 1 ? file.name() + " frame " + std::to_string(slice.number + 1) : file.name();
}

SeriesScan make_scan(const Group& group, const std::vector<std::string>& set_aside) {
    SeriesScan scan;
    scan.set_aside = set_aside;
    std::map<int, int> renumbered;
    for (const Member& m : group) {
        auto [at, is_new] = renumbered.try_emplace(m.slice.file, int(scan.files.size()));
        if (is_new) {
            scan.files.push_back(*m.file);
        }
        scan.slices.push_back(m.slice);
        scan.slices.back().file = at->second;
    }
    return scan;
}

/// The volumes of one SeriesInstanceUID.
std::vector<SeriesScan> scans_of_series(const Group& series) {
    Group slices, localizers;
    for (const Member& m : series) (m.slice.localizer ? localizers : slices).push_back(m);
    std::vector<std::string> set_aside;
    if (slices.empty()) slices.swap(localizers);
    for (const Member& m : localizers) set_aside.push_back(name_of_slice(*m.file, m.slice, m.file->frames.size()));

    std::vector<Group> groups;
    for (Group& shape : split_by_shape(slices))
        for (Group& pass : split_by_acquisition(std::move(shape))) groups.push_back(std::move(pass));
    std::size_t largest = 0;
    for (const Group& g : groups)
        if (!is_colour(g)) largest = std::max(largest, g.size());
    std::vector<Group> volumes;
    for (Group& g : groups) {
        const bool stray = g.size() <= k_stray_slices && largest >= 3 && largest >= 3 * g.size();
        if (!stray && !(is_colour(g) && largest > 0)) {
            volumes.push_back(std::move(g));
            continue;
        }
        for (const Member& m : g) set_aside.push_back(name_of_slice(*m.file, m.slice, m.file->frames.size()));
    }
    std::vector<SeriesScan> scans;
    for (const Group& g : volumes) scans.push_back(make_scan(g, set_aside));
    return scans;
}

}  // namespace

std::string SeriesScan::name_of(const Frame& slice) const {
    const File& file = file_of(slice);
    return name_of_slice(file, slice, file.frames.size());
}

std::vector<SeriesScan> group_series(std::vector<File> files) {
    std::map<std::pair<int, std::string>, Group> by_uid;
    for (std::size_t f = 0; f < files.size(); ++f)
        for (Frame& slice : files[f].frames) {
            slice.file = int(f);
            by_uid[{files[f].series_number, files[f].series_uid}].push_back({&files[f], slice});
        }
    std::vector<SeriesScan> scans;
    bool any_volume = false;
    const auto is_volume = [](const SeriesScan& s) {
        return !s.slices.front().localizer && !s.files.front().unsupported;
    };
    for (const auto& [key, series] : by_uid) {
        auto found = scans_of_series(series);
        for (std::size_t i = 0; i < found.size(); ++i) {
            found[i].uid = key.second + (i == 0 ? "" : "#" + std::to_string(i + 1));
            any_volume = any_volume || is_volume(found[i]);
            scans.push_back(std::move(found[i]));
        }
    }
    if (!any_volume) return scans;
    std::vector<std::string> beside;  // scout series and colour pictures next to real volumes
    for (const SeriesScan& s : scans)
        if (!is_volume(s))
            for (const Frame& slice : s.slices) beside.push_back(s.name_of(slice));
    std::erase_if(scans, [&](const SeriesScan& s) { return !is_volume(s); });
    if (scans.size() == 1) scans.front().set_aside.insert(scans.front().set_aside.end(), beside.begin(), beside.end());
    return scans;
}

}  // namespace lacuna::dicom
