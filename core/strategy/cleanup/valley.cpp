#include "core/strategy/cleanup/valley.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/valley_fit.h"
#include "core/strategy/surface/facet_rows.h"
#include "core/strategy/surface/point_grid.h"

#include <numeric>
#include <optional>

namespace facetmill {

namespace {

constexpr std::size_t block_facets = 256;
constexpr double max_samples = 4e6;
constexpr std::size_t check_every = 8192;
/// Of the samples' spacing: facets with shorter edges are small.
constexpr double small_share = 0.6;
/// Steps along a curve, in radii of the cutter.
constexpr double step_share = 0.08;
/// Of the cutter's radius: touched points nearer to each other are the same flank's. More than noise lets a
/// touched point jump about on one flank, less than the width of any valley that leaves something.
constexpr double min_jump = 0.12;
/// By more the touched points do not move, in radii, between two steps on the same two flanks.
constexpr double max_move = 0.45;
/// By more, in radii, the tip falls only beside an upright wall.
constexpr double fall_share = 0.02;
/// Of a step: points nearer to each other are one.
constexpr double min_step = 0.4;
/// Of an arc on which the next point is looked for.
constexpr int arc_samples = 13, ring_samples = 24;
constexpr int halvings = 30, arc_halvings = 16;
/// The end of a curve is found to this share of a step.
constexpr double end_share = 1.0 / 32;
/// After so many steps beyond a place where it was lost a curve has not ended.
constexpr int steps_to_go_on = 4;
constexpr std::size_t max_steps = 200000;
/// The fitted vector is an average over this many radii along the curve, to either side.
constexpr double fit_share = 0.25;
/// Planes whose normals span less than this meet in no one place.
constexpr double flat_corner = 0.02;
/// What is farther from the touched points than so many radii is no corner under the cutter.
constexpr double corner_reach = 3;
/// What is left ahead of the last centre is looked for up to this angle from the fitted vector.
constexpr double max_turn = 1.2;
/// Ends nearer to each other than this many steps meet.
constexpr double node_steps = 2;

/// The cutter let down at a place.
struct Touch {
    bool valid = false; ///< false: it meets nothing
    Vec3 tip, point, normal;
    Vec3 feature; ///< the touched point from the tip, in radii
};

class Finder {
public:
    Finder(const ValleyInput& input, Valleys& result)
        : in_(input), out_(result), radius_(input.cover->radius()), reach_(input.mesh->box().diagonal()),
          step_(step_share * radius_), done_(step_) {
        out_.step = step_;
    }

    void run(const Progress& progress) {
        sample(progress.part(0, 0.5, "Looking where the previous cutter left something"));
        const auto seeds = converged(progress.part(0.5, 0.75));
        follow(seeds, progress.part(0.75, 0.95, "Following valleys"));
        measure(progress.part(0.95, 1));
    }

private:
    enum class End { lost, joined, off };
    struct Traced {
        std::vector<PencilPoint> points;
        bool closed = false;
        End end = End::lost;
    };
    struct Found {
        double angle = 0;
        PencilPoint point;
    };

    Touch touch_at(const Vec2& at) const {
        Touch t;
        const AxialContact c = in_.lift->contact(at.x(), at.y());
        if (!(c.tip_z > -infinity)) return t;
        t.valid = true;
        t.tip = Vec3(at.x(), at.y(), c.tip_z);
        t.point = c.point;
        const Vec3 rel = c.point - t.tip;
        const Vec3 facet = in_.side->towards_tool(in_.mesh->facet_normal(c.facet));
        t.normal = in_.cover->contact_normal(rel).value_or(facet);
        t.feature = rel / radius_;
        // All places of a flat bottom are one.
        if (in_.cover->has_flat_bottom() && rel.z() <= in_.tolerance
            && (t.normal.z() > 0.98 || facet.z() > 0.98))
            t.feature = Vec3::Zero();
        return t;
    }

    static double apart(const Touch& a, const Touch& b) { return (a.feature - b.feature).norm(); }

