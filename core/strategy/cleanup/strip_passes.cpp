#include "core/strategy/cleanup/strip_passes.h"

#include "core/base/golden_section.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/vector_lift.h"
#include "core/mesh/refine.h"
#include "core/strategy/cleanup/band_facets.h"
#include "core/strategy/cleanup/border_touch.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/pass_clearing.h"
#include "core/strategy/cleanup/pass_leads.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>

namespace facetmill {

namespace {

/// Facets that lift the cutter are looked for along this many radii of the curve at once.
constexpr double chunk_radii = 4;
/// ... and so many radii beyond the band's reach there and at so many more points of the curve.
constexpr double lift_radii = 2.5;
constexpr std::size_t near_points = 8;
constexpr std::size_t check_every = 8192;
/// ... and face along the fitted vector by more than this cosine.
constexpr double facing = 0.01;
/// A tip that the part holds up by more than this many radii above where it should be has no place there.
constexpr double max_raise = 1.5, max_raise_z = 4;
/// Against the fitted vector it goes no deeper than this, in radii, beyond the plane across it; beyond a
/// valley's end as deep as it takes to roll over the rim of both flanks.
constexpr double max_sink = 0.25, max_sink_beyond = 1.5;
/// The first pass is looked for so far beside the centre, in radii.
constexpr double aside_share = 0.3, aside_accuracy = 7e-4;
constexpr int max_passes = 400, max_tries = 8;
/// Step-overs are no smaller, in radii of the cutter.
constexpr double smallest_step = 0.01;
/// The step-over suits this share of the places along a pass; elsewhere passes are put in, halving so often.
constexpr double usual_share = 0.85;
constexpr int max_fills = 4;
/// ... and so many radii of the way between two of them are passed over, too.
constexpr double bridge_radii = 4;
/// The end of a pass is found to this many halvings of a step.
constexpr int end_halvings = 8;
constexpr int ridge_angles = 241;
constexpr double ridge_tilt = 1.4; ///< radians, to either side

/// What stays between two passes is looked for on the part by so many halvings of the way from one to the
/// other.
constexpr int between_halvings = 5;
/// The least that the cutter leaves is looked for in steps down to this, of what may be left.
constexpr double finest_limit = 0.1;
/// Sine of the angle: by less the part does not turn between two passes.
constexpr double same_plane = 0.02;

/// Largest d . p over the cutter with its tip at the origin.
double support(const CutterProfile& profile, const Vec3& d) {
    const double out = std::hypot(d.x(), d.y());
    double best = std::max(0.0, d.z() * profile.height());
    for (const ProfilePiece& p : profile.pieces()) {
        best = std::max({best, out * p.from.x() + d.z() * p.from.y(), out * p.to.x() + d.z() * p.to.y()});
        if (p.kind != ProfilePiece::Kind::arc) continue;
        const Vec2 q = p.center + p.radius * Vec2(out, d.z()).normalized();
        if (q.y() >= std::min(p.from.y(), p.to.y()) && q.y() <= std::max(p.from.y(), p.to.y())
            && q.x() >= std::min(p.from.x(), p.to.x()))
            best = std::max(best, out * q.x() + d.z() * q.y());
    }
    return best;
}

/// A cutter at a place of a pass.
struct Spot {
    bool free = false;
    Vec3 tip = Vec3::Zero(), touch = Vec3::Zero(), normal = Vec3::UnitZ();
};

class ValleyCutter {
public:
    ValleyCutter(const StripCutting& with, const ValleyCurve& curve, const RestBand& band)
        : with_(with), curve_(curve), band_(band), along_(tangents(curve)), radius_(with.cover->radius()),
          count_(curve.points.size()), small_(reach_of(with)) {}

    StripCut run(const Progress& progress) {
        if (count_ < 2) return {};
        make_lifts(progress.part(0, 0.2));
        std::vector<char> all(count_, 1);
        Row pencil{std::vector<double>(count_, 0), {}};
        pencil.spots = spots(pencil.offsets, all, progress);
        add_passes(pencil, all, 0, 0);
        for (const int side : {1, -1})
            beside(side, pencil, progress.part(side > 0 ? 0.2 : 0.6, side > 0 ? 0.6 : 1));
        return std::move(cut_);
    }

private:
    const PencilPoint& at(std::size_t i) const { return curve_.points[i]; }
    double spacing(std::size_t i, std::size_t k) const { return (at(k).center - at(i).center).norm(); }

