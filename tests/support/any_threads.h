// That a plan is the same with one thread and with all of them.
#pragma once

#include "core/base/parallel.h"
#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill::test {

/// Whether `plan`, which returns a StrategyResult, has the same tips with any number of threads.
template <class Plan>
bool same_with_any_threads(const Plan& plan) {
    const auto all_tips = [&] {
        std::vector<Vec3> tips;
        const StrategyResult result = plan();
        for (const Pass& p : result.passes)
            for (const CutterLocation& c : p.cl)
                tips.push_back(c.tip);
        return tips;
    };
    const std::vector<Vec3> many = all_tips();
    set_thread_count(1);
    const std::vector<Vec3> one = all_tips();
    set_thread_count(0);
    return !many.empty() && many == one;
}

} // namespace facetmill::test
