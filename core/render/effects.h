#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

struct Frame;
struct Scene;
enum class ViewMode : int;

/// What can be done to a finished picture, named as on the command line (docs/effects.md shows each).
enum class EffectKind { ssao, ao, dof, gamma, tonemap, brightness, contrast };

/// One effect with its values in the order below; values left out take their default.
///   ssao        strength 0..4 (1), radius mm (0: 4 % of the volume's diameter)
///   ao          samples 1..1024 (16), distance mm (0: 10 % of the diameter), strength 0..1 (1), seed (1)
///   dof         focus (0.3: 0..1 is a fraction of the way through the volume's bounding sphere, more is mm from where
///               the rays start), strength 0..8 (1), dimming 0..1 (0)
///   gamma       g 0.1..10: colour^(1/g)
///   tonemap     white 0.1..100 (1.2): the luma shown as white; 1 changes nothing
///   brightness  b -1..1, added
///   contrast    c 0..10, a factor about mid grey
struct Effect {
    EffectKind kind = EffectKind::gamma;
    std::vector<double> values;
    /// Value number i, or its default where it was left out. @pre check() passed
    double value(std::size_t i) const;
    friend bool operator==(const Effect&, const Effect&) = default;
};

std::string_view name_of(EffectKind kind);

/// Reads `name[=v[,v..]][,name..]`: after a comma, a word that starts with a letter begins the next effect, a number
/// continues the values of the effect before it. @throws Error(bad_usage) naming the word and what is known
std::vector<Effect> parse_effects(std::string_view list);
/// The same list as text: parse_effects(to_text(e)) == e.
std::string to_text(const std::vector<Effect>& effects);

/// Whether an effect can do anything in a mode: ao needs one that shows a surface.
bool serves(EffectKind kind, ViewMode mode);

/// @throws Error(bad_usage) for a wrong count of values, a value out of range, or ao in a mode that shows no surface
void check(const std::vector<Effect>& effects, ViewMode mode);

/// Takes a finished picture that a better one will follow, to keep; called on the thread that works.
using FramePreview = std::function<void(Frame)>;

/// Applies the scene's effects in their order to a frame rendered from it. Works on floats, clamps nothing, leaves
/// opacity and depth as they are and pixels of opacity 0 untouched; same bytes for any number of threads. Cost at
/// 512x512 on two threads: a few ms each, but for ao (tenths of a second). Ends within 30 ms of a stop.
/// @param preview  where wanted: gets pictures on the way while ao gathers its samples, each of twice as many as the
///                 one before, all other effects applied; the last picture is the same with it and without. The frame
///                 is copied once for each.
/// @pre check(scene) passed, frame.size == scene.size  @throws Error(cancelled)
void apply_effects(const Scene& scene, Frame& frame, const JobContext& job = {}, const FramePreview& preview = nullptr);

}  // namespace lacuna