    /// Every stretch of the curve gets the facets around it. Those beside the band alone: a leaning vector
    /// would bring the cutter down on the far wall of a wide valley else.
    void make_lifts(const Progress& progress) {
        lift_of_.resize(count_);
        const std::vector<BandFacet> beside =
            facets_beside(*with_.mesh, *with_.grid, band_, radius_ + with_.overlap, progress.part(0, 0));
        // First and last point of each stretch.
        std::vector<std::array<std::size_t, 2>> chunks;
        for (std::size_t first = 0; first < count_;) {
            std::size_t last = first;
            for (double route = 0; last + 1 < count_ && route < chunk_radii * radius_; ++last)
                route += spacing(last, last + 1);
            chunks.push_back({first, last});
            first = last + 1;
        }
        parallel_for(chunks.size(), 1, progress, [&](std::size_t k) {
            const auto [first, last] = chunks[k];
            const auto lift = lift_about(first, last, beside, progress);
            for (std::size_t i = first; i <= last; ++i)
                lift_of_[i] = lift;
        });
    }

    /// The facets beside a stretch that face along its vector; null where there are none.
    std::shared_ptr<const VectorLift> lift_about(std::size_t first, std::size_t last,
                                                 const std::vector<BandFacet>& beside,
                                                 const Progress& progress) const {
        Vec3 up = Vec3::Zero();
        std::vector<Vec3> centers;
        for (std::size_t i = first; i <= last; ++i) {
            up += at(i).up;
            if (i == first || i == last || (i - first) % 4 == 0) centers.push_back(at(i).center);
        }
        up.normalize();
        // A pass goes over the band as far as points of the curve near by ask for.
        double aside = 0, high = 0;
        for (std::size_t i = first > near_points ? first - near_points : 0;
             i < std::min(last + near_points + 1, count_); ++i) {
            aside = std::max({aside, band_.reach[i][0], band_.reach[i][1]});
            high = std::max({high, band_.flank[i][0], band_.flank[i][1]});
        }
        aside += with_.overlap + lift_radii * radius_;
        high += with_.overlap + lift_radii * radius_;
        const Mesh& mesh = *with_.mesh;
        std::vector<Index> facets;
        for (std::size_t i = 0; i < beside.size(); ++i) {
            if (i % check_every == 0) progress.check();
            const auto& [f, middle, size] = beside[i];
            const bool is_near = std::any_of(centers.begin(), centers.end(), [&](const Vec3& p) {
                const Vec3 rel = middle - p;
                const double height = rel.dot(up);
                return height <= high + size && height >= -aside - size
                       && (rel - height * up).squaredNorm() <= (aside + size) * (aside + size);
            });
            if (is_near && with_.side->towards_tool(mesh.facet_normal(f)).dot(up) > facing)
                facets.push_back(f);
        }
        if (facets.empty()) return nullptr;
        return std::make_shared<VectorLift>(
            std::make_shared<ContactIndex>(std::make_shared<Mesh>(part_of(mesh, facets).mesh),
                                           progress.part(0, 0)),
            with_.cover->profile(), std::span<const BodySection>(), with_.allowance);
    }

    /// A place of the curve, at one of its points or between two.
    struct Place {
        PencilPoint point;
        Vec3 along = Vec3::Zero();
        const VectorLift* lift = nullptr;
        bool corner = false; ///< where it meets others
    };
    Place place(std::size_t i) const {
        const bool corner =
            !curve_.closed && ((i == 0 && curve_.node[0] >= 0) || (i + 1 == count_ && curve_.node[1] >= 0));
        return {at(i), along_[i], lift_of_[i].get(), corner};
    }
    Place between(std::size_t i, std::size_t k, double t) const {
        Place p = place(i);
        const PencilPoint &a = at(i), &b = at(k);
        p.corner = false;
        p.point.center += t * (b.center - a.center);
        p.point.from += t * (b.from - a.from);
        p.point.up = ((1 - t) * a.up + t * b.up).normalized();
        p.point.on_part = a.on_part && b.on_part;
        return p;
    }

