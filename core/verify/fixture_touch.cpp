#include "core/verify/fixture_touch.h"

#include "core/base/tolerances.h"
#include "core/verify/moving_bodies.h"
#include "core/verify/winding_number.h"
#include "core/verify/working_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace facetmill {

namespace {

/// How far apart places on a fixture are where a body may touch it, in working radii of the cutter: a ball
/// that dips in by d covers a circle of radius sqrt(2 R d).
constexpr double fixture_spacing_share = 0.2;
/// Once a touch was found, so many places are enough to say how deep it is.
constexpr std::size_t enough_places = 400'000;
constexpr int max_fixture_halvings = 40;

using TouchKey = std::tuple<std::size_t, Collision::Kind>; // motion
using TouchMap = std::map<TouchKey, Collision>;

void keep_deepest_touch(TouchMap& map, const Collision& c) {
    const auto [at, is_new] = map.try_emplace({c.at.motion, c.kind}, c);
    if (!is_new && c.depth > at->second.depth) at->second = c;
}

/// Asks a fixture's facets: those that no body comes to are passed over whole, the others divided until they
/// are small.
class TouchSearch {
public:
    TouchSearch(const std::vector<MovingBody>& bodies, std::size_t program, const FixtureSolid& fixture,
                double spacing, const Progress& progress)
        : bodies_(bodies), program_(program), fixture_(fixture), spacing_(spacing), progress_(progress) {}

    TouchMap run() {
        std::vector<std::size_t> all(bodies_.size());
        for (std::size_t b = 0; b < all.size(); ++b)
            all[b] = b;
        for (std::size_t f = 0; f < fixture_.mesh->facet_count(); ++f)
            look({fixture_.mesh->corner(f, 0), fixture_.mesh->corner(f, 1), fixture_.mesh->corner(f, 2)}, all,
                 0);
        return std::move(found_);
    }

private:
    void look(const std::array<Vec3, 3>& corners, const std::vector<std::size_t>& among, int halvings) {
        progress_.check();
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        double radius = 0;
        for (const Vec3& c : corners)
            radius = std::max(radius, (c - middle).norm());
        std::vector<std::size_t> near;
        std::vector<std::vector<Index>> nodes;
        for (const std::size_t b : among) {
            std::vector<Index> own = bodies_[b].probes.near(middle, radius, tolerance::collision_depth);
            // Nowhere on the facet is a point deeper than in the middle by more than the way there.
            DepthProbe reached{tolerance::collision_depth - radius, no_index};
            if (own.empty() || !bodies_[b].probes.deepen(middle, no_index, reached, own)) continue;
            near.push_back(b);
            nodes.push_back(std::move(own));
        }
        if (near.empty()) return;
        const bool small = radius <= spacing_ || halvings >= max_fixture_halvings
                           || (!found_.empty() && places_ > enough_places);
        if (small) {
            for (std::size_t k = 0; k < near.size(); ++k) {
                for (const Vec3& c : corners)
                    ask(c, bodies_[near[k]], nodes[k]);
                ask(middle, bodies_[near[k]], nodes[k]);
            }
            places_ += corners.size() + 1;
            return;
        }
        // Across the longest side: facets stay no longer than they have to be.
        std::size_t longest = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if ((corners[(k + 1) % 3] - corners[k]).norm()
                > (corners[(longest + 1) % 3] - corners[longest]).norm())
                longest = k;
        const Vec3 &a = corners[longest], &b = corners[(longest + 1) % 3], &c = corners[(longest + 2) % 3];
        const Vec3 half = 0.5 * (a + b);
        look({a, half, c}, near, halvings + 1);
        look({half, b, c}, near, halvings + 1);
    }

    void ask(const Vec3& p, const MovingBody& body, const std::vector<Index>& among) {
        DepthProbe probe{tolerance::collision_depth, no_index};
        if (!body.probes.deepen(p, no_index, probe, among)) return;
        const Index motion = body.probes.first_as_deep(p, probe);
        keep_deepest_touch(
            found_, {body.kind, false, {program_, motion, probe.course}, p, probe.depth, fixture_.name});
    }

    const std::vector<MovingBody>& bodies_;
    std::size_t program_;
    const FixtureSolid& fixture_;
    double spacing_;
    const Progress& progress_;
    TouchMap found_;
    std::size_t places_ = 0;
};

} // namespace

std::vector<Collision> fixture_touches(std::span<const VerifyProgram> programs, double bound,
                                       const Progress& progress) {
    std::vector<Collision> all;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const VerifyProgram& program = programs[i];
        if (!program.fixtures || program.fixtures->empty()) continue;
        std::vector<MovingBody> bodies = moving_bodies(program, bound, progress);
        std::erase_if(bodies, [](const MovingBody& b) { return b.probes.motions().empty(); });
        const double spacing = fixture_spacing_share * working_radius(program.tool.cutter);
        const Motion& first = program.motions->motions.front();
        for (const FixtureSolid& fixture : *program.fixtures) {
            if (fixture.tab) continue;
            TouchMap touches = TouchSearch(bodies, i, fixture, spacing, progress).run();
            // Motions that begin in there may never meet its surface.
            if (touches.empty() && std::abs(winding_number(*fixture.mesh, first.to.tip, progress)) > 0.5)
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
