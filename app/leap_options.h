#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/render/plan.h"

namespace lacuna::cli {

/// The words of `lacuna render` about leaping: how its volume is made and used.
class LeapWords {
public:
    void add_to(CLI::App& command);
    /// @throws Error(bad_usage) for a word that means nothing
    void parse();
    /// The first flag given; null: none was.
    const char* given() const;
    /// Puts what was said into a plan, with its reasons. @pre parse() was called
    void apply(Plan& plan) const;

private:
    std::optional<std::string> kernel_word_, values_word_, quantise_word_, min_voxels_word_;
    LeapPlan leap_;
};

}  // namespace lacuna::cli
