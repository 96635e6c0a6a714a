#include "core/strategy/lathe_finish.h"

#include "core/strategy/budget.h"
#include "core/strategy/lathe_path.h"

namespace facetmill {

namespace {

const OperationRegistration registration("lathe_finish", "Finish, turning part",
                                         [] { return std::make_unique<LatheFinish>(); });

} // namespace

const ParameterTable<LatheFinishSettings>& lathe_finish_parameters() {
    static const auto table = [] {
        ParameterTable<LatheFinishSettings> t;
        add_common_parameters(t);
        add_lathe_parameters(t);
        return t;
    }();
    return table;
}

StrategyResult LatheFinish::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    const double cusp = cusp_budget(settings_, context);
    const double chord = chord_budget(settings_.chord_tolerance, cusp);
    const LathePath path(settings_, context, settings_.allowance + context.tessellation_tolerance[1], cusp,
                         chord, progress.part(0, 0.97));
    StrategyResult result = path.base();
    const std::vector<std::string> uncut = reach_warnings(path.reach(), context.unit);
    result.warnings.insert(result.warnings.end(), uncut.begin(), uncut.end());
    const auto& points = path.points();
    const auto& turns = path.turns();
    for (std::size_t t = 0; t < turns.size(); ++t) {
        progress.check();
        Pass pass;
        pass.drive = int(t);
        pass.offset = points[turns[t]].place.y;
        const std::size_t last = t + 1 < turns.size() ? turns[t + 1] : points.size() - 1;
        pass.cc.reserve(last - turns[t] + 1);
        pass.cl.reserve(last - turns[t] + 1);
        for (std::size_t i = turns[t]; i <= last; ++i) {
            pass.cc.push_back(points[i].cc);
            pass.cl.push_back(path.location(i, points[i].u));
        }
        result.passes.push_back(std::move(pass));
    }
    progress.set(1);
    return result;
}

} // namespace facetmill
