#include "core/strategy/finish3/stepover.h"

#include "core/base/golden_section.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"

namespace facetmill {

namespace {

constexpr std::size_t block_columns = 8;
/// A lift that changes by more than this per unit sideways is looked at as a wall.
constexpr double wall_slope = 5;
/// Contacts of tips that move by less than this share of the tips' own way stand still: an edge, or nearly.
constexpr double still_share = 0.5;
/// Contacts are looked for between two that are farther apart than this share of the step on a level plane;
/// beside an edge, where what is left rises steeply, finely.
constexpr double jump_gap = 0.4, edge_gap = 0.05;
/// Of the allowed cusp, more than a line leaves a quarter of the way to the next on one flank.
constexpr double jump_share = 0.3;
/// Beside the place where the contact jumps from flank to flank the part is to be cut as far into the hollow
/// as the cutter that touches both leaves this share of the allowed cusp, as find_uncut has it.
constexpr double hollow_share = 0.25;
constexpr int hollow_halvings = 14;
/// A flank whose normal rises by less has no surface that is known from above.
constexpr double steepest_hollow = 0.05;
/// Halvings between two such tips.
constexpr int deepest_between = 5;
/// Accepted without a further try: share of the allowed cusp.
constexpr double good_share = 0.96;
/// Accepted after a few tries.
constexpr double fair_share = 0.92;

bool inside(const std::vector<Interval>& intervals, double u, double slack) {
    for (const Interval& i : intervals)
        if (u >= i.lo - slack && u <= i.hi + slack) return true;
    return false;
}

} // namespace

StepOver::StepOver(const StepOverInput& input) : in_(input), field_{input.lift, input.floor} {
    const double radius = in_.cover->radius(), r = std::max(in_.cover->profile().cutter().r, in_.cusp);
    surface_ = std::make_unique<AxialLift>(
        in_.contact, CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height)));
    // On a level plane, cusps between passes of a ball of radius r.
    const double level = 2 * std::sqrt(std::max(2 * r * in_.cusp - in_.cusp * in_.cusp, 0.0));
    largest_ = 0.95 * 2 * radius; // Lu's c for roughing: never the whole diameter
    guess_ = std::min(largest_, level);
    smallest_ = tolerance::smallest_step_share * std::min(level, largest_);
    grid_ = 0.08 * radius;
    level_ = level;
    sharp_ = in_.cover->profile().cutter().r < 0.25 * radius;
}

std::vector<Interval> StepOver::ranges(double v, double back, double ahead) const {
    return in_.domain->strip(v - back, v + ahead, in_.merge);
}

DriveLine StepOver::line(double v, double back, double ahead, const Progress& progress) const {
    DriveLine line;
    line.v = v;
    line.back = back;
    line.ahead = ahead;
    LineTolerance rough;
    rough.below = rough.above = cusp_detail(in_.cusp);
    rough.spacing = grid_;
    for (const Interval& r : ranges(v, back, ahead))
        line.runs.push_back(
            lift_line(field_, v * in_.frame.across, in_.frame.along, r.lo, r.hi, rough, progress));
    return line;
}

