#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/classify/transfer_function.h"

namespace lacuna {

/// Colour maps whose lightness rises evenly, so that equal steps of a value look equally large and a map still tells
/// larger from smaller in print; the diverging one rises to its middle and falls. Each is a path through OKLCh
/// (Ottosson 2020) of lightness, chroma and hue, its chroma lowered where sRGB cannot show it; `cubehelix` is Green's
/// formula (2011).
std::vector<std::string> colour_map_names();

/// sRGB 0..1 of a map at t (clamped to 0..1). @throws Error(bad_usage) listing the known names
glm::dvec3 colour_map_at(const std::string& name, double t);

/// OKLab lightness, 0 black to 1 white, of an sRGB colour.
double lightness_of(const glm::dvec3& srgb);

/// Gives the points from `first` to `last` (indices) the map's colours by where their values lie between these two, and
/// adds points on the curve where straight lines between so few would show another map. Opacity stays as it is at every
/// value. @pre first <= last < points.size()
TransferFunction with_colour_map(const TransferFunction& tf, const std::string& map, std::size_t first,
                                 std::size_t last);

/// The same points with the order of the colours turned around.
TransferFunction with_colours_reversed(const TransferFunction& tf);

}  // namespace lacuna