    Spot spot(std::size_t i, double offset) const { return spot(place(i), offset); }

    /// The cutter at `offset` to the left of a place of the curve.
    Spot spot(const Place& of, double offset) const {
        Spot s;
        const PencilPoint& p = of.point;
        const Vec3 left = left_of(of.along, p.up);
        if (left == Vec3::Zero() || !of.lift) return s;
        const Vec3 base = p.center + offset * left;
        if (with_.along_z) {
            if (!place_along_z(p, base, offset, s)) return s;
        } else {
            Vec3 tip = base + with_.cover->tip_offset(p.up);
            if (offset == 0) tip += lowest(of, tip, left);
            const VectorContact c = of.lift->contact({tip, Vec3::UnitZ(), p.up});
            // Past the end of the flanks it would slide on to whatever comes.
            if (!(c.lift > -(p.on_part ? max_sink : max_sink_beyond) * radius_)) return s;
            s.touch = c.point;
            // A hair off what it touches: an upright wall would hold it up to its top else.
            s.tip = tip + (c.lift + tolerance::contact_distance) * p.up;
        }
        const double free = with_.lift->tip_z(s.tip.x(), s.tip.y());
        const double raise = free - s.tip.z();
        if (raise > (with_.along_z ? max_raise_z : max_raise) * radius_) return s;
        if (raise > 0 || with_.along_z) {
            const AxialContact c = with_.lift->contact(s.tip.x(), s.tip.y());
            if (!(c.tip_z > -infinity)) return s;
            s.touch = c.point;
            s.tip.z() = c.tip_z;
        }
        s.normal = with_.cover->contact_normal(s.touch - s.tip).value_or(p.up);
        // Beyond the border there is nothing to cut.
        s.free = !rolls_over_border(*with_.mesh, *with_.grid, *with_.side, s.touch, s.normal);
        return s;
    }

    /// How far to the left the cutter comes lowest against the fitted vector: there it touches both flanks,
    /// though noise has moved the centre. The lift has one low place, as the valley has. In a corner it is
    /// looked for along the curve, too: there it touches all three flanks.
    Vec3 lowest(const Place& of, const Vec3& tip, const Vec3& left) const {
        const double aside = aside_share * radius_, accuracy = aside_accuracy * radius_;
        const auto lowest_on = [&](const Vec3& from) {
            const auto height = [&](double x) {
                return of.lift->lift({from + x * left, Vec3::UnitZ(), of.point.up});
            };
            LowPlace low = golden_minimum(height, -aside, aside, accuracy, -infinity);
            // Lowest at an end there is no low place: as on a rim that the cutter rolls over.
            const bool at_end = std::abs(low.at) > aside - 4 * accuracy;
            if (const double middle = height(0); at_end || !(low.value < middle)) low = {0, middle};
            return low;
        };
        if (!of.corner) return lowest_on(tip).at * left;
        const Vec3 ahead = left.cross(of.point.up);
        const LowPlace along = golden_minimum([&](double y) { return lowest_on(tip + y * ahead).value; },
                                              -aside, aside, accuracy, -infinity);
        return along.at * ahead + lowest_on(tip + along.at * ahead).at * left;
    }

    /// Between the last place of a pass and the next, where there is none any more: as far as it goes.
    std::optional<Spot> last_before(std::size_t i, std::size_t k, double offset) const {
        std::optional<Spot> last;
        double lo = 0, hi = 1;
        for (int n = 0; n < end_halvings; ++n) {
            const double mid = 0.5 * (lo + hi);
            const Spot s = spot(between(i, k, mid), offset);
            (s.free ? lo : hi) = mid;
            if (s.free) last = s;
        }
        return last;
    }

