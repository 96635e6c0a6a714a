#include "core/strategy/finish3/cusp_field.h"

#include "core/base/golden_section.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"

namespace facetmill {

namespace {

/// A corner of the profile with a radius below this share of the cutter's leaves what grows with the
/// distance, not with its square.
constexpr double sharp_share = 0.25;

/// On a level plane, the step-over that leaves the cusp with a ball of radius r.
double level_step_of(const StepOverInput& in) {
    const double r = std::max(in.cover->profile().cutter().r, in.cusp);
    return 2 * std::sqrt(std::max(2 * r * in.cusp - in.cusp * in.cusp, 0.0));
}

/// The first point of a run behind u.
auto first_behind(const std::vector<LinePoint>& run, double u) {
    return std::upper_bound(run.begin(), run.end(), u, [](double s, const LinePoint& q) { return s < q.s; });
}

/// The piece of a run at u, or the nearest.
std::size_t piece_at(const std::vector<LinePoint>& run, double u) {
    if (run.size() < 2) return 0;
    const auto after = first_behind(run, u);
    return after == run.begin() ? 0 : std::min(std::size_t(after - run.begin()) - 1, run.size() - 2);
}

} // namespace

CuspField::CuspField(const StepOverInput& input)
    : in_(input), field_{input.lift, input.floor},
      surface_(input.contact, CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height))),
      grid_(input.look.share * input.cover->radius()), level_(level_step_of(input)),
      sharp_(input.cover->profile().cutter().r < sharp_share * input.cover->radius()) {}

CuspField::Sample CuspField::sample(double u, double v, LiftHint& hint) const {
    const Vec2 xy = in_.frame.xy(u, v);
    return sample_of(xy, in_.lift->contact(xy.x(), xy.y(), hint));
}

std::vector<CuspField::Sample> CuspField::samples(const std::vector<Vec2>& places,
                                                  const Progress& progress) const {
    std::vector<Vec2> points;
    points.reserve(places.size());
    for (const Vec2& p : places)
        points.push_back(in_.frame.xy(p.x(), p.y()));
    std::vector<AxialContact> contacts(points.size());
    in_.lift->contact(points, contacts, progress);
    std::vector<Sample> all;
    all.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back(sample_of(points[i], contacts[i]));
    return all;
}

CuspField::Sample CuspField::sample_of(const Vec2& xy, const AxialContact& c) const {
    Sample s;
    s.tip_z = std::max(c.tip_z, in_.floor);
    if (!(c.tip_z >= in_.floor) || c.facet == no_index) return s;
    const Vec3 tip(xy.x(), xy.y(), c.tip_z);
    s.valid = true;
    s.point = c.point;
    if (in_.cover->has_flat_bottom()) {
        const double z = surface_.tip_z(xy.x(), xy.y());
        if (c.tip_z - in_.allowance - z <= cusp_detail(in_.cusp)) {
            s.normal = Vec3(0, 0, 1);
            s.point = Vec3(xy.x(), xy.y(), z + in_.allowance);
            return s;
        }
    }
    if (const auto n = in_.cover->contact_normal(c.point - tip))
        s.normal = *n;
    else
        s.normal = in_.contact->mesh().facet_normal(c.facet);
    if (s.normal.z() < 0) s.normal = -s.normal;
    s.point += in_.allowance * s.normal;
    return s;
}

/// The entry is convex along a piece, and a normal of the cutter where it is met tells its slope.
bool CuspField::rises(const Vec3& from, const Vec3& to, const Vec3& p, const Vec3& n, double entry) const {
    if (!(std::abs(entry) < infinity)) return false;
    const auto out = in_.cover->ball_normal(p + entry * n - from);
    return out && out->dot(to - from) <= 0; // the line comes in against the normal
}

/// The smallest entry along one piece of a run: convex, because a swept convex body is convex.
double CuspField::piece_entry(const DriveLine& line, const std::vector<LinePoint>& run, std::size_t k,
                              const Vec3& p, const Vec3& n, Ends& ends) const {
    const double limit = 2 * in_.cover->radius();
    const Vec3 a = in_.frame.point(run[k].s, line.v, run[k].z),
               b = in_.frame.point(run[k + 1].s, line.v, run[k + 1].z);
    const auto f = [&](double x) { return in_.cover->ray_entry(p, n, a + x * (b - a), limit); };
    if (std::isnan(ends.a)) ends.a = in_.cover->ray_entry(p, n, a, limit);
    if (rises(a, b, p, n, ends.a)) return ends.a;
    if (std::isnan(ends.b)) ends.b = in_.cover->ray_entry(p, n, b, limit);
    if (rises(b, a, p, n, ends.b)) return ends.b;
    const double f0 = ends.a, f1 = f(0.5), f2 = ends.b;
    double least = std::min({f0, f1, f2});
    if (least == infinity) return least;
    if (f0 < infinity && f1 < infinity && f2 < infinity) {
        const double bend = f0 - 2 * f1 + f2;
        if (bend > 0) {
            const double x = 0.5 + 0.25 * (f0 - f2) / bend;
            if (x > 0 && x < 1) least = std::min(least, f(x));
        }
        return least;
    }
    return std::min(least, min_where_finite(f, 0, 1, f0 < f2));
}

