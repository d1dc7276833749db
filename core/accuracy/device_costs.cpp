#include "core/accuracy/device_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/log.h"
#include "core/compute/program_cache.h"

namespace lacuna {

namespace {

using nlohmann::ordered_json;

constexpr int k_side = 48, k_picture = 192, k_timings = 5, k_sparse = 4;
constexpr double k_step = 0.5;

struct Field {
    const char* key;
    double DeviceCosts::*member;
};
constexpr std::array<Field, 8> k_fields{{{"frame_ms", &DeviceCosts::frame_ms},
                                         {"ray_ns", &DeviceCosts::ray_ns},
                                         {"sample_ns", &DeviceCosts::sample_ns},
                                         {"nearest_ns", &DeviceCosts::nearest_ns},
                                         {"shown_ns", &DeviceCosts::shown_ns},
                                         {"gradient_ns", &DeviceCosts::gradient_ns},
                                         {"read_ns", &DeviceCosts::read_ns},
                                         {"sparse_pixel_ns", &DeviceCosts::sparse_pixel_ns}}};

/// A ramp, so that there is a gradient everywhere.
Volume ramp() {
    GridGeometry grid;
    grid.size = glm::ivec3(k_side);
    return make_volume<std::uint16_t>(grid, [](auto voxels) {
        std::size_t i = 0;
        for (int z = 0; z < k_side; ++z)
            for (int y = 0; y < k_side; ++y)
                for (int x = 0; x < k_side; ++x) voxels[i++] = std::uint16_t(400 * (x + y + z));
    });
}

class Calibration {
public:
    Calibration(Engine& engine, const JobContext& job) : engine_(engine), job_(job) {
        scene_.volume = ramp();
        scene_.mode = ViewMode::ea;
        scene_.size = glm::ivec2(k_picture);
        scene_.camera.azimuth_deg = 30;
        scene_.camera.elevation_deg = 20;
        scene_.shading = Shading::none;
        scene_.classification.tf = {"calibration", 1.0, {{0, {1, 1, 1}, 0}, {60000, {1, 1, 1}, 0}}, {}};
        plan_ = default_plan(scene_);
        plan_.structure = Structure::none;
        plan_.step = k_step;
        plan_.ert = 0;
        plan_.cells = 4;
    }

    DeviceCosts run() {
        const ViewFacts facts = measure_view_facts(scene_, k_step, k_picture * k_picture, {job_.stop});
        const double rays = facts.rays, samples = facts.whole.samples;
        DeviceCosts costs;
        costs.frame_ms = time([](Scene& scene, Plan&) { scene.size = glm::ivec2(8); });
        const auto cells = [](Scene&, Plan& plan) { plan.structure = Structure::macrocells; };
        const auto distances = [](Scene&, Plan& plan) { plan.structure = Structure::acd; };
        const double near_ms = time(distances), cells_ms = time(cells);
        const double few = reads(distances), many = reads(cells);
        costs.read_ns = per(cells_ms - near_ms, many - few);
        costs.ray_ns = per(near_ms - costs.frame_ms - few * costs.read_ns * 1e-6, rays);
        const double lead_ms = costs.frame_ms + rays * costs.ray_ns * 1e-6;
        const double plain_ms = time([](Scene&, Plan&) {});
        costs.sample_ns = per(plain_ms - lead_ms, samples);
        costs.nearest_ns = per(time([](Scene&, Plan& plan) { plan.sampler = Sampler::nearest; }) - lead_ms, samples);
        const auto faint = [](Scene& scene, Plan&) {
            for (TransferPoint& point : scene.classification.tf.points) point.opacity = 0.0005;
        };
        const double shown_ms = time(faint);
        costs.shown_ns = per(shown_ms - plain_ms, samples);
        costs.gradient_ns = per(time([&](Scene& scene, Plan& plan) {
                                    faint(scene, plan);
                                    scene.shading = Shading::phong;
                                }) - shown_ms,
                                samples);
        const double sparse_ms = time([](Scene&, Plan& plan) { plan.sparse = k_sparse; });
        const double share = 1.0 / (k_sparse * k_sparse);
        costs.sparse_pixel_ns =
            per(sparse_ms - costs.frame_ms - share * (plain_ms - costs.frame_ms), double(k_picture) * k_picture);
        return costs;
    }

private:
    static double per(double ms, double count) { return count > 0 ? std::max(0.0, 1e6 * ms / count) : 0; }

