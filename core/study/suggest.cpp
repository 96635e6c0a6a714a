#include "core/study/suggest.h"

#include "core/job/axis_view.h"
#include "core/job/project_setup.h"
#include "core/job/verification.h"
#include "core/job/verify_limits.h"
#include "core/job/work_estimate.h"
#include "core/strategy/surface/slope_facets.h"
#include "core/study/evaluation.h"
#include "core/study/previewed.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace facetmill {

namespace {

/// How many are suggested, and how many of those that can be planned are judged, at least.
constexpr std::size_t max_suggested = 3, fewest_judged = 4;
/// Of a processor: longer than that nobody waits for advice.
constexpr double longest_wait = 15;
/// A preview leaves no more than others where it is less than this share of the part.
constexpr double more_left = 0.02;

/// Nothing of them but a curve says where they cut.
bool needs_curve(const Operation& operation) {
    return operation.kind() == "along_curve";
}

bool runs_on(const Operation& operation, const Machine& machine, bool turns) {
    if (operation.turning()) return turns && !machine.rotary.empty();
    if (turns) return false;
    return operation.keeps_axis() || machine.rotary.size() == 2;
}

/// The largest tool with a round end, or a rounded corner.
const Tool* largest_round(const Project& project) {
    const Tool* best = nullptr;
    for (const Tool& t : project.tools)
        if (t.corner_radius > 0 && t.taper_angle >= 0 && (!best || t.corner_radius > best->corner_radius))
            best = &t;
    return best;
}

/// The shown setup with its roughing alone.
Project roughing_of(const Project& project) {
    Project rough = project;
    rough.after.clear();
    std::erase_if(rough.operations,
                  [](const auto& o) { return o->common().off || o->purpose() != Purpose::roughing; });
    return rough;
}

double seconds_of(const RungResult& result) {
    return result.measures[Measure::machining_time].value_or(0);
}

/// What it leaves: the share of the surface that stays uncut, then the height of what stays.
std::pair<double, double> left_by(const Suggestion& s) {
    return {s.result.measures[Measure::uncut_share].value_or(1),
            s.result.measures[Measure::excess_p99].value_or(infinity)};
}

/// Less than this share of the surface more, or of the height, is the same.
constexpr double same_share = 0.002, same_height = 0.1;

bool no_worse(const Suggestion& a, const Suggestion& b) {
    const auto [uncut, high] = left_by(a);
    const auto [other_uncut, other_high] = left_by(b);
    return a.result.passed >= b.result.passed && a.seconds <= b.seconds && uncut <= other_uncut + same_share
           && high <= other_high * (1 + same_height);
}

/// Verified ones first, and of like ones the quicker.
bool preferred(const Suggestion& a, const Suggestion& b) {
    if (a.result.passed != b.result.passed) return a.result.passed;
    const double uncut = left_by(a).first, other = left_by(b).first;
    if (!a.result.passed && std::abs(uncut - other) > same_share) return uncut < other;
    return a.seconds < b.seconds;
}

class Suggester {
public:
    Suggester(const Project& project, const PreparedPart& part)
        : project_(project), part_(part), rough_(roughing_of(project)) {}

    Suggestions run(const Progress& progress) {
        describe(progress.part(0, 0.02));
        const auto all = suggestable(project_);
        made_.looked_at = all.size();
        add_roughing(all);
        std::vector<Suggestion> found = previewed(all, progress.part(0.02, 0.1));
        std::set<const Operation*> fit;
        double wait = roughing_wait();
        for (const Suggestion& s : found) {
            if (wait + s.planning_seconds > longest_wait) continue;
            wait += s.planning_seconds;
            fit.insert(s.operation.get());
        }
        if (fit.size() == found.size() || fit.size() >= fewest_judged)
            found = judged(all, fit, progress.part(0.1, 1));
        choose(found);
        return std::move(made_);
    }

private:
    /// Where it is needed.
    void add_roughing(const std::vector<std::shared_ptr<const Operation>>& all) {
        for (const auto& operation : all) {
            const auto unroughed = unroughed_stock(rough_, part_, *operation);
            if (!unroughed) continue;
            made_.unroughed = *unroughed;
            made_.rough = new_operation("rough", project_);
            rough_.operations.push_back(made_.rough->operation->clone());
            if (made_.rough->tool) rough_.tools.push_back(*made_.rough->tool);
            return;
        }
    }