double CuspField::run_entry(const DriveLine& line, const std::vector<LinePoint>& run, std::size_t k, double u,
                            const Vec3& p, const Vec3& n) const {
    const double limit = 2 * in_.cover->radius();
    const auto at_point = [&](const LinePoint& q) {
        return in_.cover->ray_entry(p, n, in_.frame.point(q.s, line.v, q.z), limit);
    };
    const auto point = [&](std::size_t i) { return in_.frame.point(run[i].s, line.v, run[i].z); };
    if (run.size() == 1) return at_point(run[0]);
    const std::size_t last = run.size() - 2;
    Ends ends;
    double here = piece_entry(line, run, k, p, n, ends);
    if (here == infinity) {
        // Not met near u: look at all of the run that can reach p.
        std::size_t found = no_index;
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (std::abs(run[i].s - u) > limit) continue;
            const double t = at_point(run[i]);
            if (t < here) {
                here = t;
                found = i;
            }
        }
        if (found == no_index) return infinity;
        k = std::min(found, last);
        ends = {};
        here = std::min(here, piece_entry(line, run, k, p, n, ends));
    }
    // Neighbours share an end. Before a line falls off a wall it may go a little way level, and away from the
    // wall: short pieces that bring nothing do not end the search.
    const double short_piece = cusp_detail(in_.cusp);
    const auto is_short = [&](std::size_t i) { return (point(i + 1) - point(i)).norm() <= short_piece; };
    const double first_b = ends.b;
    for (std::size_t left = k; left > 0; --left) {
        const bool goes_on = is_short(left - 1);
        if (!goes_on && rises(point(left), point(left - 1), p, n, ends.a)) break;
        ends = {std::numeric_limits<double>::quiet_NaN(), ends.a};
        const double t = piece_entry(line, run, left - 1, p, n, ends);
        if (!(t < here) && !goes_on) break;
        here = std::min(here, t);
    }
    ends.b = first_b;
    for (std::size_t right = k; right < last; ++right) {
        const bool goes_on = is_short(right + 1);
        if (!goes_on && rises(point(right + 1), point(right + 2), p, n, ends.b)) break;
        ends = {ends.b, std::numeric_limits<double>::quiet_NaN()};
        const double t = piece_entry(line, run, right + 1, p, n, ends);
        if (!(t < here) && !goes_on) break;
        here = std::min(here, t);
    }
    return here;
}

CuspField::Near CuspField::near(const DriveLine* line, double u) const {
    Near near{line, u};
    if (!line) return near;
    const double limit = 2 * in_.cover->radius();
    const auto& runs = line->runs;
    while (near.begin < runs.size() && runs[near.begin].back().s < u - limit)
        ++near.begin;
    near.end = near.begin;
    while (near.end < runs.size() && runs[near.end].front().s <= u + limit)
        ++near.end;
    if (near.begin < near.end) near.piece = piece_at(runs[near.begin], u);
    return near;
}

double CuspField::entry(const Near& near, const Vec3& p, const Vec3& n) const {
    double best = infinity;
    for (std::size_t i = near.begin; i < near.end; ++i) {
        const auto& run = near.line->runs[i];
        const std::size_t piece = i == near.begin ? near.piece : piece_at(run, near.u);
        best = std::min(best, run_entry(*near.line, run, piece, near.u, p, n));
    }
    return std::max(best, 0.0);
}

double CuspField::height_on(const DriveLine& line, double u) const {
    for (const auto& run : line.runs) {
        if (run.empty() || u < run.front().s || u > run.back().s) continue;
        const auto after = first_behind(run, u);
        if (after == run.end()) return run.back().z;
        const LinePoint &p = *(after - 1), &q = *after;
        return p.z + (q.z - p.z) * (u - p.s) / (q.s - p.s);
    }
    return field_.tip_z(in_.frame.xy(u, line.v));
}

} // namespace facetmill
