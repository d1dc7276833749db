#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/inspect/report.h"

namespace lacuna::test {

inline Measured around(double value, double off) { return {value, value - off, value + off}; }

/// A block of material, 16 x 14 x 12 voxels of 0.5 mm in a 20 x 18 x 16 grid, with three voids put in by hand: what
/// analyse_part would give, but with values that a test can know.
struct HandMadePart {
    Volume volume;
    PartAnalysis analysis;

    HandMadePart() {
        GridGeometry grid;
        grid.size = {20, 18, 16};
        grid.spacing = glm::dvec3(0.5);
        analysis.labels = {grid, std::make_shared<std::vector<std::uint32_t>>(std::size_t(grid.voxel_count()))};
        analysis.part_mask = {grid, std::make_shared<std::vector<std::uint8_t>>(std::size_t(grid.voxel_count()))};
        for (int z = 2; z < 14; ++z)
            for (int y = 2; y < 16; ++y)
                for (int x = 2; x < 18; ++x) (*analysis.part_mask.labels)[std::size_t(grid.linear_index(x, y, z))] = 1;
        add(1, {5, 5, 5}, {7, 7, 7});
        add(2, {12, 9, 8}, {13, 10, 9});
        add(3, {9, 12, 11}, {9, 12, 11});
        analysis.defects[2].measurable = false;
        analysis.defects[2].probability = 0.6;
        volume = make_volume<std::uint8_t>(grid, [&](auto voxels) {
            for (std::size_t i = 0; i < voxels.size(); ++i)
                voxels[i] = (*analysis.part_mask.labels)[i] && !(*analysis.labels.labels)[i] ? 200 : 20;
        });
        volume.name = "hand-made";
        PartFacts& part = analysis.part;
        part.has_material = true;
        part.material_threshold = 110;
        part.void_level = 20;
        part.material_level = 200;
        part.part_volume_mm3 = around(336, 10);
        part.material_volume_mm3 = 331.5;
        part.porosity_percent = around(1.35, 0.1);
        part.bbox_min_mm = glm::dvec3(0.75);
        part.bbox_max_mm = {8.75, 7.75, 6.75};
        analysis.surface_method = "by hand";
        analysis.adjacency = "26";
        analysis.stability = {{90, 110, 130}, {1.3, 1.35, 1.4}, {3, 3, 3}, {3, 3, 3}, {95, 125}};
    }

    void add(std::uint32_t id, glm::ivec3 first, glm::ivec3 last) {
        const GridGeometry& grid = analysis.labels.geometry;
        Defect d;
        d.id = id;
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x, ++d.voxels)
                    (*analysis.labels.labels)[std::size_t(grid.linear_index(x, y, z))] = id;
        const double volume_mm3 = double(d.voxels) * grid.voxel_volume_mm3();
        const double side = 0.5 * double(last.x - first.x + 1);
        d.volume_mm3 = around(volume_mm3, 0.1 * volume_mm3);
        d.voxel_volume_mm3 = d.integral_volume_mm3 = volume_mm3;
        d.threshold = 110;
        d.bbox_first = first;
        d.bbox_last = last;
        d.bbox_min_mm = grid.voxel_to_mm(glm::dvec3(first) - 0.5);
        d.bbox_max_mm = grid.voxel_to_mm(glm::dvec3(last) + 0.5);
        d.centroid_mm = 0.5 * (d.bbox_min_mm + d.bbox_max_mm);
        d.diameter_mm = around(side * std::sqrt(3.0), 0.1);
        d.equivalent_diameter_mm = around(std::cbrt(6 * volume_mm3 / 3.14159265358979), 0.05);
        d.principal_lengths_mm = glm::dvec3(side);
        d.area_mm2 = around(6 * side * side, 0.2);
        d.surface_crofton_mm2 = d.surface_mesh_mm2 = 6 * side * side;
        d.sphericity = 0.8;
        d.shape_factor = 216;
        d.surface_distance_mm = around(1.5, 0.1);
        d.gap_mm = 1.2;
        d.projected_area_mm2 = glm::dvec3(side * side);
        d.mean = d.min = d.max = 20;
        d.probability = 0.999;
        analysis.defects.push_back(d);
    }

    /// The report of the part judged by these criteria, without pictures.
    InspectionReport report(const Criteria& criteria, std::vector<HandDecision> by_hand = {}) const {
        InspectionReport made;
        made.scan.name = "hand-made";
        made.scan.input = "hand-made.nrrd";
        made.scan.sha256 = std::string(64, 'a');
        made.scan.geometry = volume.geometry();
        made.scan.range = {20, 200};
        made.analysis = analysis;
        made.criteria = criteria;
        made.judgement = judge(analysis, criteria, lay_zones(criteria, volume.geometry()), std::move(by_hand));
        made.software = "Lacuna 0.0.0";
        made.replay = "lacuna inspect hand-made.nrrd --criteria criteria.json --report REPORT";
        return made;
    }
};

}  // namespace lacuna::test
