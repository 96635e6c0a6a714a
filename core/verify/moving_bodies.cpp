#include "core/verify/moving_bodies.h"

namespace facetmill {

std::vector<MovingBody> moving_bodies(const VerifyProgram& program, double bound, const Progress& progress) {
    using Kind = Collision::Kind;
    const auto slow = std::make_shared<const MotionTree>(
        program, [](MotionKind k) { return k != MotionKind::rapid; }, progress);
    const auto fast = std::make_shared<const MotionTree>(
        program, [](MotionKind k) { return k == MotionKind::rapid; }, progress);
    std::vector<MovingBody> bodies;
    const auto add = [&](Kind kind, const TurnedBody& body, const BodySupport& support) {
        bodies.push_back({kind, MotionProbes(body, support, slow, bound)});
        bodies.push_back({Kind::rapid, MotionProbes(body, support, fast, bound)});
    };
    add(Kind::cutter, TurnedBody(program.tool.cutter), BodySupport(program.tool.cutter));
    for (const ToolSection& s : program.tool.sections)
        add(s.part == ToolSection::Part::shank ? Kind::shank : Kind::holder,
            TurnedBody(s.radius, s.from, s.to), BodySupport(s));
    return bodies;
}

} // namespace facetmill