    PencilPoint pencil(const Touch& left, const Touch& right) const {
        PencilPoint p;
        p.touch = {left.point, right.point};
        p.normal = {left.normal, right.normal};
        p.tip = left.tip.z() > right.tip.z() ? left.tip : right.tip;
        const double fall = left.tip.z() - right.tip.z();
        if (std::abs(fall) > fall_share * radius_) {
            // An upright wall: the lower one passes along it, the higher one stands on its top.
            const Touch& low = fall > 0 ? right : left;
            const Touch& high = fall > 0 ? left : right;
            p.tip = low.tip;
            Vec3 out(high.point.x() - low.tip.x(), high.point.y() - low.tip.y(), 0);
            if (out.norm() > 0) out.normalize();
            const std::size_t side = fall > 0 ? 0 : 1;
            p.touch[side] = low.tip + radius_ * out + Vec3(0, 0, in_.cover->shoulder());
            p.normal[side] = -out;
        }
        return p;
    }
    Vec3 feature(const PencilPoint& p, int side) const {
        return (p.touch[std::size_t(side)] - p.tip) / radius_;
    }
    double moved(const PencilPoint& a, const PencilPoint& b) const {
        return std::max((feature(a, 0) - feature(b, 0)).norm(), (feature(a, 1) - feature(b, 1)).norm());
    }

    /// Halves [a, b] until the jump between both is known to rounding; false where there is none left.
    template <class At>
    bool halve(At&& at, double lo, double hi, Touch& a, Touch& b, int times) const {
        for (int i = 0; i < times; ++i) {
            const double mid = 0.5 * (lo + hi);
            const Touch t = at(mid);
            if (!t.valid) return false;
            if (apart(t, a) <= apart(t, b)) {
                a = t;
                lo = mid;
            } else {
                b = t;
                hi = mid;
            }
            if (apart(a, b) < min_jump) return false;
        }
        return true;
    }

    /// Those that a tool can come to; of facets that are small against the spacing one a cell is enough, and
    /// one of those that face another way.
    std::vector<Index> asked_facets(double spacing, const Progress& progress) const {
        const Mesh& mesh = *in_.mesh;
        // What is done with each: left out, asked, or asked where it is the first that faces one of five ways
        // in its cell.
        enum : std::uint8_t { out, asked_for, small };
        std::vector<std::uint8_t> what(mesh.facet_count(), out);
        parallel_for(mesh.facet_count(), check_every, progress.part(0, 0), [&](std::size_t f) {
            const Vec3 n = in_.side->towards_tool(mesh.facet_normal(f));
            if (n == Vec3::Zero() || n.z() < -tolerance::vertical_normal_z) return;
            const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
            const double longest2 =
                std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            what[f] = asked_for;
            if (longest2 >= small_share * small_share * spacing * spacing) return;
            const Vec3 size = n.cwiseAbs();
            const int facing = size.z() >= size.x() && size.z() >= size.y() ? 0
                               : size.x() >= size.y()                       ? (n.x() > 0 ? 1 : 2)
                                                                            : (n.y() > 0 ? 3 : 4);
            what[f] = std::uint8_t(small + facing);
        });
        std::array<PointGrid, 5> seen{PointGrid(spacing), PointGrid(spacing), PointGrid(spacing),
                                      PointGrid(spacing), PointGrid(spacing)};
        std::vector<Index> asked;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % check_every == 0) progress.check();
            if (what[f] == out) continue;
            if (what[f] >= small
                && !seen[std::size_t(what[f] - small)].add_first(
                    (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3))
                continue;
            asked.push_back(Index(f));
        }
        return asked;
    }

