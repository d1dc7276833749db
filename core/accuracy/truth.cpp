#include "core/accuracy/truth.h"

#include <fmt/format.h>

#include "core/accuracy/closed_form.h"
#include "core/base/names.h"
#include "core/render/reference_renderer.h"

namespace lacuna {

namespace {

constexpr NameTable<Truth, 3> k_truth_names{
    {{Truth::samples, "samples"}, {Truth::fine, "fine"}, {Truth::closed_form, "closed-form"}}};

constexpr double k_finer = 16;

}  // namespace

std::string_view name_of(Truth truth) { return name_in(k_truth_names, truth); }
Truth parse_truth(std::string_view text) { return parse_name(k_truth_names, text, "reference"); }

TrueFrame render_truth(Truth truth, const Scene& scene, const Plan& like, const AnalyticSample* sample,
                       const JobContext& job) {
    if (truth == Truth::closed_form) {
        if (!sample)
            throw Error(Errc::unsupported,
                        "Only a built-in sample has a closed form to compare with; take sample:NAME or the reference "
                        "'fine'.");
        return render_closed_form(scene, *sample, like, job);
    }
    Plan plan = reference_plan(scene, like);
    if (truth == Truth::fine) plan.step /= k_finer;
    TrueFrame made{render_reference(scene, plan, job), "", true};
    apply_effects(scene, made.frame, job);
    made.reference = fmt::format("reference renderer, structure none, ert {:g}, step {:g}, sampler {}", plan.ert,
                                 plan.step, name_of(plan.sampler));
    return made;
}

}  // namespace lacuna
