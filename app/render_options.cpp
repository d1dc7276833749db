#include "app/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "app/parse.h"
#include "core/base/atomic_file.h"
#include "core/classify/preset_file.h"
#include "core/render/turn.h"

namespace lacuna::cli {

namespace {

std::optional<double> optional_number(const std::string& flag, const std::optional<std::string>& text) {
    return text ? std::optional(parse_number(flag, *text)) : std::nullopt;
}

}  // namespace

void RenderOptions::add_to(CLI::App& command) {
    input.add_to(command, false);
    input.add_smooth(command);
    command.add_option("-o,--output", output, "picture to write, OUT.png");
    const auto word = [&](const char* flag, std::optional<std::string>& text, const char* meaning) {
        command.add_option(flag, text, meaning);
    };
    const auto words = [&](const char* flag, std::vector<std::string>& texts, const char* meaning) {
        command.add_option(flag, texts, meaning)->allow_extra_args(false)->take_all();
    };
    word("--mode", words_.mode, "iso, ea (default), mip, lmip, minip, mean or shear-warp");
    word("--iso", words_.iso, "isovalue (default: Otsu's threshold)");
    word("--tf", words_.tf,
         "transfer function: FILE or preset:NAME (default: fitted); mode, shading and step a FILE states hold where "
         "no flag says otherwise");
    words("--range", words_.ranges, "LO,HI[:FILE|:preset:NAME]: values outside are transparent (repeat)");
    words("--cut", words_.cuts, "a,b,c,d[:cap|open]: keep a*x+b*y+c*z+d >= 0, mm (repeat)");
    word("--window", words_.window, "LO,HI: grey levels, black to white (default: all values)");
    word("--lmip-threshold", words_.lmip_threshold, "least value of a local maximum (default: Otsu's threshold)");
    word("--shading", words_.shading, "none, lambert or phong (default)");
    word("--size", words_.size, "WxH in pixels (default 512x512)");
    word("--azimuth", words_.azimuth, "degrees; 0 is the view from the front");
    word("--elevation", words_.elevation, "degrees");
    word("--roll", words_.roll, "degrees");
    word("--zoom", words_.zoom, "1 shows the whole volume");
    word("--center", words_.center, "x,y,z in mm (default: the volume's centre)");
    word("--perspective", words_.perspective, "field of view, degrees (default: orthographic)");
    word("--step", words_.step, "sample distance in smallest voxel spacings (default 0.5)");
    word("--sampler", words_.sampler, "nearest, linear (default) or adaptive (nearest where it cannot matter)");
    word("--gradient", words_.gradient,
         "central (default) or sobel, on-the-fly (default) or stored; one of each: sobel,stored");
    word("--integration", words_.integration, "riemann (default), or preintegrated segments between samples (ea)");
    word("--refine", words_.refine, "none, bisect, regula-falsi (default), regula-falsi-plain, newton or cubic (iso)");
    word("--refine-steps", words_.refine_steps, "most refinement steps (default 5)");
    word("--structure", words_.structure,
         "auto (default), none, macrocells, octree, pyramid, pc, acd, eacd, leap or visible (shear-warp)");
    word("--cells", words_.cells, "voxels a macro-cell edge of pc, acd, eacd: 4, 8 (default), 16; 1: an entry a voxel");
    word("--brick", words_.brick, "voxels a brick edge, 8 to 1024 (default: bricks only of what does not fit whole)");
    word("--homogeneity", words_.homogeneity,
         "T[,A]: opacities (octree: values; leap: share of the value range a region spans) and angles that count as "
         "equal");
    leap.add_to(command);
    regions.add_to(command);
    word("--sparse", words_.sparse,
         "K[,G][,aware]: cast every K-th pixel, all where colours differ by more than G (0..1, default 0.02); aware: "
         "and where the structure allows for more than the cast rays met");
    word("--directions", words_.directions, "regions of viewing directions of shear-warp: 6 or 24 (default)");
    word("--voxel-gradient", words_.voxel_gradient,
         "normals of shear-warp with --sampler nearest: central, sobel (default) or gaussian");
    word("--ert", words_.ert, "stop when opacity exceeds 1-E; 0: never (default 0.002)");
    words("--effects", words_.effects,
          "name[=v[,v..]],..: ssao, ao, dof, gamma, tonemap, brightness, contrast, in this order (docs/effects.md)");
    word("--turntable", words_.turntable, "N frames over 360 degrees: OUT-000.png ...");
    word("--error-budget", words_.error_budget,
         "E: the fastest plan no pixel of which is off by more than E/255 from brute force");
    word("--time-budget", words_.time_budget, "MS: the most exact plan that draws a frame in MS milliseconds");
    word("--plan", words_.plan, "FILE or {JSON}: draw by this plan, as lacuna bench and --stats write it");
    command.add_flag("--verify", verify, "also render the reference and report the error");
    word("--verify-against", words_.verify_against,
         "samples (default), fine (a 16 times finer step) or closed-form (of a sample:NAME); implies --verify");
    command.add_option("--verify-map", verify_map,
                       "write where and how much it is off as a picture, OUT.png; implies --verify");
    command.add_option("--stats", stats, "write times, counters and errors as JSON");
    command.add_option("--device", device, "OpenCL device: number, part of its name, or list");
}

RenderOptions::TfChoice RenderOptions::parse_tf(const std::string& flag, const std::string& text) {
    constexpr std::string_view k_preset = "preset:";
    if (!text.starts_with(k_preset)) return {"", load_transfer_function(text)};
    const std::string name = text.substr(k_preset.size());
    const std::vector<std::string> known = preset_names();
    if (std::find(known.begin(), known.end(), name) == known.end())
        refuse(flag, text, fmt::format("a known preset: {}", fmt::join(known, ", ")));
    return {name, std::nullopt};
}

TransferFunction RenderOptions::TfChoice::resolve(const Volume& volume, const VolumeStatistics& statistics) const {
    return loaded ? *loaded : make_preset(preset, volume, statistics);
}

RenderOptions::Range RenderOptions::parse_segmentation_range(const std::string& text) {
    const std::size_t colon = text.find(':');
    Range range;
    range.name = text.substr(0, colon);
    range.values = parse_range("--range", range.name);
    if (colon != std::string::npos) range.tf = parse_tf("--range", text.substr(colon + 1));
    return range;
}

CuttingPlane RenderOptions::parse_cut(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::vector<double> v = parse_numbers("--cut", text.substr(0, colon), 4);
    CuttingPlane cut{{v[0], v[1], v[2]}, v[3], true};
    if (colon != std::string::npos) {
        const std::string kind = text.substr(colon + 1);
        if (kind != "cap" && kind != "open") refuse("--cut", text, "a,b,c,d, a,b,c,d:cap or a,b,c,d:open");
        cut.cap = kind == "cap";
    }
    return cut;
}

/// What a file states of mode, shading and step holds where no word says otherwise.
void RenderOptions::take_technique(const std::string& file) {
    const std::optional<Technique> technique = load_preset(file).technique;
    if (!technique) return;
    try {
        if (!technique->mode.empty() && !words_.mode && !words_.plan) mode_ = parse_view_mode(technique->mode);
        if (!technique->shading.empty() && !words_.shading) shading_ = parse_shading(technique->shading);
    } catch (const Error& fault) {
        throw Error(Errc::bad_input, fmt::format("{}: technique: {}", file, fault.what()));
    }
    if (technique->step != 0 && !words_.step && !words_.plan) step_ = technique->step;
}

void RenderOptions::parse_camera() {
    camera_.azimuth_deg = optional_number("--azimuth", words_.azimuth).value_or(camera_.azimuth_deg);
    camera_.elevation_deg = optional_number("--elevation", words_.elevation).value_or(camera_.elevation_deg);
    camera_.roll_deg = optional_number("--roll", words_.roll).value_or(camera_.roll_deg);
    camera_.zoom = optional_number("--zoom", words_.zoom).value_or(camera_.zoom);
    camera_.fov_deg = optional_number("--perspective", words_.perspective);
    if (!(camera_.zoom > 0)) refuse("--zoom", *words_.zoom, "above 0");
    if (camera_.fov_deg)
        for_flag("--perspective " + *words_.perspective, [&] {
            Camera alone;
            alone.fov_deg = camera_.fov_deg;
            check(alone);
        });
    if (words_.center) {
        const std::vector<double> v = parse_numbers("--center", *words_.center, 3);
        camera_.center_mm = glm::dvec3(v[0], v[1], v[2]);
    }
    if (words_.size) size_ = parse_size("--size", *words_.size);
    if (words_.turntable) turntable_ = int(parse_integer("--turntable", *words_.turntable, 1, 3600));
}

void RenderOptions::parse_plan() {
    step_ = optional_number("--step", words_.step);
    if (step_ && !(*step_ > 0)) refuse("--step", *words_.step, "above 0");
    ert_ = optional_number("--ert", words_.ert);
    if (ert_ && !(*ert_ >= 0 && *ert_ < 1)) refuse("--ert", *words_.ert, "from 0 to below 1");
    if (words_.sampler) sampler_ = for_flag("--sampler", [&] { return parse_sampler(*words_.sampler); });
    if (words_.refine) refine_ = for_flag("--refine", [&] { return parse_refinement(*words_.refine); });
    if (words_.refine_steps) refine_steps_ = int(parse_integer("--refine-steps", *words_.refine_steps, 0, 100));
    if (words_.structure && *words_.structure != "auto")
        structure_ = for_flag("--structure", [&] { return parse_structure(*words_.structure); });
    if (words_.sparse) {
        std::string text = *words_.sparse;
        constexpr std::string_view k_aware = ",aware";
        sparse_aware_ = text.ends_with(k_aware);
        if (sparse_aware_) text.resize(text.size() - k_aware.size());
        const std::vector<double> v = parse_numbers("--sparse", text, text.find(',') == std::string::npos ? 1 : 2);
        if (!(v[0] >= 2 && v[0] <= 64) || v[0] != int(v[0])) refuse("--sparse", text, "a whole number from 2 to 64");
        sparse_ = int(v[0]);
        if (v.size() > 1) sparse_gradient_ = v[1];
        if (v.size() > 1 && !(v[1] >= 0)) refuse("--sparse", text, "a colour difference of at least 0");
    }
    if (words_.cells) {
        cells_ = int(parse_integer("--cells", *words_.cells, 1, 16));
        if (*cells_ & (*cells_ - 1) || *cells_ == 2) refuse("--cells", *words_.cells, "1, 4, 8 or 16");
    }
    if (words_.brick) brick_ = int(parse_integer("--brick", *words_.brick, 8, 1024));
    if (words_.homogeneity) {
        const std::string& text = *words_.homogeneity;
        const std::vector<double> v = parse_numbers("--homogeneity", text, text.find(',') == std::string::npos ? 1 : 2);
        if (!(v[0] >= 0)) refuse("--homogeneity", text, "a threshold of at least 0");
        homogeneity_ = v[0];
        if (v.size() > 1) homogeneity_angle_ = v[1];
        if (v.size() > 1 && !(v[1] >= 0 && v[1] <= 180))
            refuse("--homogeneity", text, "an angle from 0 to 180 degrees");
    }
    if (words_.directions) {
        directions_ = int(parse_integer("--directions", *words_.directions, 6, 24));
        if (*directions_ != 6 && *directions_ != 24) refuse("--directions", *words_.directions, "6 or 24");
    }
    if (words_.voxel_gradient)
        voxel_gradient_ = for_flag("--voxel-gradient", [&] { return parse_voxel_gradient(*words_.voxel_gradient); });
    leap.parse();
    if (words_.gradient) {
        gradient_.emplace(GradientFilter::central, GradientStore::on_the_fly);
        for_flag("--gradient", [&] { parse_gradient(*words_.gradient, gradient_->first, gradient_->second); });
    }
    if (words_.integration)
        integration_ = for_flag("--integration", [&] { return parse_integration(*words_.integration); });
}

/// Words about how to draw, where something else says it.
void RenderOptions::refuse_plan_words(const std::string& with) const {
    for (const auto& [flag, word] :
         {std::pair("--structure", &words_.structure), std::pair("--sampler", &words_.sampler),
          std::pair("--directions", &words_.directions), std::pair("--voxel-gradient", &words_.voxel_gradient),
          std::pair("--refine", &words_.refine), std::pair("--refine-steps", &words_.refine_steps),
          std::pair("--ert", &words_.ert), std::pair("--cells", &words_.cells), std::pair("--sparse", &words_.sparse),
          std::pair("--homogeneity", &words_.homogeneity), std::pair("--brick", &words_.brick),
          std::pair("--gradient", &words_.gradient), std::pair("--integration", &words_.integration)})
        if (*word) throw Error(Errc::bad_usage, fmt::format("{} does not go with {}.", flag, with));
    if (leap.given()) throw Error(Errc::bad_usage, fmt::format("{} does not go with {}.", leap.given(), with));
}

void RenderOptions::parse_budget() {
    error_budget_ = optional_number("--error-budget", words_.error_budget);
    time_budget_ = optional_number("--time-budget", words_.time_budget);
    if (error_budget_ && !(*error_budget_ >= 0)) refuse("--error-budget", *words_.error_budget, "at least 0");
    if (time_budget_ && !(*time_budget_ > 0)) refuse("--time-budget", *words_.time_budget, "above 0");
    if (!error_budget_ && !time_budget_) return;
    refuse_plan_words("a budget, by which the planner picks it");
    if (words_.plan) throw Error(Errc::bad_usage, "--plan does not go with a budget, by which the planner picks it.");
    if (mode_ == ViewMode::shear_warp)
        throw Error(Errc::bad_usage, "A budget does not go with --mode shear-warp, which has one plan.");
}

/// --plan replaces every word about how to draw, and brings its mode.
void RenderOptions::parse_replayed_plan() {
    if (!words_.plan) return;
    refuse_plan_words("--plan, which says it all");
    if (words_.step) throw Error(Errc::bad_usage, "--step does not go with --plan, which says it all.");
    constexpr std::uintmax_t k_most_bytes = 1 << 16;
    const bool inline_json = words_.plan->starts_with("{");
    replayed_ = plan_from_json(inline_json ? *words_.plan : read_file(*words_.plan, k_most_bytes),
                               inline_json ? "--plan" : *words_.plan);
    if (words_.mode && mode_ != replayed_->mode)
        throw Error(Errc::bad_usage, fmt::format("--mode {} does not go with --plan, whose mode is {}.", *words_.mode,
                                                 name_of(replayed_->mode)));
    mode_ = replayed_->mode;
}

void RenderOptions::check_combinations() const {
    if (regions.functions() && mode_ != ViewMode::ea)
        throw Error(Errc::bad_usage, "--region-tf goes with --mode ea alone.");
    if (regions.any() && mode_ == ViewMode::shear_warp)
        throw Error(Errc::bad_usage,
                    "--regions and --region-tf do not go with --mode shear-warp, which paints surface voxels whatever "
                    "region they are in.");
    if (mode_ == ViewMode::shear_warp) {
        if (camera_.fov_deg)
            throw Error(Errc::bad_usage,
                        "--perspective does not go with --mode shear-warp, which is orthographic only.");
        if (verify)
            throw Error(Errc::bad_usage,
                        "--verify does not go with --mode shear-warp: the reference renderer has no such mode; "
                        "compare with --mode iso.");
    }
    const std::string extension = std::filesystem::path(output).extension().string();
    if (!extension.empty() && extension != ".png" && extension != ".PNG")
        refuse("-o", output, "a .png file, the one kind of picture written");
    const std::string map_extension = std::filesystem::path(verify_map).extension().string();
    if (!map_extension.empty() && map_extension != ".png" && map_extension != ".PNG")
        refuse("--verify-map", verify_map, "a .png file, the one kind of picture written");
    if (verify_against == Truth::closed_form && input.smooth_mm > 0)
        throw Error(Errc::bad_usage,
                    "--smooth does not go with --verify-against closed-form, which is that of the sample as it is.");
}

/// Checks scene and plan on a tiny volume, so that no wrong word is found only after a long read.
void RenderOptions::rehearse() const {
    GridGeometry geometry;
    geometry.size = {2, 2, 2};
    const Volume tiny = make_volume<std::uint8_t>(geometry, [](std::span<std::uint8_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint8_t(i);
    });
    const Scene trial = scene(tiny, compute_statistics(tiny));
    lacuna::check(trial);
    const Plan planned = plan(trial);
    lacuna::check(planned, trial);
    if (leap.given() && planned.structure != Structure::leap)
        throw Error(Errc::bad_usage, fmt::format("{} goes with --structure leap.", leap.given()));
}

void RenderOptions::parse() {
    input.check();
    if (input.input.empty()) throw Error(Errc::bad_usage, "INPUT is missing; see lacuna render --help.");
    if (output.empty()) throw Error(Errc::bad_usage, "-o OUT.png is missing; see lacuna render --help.");
    if (words_.mode) mode_ = for_flag("--mode", [&] { return parse_view_mode(*words_.mode); });
    if (words_.shading) shading_ = for_flag("--shading", [&] { return parse_shading(*words_.shading); });
    iso_ = optional_number("--iso", words_.iso);
    lmip_threshold_ = optional_number("--lmip-threshold", words_.lmip_threshold);
    if (words_.window) window_ = parse_range("--window", *words_.window);
    parse_camera();
    parse_plan();
    if (words_.tf) {
        tf_ = parse_tf("--tf", *words_.tf);
        if (tf_->loaded) take_technique(*words_.tf);
    }
    parse_replayed_plan();
    parse_budget();
    if (words_.verify_against)
        verify_against = for_flag("--verify-against", [&] { return parse_truth(*words_.verify_against); });
    if (words_.verify_against || !verify_map.empty()) verify = true;
    if (verify_against == Truth::closed_form && !input.input.starts_with("sample:"))
        refuse("--verify-against", *words_.verify_against, "known for an input other than sample:NAME");
    for (const std::string& text : words_.cuts) cuts_.push_back(parse_cut(text));
    for (const std::string& text : words_.effects)
        for (Effect& effect : for_flag("--effects", [&] { return parse_effects(text); }))
            effects_.push_back(std::move(effect));
    regions.parse();
    check_combinations();
    for (const std::string& text : words_.ranges) ranges_.push_back(parse_segmentation_range(text));
    rehearse();
}

Scene RenderOptions::scene(const Volume& volume, const VolumeStatistics& statistics) const {
    Scene scene = default_scene(volume, statistics);
    scene.mode = mode_;
    scene.camera = camera_;
    scene.size = size_;
    scene.cuts = cuts_;
    scene.effects = effects_;
    if (iso_) scene.iso = *iso_;
    if (lmip_threshold_) scene.lmip_threshold = *lmip_threshold_;
    if (window_) scene.window = *window_;
    if (shading_) scene.shading = *shading_;
    if (tf_) {
        scene.classification.tf = tf_->resolve(volume, statistics);
        scene.color_by_tf = true;
    }
    for (const Range& range : ranges_) {
        SegmentationRange kept{range.name, range.values, std::nullopt};
        if (range.tf) kept.tf = range.tf->resolve(volume, statistics);
        scene.classification.ranges.push_back(std::move(kept));
    }
    return scene;
}

std::optional<Budget> RenderOptions::budget() const {
    if (!error_budget_ && !time_budget_) return std::nullopt;
    Budget budget{error_budget_, time_budget_};
    if (step_) budget.step = *step_;
    budget.frames = std::max(budget.frames, turntable_);
    budget.other_views = full_turn(camera_, turntable_);
    budget.other_views.erase(budget.other_views.begin());
    return budget;
}

Plan RenderOptions::plan(const Scene& scene) const {
    if (replayed_) return replayed_->plan;
    Plan plan = default_plan(scene);
    const auto take = [&](auto& value, const auto& asked, const char* flag) {
        if (!asked) return;
        value = *asked;
        plan.why.push_back(fmt::format("{} as asked for", flag));
    };
    take(plan.structure, structure_, "--structure");
    if (structure_) plan.cells = Plan{}.cells;  // fine cells were chosen for the default structure
    take(plan.step, step_, words_.step ? "--step" : "the step of the --tf file");
    take(plan.sampler, sampler_, "--sampler");
    take(plan.refine, refine_, "--refine");
    take(plan.refine_steps, refine_steps_, "--refine-steps");
    if (gradient_) {
        std::tie(plan.gradient, plan.gradient_store) = *gradient_;
        plan.why.push_back("--gradient as asked for");
    }
    take(plan.integration, integration_, "--integration");
    take(plan.ert, ert_, "--ert");
    if (ert_ && scene.mode == ViewMode::ea) plan.why.push_back(termination_reason(plan.ert, scene.shading));
    add_method_reasons(plan, scene);
    if (input.smooth_mm > 0)
        plan.why.push_back(
            fmt::format("Smoothed by a Gaussian of {:g} mm before anything else, as asked for.", input.smooth_mm));
    take(plan.cells, cells_, "--cells");
    take(plan.brick, brick_, "--brick");
    take(plan.sparse, sparse_, "--sparse");
    if (sparse_gradient_) plan.sparse_gradient = *sparse_gradient_;
    take(plan.directions, directions_, "--directions");
    take(plan.voxel_gradient, voxel_gradient_, "--voxel-gradient");
    plan.sparse_aware = sparse_aware_;
    take(plan.homogeneity, homogeneity_, "--homogeneity");
    if (homogeneity_angle_) plan.homogeneity_angle_deg = *homogeneity_angle_;
    leap.apply(plan);
    if (const std::string note = gain_note(plan, scene); !note.empty()) plan.why.push_back(note);
    return plan;
}

std::filesystem::path RenderOptions::frame_path(int frame) const {
    std::filesystem::path path = output;
    if (turntable_ > 1)
        path.replace_filename(fmt::format("{}-{:03}{}", path.stem().string(), frame, path.extension().string()));
    return path;
}

}  // namespace lacuna::cli
