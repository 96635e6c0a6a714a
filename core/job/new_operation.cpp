#include "core/job/new_operation.h"

#include "core/base/usual_value.h"
#include "core/job/asked_operations.h"
#include "core/job/cutting_choice.h"
#include "core/job/usual_tools.h"
#include "core/setup/tool_edit.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Layers of roughing, in diameters of its cutter; what it leaves above the allowance at most, and for
/// finishing.
constexpr double depth_share = 0.25, rough_share = 0.1, left_share = 0.05;
/// A larger cutter leaves no more than this, mm.
constexpr double max_rough_tolerance = 0.5;
/// What finishing may leave, in diameters, where no other operation says it.
constexpr double finish_share = 0.01;

bool has_flat(const Tool& t) {
    return t.corner_radius < 0.5 * t.diameter && t.bottom_angle == 0 && t.taper_angle >= 0;
}

class NewOperationMaker {
public:
    NewOperationMaker(std::string_view kind, const Project& project, const OperationWish& wish)
        : project_(project), per_(mm_per(project.unit)), wished_tool_(wished(wish.tool)),
          wished_previous_(wished(wish.previous_tool)), steeper_(wish.steeper) {
        made_.operation = make_operation(kind);
        take_usual_values(*made_.operation, project.unit);
        const auto& all = project.operations;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i]->purpose() <= made_.operation->purpose()) made_.place = i + 1;
    }

    NewOperation run() {
        const auto& all = project_.operations;
        const auto like = std::ranges::find(all.rbegin(), all.rend(), made_.operation->kind(),
                                            [](const auto& o) { return o->kind(); });
        if (like != all.rend()) {
            take_from(**like);
            if (wished_tool_ || wished_previous_) take_wished();
        } else if (!project_.tools.empty()) {
            copy_from_neighbor();
            switch (made_.operation->purpose()) {
            case Purpose::roughing:
                rough();
                break;
            case Purpose::finishing:
                finish();
                break;
            case Purpose::cleaning:
                clean_up();
                break;
            }
            run_as_tool_says();
        }
        if (steeper_ && made_.operation->has("slope_limits"))
            made_.operation->set("slope_limits", std::array{*steeper_, 0.5 * pi});
        return std::move(made_);
    }