    void sample(const Progress& progress) {
        const Mesh& mesh = *in_.mesh;
        double spacing =
            std::clamp(0.7 * std::sqrt(2 * radius_ * in_.tolerance), 0.05 * radius_, 0.25 * radius_);
        double area = 0;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            area += 0.5 * mesh.facet_cross(f).norm();
        spacing = std::max(spacing, std::sqrt(area / max_samples));
        const std::vector<Index> asked = asked_facets(spacing, progress);
        using Samples = std::vector<RestSample>;
        out_.samples = parallel_reduce(
            asked.size(), block_facets, Samples(), progress,
            [&](std::size_t begin, std::size_t end) {
                Samples found;
                LiftHint hint;
                for (std::size_t i = begin; i < end; ++i) {
                    const Index f = asked[i];
                    const Vec3 n = in_.side->towards_tool(mesh.facet_normal(f));
                    const FacetRows rows(mesh, f, spacing);
                    for (std::size_t r = 0; r < rows.rows(); ++r)
                        for (std::size_t c = 0; c < rows.columns(r); ++c) {
                            if (c % 512 == 0) progress.check();
                            RestSample s = nearest_touch(in_, rows.point(r, c), n, hint);
                            if (s.gap <= in_.tolerance) continue;
                            s.area = rows.weight(r);
                            found.push_back(s);
                        }
                }
                return found;
            },
            [](Samples a, const Samples& b) {
                a.insert(a.end(), b.begin(), b.end());
                return a;
            });
    }

    /// Moves the tip from a sample's until another flank holds it.
    std::optional<PencilPoint> converge(const RestSample& s) const {
        const Vec2 at = s.tip.head<2>();
        Touch last = touch_at(at);
        if (!last.valid) return std::nullopt;
        Vec2 route = (last.normal - s.normal).head<2>();
        if (route.norm() < tolerance::level_angle) route = -s.normal.head<2>();
        if (route.norm() < tolerance::level_angle) return std::nullopt;
        route.normalize();
        const auto on_route = [&](double x) { return touch_at(at + x * route); };
        const double stride = 0.15 * radius_;
        for (double x = 0; x < 2.2 * radius_; x += stride) {
            Touch next = on_route(x + stride);
            if (!next.valid) return std::nullopt;
            Touch a = last, b = next;
            if (apart(a, b) >= min_jump && halve(on_route, x, x + stride, a, b, halvings))
                return pencil(a, b);
            last = next;
        }
        return std::nullopt;
    }

    std::vector<PencilPoint> converged(const Progress& progress) const {
        // One sample a cell is enough to meet every curve many times.
        PointGrid seen(2 * step_);
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < out_.samples.size(); ++i)
            if (seen.add_first(out_.samples[i].point)) chosen.push_back(i);
        std::vector<std::optional<PencilPoint>> found(chosen.size());
        parallel_for(chosen.size(), 32, progress,
                     [&](std::size_t i) { found[i] = converge(out_.samples[chosen[i]]); });
        std::vector<PencilPoint> seeds;
        for (const auto& f : found)
            if (f) seeds.push_back(*f);
        return seeds;
    }

    /// All jumps on an arc about a place, counter-clockwise.
    std::vector<Found> jumps(const Vec2& about, double rho, double from, double to, int samples) const {
        const auto on_arc = [&](double angle) {
            return touch_at(about + rho * Vec2(std::cos(angle), std::sin(angle)));
        };
        std::vector<Found> found;
        Touch last = on_arc(from);
        double angle = from;
        for (int k = 1; k < samples; ++k) {
            const double next_angle = from + (to - from) * k / (samples - 1);
            const Touch next = on_arc(next_angle);
            Touch a = last, b = next;
            if (a.valid && b.valid && apart(a, b) >= min_jump
                && halve(on_arc, angle, next_angle, a, b, arc_halvings)) {
                // Going on along the arc's radius, what comes later is on the left.
                Found f;
                f.point = pencil(b, a);
                const Vec2 d = f.point.tip.head<2>() - about;
                f.angle = std::atan2(d.y(), d.x());
                found.push_back(f);
            }
            last = next;
            angle = next_angle;
        }
        return found;
    }