    /// Touching both flanks, or the flank at the place beside the centre.
    bool place_along_z(const PencilPoint& p, const Vec3& base, double offset, Spot& s) const {
        const auto lack = [&](const Vec3& n) { return with_.cover->tip_offset(n).dot(n) + with_.allowance; };
        if (offset == 0) {
            double k = 0;
            for (const Vec3& n : p.normal)
                if (const double c = p.up.dot(n); c > facing && n.z() >= 0) k = std::max(k, lack(n) / c);
            s.tip = p.center + (k + tolerance::contact_distance) * p.up;
            return true;
        }
        const Vec3 from = base + (p.from - p.center).dot(p.up) * p.up;
        const auto hit = with_.grid->first_hit(from, -p.up, 4 * (p.from - p.center).norm() + 4 * radius_);
        if (!hit) return false;
        const Vec3 on = from - hit->distance * p.up;
        const Vec3 n = with_.side->towards_tool(with_.mesh->facet_normal(hit->facet));
        if (!(n.z() >= 0)) return false;
        s.tip = on + with_.cover->tip_offset(n) + (with_.allowance + tolerance::contact_distance) * n;
        return true;
    }

    /// A pass: where the cutter stands beside each point of the curve.
    struct Row {
        std::vector<double> offsets; ///< left positive
        std::vector<Spot> spots;
    };

    std::vector<Spot> spots(const std::vector<double>& offsets, const std::vector<char>& which,
                            const Progress& progress) const {
        std::vector<Spot> result(count_);
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (which[i]) result[i] = spot(i, offsets[i]);
        });
        return result;
    }