private:
    OperationCommon& common() { return made_.operation->common(); }

    const Tool* wished(std::optional<long> number) const {
        if (!number) return nullptr;
        if (const Tool* tool = find_tool(project_.tools, *number)) return tool;
        throw Error(ErrorCode::missing_reference, "tool", "there is no tool " + std::to_string(*number),
                    "add a tool");
    }

    /// Postures were kept for contact points of that one, regions edited by hand were its.
    void take_from(const Operation& like) {
        made_.operation = like.clone();
        forget_places(*made_.operation);
    }

    /// What is like another one, but for its tools.
    void take_wished() {
        if (made_.operation->purpose() == Purpose::cleaning && made_.operation->has("previous_tool")) {
            const Tool* previous = wished_previous_;
            if (!previous)
                previous = find_tool(project_.tools, std::get<long>(made_.operation->get("previous_tool")));
            if (previous) clean_up_after(*previous);
        } else if (wished_tool_) {
            common().tool = wished_tool_->number;
        }
        run_as_tool_says();
    }

    /// The one before it where it will stand, else the one after; null where there is none.
    const Operation* neighbor() const {
        const auto& all = project_.operations;
        if (all.empty()) return nullptr;
        return all[made_.place > 0 ? made_.place - 1 : 0].get();
    }

    /// One that is switched off only where none is on.
    const Operation* nearest(Purpose purpose) const {
        const Operation* on = nearest(purpose, false);
        return on ? on : nearest(purpose, true);
    }

    /// The last one of a purpose that will stand before it, else the first after it.
    const Operation* nearest(Purpose purpose, bool off) const {
        const auto& all = project_.operations;
        const auto fits = [&](const auto& o) { return o->purpose() == purpose && o->common().off == off; };
        const auto place = all.begin() + std::ptrdiff_t(made_.place);
        for (auto o = place; o != all.begin();)
            if (fits(*--o)) return o->get();
        const auto after = std::find_if(place, all.end(), fits);
        return after != all.end() ? after->get() : nullptr;
    }

    /// All but what belongs to its purpose.
    void copy_from_neighbor() {
        const Operation* from = neighbor();
        if (!from) return;
        const OperationCommon own = common();
        common() = from->common();
        common().name = own.name;
        common().tolerance = own.tolerance;
        common().allowance = own.allowance;
        common().off = own.off;
    }

    /// In round numbers of the project's unit.
    double rounded(double mm) const { return round_down(mm / per_) * per_; }

    /// The largest tool by diameter of those that are asked for; null where none is.
    template <class Asked>
    const Tool* largest(Asked&& asked) const {
        const Tool* best = nullptr;
        for (const Tool& t : project_.tools)
            if (asked(t) && (!best || t.diameter > best->diameter)) best = &t;
        return best;
    }

    void rough() {
        const bool turns = made_.operation->turning();
        const Tool* tool = wished_tool_ ? wished_tool_ : largest(has_flat);
        if (!tool && turns) tool = largest([](const Tool& t) { return t.taper_angle >= 0; });
        if (!tool && turns) tool = &project_.tools.front();
        if (!tool) tool = &made_.tool.emplace(usual_roughing_tool(project_));
        common().tool = tool->number;
        common().tolerance = rounded(std::min(max_rough_tolerance, rough_share * tool->diameter));
        const double depth = rounded(std::min(depth_share * tool->diameter, tool->flute_length)),
                     left = rounded(left_share * tool->diameter);
        if (made_.operation->turning()) {
            made_.operation->set("depth_of_cut", depth);
            made_.operation->set("finishing_allowance", left);
            if (const Operation* finish = nearest(Purpose::finishing))
                common().allowance = finish->common().allowance;
        } else {
            made_.operation->set("depth", depth);
            common().allowance = left;
        }
    }

    void finish() {
        if (const Operation* other = nearest(Purpose::finishing)) {
            common().tool = wished_tool_ ? wished_tool_->number : other->common().tool;
            common().tolerance = other->common().tolerance;
            common().allowance = other->common().allowance;
            return;
        }
        const Tool* tool = wished_tool_;
        if (!tool) tool = largest([](const Tool& t) { return !has_flat(t) && t.corner_radius > 0; });
        if (!tool) tool = &project_.tools.front();
        common().tool = tool->number;
        common().tolerance = rounded(finish_share * tool->diameter);
    }

    void clean_up() {
        const Operation* before = nearest(Purpose::finishing);
        if (!before) before = neighbor();
        const Tool* previous = wished_previous_ ? wished_previous_ : &project_.tools.front();
        if (before) {
            const Tool* its = find_tool(project_.tools, before->common().tool);
            if (its && !wished_previous_) previous = its;
            common().tolerance = before->common().tolerance;
            common().allowance = before->purpose() == Purpose::finishing ? before->common().allowance : 0;
        }
        if (made_.operation->has("previous_tool"))
            clean_up_after(*previous);
        else // it goes over the valleys that its own tool left
            common().tool = wished_tool_ ? wished_tool_->number : previous->number;
    }

    void clean_up_after(const Tool& previous) {
        made_.operation->set("previous_tool", previous.number);
        // It comes in where the other one does not: what is as wide as a ball does on floors alone.
        const bool on_floors = has_flat(previous);
        const Tool* tool = wished_tool_;
        if (!tool)
            tool = largest([&](const Tool& t) {
                return t.taper_angle >= 0 && t.diameter <= previous.diameter
                       && t.corner_radius <= previous.corner_radius
                       && (t.diameter < previous.diameter
                           || (on_floors && t.corner_radius < previous.corner_radius));
            });
        if (!tool) made_.tool = half_of(previous);
        common().tool = tool ? tool->number : made_.tool->number;
    }

    /// Feeds of a neighbour are those of another tool.
    void run_as_tool_says() {
        const Tool* tool = find_tool(project_.tools, common().tool);
        const Operation* from = neighbor();
        if (!tool || (from && from->common().tool == tool->number)) return;
        const Tool* before = from ? find_tool(project_.tools, from->common().tool) : nullptr;
        const CuttingData* ran_by = before ? runs_by(*from, *before) : nullptr;
        if (const CuttingData* data = cutting_for(*tool, ran_by ? ran_by->material : std::string()))
            run_by(*made_.operation, *tool, *data);
    }

    /// A ball of half its size or the next smaller one that is sold, as slim as that above its flutes.
    Tool half_of(const Tool& tool) const {
        Tool half = tool;
        half.number = free_tool_number(project_.tools);
        half.diameter = usual_diameter(0.5 * tool.diameter, project_.unit);
        if (half.diameter > 0.5 * tool.diameter) half.diameter = 0.5 * tool.diameter; // none is so small
        half.shank_diameter = half.diameter;
        half.corner_radius = 0.5 * half.diameter;
        half.bottom_angle = half.taper_angle = 0;
        half.cutting.clear(); // those of the larger one
        half.name = usual_tool_name(half, project_.unit);
        return half;
    }

    const Project& project_;
    double per_;
    const Tool *wished_tool_, *wished_previous_; ///< null: not wished
    std::optional<double> steeper_;
    NewOperation made_;
};

} // namespace

NewOperation new_operation(std::string_view kind, const Project& project, const OperationWish& wish) {
    return NewOperationMaker(kind, project, wish).run();
}

} // namespace facetmill
