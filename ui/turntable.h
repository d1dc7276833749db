#pragma once

#include <QString>

#include "core/accuracy/planner.h"

namespace lacuna::ui {

/// A full turn about the vertical axis, drawn frame by frame.
struct Turntable {
    Scene scene;
    Plan plan;
    /// Kept by every picture of the turn: the planner then picks another plan, as the one in use is for one view.
    std::optional<Budget> budget;
    int frames = 72;
    QString file;  ///< .png: a series NAME-000.png ..; .mp4 or .webm: a film of 24 frames a second
};

/// The program that makes films of pictures; empty where there is none.
QString film_encoder();

/// Draws and writes. A film appears whole or not at all; of a series every picture does. Runs on a worker thread.
/// @throws Error(unsupported) where a film is asked for and ffmpeg is missing or fails; Error(io), Error(cancelled)
void write_turntable(const Turntable& table, Engine& engine, const JobContext& job);

}  // namespace lacuna::ui