    /// Of a processor: what planning the roughing takes that goes before each, about.
    double roughing_wait() const {
        double seconds = 0;
        for (const auto& o : rough_.operations)
            for (const WorkEstimate& work : estimate_plan(rough_, part_, o->common().name))
                seconds += work.seconds;
        return seconds;
    }

    /// By what their previews say, the best first.
    std::vector<Suggestion> previewed(const std::vector<std::shared_ptr<const Operation>>& all,
                                      const Progress& progress) {
        PassPreviewer previewer;
        std::vector<Suggestion> found;
        double least = infinity;
        for (std::size_t i = 0; i < all.size(); ++i) {
            progress.task(all[i]->common().name);
            const Project with = candidate(*all[i]);
            try {
                const PreviewedOperation preview = previewed_operation(
                    previewer, with, with.operations.size() - 1, part_, share(progress, 0, 1, i, all.size()));
                Suggestion s = named(all[i]);
                s.previewed = true;
                s.seconds = preview.seconds;
                s.result.measures[Measure::uncut_share] = preview.uncut_share;
                s.planning_seconds = preview.planning_seconds;
                least = std::min(least, preview.uncut_share);
                found.push_back(std::move(s));
            } catch (const Error& e) {
                made_.refused.emplace_back(all[i]->common().name, e.what());
            }
        }
        for (Suggestion& s : found)
            s.result.passed = left_by(s).first <= least + more_left;
        std::ranges::stable_sort(found, preferred);
        return found;
    }

