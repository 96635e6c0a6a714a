#include "core/cspace/cspace.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cspace/posture_terms.h"
#include "core/setup/kinematics.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

namespace facetmill {

namespace {

/// Processor time of the calling thread, s.
double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

const ToolLift& wanted(const ToolLift* lift) {
    if (!lift) throw Error(ErrorCode::internal, "CSpaceBuilder", "was made without a tool", "report this");
    return *lift;
}

/// Next to 0: what is no higher than this leaves too much.
constexpr double below_0 = -std::numeric_limits<double>::min();

/// What the top of one posture after the other has in common.
class TopSearch {
public:
    /// `low`: tops below 0 are wanted as they are.
    TopSearch(const CurveLift& lift, std::span<const RaisedCurve> curves, bool low)
        : lift_(lift), curves_(curves), hints_(curves.size()), low_(low) {}

    double top(const ToolPose& pose) {
        double least = infinity;
        std::size_t lowest = first_;
        // The curve that was lowest first: of most others it is then enough to know that they are higher.
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            const std::size_t c = i == 0 ? first_ : i <= first_ ? i - 1 : i;
            const double here = lift_.lift(pose, curves_[c], hints_[c], least, low_ ? -infinity : below_0);
            if (here < least) {
                least = here;
                lowest = c;
            }
            if (!low_ && least < 0) break;
        }
        first_ = lowest;
        return least;
    }

private:
    const CurveLift& lift_;
    std::span<const RaisedCurve> curves_;
    std::vector<CurveLift::Hint> hints_;
    bool low_;
    std::size_t first_ = 0;
};

} // namespace

const char* posture_block_name(PostureBlock block) {
    switch (block) {
    case PostureBlock::free:
        return "free";
    case PostureBlock::local:
        return "local";
    case PostureBlock::global:
        return "global";
    case PostureBlock::shank:
        return "shank";
    case PostureBlock::holder:
        return "holder";
    case PostureBlock::lift:
        return "lift";
    case PostureBlock::machine:
        break;
    }
    return "machine";
}

CSpaceBuilder::CSpaceBuilder(const CSpaceInput& input)
    : input_(input), curve_(wanted(input.lift).cutter(), input.height) {
    if (!(input.local_radius >= 0))
        throw Error(ErrorCode::out_of_range, "local_radius", "is negative", "give a length");
}

double CSpaceBuilder::bottom(const ContactFrame& frame, double lead, double yaw, ToolLift::Hint& hint,
                             double enough) const {
    const CutterProfile& cutter = input_.lift->cutter();
    if (!can_touch(cutter, lead, input_.height)) return infinity;
    return input_.lift->lift_above(posture_pose(cutter, frame, {lead, yaw, 0}), 0, enough, hint);
}

std::optional<CSpaceBuilder::Free> CSpaceBuilder::free(const ContactFrame& frame, double lead, double yaw,
                                                       std::span<const RaisedCurve> curves,
                                                       Hints& hints) const {
    const CutterProfile& cutter = input_.lift->cutter();
    if (!can_touch(cutter, lead, input_.height)) return std::nullopt;
    const LeanTerms lean(lead);
    const TurnTerms turn(yaw);
    const Vec2 at = plane_contact(cutter, lean.angle);
    const ToolPose pose = lean.pose(at, frame, turn, 0);
    // The top first: the curves are short, and where it is below 0 that is all.
    hints.top.resize(std::max(hints.top.size(), curves.size()));
    double top = infinity;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        top = std::min(top, curve_.lift(pose, curves[i], hints.top[i], top, below_0));
        if (!(top >= 0)) return std::nullopt;
    }
    const Free found{{lead, yaw, input_.lift->lift_above(pose, 0, top, hints.bottom)}, top};
    if (!(found.posture.delta <= top) || !holds(lean.pose(at, frame, turn, found.posture.delta)))
        return std::nullopt;
    return found;
}

double CSpaceBuilder::top(const ContactFrame& frame, double lead, double yaw,
                          std::span<const RaisedCurve> curves) const {
    const CutterProfile& cutter = input_.lift->cutter();
    if (!can_touch(cutter, lead, input_.height)) return -infinity;
    const ToolPose pose = posture_pose(cutter, frame, {lead, yaw, 0});
    double least = infinity;
    for (const RaisedCurve& curve : curves) {
        CurveLift::Hint hint;
        least = std::min(least, curve_.lift(pose, curve, hint, least));
    }
    return least;
}