StepOver::Sample StepOver::sample(double u, double v) const {
    Sample s;
    const Vec2 xy = in_.frame.xy(u, v);
    const AxialContact c = in_.lift->contact(xy.x(), xy.y());
    s.tip_z = std::max(c.tip_z, in_.floor);
    if (!(c.tip_z >= in_.floor) || c.facet == no_index) return s;
    const Vec3 tip(xy.x(), xy.y(), c.tip_z);
    s.valid = true;
    s.point = c.point;
    if (in_.cover->has_flat_bottom()) {
        const double z = surface_->tip_z(xy.x(), xy.y());
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

double StepOver::entry(const DriveLine* line, double u, const Vec3& p, const Vec3& n) const {
    if (!line) return infinity;
    const double limit = 2 * in_.cover->radius();
    double best = infinity;
    const auto tip = [&](const LinePoint& q) { return in_.frame.point(q.s, line->v, q.z); };
    for (const auto& run : line->runs) {
        if (run.empty() || run.front().s > u + limit || run.back().s < u - limit) continue;
        if (run.size() == 1) {
            best = std::min(best, in_.cover->ray_entry(p, n, tip(run[0]), limit));
            continue;
        }
        // The smallest entry along one piece: convex, because a swept convex body is convex.
        const auto piece = [&](std::size_t k) {
            const Vec3 a = tip(run[k]), b = tip(run[k + 1]);
            const auto f = [&](double x) { return in_.cover->ray_entry(p, n, a + x * (b - a), limit); };
            const double f0 = f(0), f1 = f(0.5), f2 = f(1);
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
        };
        const auto after =
            std::upper_bound(run.begin(), run.end(), u, [](double s, const LinePoint& q) { return s < q.s; });
        const std::size_t last = run.size() - 2;
        std::size_t k = after == run.begin() ? 0 : std::min(std::size_t(after - run.begin()) - 1, last);
        double here = piece(k);
        if (here == infinity) {
            // Not met near u: look at all of the run that can reach p.
            std::size_t found = no_index;
            for (std::size_t i = 0; i < run.size(); ++i) {
                if (std::abs(run[i].s - u) > limit) continue;
                const double t = in_.cover->ray_entry(p, n, tip(run[i]), limit);
                if (t < here) {
                    here = t;
                    found = i;
                }
            }
            if (found == no_index) continue;
            k = std::min(found, last);
            here = std::min(here, piece(k));
        }
        std::size_t left = k, right = k;
        for (double t; left > 0 && (t = piece(left - 1)) < here; --left)
            here = t;
        for (double t; right < last && (t = piece(right + 1)) < here; ++right)
            here = t;
        best = std::min(best, here);
    }
    return std::max(best, 0.0);
}

double StepOver::left_at(const DriveLine* a, const DriveLine* b, double u, const Sample& s) const {
    return std::min(entry(a, u, s.point, s.normal), entry(b, u, s.point, s.normal));
}

double StepOver::height_on(const DriveLine& line, double u) const {
    for (const auto& run : line.runs) {
        if (run.empty() || u < run.front().s || u > run.back().s) continue;
        const auto after =
            std::upper_bound(run.begin(), run.end(), u, [](double s, const LinePoint& q) { return s < q.s; });
        if (after == run.end()) return run.back().z;
        const LinePoint &p = *(after - 1), &q = *after;
        return p.z + (q.z - p.z) * (u - p.s) / (q.s - p.s);
    }
    return field_.tip_z(in_.frame.xy(u, line.v));
}

double StepOver::wall(const DriveLine* a, const DriveLine* b, Vec2 from, Vec2 to, double z_from,
                      double z_to) const {
    // Halve towards the middle height: on a steep wall this ends at a contact halfway down, at a jump on its
    // two sides.
    const double middle = 0.5 * (z_from + z_to), shortest = cusp_detail(in_.cusp);
    while ((to - from).norm() > shortest) {
        const Vec2 mid = 0.5 * (from + to);
        const Vec2 xy = in_.frame.xy(mid.x(), mid.y());
        const double z = field_.tip_z(xy);
        const bool with_from = (z > middle) == (z_from > middle);
        (with_from ? from : to) = mid;
        (with_from ? z_from : z_to) = z;
    }
    const bool from_high = z_from > z_to;
    const Vec2 high = from_high ? from : to;
    Sample top = sample(high.x(), high.y());
    if (!top.valid) return 0;
    double worst = left_at(a, b, high.x(), top);
    if (std::abs(z_from - z_to) < wall_slope * shortest) return worst;
    const Vec2 xy = in_.frame.xy(high.x(), high.y());
    Vec2 side = xy - Vec2(top.point.x(), top.point.y());
    if (!(side.norm() > 0.5 * in_.cover->radius())) return worst; // not the cutter's side that touches
    side.normalize();
    top.point = Vec3(xy.x(), xy.y(), middle + in_.cover->shoulder())
                - in_.cover->radius() * Vec3(side.x(), side.y(), 0);
    top.normal = Vec3(side.x(), side.y(), 0);
    return std::max(worst, left_at(a, b, high.x(), top));
}

double StepOver::between(const DriveLine* a, const DriveLine* b, double u, double v0, const Sample& s0,
                         double v1, const Sample& s1, double gap, int depth) const {
    if (!s0.valid || !s1.valid || !((s1.point - s0.point).norm() > gap)) return 0;
    if (depth == 0) {
        // Half-way at a jump: where both cutters leave the same, as far as the two places tell.
        const double a0 = entry(a, u, s0.point, s0.normal), a1 = entry(a, u, s1.point, s1.normal);
        const double b0 = entry(b, u, s0.point, s0.normal), b1 = entry(b, u, s1.point, s1.normal);
        const double d0 = b0 - a0, d1 = a1 - b1;
        const double between = d0 > 0 && d1 > 0 && d0 + d1 < infinity ? a0 + (a1 - a0) * d0 / (d0 + d1) : 0;
        return sharp_ ? between : std::max(between, hollow(a, b, s0, s1, u, 0.5 * (v0 + v1)));
    }
    const double v = 0.5 * (v0 + v1);
    const Sample s = sample(u, v);
    if (!s.valid) return 0;
    const double worst = left_at(a, b, u, s);
    if (worst > in_.cusp) return worst;
    return std::max({worst, between(a, b, u, v0, s0, v, s, gap, depth - 1),
                     between(a, b, u, v, s, v1, s1, gap, depth - 1)});
}

double StepOver::hollow(const DriveLine* a, const DriveLine* b, const Sample& s0, const Sample& s1, double u,
                        double v) const {
    const Vec3 route = s1.point - s0.point;
    if (!((s1.normal - s0.normal).dot(route) < 0)) return 0; // a ridge
    const Vec2 xy = in_.frame.xy(u, v);
    const Vec3 seat(xy.x(), xy.y(), std::max(s0.tip_z, s1.tip_z));
    // A hollow that runs across the columns lies elsewhere half-way to the next.
    const Vec3 bottom = s0.normal.cross(s1.normal);
    const double du = std::abs(bottom.head<2>().dot(in_.frame.along)),
                 dv = std::abs(bottom.head<2>().dot(in_.frame.across));
    const double beside = du > 0 ? grid_ * dv / du : infinity;
    double worst = 0;
    for (const std::size_t k : {0, 1}) {
        const Sample* s = k == 0 ? &s0 : &s1;
        Vec3 inward = s == &s0 ? route : Vec3(-route);
        inward -= inward.dot(s->normal) * s->normal;
        const double length = inward.norm();
        if (!(length > 0)) continue;
        inward /= length;
        const auto entry_at = [&](double w) {
            return in_.cover->ray_entry(s->point + w * inward, s->normal, seat, 2 * in_.cover->radius());
        };
        double lo = 0, hi = length;
        for (int i = 0; i < hollow_halvings; ++i) {
            const double mid = 0.5 * (lo + hi);
            (entry_at(mid) <= hollow_share * in_.cusp ? lo : hi) = mid;
        }
        // On the part, which may be round.
        Vec3 p = s->point + lo * inward;
        if (s->normal.z() > steepest_hollow) {
            const double z = surface_->tip_z(p.x(), p.y()) + in_.allowance / s->normal.z();
            if (z > p.z()) p.z() = z;
        }
        const double by_a = entry(a, u, p, s->normal), by_b = entry(b, u, p, s->normal);
        worst = std::max(worst, std::min(by_a, by_b));
        if (!a || !b || !(by_a < infinity && by_b < infinity)) continue;
        // What a line leaves grows with its distance from the place, from what the cutter there leaves.
        const double least = hollow_share * in_.cusp;
        const double rise_a = (by_a - least) / (v - a->v), rise_b = (by_b - least) / (b->v - v);
        if (!(rise_a > 0 && rise_b > 0)) continue;
        const double at = std::clamp((rise_a * a->v + rise_b * b->v) / (rise_a + rise_b),
                                     std::max(a->v, v - beside), std::min(b->v, v + beside));
        worst = std::max(worst, least + std::min(rise_a * (at - a->v), rise_b * (b->v - at)));
    }
    return worst;
}

double StepOver::worst_cusp(const DriveLine* a, const DriveLine* b, double edge,
                            const Progress& progress) const {
    const double v0 = a ? a->v : edge, v1 = b ? b->v : edge;
    if (!(v1 > v0)) return 0;
    constexpr int rows = 3;
    double v[rows];
    std::vector<Interval> domain[rows], all;
    for (int i = 0; i < rows; ++i) {
        v[i] = v0 + 0.25 * (i + 1) * (v1 - v0);
        // At a border the outermost row lies on it, but for the rounding of the domain's ends.
        const double inset = std::min(tolerance::border_inset, 0.01 * (v1 - v0));
        if (!a && i == 0) v[i] = v0 + inset;
        if (!b && i == rows - 1) v[i] = v1 - inset;
        domain[i] = in_.domain->line(v[i], in_.merge);
        all.insert(all.end(), domain[i].begin(), domain[i].end());
    }
    const auto of_line = [&](const DriveLine* line) {
        return line ? in_.domain->line(line->v, in_.merge) : std::vector<Interval>();
    };
    const std::vector<Interval> domain_a = of_line(a), domain_b = of_line(b);
    std::vector<double> columns;
    std::vector<char> joins_next;
    // Just inside the ends, so that there is something below. The ends of every row, because a corner of the
    // part may be narrower than the grid.
    const auto inset = [](const Interval& r) { return std::min(tolerance::border_inset, 0.1 * r.length()); };
    for (const Interval& r : all)
        for (const double u : {r.lo + inset(r), r.hi - inset(r)}) {
            columns.push_back(u);
            joins_next.push_back(false);
        }
    for (const Interval& r : joined(std::move(all), in_.merge)) {
        const auto n = std::size_t(std::ceil(r.length() / grid_)) + 1;
        const double from = r.lo + inset(r), length = r.length() - 2 * inset(r);
        for (std::size_t i = 0; i < n; ++i) {
            columns.push_back(n == 1 ? from : from + length * (double(i) / double(n - 1)));
            joins_next.push_back(i + 1 < n);
        }
    }
    const double steep = wall_slope;
    return parallel_reduce(
        columns.size(), block_columns, 0.0, progress,
        [&](std::size_t begin, std::size_t end) {
            double worst = 0;
            Sample ahead; // the next column's middle row, found while looking for walls
            std::size_t ahead_of = no_index;
            for (std::size_t c = begin; c < end; ++c) {
                const double u = columns[c];
                Sample s[rows];
                double x[rows] = {}, y[rows] = {};
                for (int i = 0; i < rows; ++i) {
                    if (!inside(domain[i], u, tolerance::contact_distance)) continue;
                    s[i] = i == 1 && ahead_of == c ? ahead : sample(u, v[i]);
                    if (!s[i].valid) continue;
                    const double ta = entry(a, u, s[i].point, s[i].normal);
                    const double tb = entry(b, u, s[i].point, s[i].normal);
                    worst = std::max(worst, std::min(ta, tb));
                    x[i] = std::sqrt(ta);
                    y[i] = std::sqrt(tb);
                }
                if (worst == infinity) return worst;
                const double from_a = x[0], from_b = y[rows - 1];
                // The contact jumps in a hollow hardly wider than the cutter, and stands still while the
                // cutter rolls over a convex edge; then the surface lies between the outermost rows and the
                // lines.
                bool still = false;
                for (int i = 0; i + 1 < rows; ++i)
                    still |= s[i].valid && s[i + 1].valid
                             && (s[i + 1].point - s[i].point).norm() < still_share * (v[i + 1] - v[i]);
                const auto look_between = [&](double va, const Sample& sa, double vb, const Sample& sb) {
                    // A sharp rim's contact jumps from side to side on any hollow surface.
                    if (worst > in_.cusp || (sharp_ && !still)) return;
                    worst = std::max(worst,
                                     between(a, b, u, va, sa, vb, sb,
                                             still ? edge_gap * level_ : jump_gap * level_, deepest_between));
                };
                for (int i = 0; i + 1 < rows; ++i)
                    look_between(v[i], s[i], v[i + 1], s[i + 1]);
                // So it does where the contact jumps between them, and the line leaves more than on a flank.
                const auto beside_line = [&](double root) {
                    return still || root * root > jump_share * in_.cusp;
                };
                if (a && beside_line(from_a) && inside(domain_a, u, tolerance::contact_distance))
                    look_between(v0, sample(u, v0), v[0], s[0]);
                if (b && beside_line(from_b) && inside(domain_b, u, tolerance::contact_distance))
                    look_between(v[rows - 1], s[rows - 1], v1, sample(u, v1));
                // The cusp's ridge lies where both cutters leave the same. Beside a round cutter what is left
                // grows with the square of the distance, so roots run linearly; beside a sharp rim it grows
                // with the distance.
                if (a && b) {
                    const auto crossing = [](double xa, double xb, double ya, double yb) {
                        const double da = ya - xa, db = xb - yb;
                        return da > 0 && db > 0 && da + db < infinity ? xa + (xb - xa) * da / (da + db) : 0;
                    };
                    const auto ridge = [&](const double* xs, const double* ys) {
                        double least = 0;
                        for (int i = 0; i + 1 < rows; ++i)
                            if (s[i].valid && s[i + 1].valid)
                                least = std::max(least, crossing(xs[i], xs[i + 1], ys[i], ys[i + 1]));
                        if (s[0].valid && s[1].valid)
                            least = std::max(least,
                                             crossing(0, xs[0], std::max(2 * ys[0] - ys[1], ys[0]), ys[0]));
                        constexpr int l = rows - 1;
                        if (s[l].valid && s[l - 1].valid)
                            least = std::max(
                                least, crossing(xs[l], std::max(2 * xs[l] - xs[l - 1], xs[l]), ys[l], 0));
                        return least;
                    };
                    const double root = ridge(x, y);
                    worst = std::max(worst, root * root);
                    if (sharp_) {
                        for (int i = 0; i < rows; ++i) {
                            x[i] *= x[i];
                            y[i] *= y[i];
                        }
                        worst = std::max(worst, ridge(x, y));
                    }
                }
                for (int i = 0; i + 1 < rows; ++i)
                    if (s[i].valid && s[i + 1].valid
                        && std::abs(s[i].tip_z - s[i + 1].tip_z)
                               > std::max(steep * (v[i + 1] - v[i]), in_.cusp))
                        worst = std::max(
                            worst, wall(a, b, Vec2(u, v[i]), Vec2(u, v[i + 1]), s[i].tip_z, s[i + 1].tip_z));
                // Outermost rows against the lines themselves.
                const auto to_line = [&](const DriveLine* line, const std::vector<Interval>& on_line,
                                         int row) {
                    if (!line || !s[row].valid || !inside(on_line, u, tolerance::contact_distance)) return;
                    const double z = height_on(*line, u);
                    if (std::abs(z - s[row].tip_z) > std::max(steep * std::abs(v[row] - line->v), in_.cusp))
                        worst =
                            std::max(worst, wall(a, b, Vec2(u, line->v), Vec2(u, v[row]), z, s[row].tip_z));
                };
                to_line(a, domain_a, 0);
                to_line(b, domain_b, rows - 1);
                // A wall across the passes, between this column and the next.
                if (s[1].valid && joins_next[c]
                    && inside(domain[1], columns[c + 1], tolerance::contact_distance)) {
                    ahead = sample(columns[c + 1], v[1]);
                    ahead_of = c + 1;
                    const double z = ahead.valid ? ahead.tip_z : in_.floor;
                    if (std::abs(z - s[1].tip_z) > std::max(steep * (columns[c + 1] - u), in_.cusp))
                        worst = std::max(
                            worst, wall(a, b, Vec2(u, v[1]), Vec2(columns[c + 1], v[1]), s[1].tip_z, z));
                }
            }
            return worst;
        },
        [](double x, double y) { return std::max(x, y); });
}

StepOver::Step StepOver::next(const DriveLine* a, const Progress& progress) {
    const double from = a ? a->v : in_.domain->lo();
    const double cap = std::min(a ? largest_ : 0.5 * largest_, in_.domain->hi() - from);
    Step best, last;
    best.satisfied = last.satisfied = false;
    double low = 0, high = infinity;
    double step = std::min(a ? guess_ : 0.5 * guess_, cap);
    // At a slanted border the line before reaches half of the way, and so does this one. The step after this
    // one is not known yet: as much as it will likely be.
    DriveLine longer;
    const auto attempt = [&](double d) {
        Step s;
        s.line = line(from + d, reach_share * d, reach_share * std::max(d, guess_), progress);
        if (a && a->ahead < reach_share * d) {
            longer = line(a->v, a->back, reach_share * std::max(d, guess_), progress);
            a = &longer;
        }
        s.cusp = worst_cusp(a, &s.line, from, progress);
        s.satisfied = s.cusp <= in_.cusp;
        return s;
    };
    for (int tries = 0; tries < 24; ++tries) {
        Step s = attempt(step);
        double wish = 0.5 * step;
        if (s.cusp < infinity)
            wish = s.cusp > 0 ? std::min(step * std::sqrt(0.985 * in_.cusp / s.cusp), 4 * step) : 4 * step;
        if (s.satisfied) {
            low = step;
            const bool good = s.cusp >= good_share * in_.cusp;
            best = std::move(s);
            if (good || step >= cap) break;
        } else {
            high = step;
            last = std::move(s);
            if (step <= smallest_) break;
        }
        if (low > 0 && high < infinity && high - low <= 0.01 * high) break;
        // A step is only as the root of the cusp: what is left to gain is small.
        if (tries >= 2 && best.satisfied && best.cusp >= fair_share * in_.cusp) break;
        if (low == 0) {
            step = std::clamp(wish, 0.1 * high, 0.99 * high);
            step = std::max(step, std::min(smallest_, 0.9 * high));
        } else if (high == infinity) {
            step = std::min(std::max(wish, 1.02 * low), cap);
        } else {
            const double margin = 0.1 * (high - low);
            step = std::clamp(wish, low + margin, high - margin);
        }
        step = std::min(step, cap);
    }
    if (best.satisfied) {
        if (a) guess_ = std::min(low, largest_);
        return best;
    }
    // No step is small enough. Take the largest that leaves hardly more than the smallest does: what a
    // smaller step does not improve is not the step's fault.
    double fine = last.cusp;
    for (double d = std::min(2 * step, cap); d > step && d <= guess_; d = std::min(2 * d, cap)) {
        Step s = attempt(d);
        if (!(s.cusp <= 1.05 * fine)) break;
        last = std::move(s);
        if (d >= cap) break;
    }
    return last;
}

} // namespace facetmill