    /// Where the cutter has no place so far out, it goes as far as it can, from what it cut before: which
    /// have been moved so.
    std::vector<char> come_nearer(const Row& last, Row& next, const std::vector<char>& which,
                                  const Progress& progress) const {
        std::vector<char> moved(count_, 0);
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (!which[i] || next.spots[i].free) return;
            double near = last.offsets[i], far = next.offsets[i];
            for (int n = 0; n < end_halvings; ++n) {
                const double mid = 0.5 * (near + far);
                const Spot s = spot(i, mid);
                (s.free ? near : far) = mid;
                if (!s.free) continue;
                next.spots[i] = s;
                next.offsets[i] = mid;
                moved[i] = 1;
            }
        });
        return moved;
    }

    /// How far from a centre: across the fitted vector, and up the flank. On a steep one the first says
    /// little.
    struct Extent {
        double across = 0, flank = 0;
        bool holds(const Extent& other) const { return across >= other.across && flank >= other.flank; }
        void grow(const Extent& other) {
            across = std::max(across, other.across);
            flank = std::max(flank, other.flank);
        }
    };

    /// Where the band ends, a little smoothed.
    std::vector<Extent> needed(int side) const {
        std::vector<Extent> result(count_);
        const auto n = std::ptrdiff_t(count_);
        const std::size_t of = side > 0 ? 0 : 1;
        for (std::ptrdiff_t i = 0; i < n; ++i)
            for (std::ptrdiff_t k = i - 2; k <= i + 2; ++k) {
                if (!curve_.closed && (k < 0 || k >= n)) continue;
                const auto j = std::size_t(((k % n) + n) % n);
                result[std::size_t(i)].grow({band_.reach[j][of], band_.flank[j][of]});
            }
        for (Extent& e : result)
            if (e.flank > 0) e.flank += with_.overlap;
        return result;
    }
    Extent extent(std::size_t i, const Vec3& p, int side) const {
        const Vec3 rel = p - at(i).center;
        return {side * rel.dot(left_of(along_[i], at(i).up)), (rel - rel.dot(along_[i]) * along_[i]).norm()};
    }

    void beside(int side, const Row& pencil, const Progress& progress) {
        const std::vector<Extent> need = needed(side);
        std::vector<Extent> got(count_);
        std::vector<char> done(count_, 0);
        Row last = pencil;
        // On a flank that leans by 45 degrees.
        double step = std::sqrt(4 * std::max(with_.cover->profile().cutter().r, 0.1 * radius_) * with_.cusp);
        double offset = 0;
        for (int number = 1; number <= max_passes; ++number) {
            std::vector<char> todo(count_, 0);
            std::size_t left = 0;
            for (std::size_t i = 0; i < count_; ++i)
                if (last.spots[i].free && !done[i] && !got[i].holds(need[i])) {
                    todo[i] = 1;
                    ++left;
                }
            if (left == 0) break;
            progress.set(std::min(1.0, number / 50.0));
            Row next;
            double cusp = 0;
            step = std::max(step, smallest_step * radius_);
            for (int tries = 0; tries < max_tries; ++tries) {
                next.offsets.assign(count_, side * (offset + step));
                next.spots = spots(next.offsets, todo, progress);
                // Of most places; further passes are put in at the others.
                std::vector<double> all = left_between(last, next, progress);
                std::erase(all, 0);
                std::sort(all.begin(), all.end());
                cusp = all.empty() ? 0 : all[std::size_t(usual_share * double(all.size() - 1))];
                if (cusp <= with_.cusp || step <= smallest_step * radius_) break;
                step = std::max(step * std::max(0.3, 0.93 * std::sqrt(with_.cusp / cusp)),
                                smallest_step * radius_);
            }
            const std::vector<char> at_end = come_nearer(last, next, todo, progress);
            fill(last, next, max_fills, progress);
            offset += step;
            for (std::size_t i = 0; i < count_; ++i) {
                if (!todo[i]) continue;
                // Over the shoulder: nothing more of this flank is touched farther out.
                done[i] = !next.spots[i].free || at_end[i] || offset > need[i].across + radius_;
                if (next.spots[i].free) got[i].grow(extent(i, next.spots[i].touch, side));
            }
            cut_.cusp_max = std::max(cut_.cusp_max, cusp);
            cut_.stepover_min = std::min(cut_.stepover_min, step);
            cut_.stepover_max = std::max(cut_.stepover_max, step);
            std::vector<char> longer = extended(todo);
            for (std::size_t i = 0; i < count_; ++i)
                longer[i] = longer[i] && !todo[i];
            const std::vector<Spot> more = spots(next.offsets, longer, progress);
            Row pass = next;
            for (std::size_t i = 0; i < count_; ++i)
                if (longer[i]) pass.spots[i] = more[i];
            add_passes(pass, todo, ++number_, side * offset);
            last = std::move(next);
            if (cusp > 0 && cusp < with_.cusp) step *= std::min(1.8, 0.95 * std::sqrt(with_.cusp / cusp));
        }
    }

    /// What stays between two passes; 0 where not both have a place.
    std::vector<double> left_between(const Row& a, const Row& b, const Progress& progress) const {
        std::vector<double> all(count_, 0);
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (a.spots[i].free && b.spots[i].free) all[i] = left_between(a.spots[i], b.spots[i], i);
        });
        return all;
    }

    /// What stays between two places beside each other. Where both touch a plane, or the part is round, it is
    /// no more than their ridge. In a hollow both come to nearly the same place and touch far from each
    /// other: there it is measured on the part, less what the cutter cannot reach at all.
    double left_between(const Spot& a, const Spot& b, std::size_t i) const {
        double most = ridge(with_.cover->profile(), b.tip - a.tip, along_[i]);
        const Vec3 route = b.touch - a.touch;
        if (most > with_.cusp || a.normal.cross(b.normal).norm() < same_plane
            || (b.normal - a.normal).dot(route) >= 0)
            return most;
        LiftHint hint;
        // Most stays where both leave the same: from the first the way there is to the other side of it.
        double lo = 0, hi = 1;
        for (int n = 0; n < between_halvings; ++n) {
            const double share = 0.5 * (lo + hi), beyond = hi;
            hi = share; // where there is no place to ask at
            const Vec3 out = (1 - share) * a.normal + share * b.normal;
            if (out.norm() < same_plane) continue;
            const Vec3 normal = out.normalized();
            const double back = std::min(route.norm(), radius_);
            const auto hit =
                with_.grid->first_hit(a.touch + share * route + back * normal, -normal, 2 * back + radius_);
            if (!hit) continue;
            const Vec3 facet = with_.side->towards_tool(with_.mesh->facet_normal(hit->facet));
            if (!(facet.dot(normal) > 0) || facet.z() < -tolerance::vertical_normal_z) continue;
            const Vec3 p =
                a.touch + share * route + (back - hit->distance) * normal + with_.allowance * facet;
            const double by_a = with_.cover->distance(p - a.tip), by_b = with_.cover->distance(p - b.tip);
            if (by_a < by_b) {
                lo = share;
                hi = beyond;
            }
            const double rest = std::min(by_a, by_b);
            if (rest <= std::max(most, with_.cusp)) continue;
            RestSample least = nearest_touch(small_, p, facet, hint);
            if (normal.z() >= 0)
                if (const RestSample other = nearest_touch(small_, p, normal, hint); other.gap < least.gap)
                    least = other;
            const double limit =
                nearest_about(small_, least, rest - 2 * with_.cusp, finest_limit * with_.cusp, hint).gap;
            most = std::max(most, rest - limit);
        }
        return most;
    }

    /// Short passes between two where too much stays.
    void fill(const Row& a, const Row& b, int depth, const Progress& progress) {
        if (depth == 0) return;
        std::vector<char> which(count_, 0);
        bool any = false;
        const std::vector<double> left = left_between(a, b, progress);
        for (std::size_t i = 0; i < count_; ++i)
            if (left[i] > with_.cusp) {
                any = true;
                for (const std::size_t k : {i > 0 ? i - 1 : i, i, i + 1 < count_ ? i + 1 : i})
                    which[k] = 1;
            }
        progress.check();
        if (!any) return;
        bridge(which);
        Row middle{a.offsets, {}};
        for (std::size_t i = 0; i < count_; ++i)
            middle.offsets[i] = 0.5 * (a.offsets[i] + b.offsets[i]);
        middle.spots = spots(middle.offsets, which, progress);
        fill(a, middle, depth - 1, progress);
        const auto first = std::size_t(std::find(which.begin(), which.end(), 1) - which.begin());
        add_passes(middle, which, ++number_, middle.offsets[first]);
        fill(middle, b, depth - 1, progress);
    }

    /// Cutting nothing over a short way takes less time than a way out, over and in again.
    void bridge(std::vector<char>& which) const {
        std::size_t last = count_;
        double route = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (i > 0) route += spacing(i - 1, i);
            if (!which[i]) continue;
            if (last < count_ && route <= bridge_radii * radius_)
                std::fill(which.begin() + std::ptrdiff_t(last), which.begin() + std::ptrdiff_t(i), 1);
            last = i;
            route = 0;
        }
    }

    /// With the overlap before and after.
    std::vector<char> extended(const std::vector<char>& which) const {
        std::vector<char> result = which;
        const auto n = std::ptrdiff_t(count_);
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            if (!which[std::size_t(i)]) continue;
            for (const std::ptrdiff_t step : {-1, 1}) {
                double route = 0;
                std::ptrdiff_t k = i;
                while (route < with_.overlap) {
                    std::ptrdiff_t next = k + step;
                    if (curve_.closed) next = (next + n) % n;
                    if (next < 0 || next >= n || which[std::size_t(next)] || next == i) break;
                    route += spacing(std::size_t(k), std::size_t(next));
                    k = next;
                    result[std::size_t(k)] = 1;
                }
            }
        }
        return result;
    }

    void add_passes(const Row& row, const std::vector<char>& wanted, int number, double offset) {
        const std::vector<Spot>& spots = row.spots;
        // A closed pass begins where one is missing, if any is.
        std::size_t first = 0;
        bool whole = true;
        for (std::size_t i = 0; i < count_; ++i) {
            if (spots[i].free) continue;
            if (wanted[i] && at(i).on_part && i + 1 < count_) cut_.blocked += spacing(i, i + 1);
            if (whole) first = i;
            whole = false;
        }
        std::vector<std::size_t> run;
        std::vector<std::vector<std::size_t>> runs;
        const std::size_t start = curve_.closed ? first : 0;
        for (std::size_t k = 0; k < count_; ++k) {
            const std::size_t i = (start + k) % count_;
            if (spots[i].free) run.push_back(i);
            if (!run.empty() && (!spots[i].free || k + 1 == count_)) {
                runs.push_back(run);
                run.clear();
            }
        }
        const bool backwards = !with_.one_way && number % 2 != 0;
        if (backwards) std::reverse(runs.begin(), runs.end());
        for (auto& r : runs) {
            if (r.size() < 2) continue;
            if (curve_.closed && whole) {
                // Once around, and the overlap.
                double route = 0;
                const std::size_t n = r.size();
                for (std::size_t k = 0; k < n && (k == 0 || route < with_.overlap); ++k) {
                    r.push_back(r[k]);
                    route += spacing(r[k], r[(k + 1) % n]);
                }
            }
            std::vector<Spot> route;
            for (const std::size_t i : r)
                route.push_back(spots[i]);
            const auto next = [&](std::size_t i, bool ahead) {
                if (ahead) return i + 1 < count_ ? i + 1 : curve_.closed ? 0 : count_;
                return i > 0 ? i - 1 : curve_.closed ? count_ - 1 : count_;
            };
            for (const bool ahead : {true, false}) {
                const std::size_t end = ahead ? r.back() : r.front(), k = next(end, ahead);
                if (k == count_ || !wanted[k] || spots[k].free) continue;
                if (const auto last = last_before(end, k, row.offsets[end]))
                    route.insert(ahead ? route.end() : route.begin(), *last);
            }
            if (backwards) {
                std::reverse(r.begin(), r.end());
                std::reverse(route.begin(), route.end());
            }
            Pass pass;
            pass.drive = number;
            pass.offset = offset;
            for (const Spot& s : route) {
                pass.cl.push_back({s.tip, Vec3::UnitZ()});
                pass.cc.push_back({s.touch, s.normal});
            }
            add_leads(with_, pass, at(r.front()).up, at(r.back()).up);
            cut_.passes.push_back(std::move(pass));
        }
    }

    const StripCutting& with_;
    const ValleyCurve& curve_;
    const RestBand& band_;
    std::vector<Vec3> along_;
    double radius_;
    std::size_t count_;
    ValleyInput small_; ///< for what it cannot reach
    std::vector<std::shared_ptr<const VectorLift>> lift_of_;
    StripCut cut_;
    int number_ = 0; ///< of passes, for turning every other one
};

} // namespace

