#include "core/accuracy/shortlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

std::vector<std::string> leave_out(const std::vector<Outlook>& outlooks) {
    const Outlook* best = nullptr;
    for (const Outlook& one : outlooks)
        if (one.ms && !std::isnan(*one.ms) && (!best || *one.ms < *best->ms)) best = &one;
    std::vector<std::string> reasons(outlooks.size());
    for (std::size_t i = 0; i < outlooks.size(); ++i)
        if (best && outlooks[i].ms && !(*outlooks[i].ms <= k_hopeless * *best->ms))
            reasons[i] =
                fmt::format("about {:.3g} ms a frame by this device's costs, {} about {:.3g} ms; not measured.",
                            *outlooks[i].ms, name_of(best->plan.plan.structure), *best->ms);
    return reasons;
}

std::string off_already(const ModePlan& plan, const std::vector<TooFarOff>& measured) {
    const Plan& p = plan.plan;
    for (const TooFarOff& other : measured) {
        const Plan& q = other.plan.plan;
        ModePlan alike = other.plan;
        alike.plan.step = p.step;
        alike.plan.ert = p.ert;
        alike.plan.why = p.why;
        if (q.step <= p.step && q.ert <= p.ert && to_json(alike) == to_json(plan))
            return fmt::format("step {:g} with ert {:g} is {:.3g}/255 off already; not measured.", q.step, q.ert,
                               other.error);
    }
    return "";
}

std::size_t finalists(const std::vector<double>& expected_ms, std::size_t first) {
    std::size_t end = first + 1;
    while (end < expected_ms.size() && end < first + k_finalists && expected_ms[end] <= k_close * expected_ms[first])
        ++end;
    return first < expected_ms.size() ? end - first : 0;
}

}  // namespace lacuna
