#include "core/strategy/waterline/contour_passes.h"

#include "core/mesh/edge_table.h"
#include "core/mesh/facet_boxes.h"
#include "core/mesh/triangle_distance.h"
#include "core/strategy/surface/up_side.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// A pass goes so far beyond what asks for it, in radii of the cutter, and on over gaps as long as that.
constexpr double beyond_radii = 0.25, gap_radii = 2;
/// A wall is as near as this to where the cutter's side would touch it, in radii.
constexpr double wall_radii = 0.02;
/// Beside it the tip is lifted by so much more than it goes aside.
constexpr double wall_rise = 11;
const double upright_slope = radians(85);
/// How far apart places of a link are looked at, in radii.
constexpr double link_look = 0.05;

} // namespace

std::vector<std::size_t> kept_places(std::span<const Vec2> line, double beside) {
    std::vector<std::size_t> kept;
    if (line.empty()) return kept;
    kept.push_back(0);
    std::size_t from = 0;
    while (from + 1 < line.size()) {
        // Directions of a chord from `from` that pass all places so far near enough: angles from the first.
        double low = -pi, high = pi, farthest = 0, turn = 0;
        Vec2 first = Vec2::Zero();
        std::size_t best = from + 1;
        for (std::size_t k = from + 1; k < line.size(); ++k) {
            const Vec2 d = line[k] - line[from];
            const double distance = d.norm();
            if (distance < farthest) break; // turned back
            farthest = distance;
            if (!(distance > beside)) {
                best = k;
                continue;
            }
            if (first == Vec2::Zero()) first = d / distance;
            turn = std::atan2(first.x() * d.y() - first.y() * d.x(), first.dot(d));
            if (turn >= low && turn <= high) best = k;
            const double spread = std::asin(std::min(beside / distance, 1.0));
            low = std::max(low, turn - spread);
            high = std::min(high, turn + spread);
            if (low > high || std::abs(turn) > 0.5 * pi) break;
        }
        kept.push_back(best);
        from = best;
    }
    return kept;
}

ContourPasses::ContourPasses(const AxialLift& lift, const TouchTeller& tell, const Mesh& mesh,
                             const Options& options, const Progress& progress)
    : lift_(lift), tell_(tell), mesh_(mesh), options_(options), closed_(UpSide(mesh, progress).closed()) {
    if (closed_) return;
    borders_.assign(mesh.facet_count(), 0);
    const EdgeTable edges(mesh, progress);
    for (std::size_t low = 0; low < edges.vertex_count(); ++low)
        edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            if (sides.size() != 1) return;
            char& border = borders_[sides[0].facet()];
            border = char(border | (1 << sides[0].corner()));
        });
    facets_ = BoxTree(facet_boxes(mesh), progress);
}

/// Whether a place lies on an edge at which the sheet ends.
bool ContourPasses::is_border(Index facet, const Vec3& p) const {
    if (closed_ || !borders_[facet]) return false;
    const double near = 0.5 * options_.chord + tell_.allowance();
    for (int k = 0; k < 3; ++k)
        if (borders_[facet] >> k & 1
            && squared_distance(p, mesh_.corner(facet, k), mesh_.corner(facet, (k + 1) % 3)) < near * near)
            return true;
    return false;
}

/// The surface beside which the cutter's side stands; of a closed mesh there always is one.
std::optional<Vec3> ContourPasses::wall_at(const Vec3& p) const {
    if (closed_) return p;
    const double reach = wall_radii * options_.radius + options_.chord;
    double near2 = reach * reach;
    std::optional<Vec3> found;
    facets_.nearest(p, near2, [&](std::size_t f) {
        if (f >= options_.facets) return;
        const Vec3 q = nearest_in_triangle(p, mesh_.corner(f, 0), mesh_.corner(f, 1), mesh_.corner(f, 2));
        const double d2 = (q - p).squaredNorm();
        if (!(d2 < near2) || std::abs(mesh_.facet_normal(f).z()) > std::cos(upright_slope)) return;
        near2 = d2;
        found = q;
    });
    return found;
}

bool ContourPasses::is_within(const Vec2& tip, const Vec3& contact, Index facet) const {
    if (!options_.within) return true;
    const KeptWithin& within = *options_.within;
    if (within.contain != Containment::contact) return within.region->depth(tip) >= within.min_depth();
    Index hint = facet < options_.facets ? facet : no_index;
    return within.region->holds(contact, hint);
}

/// Takes down what the tip touches at a place, which has to be as near as contours are to their border. True:
/// it is a surface with a slope that is asked for.
bool ContourPasses::touch(const Vec2& p, const AxialContact& at, Touched& result) const {
    const TipTouch touch = tell_(p, at);
    if (!touch.any) return false;
    result.cc = {touch.point, touch.normal};
    const double slope = touch.slope();
    if (slope < options_.slopes.lo || slope > options_.slopes.hi) return false;
    result.wanted =
        (touch.surface || !is_border(at.facet, touch.point)) && is_within(p, touch.point, at.facet);
    return true;
}