double ridge(const CutterProfile& profile, const Vec3& apart, const Vec3& travel) {
    const Vec3 across = apart - apart.dot(travel) * travel;
    const double width = across.norm();
    if (width == 0) return 0;
    const AptCutter& c = profile.cutter();
    const Vec3 x = across / width;
    Vec3 m = travel.cross(x);
    if (m.z() < 0) m = -m;
    if (c.r == profile.max_radius()) {
        // A ball touches wherever it is asked to.
        const double half = 0.5 * width;
        return half < c.r ? c.r - std::sqrt(c.r * c.r - half * half) : c.r;
    }
    // The outline across the travel: what it reaches down to at a distance from where the tip is.
    std::array<double, ridge_angles> tangent{}, reach{};
    for (std::size_t k = 0; k < ridge_angles; ++k) {
        const double a = ridge_tilt * (2.0 * double(k) / (ridge_angles - 1) - 1);
        tangent[k] = std::tan(a);
        reach[k] = support(profile, std::sin(a) * x - std::cos(a) * m) / std::cos(a);
    }
    const auto low = [&](double at) {
        double y = -infinity;
        for (std::size_t k = 0; k < ridge_angles; ++k)
            y = std::max(y, at * tangent[k] - reach[k]);
        return y;
    };
    // The crossing of both outlines: the near one rises, the other falls.
    double lo = -4 * profile.max_radius(), hi = 4 * profile.max_radius() + width;
    for (int i = 0; i < 60; ++i) {
        const double mid = 0.5 * (lo + hi);
        (low(mid) < low(mid - width) ? lo : hi) = mid;
    }
    return std::max(0.0, low(hi) + support(profile, -m));
}

