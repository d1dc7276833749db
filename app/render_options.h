#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/input_options.h"
#include "app/leap_options.h"
#include "app/region_words.h"
#include "core/accuracy/planner.h"
#include "core/accuracy/truth.h"
#include "core/render/plan_json.h"
#include "core/render/scene.h"

namespace lacuna::cli {

/// The words of `lacuna render` as typed, and what they mean.
class RenderOptions {
public:
    InputOptions input;
    LeapWords leap;
    RegionWords regions;
    std::string output, stats, device;
    bool verify = false;
    std::string verify_map;                 ///< --verify-map: where the difference map goes; empty: nowhere
    Truth verify_against = Truth::samples;  ///< --verify-against

    void add_to(CLI::App& command);
    /// Reads every word, loads the transfer functions named, and checks all that can be checked without the volume.
    /// @throws Error(bad_usage), Error(bad_input) and Error(io) of transfer-function files
    void parse();

    int turntable() const { return turntable_; }
    glm::ivec2 picture_size() const { return size_; }
    /// What the words ask to see of a volume. @pre parse() was called
    Scene scene(const Volume& volume, const VolumeStatistics& statistics) const;
    /// --error-budget and --time-budget: how is the planner's choice then. @pre parse() was called
    std::optional<Budget> budget() const;
    /// The difference in 1/255 from which a pixel counts as wrong: --error-budget, else one level.
    double error_allowed() const { return error_budget_.value_or(1); }
    /// Flags that say nothing in this call, for a note. @pre parse() was called
    std::vector<std::string> without_effect(const Plan& plan) const;
    /// How: the default plan with what was asked for. @pre parse() was called
    Plan plan(const Scene& scene) const;
    /// OUT.png, or OUT-007.png for frame 7 of a turntable.
    std::filesystem::path frame_path(int frame) const;

private:
    /// A transfer function by name: a preset is fitted once the volume is known.
    struct TfChoice {
        std::string preset;
        std::optional<TransferFunction> loaded;
        TransferFunction resolve(const Volume& volume, const VolumeStatistics& statistics) const;
    };
    struct Range {
        ValueRange values;
        std::string name;
        std::optional<TfChoice> tf;
    };
    struct Words {
        std::optional<std::string> mode, iso, tf, window, shading, lmip_threshold, size, azimuth, elevation, roll, zoom,
            center, perspective, step, sampler, gradient, integration, refine, refine_steps, structure, cells, brick,
            homogeneity, sparse, ert, turntable, directions, voxel_gradient, plan, verify_against, error_budget,
            time_budget;
        std::vector<std::string> ranges, cuts, effects;
    };

    static TfChoice parse_tf(const std::string& flag, const std::string& text);
    static Range parse_segmentation_range(const std::string& text);
    static CuttingPlane parse_cut(const std::string& text);
    void take_technique(const std::string& file);
    void parse_camera();
    void parse_plan();
    void parse_replayed_plan();
    void parse_budget();
    void refuse_plan_words(const std::string& with) const;
    void check_combinations() const;
    void rehearse() const;

    Words words_;
    ViewMode mode_ = ViewMode::ea;
    std::optional<double> iso_, lmip_threshold_, step_, error_budget_, time_budget_, ert_, homogeneity_,
        homogeneity_angle_;
    std::optional<int> cells_, sparse_, brick_;
    std::optional<double> sparse_gradient_;
    std::optional<int> directions_;
    std::optional<VoxelGradient> voxel_gradient_;
    bool sparse_aware_ = false;
    std::optional<ValueRange> window_;
    std::optional<Shading> shading_;
    std::optional<TfChoice> tf_;
    std::vector<Range> ranges_;
    std::vector<CuttingPlane> cuts_;
    std::vector<Effect> effects_;
    Camera camera_;
    glm::ivec2 size_{512, 512};
    std::optional<ModePlan> replayed_;
    std::optional<Structure> structure_;
    std::optional<Sampler> sampler_;
    std::optional<Refinement> refine_;
    std::optional<int> refine_steps_;
    std::optional<std::pair<GradientFilter, GradientStore>> gradient_;
    std::optional<Integration> integration_;
    int turntable_ = 1;
};

}  // namespace lacuna::cli
