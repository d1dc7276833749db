#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/render_options.h"
#include "core/accuracy/sweep.h"

namespace lacuna::cli {

/// A scene as a scene file or the command line words it: the words of `lacuna render`, and how often to look.
struct SceneWords {
    std::string name;
    std::vector<std::string> words;  ///< of lacuna render, INPUT first, no -o
    int views = 0;                   ///< over 360 degrees of azimuth from the words' own; 0: as the command line says
};

/// Reads a scene file (docs/schemas/scenes.schema.json). Inputs are taken relative to `data`, transfer-function files
/// relative to the scene file. @throws Error(bad_input) naming file, scene and key; Error(io)
std::vector<SceneWords> load_scenes(const std::filesystem::path& file, const std::filesystem::path& data);

/// Reads every scene's words before any volume is opened. @throws Error(bad_usage) naming scene and flag
class BenchScene {
public:
    explicit BenchScene(const SceneWords& scene);

    /// What renders the scene's first view, but for -o, as a shell reads it.
    std::string command() const;
    /// Volumes are opened once as long as scenes in turn share them.
    SweepScene open(const Console& console, int views);

private:
    SceneWords scene_;
    RenderOptions options_;
};

}  // namespace lacuna::cli