namespace {

/// Beyond its ends, where it meets no other curve: as far as the cutter overlaps, and past a border until
/// what is beside the valley is cut too.
void run_out(const StripCutting& with, ValleyCurve& curve, RestBand& band) {
    auto& p = curve.points;
    if (curve.closed || p.size() < 3) return;
    const double route = with.overlap + with.cover->radius();
    for (const std::size_t side : {0, 1}) {
        if (curve.node[side] >= 0) continue;
        const PencilPoint end = side == 0 ? p.front() : p.back();
        const Vec3 before = side == 0 ? p[2].center : p[p.size() - 3].center;
        const double step = 0.5 * (end.center - before).norm();
        if (step <= 0) continue;
        const Vec3 ahead = (end.center - before).normalized();
        const auto reach = side == 0 ? band.reach.front() : band.reach.back();
        const auto flank = side == 0 ? band.flank.front() : band.flank.back();
        for (int k = 1; k * step <= route + step; ++k) {
            PencilPoint q = end;
            q.on_part = false;
            for (Vec3* v : {&q.tip, &q.touch[0], &q.touch[1], &q.from, &q.center})
                *v += k * step * ahead;
            p.insert(side == 0 ? p.begin() : p.end(), q);
            band.reach.insert(side == 0 ? band.reach.begin() : band.reach.end(), reach);
            band.flank.insert(side == 0 ? band.flank.begin() : band.flank.end(), flank);
        }
    }
}

} // namespace

