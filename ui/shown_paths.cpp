#include "ui/shown_paths.h"

#include <algorithm>

namespace facetmill::ui {

bool ShownPaths::update() {
    const auto before = std::move(programs_);
    programs_.clear();
    ids_.clear();
    opened_ = document_.program();
    if (opened_) {
        programs_ = opened_->operations;
        for (std::size_t i = 0; i < programs_.size(); ++i)
            ids_.push_back(-1 - int(i));
        return programs_ != before;
    }
    for (std::size_t i = 0; i < document_.operation_count(); ++i)
        if (const auto result = document_.result(i))
            for (const auto& program : programs_of(result)) {
                programs_.push_back(program);
                ids_.push_back(document_.operation_id(i));
            }
    return programs_ != before;
}

std::optional<std::size_t> ShownPaths::place_of(std::size_t source) const {
    return opened_ ? std::optional(source) : document_.index_of(ids_.at(source));
}

std::optional<std::size_t>
ShownPaths::source_of(const std::shared_ptr<const OperationResult>& program) const {
    const auto at = std::find(programs_.begin(), programs_.end(), program);
    if (at == programs_.end()) return std::nullopt;
    return std::size_t(at - programs_.begin());
}

const Tool& ShownPaths::tool_of(std::size_t source) const {
    if (opened_) return opened_->tools.at(source);
    const auto index = document_.index_of(ids_.at(source));
    const auto& program = programs_[source];
    const Project& project = document_.project();
    // The operation's own tool may have been renumbered since; a further one is known by its number.
    if (index && document_.result(*index) == program) return project.tool_of(document_.operation(*index));
    for (const Tool& t : project.tools)
        if (t.number == program->program.tool_number) return t;
    throw Error(ErrorCode::missing_reference, program->name, "its tool is not in the project any more",
                "plan it again");
}

std::size_t ShownPaths::motion_of(const PathPick& pick) const {
    const auto& motions = programs_[pick.source]->program.motions.motions;
    if (pick.motion < motions.size()) return pick.motion;
    const auto it = std::find_if(motions.begin(), motions.end(), [&](const Motion& m) {
        return m.pass == pick.pass && m.point == pick.point;
    });
    return it == motions.end() ? 0 : std::size_t(it - motions.begin());
}

const CutterContact* ShownPaths::contact_of(const PathPick& pick) const {
    if (pick.source >= programs_.size()) return nullptr;
    const auto& passes = programs_[pick.source]->path.passes;
    if (pick.pass >= passes.size() || pick.point >= passes[pick.pass].cc.size()) return nullptr;
    return &passes[pick.pass].cc[pick.point];
}

std::optional<PathPick> ShownPaths::pick_at(std::size_t source, std::size_t motion) const {
    if (source >= programs_.size()) return std::nullopt;
    const auto& motions = programs_[source]->program.motions.motions;
    if (motion >= motions.size()) return std::nullopt;
    PathPick pick;
    pick.source = source;
    pick.motion = motion;
    pick.pass = motions[motion].pass;
    pick.point = motions[motion].point;
    pick.position = motions[motion].to.tip;
    pick.location = motions[motion].to;
    return pick;
}

std::optional<PathPick> ShownPaths::nearest_cut(std::size_t source, const Vec3& tip) const {
    const auto& motions = programs_[source]->program.motions.motions;
    std::size_t best = motions.size();
    double nearest = infinity;
    for (std::size_t m = 0; m < motions.size(); ++m) {
        const double away = (motions[m].to.tip - tip).squaredNorm();
        if (motions[m].kind == MotionKind::cut && away < nearest) {
            nearest = away;
            best = m;
        }
    }
    return pick_at(source, best);
}

} // namespace facetmill::ui
