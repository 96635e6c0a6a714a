#include "core/strategy/lathe/lathe_finish.h"

#include "core/strategy/lathe/lathe_path.h"
#include "core/strategy/plan/budget.h"

namespace facetmill {

namespace {

const OperationRegistration finish_registration("lathe_finish", "Finish, turning part",
                                                [] { return std::make_unique<LatheFinish>(); });

/// Points between two looks at the cancel flag.
constexpr std::size_t points_per_check = 256;

/// Whether the path comes anywhere deeper than the raw material stands.
bool meets_stock(const LathePath& path, const PlanContext& context, const Progress& progress) {
    const LatheStock stock(path.field().frame(), context, LatheStock::Of::cutter, progress);
    const double least = path.base().chord_tolerance;
    LatheStock::Hint hint;
    for (std::size_t i = 0; i < path.points().size(); ++i) {
        if (i % points_per_check == 0) progress.check();
        if (stock.u(path.points()[i].place, hint) > path.points()[i].u + least) return true;
    }
    return false;
}

} // namespace

const ParameterTable<LatheFinishSettings>& lathe_finish_parameters() {
    static const auto table = [] {
        ParameterTable<LatheFinishSettings> t;
        add_common_parameters(t, Workholding::turning);
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
    // A stock that is the part itself is cut over without a word; an allowance that leaves nothing is a slip.
    if (settings_.allowance > 0 && path.field().stock_radius() > 0
        && !meets_stock(path, context, progress.part(0.97, 0.98)))
        throw_no_stock_above(settings_.name, settings_.allowance, context.unit);
    StrategyResult result = path.base();
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
