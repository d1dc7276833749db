#pragma once

#include <string>
#include <vector>

#include "core/accuracy/sweep.h"
#include "core/chart/chart.h"

namespace lacuna {

/// The contract's JSON of a sweep (docs/schemas/bench.schema.json); what is infinite becomes null.
std::string sweep_json(const std::string& device, const std::vector<SceneResult>& scenes, FrontError front);

/// One scene as a table for a terminal: the points by time, each plan by what sets it apart from the reference, those
/// on the front marked; what was refused with its reason.
std::string sweep_table(const SceneResult& scene);

/// One scene's time a frame against its error, both logarithmic: one series a structure, the front drawn and its plans
/// labelled, the reference's own error from a finer step marked.
Chart scene_chart(const SceneResult& scene, FrontError front);

/// A chart a scene.
ChartSheet sweep_chart(const std::string& device, const std::vector<SceneResult>& scenes, FrontError front);

}  // namespace lacuna
