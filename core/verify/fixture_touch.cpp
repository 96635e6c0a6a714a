#include "core/verify/fixture_touch.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/verify/deviation_surface.h"
#include "core/verify/probes.h"
#include "core/verify/winding_number.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace facetmill {

namespace {

/// How far apart places on a fixture are, in radii of the cutter: a ball that dips in by d covers a circle of
/// radius sqrt(2 R d).
constexpr double fixture_spacing_share = 0.2;
constexpr std::size_t max_fixture_samples = 400'000;
constexpr std::size_t fixture_samples_per_block = 64;

/// A body of the tool along the motions of one sort.
struct Moving {
    Collision::Kind kind;
    MotionProbes probes;
};

std::vector<Moving> moving_bodies(const VerifyProgram& program, double bound, const Progress& progress) {
    std::vector<Moving> bodies;
    for (const bool rapid : {false, true}) {
        const auto tree = std::make_shared<const MotionTree>(
            program, [&](MotionKind kind) { return (kind == MotionKind::rapid) == rapid; }, progress);
        if (tree->empty()) continue;
        using Kind = Collision::Kind;
        bodies.push_back(
            {rapid ? Kind::rapid : Kind::cutter,
             MotionProbes(TurnedBody(program.tool.cutter), BodySupport(program.tool.cutter), tree, bound)});
        for (const ToolSection& s : program.tool.sections)
            bodies.push_back({rapid                                ? Kind::rapid
                              : s.part == ToolSection::Part::shank ? Kind::shank
                                                                   : Kind::holder,
                              MotionProbes(TurnedBody(s.radius, s.from, s.to), BodySupport(s), tree, bound)});
    }
    return bodies;
}

using TouchKey = std::tuple<std::size_t, Collision::Kind>; // motion
using TouchMap = std::map<TouchKey, Collision>;

void keep_deepest_touch(TouchMap& map, const Collision& c) {
    const auto [at, is_new] = map.try_emplace({c.at.motion, c.kind}, c);
    if (!is_new && c.depth > at->second.depth) at->second = c;
}

TouchMap touches_of(const std::vector<Moving>& bodies, std::size_t program, const FixtureSolid& fixture,
                    double spacing, const Progress& progress) {
    const SurfaceSamples samples = sample_surface(*fixture.mesh, spacing, max_fixture_samples,
                                                  progress.part(0, 0.1), tolerance::collision_depth);
    const std::size_t n = samples.points.size();
    std::vector<TouchMap> found((n + fixture_samples_per_block - 1) / fixture_samples_per_block);
    parallel_blocks(
        n, fixture_samples_per_block, progress.part(0.1, 1), [&](std::size_t begin, std::size_t end) {
            TouchMap& mine = found[begin / fixture_samples_per_block];
            for (std::size_t i = begin; i < end; ++i)
                for (const Moving& body : bodies) {
                    const Vec3& p = samples.points[i];
                    DepthProbe probe{tolerance::collision_depth, no_index};
                    if (!body.probes.deepen(p, no_index, probe)) continue;
                    const Index motion = body.probes.first_as_deep(p, probe);
                    keep_deepest_touch(
                        mine,
                        {body.kind, false, {program, motion, probe.course}, p, probe.depth, fixture.name});
                }
        });
    TouchMap all;
    for (const TouchMap& block : found)
        for (const auto& [key, c] : block)
            keep_deepest_touch(all, c);
    return all;
}

} // namespace

std::vector<Collision> fixture_touches(std::span<const VerifyProgram> programs, double bound,
                                       const Progress& progress) {
    std::vector<Collision> all;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const VerifyProgram& program = programs[i];
        if (!program.fixtures || program.fixtures->empty()) continue;
        const std::vector<Moving> bodies = moving_bodies(program, bound, progress);
        const double spacing = fixture_spacing_share * program.tool.cutter.max_radius();
        const Motion& first = program.motions->motions.front();
        for (const FixtureSolid& fixture : *program.fixtures) {
            TouchMap touches = touches_of(bodies, i, fixture, spacing, progress);
            // Motions that begin in there may never meet its surface.
            if (touches.empty() && winding_number(*fixture.mesh, first.to.tip, progress) > 0.5)
                keep_deepest_touch(touches, {first.kind == MotionKind::rapid ? Collision::Kind::rapid
                                                                             : Collision::Kind::cutter,
                                             false,
                                             {i, 0},
                                             first.to.tip,
                                             program.tool.cutter.max_radius(),
                                             fixture.name});
            for (const auto& [key, c] : touches)
                all.push_back(c);
        }
    }
    return all;
}

} // namespace facetmill