    double time(const std::function<void(Scene&, Plan&)>& change) {
        Scene scene = scene_;
        Plan plan = plan_;
        change(scene, plan);
        engine_.render(scene, plan, {job_.stop});
        std::array<double, k_timings> times{};
        for (double& one : times) one = engine_.render(scene, plan, {job_.stop}).frame.ms;
        job_.checkpoint(++done_, k_pictures);
        std::sort(times.begin(), times.end());
        return times[k_timings / 2];
    }

    double reads(const std::function<void(Scene&, Plan&)>& change) {
        Scene scene = scene_;
        Plan plan = plan_;
        change(scene, plan);
        return double(engine_.render(scene, plan, {job_.stop}, true).frame.counters.structure_reads);
    }

    static constexpr std::size_t k_pictures = 8;
    Engine& engine_;
    const JobContext& job_;
    Scene scene_;
    Plan plan_;
    std::size_t done_ = 0;
};

/// The kernels' version: costs of other ones say nothing.
std::string program_version() {
    const std::size_t hash = std::hash<std::string>()(expand_kernel_source("render/raycast_ea.cl"));
    char text[24];
    std::snprintf(text, sizeof text, "%016zx", hash);
    return text;
}

std::optional<std::string> driver_of(const std::string& device) {
    for (const DeviceInfo& info : list_devices(false))
        if (info.name == device) return info.driver;
    return std::nullopt;
}

}  // namespace

DeviceCosts measure_costs(Engine& engine, const JobContext& job) { return Calibration(engine, job).run(); }

std::string describe(const DeviceCosts& costs) {
    return fmt::format(
        "a frame {:.3g} ms, a ray {:.3g} ns, a trilinear sample {:.3g} ns, a nearest one {:.3g} ns, shown {:.3g} ns "
        "more, "
        "shaded {:.3g} ns more, a look-up {:.3g} ns, a sparse pixel {:.3g} ns",
        costs.frame_ms, costs.ray_ns, costs.sample_ns, costs.nearest_ns, costs.shown_ns, costs.gradient_ns,
        costs.read_ns, costs.sparse_pixel_ns);
}

std::string to_json(const DeviceCosts& costs) {
    ordered_json json{{"device", costs.device}, {"driver", costs.driver}, {"program", costs.program}};
    for (const Field& field : k_fields) json[field.key] = costs.*field.member;
    return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

DeviceCosts device_costs_from_json(const std::string& text, const std::string& where) {
    const ordered_json json = ordered_json::parse(text, nullptr, false);
    const auto refuse = [&](const std::string& key) {
        throw Error(Errc::bad_input, where + ": the device's costs have no good \"" + key + "\".");
    };
    if (!json.is_object()) throw Error(Errc::bad_input, where + ": this is no JSON object of a device's costs.");
    DeviceCosts costs;
    for (const auto& [key, member] : {std::pair{"device", &DeviceCosts::device},
                                      {"driver", &DeviceCosts::driver},
                                      {"program", &DeviceCosts::program}}) {
        if (!json.contains(key) || !json[key].is_string()) refuse(key);
        costs.*member = json[key].get<std::string>();
    }
    for (const Field& field : k_fields) {
        if (!json.contains(field.key) || !json[field.key].is_number()) refuse(field.key);
        costs.*field.member = json[field.key].get<double>();
        if (!(costs.*field.member >= 0 && std::isfinite(costs.*field.member))) refuse(field.key);
    }
    return costs;
}

std::filesystem::path costs_file(const std::string& device) {
    const std::filesystem::path folder = ProgramCache::default_folder();
    if (folder.empty()) return {};
    char name[40];
    std::snprintf(name, sizeof name, "costs-%016zx.json", std::hash<std::string>()(device));
    return folder / name;
}

std::optional<DeviceCosts> kept_costs(const std::string& device, const std::string& driver) {
    constexpr std::uintmax_t k_most_bytes = 1 << 16;
    const std::filesystem::path file = costs_file(device);
    std::error_code ec;
    if (file.empty() || !std::filesystem::is_regular_file(file, ec)) return std::nullopt;
    try {
        const DeviceCosts costs = device_costs_from_json(read_file(file, k_most_bytes), file.filename().string());
        if (costs.device != device || costs.driver != driver || costs.program != program_version()) return std::nullopt;
        return costs;
    } catch (const Error&) {
        return std::nullopt;  // damaged: measured again
    }
}

std::optional<DeviceCosts> costs_of(Engine& engine, const JobContext& job, bool anew) {
    const std::string device = engine.device_name();
    const std::optional<std::string> driver = driver_of(device);
    if (!driver) return std::nullopt;
    if (!anew)
        if (auto kept = kept_costs(device, *driver)) return kept;
    DeviceCosts costs = measure_costs(engine, job);
    costs.device = device;
    costs.driver = *driver;
    costs.program = program_version();
    const std::filesystem::path file = costs_file(device);
    if (file.empty()) return costs;
    std::error_code ec;
    std::filesystem::create_directories(file.parent_path(), ec);
    try {
        write_file(file, to_json(costs));
    } catch (const Error& failure) {
        log(LogLevel::debug, std::string("The device's costs are not kept on disk: ") + failure.what());
    }
    return costs;
}

namespace {

struct Work {
    double samples = 0, reads = 0;
};

/// What a structure leaves to do, on average over its cells' places: each run of empty samples ends in cells that hold
/// something as well, which are sampled whole.
std::optional<Work> work_of(const RayFacts& facts, const Plan& plan) {
    const double finer = 1 / plan.step;
    const auto skipping = [&](double cell) {
        const double border = facts.stretches * std::min(facts.empty_run(), cell);
        return std::min(facts.samples, facts.shown + border);
    };
    const double cell = plan.cells * finer, steps = std::log2(1 + facts.empty_run() / cell);
    switch (plan.structure) {
        case Structure::none:
            return Work{facts.samples, 0};
        case Structure::macrocells:
            return Work{skipping(8 * finer), facts.samples / (8 * finer)};
        case Structure::octree:
            return Work{skipping(2 * finer), facts.stretches * 8 + facts.shown / (2 * finer)};
        case Structure::pyramid:
            return Work{skipping(finer), facts.stretches * 6 + facts.shown};
        case Structure::pc:
            return Work{skipping(cell), facts.stretches * (2 + 1.5 * steps) + facts.shown / cell};
        case Structure::acd:
            return Work{skipping(cell), facts.stretches * (2 + steps) + facts.shown / cell};
        case Structure::eacd:
            return Work{skipping(cell), facts.stretches * (2 + 0.8 * steps) + facts.shown / cell};
        case Structure::leap:
        case Structure::visible:
            break;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> predicted_ms(const DeviceCosts& costs, const ViewFacts& facts, const Scene& scene,
                                   const Plan& plan, double step) {
    const bool ends = scene.mode == ViewMode::iso || scene.mode == ViewMode::ea;
    if (!ends && (scene.mode != ViewMode::mean || plan.structure != Structure::none)) return std::nullopt;
    if (scene.mode == ViewMode::shear_warp || plan.sparse >= 2 || plan.brick != 0) return std::nullopt;
    const bool to_the_end = scene.mode != ViewMode::iso && !(plan.ert > 0);
    RayFacts rays = to_the_end ? facts.whole : facts.seen;
    const double share = step / plan.step;
    rays.samples *= share;
    rays.shown *= scene.mode == ViewMode::iso ? 1 : share;
    const std::optional<Work> work = work_of(rays, plan);
    if (!work) return std::nullopt;
    const bool shaded = ends && scene.shading != Shading::none;
    const double ns = facts.rays * costs.ray_ns +
                      work->samples * (plan.sampler == Sampler::nearest ? costs.nearest_ns : costs.sample_ns) +
                      rays.shown * (costs.shown_ns + (shaded ? costs.gradient_ns : 0)) + work->reads * costs.read_ns;
    return costs.frame_ms + 1e-6 * ns;
}

double predicted_sparse_ms(const DeviceCosts& costs, double pixels, double share, double every_pixel_ms) {
    const double rays_ms = std::max(0.0, every_pixel_ms - costs.frame_ms);
    return costs.frame_ms + share * rays_ms + 1e-6 * pixels * costs.sparse_pixel_ns;
}

}  // namespace lacuna
