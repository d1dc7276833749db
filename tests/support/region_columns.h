#pragma once

#include <string>
#include <vector>

namespace lacuna::test {

/// What a row of a region table holds by the contract, in order.
inline const std::vector<std::string> k_contract_keys = {"id",
                                                         "voxels",
                                                         "volume_mm3",
                                                         "fraction",
                                                         "surface_mm2",
                                                         "shape_factor",
                                                         "sphericity",
                                                         "holes",
                                                         "tunnels",
                                                         "mean",
                                                         "min",
                                                         "max",
                                                         "stddev",
                                                         "centroid_mm",
                                                         "bbox_mm",
                                                         "equivalent_diameter_mm",
                                                         "principal_lengths_mm",
                                                         "touches_border"};

/// What stands behind: measured on the regions' surfaces.
inline const std::vector<std::string> k_surface_keys = {
    "surface_crofton_mm2", "surface_mesh_mm2",    "diameter_mm", "projected_area_mm2",
    "integral_volume_mm3", "surface_distance_mm", "gap_mm",      "volume_lo_mm3",
    "volume_hi_mm3",       "gap_lo_mm",           "gap_hi_mm"};

}  // namespace lacuna::test