double CSpaceBuilder::top(const ToolPose& pose, double lead, const RaisedCurve& curve, CurveLift::Hint& hint,
                          double enough) const {
    if (!can_touch(input_.lift->cutter(), lead, input_.height)) return -infinity;
    return curve_.lift(pose, curve, hint, enough);
}

bool CSpaceBuilder::reaches(const ToolPose& pose, double lead, const RaisedCurve& curve,
                            CurveLift::Hint& hint, double level) const {
    return can_touch(input_.lift->cutter(), lead, input_.height) && curve_.reaches(pose, curve, hint, level);
}

bool CSpaceBuilder::reaches(const ToolPose& pose, std::span<const RaisedCurve> curves, double level) const {
    return std::all_of(curves.begin(), curves.end(), [&](const RaisedCurve& curve) {
        CurveLift::Hint hint;
        return curve_.reaches(pose, curve, hint, level);
    });
}

bool CSpaceBuilder::holds(const ToolPose& pose) const {
    return pose.axis.z() >= input_.lowest_axis_z && (!input_.kinematics || input_.kinematics->reaches(pose));
}

PostureBlock CSpaceBuilder::judge(const Reason& reason, const ToolPose& pose,
                                  const ContactFrame& frame) const {
    if (!(reason.bottom < infinity)) return PostureBlock::shank;
    if (!(reason.top >= 0)) return PostureBlock::lift;
    if (reason.bottom <= reason.top) {
        return holds(ToolPose{pose.tip + reason.bottom * pose.axis, pose.axis}) ? PostureBlock::free
                                                                                : PostureBlock::machine;
    }
    switch (block_cause(reason.contact, frame.point, input_.local_radius)) {
    case BlockCause::global:
        return PostureBlock::global;
    case BlockCause::shank:
        return PostureBlock::shank;
    case BlockCause::holder:
        return PostureBlock::holder;
    case BlockCause::local:
    case BlockCause::none:
        break;
    }
    return PostureBlock::local;
}

/// What the nodes of a grid need of their leads and yaws, worked out once each.
struct CSpaceBuilder::GridTerms {
    struct Lean {
        LeanTerms terms;
        Vec2 at;
        bool touches;
    };
    std::vector<Lean> leans;
    std::vector<TurnTerms> turns;

    GridTerms(const PostureGrid& grid, const CutterProfile& cutter, double height) {
        for (const double lead : grid.lead) {
            const LeanTerms terms(lead);
            leans.push_back({terms, plane_contact(cutter, terms.angle), can_touch(cutter, lead, height)});
        }
        for (const double yaw : grid.yaw)
            turns.emplace_back(yaw);
    }
    ToolPose pose(std::size_t lead_number, std::size_t yaw_number, const ContactFrame& frame) const {
        return leans[lead_number].terms.pose(leans[lead_number].at, frame, turns[yaw_number], 0);
    }
};

CSpaceBuilder::Stages CSpaceBuilder::fill(CSpace& space, std::span<const RaisedCurve> curves,
                                          const Progress& progress) const {
    if (!input_.grid)
        throw Error(ErrorCode::internal, "CSpaceBuilder", "was asked for a space without a grid",
                    "report this");
    const PostureGrid& grid = *input_.grid;
    const GridTerms terms(grid, input_.lift->cutter(), input_.height);
    space.bottom.assign(grid.size(), infinity);
    space.top.assign(grid.size(), -infinity);
    space.block.assign(grid.size(), PostureBlock::shank);
    const double start = thread_seconds();
    fill_top(space, terms, curves, progress);
    const double between = thread_seconds();
    fill_bottom(space, terms, progress);
    return {thread_seconds() - between, between - start};
}

void CSpaceBuilder::fill_top(CSpace& space, const GridTerms& terms, std::span<const RaisedCurve> curves,
                             const Progress& progress) const {
    constexpr std::size_t postures_per_check = 256;
    const std::size_t leans = terms.leans.size();
    TopSearch search(curve_, curves, input_.low_tops);
    std::size_t seen = 0;
    // To and fro, so that every posture is a neighbour of the one before: what one met, the next is likely to
    // meet.
    for (std::size_t io = 0; io < terms.turns.size(); ++io)
        for (std::size_t k = 0; k < leans; ++k) {
            if (seen++ % postures_per_check == 0) progress.check();
            const std::size_t il = io % 2 == 0 ? k : leans - 1 - k;
            if (!terms.leans[il].touches) continue;
            space.top[input_.grid->node(il, io)] = search.top(terms.pose(il, io, space.frame));
        }
}