    /// Follows the curve from `start`, whose left and right are those of going along `heading`.
    Traced trace(const PencilPoint& start, double heading, const Progress& progress) const {
        Traced t;
        t.points.push_back(start);
        double rho = step_, stop = 0;
        bool ending = false;
        int passed = 0; // steps since the curve was lost
        while (t.points.size() < max_steps) {
            progress.check();
            const PencilPoint& last = t.points.back();
            const auto found =
                jumps(last.tip.head<2>(), rho, heading - 0.5 * pi, heading + 0.5 * pi, arc_samples);
            const Found* best = nullptr;
            double least = max_move;
            for (const Found& f : found)
                if (const double m = moved(f.point, last); m <= least) {
                    least = m;
                    best = &f;
                }
            if (!best) {
                // Steps become shorter from here on, until it is clear that the curve goes on.
                if (!ending) stop = end_share * rho;
                ending = true;
                passed = 0;
                rho *= 0.5;
                if (rho < stop) return t;
                continue;
            }
            const double route = (best->point.tip - last.tip).norm();
            if (route > 1.6 * step_ && rho > tolerance::lift_accuracy * radius_) {
                rho *= 0.5;
                continue;
            }
            if (ending && ++passed == steps_to_go_on) ending = false;
            heading = best->angle;
            if (joins(best->point)) {
                t.points.push_back(best->point);
                t.end = End::joined;
                return t;
            }
            t.points.push_back(best->point);
            if (t.points.size() > 8 && (best->point.tip - start.tip).norm() < 0.75 * step_
                && moved(best->point, start) < max_move) {
                t.closed = true;
                t.points.pop_back();
                return t;
            }
            if (!is_on_part(t.points.back())) {
                t.end = End::off;
                return t;
            }
            if (!ending && route < 0.6 * step_) rho = std::min(1.5 * rho, step_);
        }
        return t;
    }

    /// A first look, without the fit.
    bool is_on_part(const PencilPoint& p) const {
        const Vec3 up = p.normal[0] + p.normal[1];
        if (up.norm() < tolerance::level_angle) return true;
        return in_.grid->first_hit(0.5 * (p.touch[0] + p.touch[1]), -up.normalized(), reach_).has_value();
    }

    bool joins(const PencilPoint& p) const { return near_done(p, 0.5 * step_); }
    bool near_done(const PencilPoint& p, double within) const {
        return done_.near_until(p.tip, within, [&](std::size_t i) {
            const PencilPoint& q = all_[i];
            if ((q.tip - p.tip).norm() > within) return false;
            PencilPoint turned = q;
            std::swap(turned.touch[0], turned.touch[1]);
            return moved(p, q) < max_move || moved(p, turned) < max_move;
        });
    }

