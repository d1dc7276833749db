#pragma once

#include "core/accuracy/limits.h"

// When a scene meets a limit of the catalogue (limits.h), from measured facts. Each is one entry's `met`.
namespace lacuna::limit {

LimitMet thin_walls(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet narrow_peaks(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet smeared_peaks(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet thin_layers(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet hidden_light(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet spots(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet axis_switch(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet slanted_nearest(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet flattened_peak(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet wide_threshold(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet saturated_distances(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet fog(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet fooled_leaps(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet flattened_regions(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet nothing_to_leap(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet thin_wires(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet not_finite(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet far_away(const SceneFacts& facts, const Scene& scene, const Plan& plan);
LimitMet flat_or_thin(const SceneFacts& facts, const Scene& scene, const Plan& plan);

}  // namespace lacuna::limit