ContourPasses::Touched ContourPasses::touched(const Vec2& p, double z, const Vec2& left,
                                              LiftHint& hint) const {
    Touched result;
    const AxialContact at = lift_.contact(p.x(), p.y(), hint);
    result.cc = {Vec3(p.x(), p.y(), z), Vec3::UnitZ()};
    const double near = 0.5 * options_.chord;
    const auto is_part = [&](const AxialContact& c) {
        return c.facet != no_index && std::size_t(c.facet) < options_.facets;
    };
    const bool is_under = z - at.tip_z <= near;
    if (is_under && (touch(p, at, result) || !is_part(at))) return result;
    // It may stand on a floor, and its side beside a wall; or so steep a slope rises beside it that the tip
    // is farther above it than beside it.
    if (left == Vec2::Zero()) return result;
    const Vec2 beyond = p + near * left;
    const AxialContact high = lift_.contact(beyond.x(), beyond.y(), hint);
    if (!(high.tip_z > z + wall_rise * near)) {
        if (!is_under && high.tip_z > z) touch(beyond, high, result);
        return result;
    }
    if (!is_part(high)) return result;
    const double reach = options_.radius + tell_.allowance();
    const Vec2 side = p + reach * left;
    const auto wall = wall_at(Vec3(side.x(), side.y(), z + options_.shoulder));
    if (!wall) return result;
    result.cc = {*wall, Vec3(-left.x(), -left.y(), 0)};
    result.wanted = options_.slopes.hi >= upright_slope && is_within(p, *wall, high.facet);
    return result;
}

CutterContact ContourPasses::contact(const Vec3& tip, const Vec2& left) const {
    LiftHint hint;
    return touched(tip.head<2>(), tip.z(), left, hint).cc;
}

Pass ContourPasses::thinned_pass(std::span<const ContourPlace> places, std::span<const Touched> touched,
                                 double z) const {
    std::vector<Vec2> line;
    line.reserve(places.size());
    for (const ContourPlace& p : places)
        line.push_back(p.at);
    Pass pass;
    pass.offset = -z;
    for (const std::size_t i : kept_places(line, 0.5 * options_.chord)) {
        pass.cl.push_back({Vec3(line[i].x(), line[i].y(), z), Vec3::UnitZ()});
        pass.cc.push_back(touched[i].cc);
    }
    return pass;
}

std::vector<Pass> ContourPasses::passes(const Contour& contour, double z, const Progress& progress) const {
    std::vector<ContourPlace> places = contour.places;
    if (contour.closed) places.push_back(places.front());
    const std::size_t n = places.size();
    std::vector<Touched> touched(n);
    std::vector<double> arc(n, 0);
    LiftHint hint;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % 64 == 63) progress.check();
        const std::size_t before = i > 0            ? i - 1
                                   : contour.closed ? n - 2
                                                    : 0,
                          after = i + 1 < n        ? i + 1
                                  : contour.closed ? 1
                                                   : i;
        const Vec2 along = places[after].at - places[before].at;
        const double length = along.norm();
        const Vec2 left = length > 0 ? Vec2(Vec2(-along.y(), along.x()) / length) : Vec2(Vec2::Zero());
        touched[i] = this->touched(places[i].at, z, left, hint);
        if (i > 0) arc[i] = arc[i - 1] + (places[i].at - places[i - 1].at).norm();
    }
    // Runs that are asked for, and a little beyond; short gaps are passed over.
    const double beyond = beyond_radii * options_.radius, gap = gap_radii * options_.radius;
    std::vector<char> kept(n, 0);
    std::vector<double> since(n, infinity); // along the contour, to what is wanted, either way
    const int rounds = contour.closed ? 2 : 1;
    double last = -infinity;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < n; ++i) {
            if (touched[i].wanted) last = arc[i];
            since[i] = std::min(since[i], arc[i] - last);
        }
        last -= arc.back();
    }
    std::vector<double> until(n, infinity);
    double next = infinity;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = n; i-- > 0;) {
            if (touched[i].wanted) next = arc[i];
            until[i] = std::min(until[i], next - arc[i]);
        }
        next += arc.back();
    }
    for (std::size_t i = 0; i < n; ++i) {
        kept[i] = std::min(since[i], until[i]) <= beyond || since[i] + until[i] <= gap;
        const Vec3 tip(places[i].at.x(), places[i].at.y(), z);
        if (kept[i] && !touched[i].wanted) kept[i] = is_within(places[i].at, touched[i].cc.point, no_index);
    }
    const auto may_begin = [&](std::size_t i) { return !kept[i] || !places[i].joined; };
    std::size_t first = 0;
    if (contour.closed) {
        while (first + 1 < n && !may_begin(first))
            ++first;
        if (first + 1 == n && !may_begin(0)) return {thinned_pass(places, touched, z)};
        // Begun where it is broken, so that no run goes over the end.
        places.pop_back();
        touched.pop_back();
        kept.pop_back();
        const auto turn = [&](auto& list) {
            std::rotate(list.begin(), list.begin() + std::ptrdiff_t(first % list.size()), list.end());
        };
        turn(places);
        turn(touched);
        turn(kept);
    }
    std::vector<Pass> all;
    for (std::size_t i = 0; i < places.size();) {
        if (!kept[i]) {
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        bool any = touched[i].wanted;
        for (; end < places.size() && kept[end] && places[end].joined; ++end)
            any = any || touched[end].wanted;
        if (any && end - i > 1)
            all.push_back(thinned_pass(std::span(places).subspan(i, end - i),
                                       std::span(touched).subspan(i, end - i), z));
        i = end;
    }
    return all;
}

bool ContourPasses::may_link(const Vec3& from, const Vec3& to) const {
    if (!options_.within) return true;
    LiftHint hint;
    const double n = std::max(1.0, std::ceil((to - from).head<2>().norm() / (link_look * options_.radius)));
    for (double k = 0; k <= n; ++k) {
        const Vec2 p = (from + (k / n) * (to - from)).head<2>();
        const AxialContact at = lift_.contact(p.x(), p.y(), hint);
        if (!is_within(p, at.point, at.facet)) return false;
    }
    return true;
}

} // namespace facetmill