void CSpaceBuilder::fill_bottom(CSpace& space, const GridTerms& terms, const Progress& progress) const {
    // By patches of the grid: what poses that are alike can meet is found once for all of them.
    constexpr std::size_t patch_leans = 4, patch_turns = 8;
    std::vector<std::size_t> nodes;
    std::vector<ToolPose> poses;
    ToolLift::Hint hint;
    ToolLift::Group group;
    for (std::size_t il = 0; il < terms.leans.size(); il += patch_leans)
        for (std::size_t io = 0; io < terms.turns.size(); io += patch_turns) {
            progress.check();
            nodes.clear();
            poses.clear();
            const std::size_t leans_end = std::min(terms.leans.size(), il + patch_leans);
            for (std::size_t o = io; o < std::min(terms.turns.size(), io + patch_turns); ++o)
                for (std::size_t k = il; k < leans_end; ++k) {
                    const std::size_t l = o % 2 == 0 ? k : il + leans_end - 1 - k;
                    const std::size_t node = input_.grid->node(l, o);
                    if (!terms.leans[l].touches) continue;
                    const ToolPose pose = terms.pose(l, o, space.frame);
                    if (input_.bottom_everywhere || space.top[node] >= 0) {
                        nodes.push_back(node);
                        poses.push_back(pose);
                    } else {
                        Reason reason;
                        reason.top = space.top[node];
                        space.bottom[node] = 0;
                        space.block[node] = judge(reason, pose, space.frame);
                    }
                }
            judge_patch(space, nodes, poses, hint, group);
        }
}

void CSpaceBuilder::judge_patch(CSpace& space, std::span<const std::size_t> nodes,
                                std::span<const ToolPose> poses, ToolLift::Hint& hint,
                                ToolLift::Group& group) const {
    constexpr std::size_t fewest_in_group = 8;
    const bool grouped = poses.size() >= fewest_in_group;
    if (grouped) input_.lift->gather(poses, 0, group);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::size_t node = nodes[i];
        Reason reason;
        reason.top = space.top[node];
        reason.contact = grouped ? input_.lift->contact_above(poses[i], 0, hint, group)
                                 : input_.lift->contact_above(poses[i], 0, hint);
        reason.bottom = space.bottom[node] = reason.contact.lift;
        space.block[node] = judge(reason, poses[i], space.frame);
    }
}

CSpace CSpaceBuilder::build(const ContactFrame& frame, std::span<const RaisedCurve> curves,
                            const Progress& progress) const {
    CSpace space;
    space.frame = frame;
    fill(space, curves, progress);
    return space;
}

std::vector<CSpace> CSpaceBuilder::build(std::span<const ContactFrame> frames,
                                         std::span<const std::vector<RaisedCurve>> curves,
                                         const Progress& progress, Stages* stages) const {
    if (frames.size() != curves.size())
        throw Error(ErrorCode::internal, "CSpaceBuilder", "every contact point needs its curves",
                    "report this");
    std::vector<CSpace> spaces(frames.size());
    std::vector<Stages> spent(frames.size());
    parallel_for(frames.size(), 1, progress, [&](std::size_t i) {
        spaces[i].frame = frames[i];
        spent[i] = fill(spaces[i], curves[i], progress);
    });
    if (stages)
        for (const Stages& s : spent) {
            stages->bottom += s.bottom;
            stages->top += s.top;
        }
    return spaces;
}

CSpaceBuilder::Reason CSpaceBuilder::reason(const ContactFrame& frame, double lead, double yaw,
                                            std::span<const RaisedCurve> curves) const {
    const CutterProfile& cutter = input_.lift->cutter();
    if (!can_touch(cutter, lead, input_.height)) return {PostureBlock::shank, infinity, -infinity, {}};
    const ToolPose pose = posture_pose(cutter, frame, {lead, yaw, 0});
    ToolLift::Hint hint;
    Reason reason;
    reason.contact = input_.lift->contact_above(pose, 0, hint);
    reason.bottom = reason.contact.lift;
    reason.top = top(frame, lead, yaw, curves);
    reason.block = judge(reason, pose, frame);
    return reason;
}

} // namespace facetmill