ValleyInput reach_of(const StripCutting& with) {
    ValleyInput in;
    in.mesh = with.mesh.get();
    in.grid = with.grid;
    in.side = with.side;
    in.lift = with.lift;
    in.cover = with.cover;
    in.tolerance = with.cusp;
    return in;
}

StripCut cut_valley(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                    const Progress& progress) {
    ValleyCurve longer = curve;
    RestBand wider = band;
    run_out(with, longer, wider);
    StripCut cut = ValleyCutter(with, longer, wider).run(progress.part(0, 0.8));
    clear_passes(with, cut.passes, progress.part(0.8, 1));
    return cut;
}

StripCut cut_hollow(const StripCutting& with, const RestBand& band, const Progress& progress) {
    StripCut cut;
    const double radius = with.cover->radius();
    Box3 box;
    for (const auto& t : band.band)
        for (const Vec3& p : t)
            box.add(p);
    // Lines along the longer side; how close follows from a level floor.
    const bool along_x = box.size().x() >= box.size().y();
    const Vec3 u = along_x ? Vec3::UnitX() : Vec3::UnitY(), v = along_x ? Vec3::UnitY() : Vec3::UnitX();
    double step = 1.9 * radius;
    while (step > smallest_step * radius && ridge(with.cover->profile(), step * v, u) > with.cusp)
        step *= 0.9;
    step *= 0.7; // of what a floor that leans by 45 degrees asks for
    PointGrid hollow(0.5 * radius);
    for (const auto& t : band.band) {
        progress.check();
        for (const Vec3& p : t)
            hollow.add_first(Vec3(p.x(), p.y(), 0));
    }
    const auto wanted = [&](const Vec3& p) {
        return hollow.near_until(Vec3(p.x(), p.y(), 0), radius, [&](std::size_t i) {
            return (hollow.points()[i] - p).head<2>().norm() <= radius;
        });
    };
    const double v0 = box.lo.dot(v), v1 = box.hi.dot(v), u0 = box.lo.dot(u), u1 = box.hi.dot(u);
    const int lines = std::max(1, int(std::ceil((v1 - v0) / step)));
    const double spacing = 0.1 * radius;
    for (int i = 0; i <= lines; ++i) {
        progress.set(double(i) / double(lines + 1));
        const double at = v0 + (v1 - v0) * i / lines;
        Pass pass;
        pass.drive = i;
        pass.offset = at;
        const auto finish = [&] {
            if (pass.cl.size() > 1) {
                if (i % 2 != 0 && !with.one_way) {
                    std::reverse(pass.cl.begin(), pass.cl.end());
                    std::reverse(pass.cc.begin(), pass.cc.end());
                }
                cut.passes.push_back(pass);
            }
            pass.cl.clear();
            pass.cc.clear();
        };
        const int points = int(std::ceil((u1 - u0 + 2 * with.overlap) / spacing));
        for (int k = 0; k <= points; ++k) {
            const Vec3 place = (u0 - with.overlap + (u1 - u0 + 2 * with.overlap) * k / points) * u + at * v;
            const AxialContact c = with.lift->contact(place.x(), place.y());
            if (!(c.tip_z > -infinity) || !wanted(place)) {
                finish();
                continue;
            }
            const Vec3 tip(place.x(), place.y(), c.tip_z);
            pass.cl.push_back({tip, Vec3::UnitZ()});
            pass.cc.push_back({c.point, with.cover->contact_normal(c.point - tip).value_or(Vec3::UnitZ())});
        }
        finish();
    }
    cut.stepover_min = cut.stepover_max = lines > 0 ? (v1 - v0) / lines : 0;
    clear_passes(with, cut.passes, progress.part(0.9, 1));
    return cut;
}

} // namespace facetmill