    void follow(const std::vector<PencilPoint>& seeds, const Progress& progress) {
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            progress.set(double(i) / double(seeds.size()));
            const PencilPoint& seed = seeds[i];
            if (near_done(seed, 1.2 * step_)) continue;
            PencilPoint turned = seed;
            std::swap(turned.touch[0], turned.touch[1]);
            std::swap(turned.normal[0], turned.normal[1]);
            // A ring about it crosses the curve twice; on one side maybe a smaller one only, where another
            // curve is near.
            std::array<std::optional<double>, 2> heading;
            for (double rho = step_; rho > end_share * step_ && !(heading[0] && heading[1]); rho *= 0.5) {
                const auto ring = jumps(seed.tip.head<2>(), rho, -pi, pi, ring_samples);
                for (const std::size_t route : {0, 1}) {
                    if (heading[route]) continue;
                    double least = max_move;
                    for (const Found& f : ring)
                        if (const double m = moved(f.point, route == 0 ? seed : turned); m < least) {
                            least = m;
                            heading[route] = f.angle;
                        }
                }
            }
            if (!heading[0] && !heading[1]) continue;
            Traced parts[2];
            if (heading[0]) parts[0] = trace(seed, *heading[0], progress);
            if (heading[1] && !parts[0].closed) parts[1] = trace(turned, *heading[1], progress);
            ValleyCurve curve;
            if (parts[0].closed) {
                curve.closed = true;
                curve.points = std::move(parts[0].points);
            } else {
                for (std::size_t k = parts[1].points.size(); k-- > 1;) {
                    PencilPoint p = parts[1].points[k];
                    std::swap(p.touch[0], p.touch[1]);
                    std::swap(p.normal[0], p.normal[1]);
                    curve.points.push_back(p);
                }
                if (parts[0].points.empty()) parts[0].points.push_back(seed);
                curve.points.insert(curve.points.end(), parts[0].points.begin(), parts[0].points.end());
            }
            ends_.push_back({parts[1].end, parts[0].end});
            for (const PencilPoint& p : curve.points) {
                done_.add(p.tip);
                all_.push_back(p);
            }
            out_.curves.push_back(std::move(curve));
        }
    }

    /// Fitted vectors, centres, gaps; curves cut down to where more than the tolerance is left; nodes.
    void measure(const Progress& progress) {
        std::vector<ValleyCurve> runs;
        std::vector<std::array<bool, 2>> open; // ends that a third flank made
        for (std::size_t c = 0; c < out_.curves.size(); ++c) {
            ValleyCurve& curve = out_.curves[c];
            const auto place_all = [&] {
                parallel_for(curve.points.size(), 64, progress.part(0, 0),
                             [&](std::size_t i) { place(curve.points[i]); });
            };
            thin_out(curve);
            // Each by its own normals first: they say where the cutter rolls out over a rim.
            fit_up(curve, 0, std::vector<Rolls>(curve.points.size(), Rolls::no));
            place_all();
            const std::vector<Rolls> rolls = rolling(in_, curve, fit_share * radius_);
            fit_up(curve, fit_share * radius_, rolls);
            place_all();
            add_runs(curve, rolls, ends_[c], runs, open);
            progress.check();
        }
        leave_out_doubles(runs, open);
        out_.curves = std::move(runs);
        join(open);
        progress.set(1);
    }

    /// Where a curve was lost its steps became ever shorter.
    void thin_out(ValleyCurve& curve) const {
        std::vector<PencilPoint> kept;
        for (const PencilPoint& p : curve.points)
            if (kept.empty() || (p.tip - kept.back().tip).norm() >= min_step * step_) kept.push_back(p);
        if (curve.points.size() > 1 && !curve.closed && kept.size() > 1) kept.back() = curve.points.back();
        curve.points = std::move(kept);
    }

    void place(PencilPoint& p) const {
        p.from = 0.5 * (p.touch[0] + p.touch[1]);
        const auto hit = in_.grid->first_hit(p.from, -p.up, reach_);
        p.on_part = hit.has_value();
        if (!hit) return;
        p.center = p.from - hit->distance * p.up;
        p.gap = in_.cover->distance(p.center - p.tip);
    }

    void add_runs(const ValleyCurve& curve, const std::vector<Rolls>& rolls, const std::array<End, 2>& ends,
                  std::vector<ValleyCurve>& runs, std::vector<std::array<bool, 2>>& open) const {
        const auto& p = curve.points;
        const std::size_t n = p.size();
        std::vector<char> good(n);
        for (std::size_t i = 0; i < n; ++i)
            good[i] = p[i].on_part && rolls[i] != Rolls::out && p[i].gap > in_.tolerance;
        for (std::size_t i = curve.closed ? 0 : 1; i < n; ++i) {
            const std::size_t before = i > 0 ? i - 1 : n - 1;
            if (p[before].on_part && p[i].on_part && runs_back(p[before], p[i])) good[i] = good[before] = 0;
        }
        // A closed curve is opened at its first bad place.
        std::size_t first = 0;
        bool closed = curve.closed;
        if (closed) {
            const auto bad = std::find(good.begin(), good.end(), 0);
            if (bad != good.end()) first = std::size_t(bad - good.begin());
        }
        const auto at = [&](std::size_t i) { return (first + i) % n; };
        const auto route = [&](std::size_t a, std::size_t b) {
            double sum = 0;
            for (std::size_t i = a; i < b; ++i)
                sum += (p[at(i + 1)].center - p[at(i)].center).norm();
            return sum;
        };
        // [from, to) ranges, short interruptions bridged.
        std::vector<std::array<std::size_t, 2>> ranges;
        for (std::size_t i = 0; i < n; ++i) {
            if (!good[at(i)]) continue;
            bool bridge = !ranges.empty() && route(ranges.back()[1] - 1, i) <= in_.ripple;
            for (std::size_t k = bridge ? ranges.back()[1] : i; k < i; ++k)
                bridge = bridge && p[at(k)].on_part;
            if (bridge || (!ranges.empty() && ranges.back()[1] == i))
                ranges.back()[1] = i + 1;
            else
                ranges.push_back({i, i + 1});
        }
        for (const auto& [a, b] : ranges) {
            const bool whole = b - a == n;
            if (route(a, b - 1) < in_.ripple && !(whole && closed)) continue;
            ValleyCurve run;
            run.closed = whole && closed;
            for (std::size_t i = a; i < b; ++i)
                run.points.push_back(p[at(i)]);
            // The touched points come to the border before the centre does.
            const auto rolls_at = [&](std::size_t i) { return rolls[at(i)] != Rolls::no; };
            if (!run.closed && (rolls_at(b - 1) || (b < n && rolls_at(b)))) go_to_border(run);
            if (!run.closed && (rolls_at(a) || (a > 0 && rolls_at(a - 1)))) {
                std::reverse(run.points.begin(), run.points.end());
                go_to_border(run);
                std::reverse(run.points.begin(), run.points.end());
            }
            runs.push_back(std::move(run));
            open.push_back({!curve.closed && a == 0 && ends[0] != End::off,
                            !curve.closed && b == n && ends[1] != End::off});
        }
    }

    /// The last point's centre goes on straight over the surface to the part's border, if it is near.
    void go_to_border(ValleyCurve& run) const {
        auto& p = run.points;
        const PencilPoint end = p.back();
        Vec3 ahead = Vec3::Zero();
        for (std::size_t i = p.size(); i-- > 0 && ahead.norm() < fit_share * radius_;)
            ahead = end.center - p[i].center;
        if (ahead == Vec3::Zero()) return;
        ahead.normalize();
        const auto ahead_by = [&](double route) -> std::optional<PencilPoint> {
            PencilPoint q = end;
            for (Vec3* v : {&q.tip, &q.touch[0], &q.touch[1], &q.from})
                *v += route * ahead;
            const auto hit = in_.grid->first_hit(q.from, -q.up, reach_);
            if (!hit) return std::nullopt;
            q.center = q.from - hit->distance * q.up;
            if ((q.center - end.center).norm() > 1.5 * route) return std::nullopt; // another surface
            return q;
        };
        std::vector<PencilPoint> more;
        double route = step_;
        for (; route <= radius_; route += step_) {
            const auto q = ahead_by(route);
            if (!q) break;
            more.push_back(*q);
        }
        if (route > radius_) return; // no border there
        double lo = route - step_, hi = route;
        std::optional<PencilPoint> last;
        while (hi - lo > end_share * step_) {
            const double mid = 0.5 * (lo + hi);
            const auto q = ahead_by(mid);
            (q ? lo : hi) = mid;
            if (q) last = q;
        }
        p.insert(p.end(), more.begin(), more.end());
        if (last) p.push_back(*last);
    }

    /// A cutter that rolls out over the end of a valley sees it once more.
    void leave_out_doubles(std::vector<ValleyCurve>& runs, std::vector<std::array<bool, 2>>& open) {
        std::vector<std::size_t> order(runs.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return runs[a].points.size() > runs[b].points.size();
        });
        std::vector<char> keep(runs.size(), 1);
        PointGrid known(2 * step_);
        for (const std::size_t r : order) {
            std::size_t same = 0;
            for (const PencilPoint& p : runs[r].points)
                same += known.near_until(p.center, step_, [&](std::size_t i) {
                    return (known.points()[i] - p.center).norm() < step_;
                });
            if (2 * same > runs[r].points.size()) {
                keep[r] = 0;
                continue;
            }
            for (const PencilPoint& p : runs[r].points)
                known.add(p.center);
        }
        std::size_t kept = 0;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            if (!keep[r]) continue;
            if (kept != r) {
                runs[kept] = std::move(runs[r]);
                open[kept] = open[r];
            }
            ++kept;
        }
        runs.resize(kept);
        open.resize(kept);
        // Which tip is whose.
        PointGrid tips(2 * step_);
        std::vector<int> owner;
        for (std::size_t r = 0; r < runs.size(); ++r)
            for (const PencilPoint& p : runs[r].points) {
                tips.add(p.tip);
                owner.push_back(int(r));
            }
        for (const PencilPoint& p : all_) {
            int curve = -1;
            double least = step_;
            tips.near(p.tip, step_, [&](std::size_t i) {
                const double d = (tips.points()[i] - p.tip).norm();
                if (d < least) {
                    least = d;
                    curve = owner[i];
                }
            });
            out_.tips.push_back({p.tip, curve});
        }
    }

    /// Where the planes at the touched points meet, if they do in one place.
    static std::optional<Vec3> corner(const std::vector<Vec3>& touches, const std::vector<Vec3>& normals) {
        Mat3 sum = Mat3::Zero();
        Vec3 right = Vec3::Zero();
        for (std::size_t k = 0; k < touches.size(); ++k) {
            sum += normals[k] * normals[k].transpose();
            right += normals[k] * normals[k].dot(touches[k]);
        }
        if (std::abs(sum.determinant()) < flat_corner) return std::nullopt;
        return Vec3(sum.inverse() * right);
    }

    /// Ends that came to the same place go on to its centre: from between the touched points of all of them a
    /// ray along the sum of all normals meets the corner.
    void join(const std::vector<std::array<bool, 2>>& open) {
        struct EndOf {
            std::size_t curve;
            std::size_t side;
        };
        std::vector<EndOf> ends;
        for (std::size_t c = 0; c < out_.curves.size(); ++c)
            for (std::size_t s = 0; s < 2; ++s)
                if (!out_.curves[c].closed && open[c][s]) ends.push_back({c, s});
        const auto last = [&](const EndOf& e) -> PencilPoint& {
            auto& p = out_.curves[e.curve].points;
            return e.side == 0 ? p.front() : p.back();
        };
        std::vector<char> taken(ends.size(), 0);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (taken[i]) continue;
            std::vector<std::size_t> group{i};
            for (std::size_t k = i + 1; k < ends.size(); ++k)
                if (!taken[k] && (last(ends[k]).tip - last(ends[i]).tip).norm() < node_steps * step_)
                    group.push_back(k);
            if (group.size() < 2) continue;
            std::vector<Vec3> touches, normals;
            Vec3 tip = last(ends[i]).tip;
            for (const std::size_t g : group) {
                taken[g] = 1;
                const PencilPoint& p = last(ends[g]);
                if (p.tip.z() > tip.z()) tip = p.tip;
                for (std::size_t s = 0; s < 2; ++s) {
                    bool known = false;
                    for (const Vec3& t : touches)
                        known = known || (t - p.touch[s]).norm() < max_move * radius_;
                    if (known) continue;
                    touches.push_back(p.touch[s]);
                    normals.push_back(p.normal[s]);
                }
            }
            PencilPoint node;
            node.tip = tip;
            node.touch = {touches.front(), touches.back()};
            node.normal = {normals.front(), normals.back()};
            node.from = Vec3::Zero();
            Vec3 up = Vec3::Zero();
            for (std::size_t k = 0; k < touches.size(); ++k) {
                node.from += touches[k] / double(touches.size());
                up += normals[k];
            }
            up.z() = std::max(up.z(), 0.0);
            if (up.norm() < tolerance::level_angle) continue;
            node.up = up.normalized();
            Vec3 route = -node.up;
            if (const auto meet = corner(touches, normals); meet && (*meet - node.from).dot(route) > 0)
                route = (*meet - node.from).normalized();
            const auto hit = in_.grid->first_hit(node.from, route, corner_reach * radius_);
            if (!hit) continue;
            node.on_part = true;
            node.center = node.from + hit->distance * route;
            node.gap = in_.cover->distance(node.center - node.tip);
            // Three flanks that the cutter touches without leaving anything between them are no corner: as
            // where a floor becomes too narrow for it.
            if (!(node.gap > in_.tolerance)) continue;
            const int number = int(out_.nodes.size());
            out_.nodes.push_back(node.center);
            for (const std::size_t g : group)
                lead(ends[g].curve, ends[g].side, node, number);
        }
        PointGrid tips(radius_);
        for (const Valleys::Tip& t : out_.tips)
            tips.add(t.tip);
        for (const EndOf& e : ends)
            if (out_.curves[e.curve].node[e.side] < 0) turn_ahead(out_.curves[e.curve], e.side, tips);
    }

    /// Where a third flank stops the cutter that came along two, the fitted vector may lean back: what is
    /// left ahead of the last centre is the valley's too, until the cutter at another place leaves less, or
    /// none is left.
    void turn_ahead(ValleyCurve& curve, std::size_t side, const PointGrid& tips) const {
        auto& p = curve.points;
        const PencilPoint end = side == 0 ? p.front() : p.back();
        Vec3 ahead = Vec3::Zero();
        for (std::size_t i = 1; i < p.size() && ahead.norm() < fit_share * radius_; ++i)
            ahead = end.tip - p[side == 0 ? i : p.size() - 1 - i].tip;
        ahead -= ahead.dot(end.up) * end.up;
        if (ahead.norm() < tolerance::contact_distance) return;
        ahead.normalize();
        const double turn = 0.5 * step_ / (end.center - end.from).norm();
        const auto is_nearest = [&](const PencilPoint& q) {
            const double within = 2 * radius_ + q.gap;
            return !tips.near_until(q.center, within, [&](std::size_t i) {
                const Vec3& tip = tips.points()[i];
                return (tip - end.tip).norm() > min_step * step_
                       && in_.cover->distance(q.center - tip) < q.gap - 0.1 * in_.tolerance;
            });
        };
        std::vector<PencilPoint> more;
        PencilPoint q = end;
        for (double angle = turn; angle < max_turn; angle += turn) {
            const Vec3 route = std::sin(angle) * ahead - std::cos(angle) * end.up;
            const auto hit = in_.grid->first_hit(end.from, route, reach_);
            if (!hit) break;
            q.center = end.from + hit->distance * route;
            q.gap = in_.cover->distance(q.center - q.tip);
            if (!(q.gap > in_.tolerance) || !is_nearest(q)) break;
            more.push_back(q);
        }
        if (side == 0) {
            std::reverse(more.begin(), more.end());
            p.insert(p.begin(), more.begin(), more.end());
        } else {
            p.insert(p.end(), more.begin(), more.end());
        }
    }

    /// Points from the end of a curve to a node, on the part: rays from within the same cutter.
    void lead(std::size_t c, std::size_t side, const PencilPoint& node, int number) {
        ValleyCurve& curve = out_.curves[c];
        curve.node[side] = number;
        const PencilPoint from = side == 0 ? curve.points.front() : curve.points.back();
        const double route = (node.center - from.center).norm();
        const auto steps = std::size_t(std::ceil(route / step_));
        std::vector<PencilPoint> more;
        for (std::size_t k = 1; k <= steps; ++k) {
            const double x = double(k) / double(steps);
            PencilPoint p = from;
            p.tip = node.tip;
            p.from = (1 - x) * from.from + x * node.from;
            p.up = ((1 - x) * from.up + x * node.up).normalized();
            const Vec3 aim = (1 - x) * from.center + x * node.center - p.from;
            if (aim.norm() < tolerance::level_angle) continue;
            const auto hit = in_.grid->first_hit(p.from, aim.normalized(), reach_);
            if (!hit) continue;
            p.center = p.from + hit->distance * aim.normalized();
            p.gap = in_.cover->distance(p.center - p.tip);
            p.on_part = true;
            more.push_back(p);
        }
        if (side == 1) {
            curve.points.insert(curve.points.end(), more.begin(), more.end());
        } else {
            std::reverse(more.begin(), more.end());
            curve.points.insert(curve.points.begin(), more.begin(), more.end());
        }
    }

    const ValleyInput& in_;
    Valleys& out_;
    double radius_, reach_, step_;
    std::vector<PencilPoint> all_; ///< of all finished curves
    PointGrid done_;
    std::vector<std::array<End, 2>> ends_;
};

} // namespace

Valleys find_valleys(const ValleyInput& input, const Progress& progress) {
    Valleys result;
    Finder(input, result).run(progress);
    return result;
}

} // namespace facetmill