    /// Those of all that are wanted, planned and the quicker half of them judged.
    std::vector<Suggestion> judged(const std::vector<std::shared_ptr<const Operation>>& all,
                                   const std::set<const Operation*>& wanted, const Progress& progress) {
        if (!rough_.operations.empty())
            before_ = seconds_of(evaluate(rough_, rough_, Rung::estimate, progress.part(0, 0.1)));
        std::vector<Suggestion> planned;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!wanted.contains(all[i].get())) continue;
            progress.task(all[i]->common().name);
            Suggestion s = looked_at(all[i], Rung::estimate, share(progress, 0.1, 0.5, i, all.size()));
            if (s.result.passed)
                planned.push_back(std::move(s));
            else
                made_.refused.emplace_back(all[i]->common().name, s.result.why);
        }
        std::ranges::stable_sort(planned, {}, &Suggestion::seconds);
        const std::size_t most = std::min(planned.size(), std::max(fewest_judged, (planned.size() + 1) / 2));
        std::vector<Suggestion> found;
        for (std::size_t i = 0; i < most; ++i) {
            progress.task(planned[i].operation->common().name);
            Suggestion s = looked_at(planned[i].operation, Rung::coarse, share(progress, 0.5, 1, i, most));
            if (gouges(s))
                made_.refused.emplace_back(s.operation->common().name, s.result.why);
            else
                found.push_back(std::move(s));
        }
        return found;
    }

    static Progress share(const Progress& progress, double from, double to, std::size_t i, std::size_t n) {
        return progress.part(from + (to - from) * double(i) / double(n),
                             from + (to - from) * double(i + 1) / double(n));
    }

    void describe(const Progress& progress) {
        const std::vector<double> slopes = facet_slopes(*part_.mesh, false, Mat3::Identity(), progress);
        double steep = 0, all = 0;
        for (std::size_t f = 0; f < slopes.size(); ++f) {
            if (!(slopes[f] <= 0.5 * pi)) continue;
            const double area = part_.mesh->facet_cross(f).norm();
            all += area;
            if (slopes[f] > made_.part.steep) steep += area;
        }
        made_.part.steep_share = all > 0 ? steep / all : 0;
    }

    Project candidate(const Operation& operation) const {
        Project candidate = rough_;
        candidate.operations.push_back(operation.clone());
        candidate.operations.back()->common().name = free_operation_name(rough_, operation.common().name);
        return candidate;
    }

    Suggestion looked_at(const std::shared_ptr<const Operation>& operation, Rung rung,
                         const Progress& progress) const {
        const Project candidate = this->candidate(*operation);
        Suggestion s = named(operation);
        s.result = evaluate(candidate, candidate, rung, progress);
        s.seconds = seconds_of(s.result) - before_;
        return s;
    }

    Suggestion named(const std::shared_ptr<const Operation>& operation) const {
        Suggestion s;
        s.operation = operation;
        const Tool& tool = project_.tool_of(*operation);
        s.tool = "T" + std::to_string(tool.number) + ' ' + tool.name;
        return s;
    }

    bool gouges(const Suggestion& s) const {
        const double limit = verify_settings(candidate(*s.operation), nullptr).gouge_limit;
        const auto gouge = s.result.measures[Measure::gouge_max];
        return !gouge || *gouge * mm_per(project_.unit) > limit;
    }

    void choose(std::vector<Suggestion>& found) {
        if (found.empty()) {
            const auto& why = made_.refused;
            throw Error(
                ErrorCode::empty_result, "suggest",
                "none of the operations looked at can be made"
                    + (why.empty() ? std::string() : ": " + why.front().first + ": " + why.front().second),
                "check part, tools and machine");
        }
        std::ranges::stable_sort(found, preferred);
        std::vector<Suggestion> others;
        for (std::size_t i = 0; i < found.size(); ++i) {
            // What does not pass comes after all that do, however quick it is.
            const bool fails = found.front().result.passed && !found[i].result.passed;
            const bool surpassed = fails
                                   || std::any_of(found.begin(), found.begin() + std::ptrdiff_t(i),
                                                  [&](const Suggestion& s) { return no_worse(s, found[i]); });
            (surpassed ? others : made_.best).push_back(found[i]);
        }
        // Where fewer are left the next ones are named as well: three are better to choose from.
        made_.best.insert(made_.best.end(), others.begin(), others.end());
        if (made_.best.size() > max_suggested) made_.best.resize(max_suggested);
        made_.part.allowed = made_.best.front().operation->common().tolerance;
    }

    const Project& project_;
    const PreparedPart& part_;
    Project rough_;
    double before_ = 0; ///< seconds that roughing takes
    Suggestions made_;
};

} // namespace

std::vector<std::shared_ptr<const Operation>> suggestable(const Project& project) {
    const Machine machine = project_machine(project);
    const bool turns = std::ranges::any_of(
        project.operations, [](const auto& o) { return !o->common().off && o->turning() != nullptr; });
    const Tool* round = largest_round(project);
    std::vector<std::shared_ptr<const Operation>> all;
    for (const OperationKind& kind : operation_kinds()) {
        NewOperation made = new_operation(kind.kind, project);
        if (made.operation->purpose() != Purpose::finishing || made.tool || needs_curve(*made.operation)
            || !runs_on(*made.operation, machine, turns))
            continue;
        made.operation->common().off = false;
        made.operation->common().name = make_operation(kind.kind)->common().name;
        const long own = made.operation->common().tool;
        if (round && round->number != own) {
            auto other = made.operation->clone();
            other->common().tool = round->number;
            all.push_back(std::move(other));
        }
        all.push_back(std::move(made.operation));
    }
    return all;
}

Suggestions suggest(const Project& project, const PreparedPart& part, const Progress& progress) {
    if (project.tools.empty())
        throw Error(ErrorCode::empty_result, "suggest", "the project has no tools", "add a tool");
    return Suggester(project, part).run(progress);
}

} // namespace facetmill
