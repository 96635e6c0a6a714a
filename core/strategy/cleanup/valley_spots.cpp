#include "core/strategy/cleanup/valley_spots.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/border_touch.h"
#include "core/strategy/cleanup/curve_lifts.h"

namespace facetmill {

namespace {

/// A tip that the part holds up by more than this many radii above where it should be has no place there.
constexpr double max_raise = 1.5, max_raise_z = 4;
/// Against the fitted vector it goes no deeper than this, in radii, beyond the plane across it; beyond a
/// valley's end as deep as it takes to roll over the rim of both flanks.
constexpr double max_sink = 0.25, max_sink_beyond = 1.5;
/// The first pass is looked for so far beside the centre, and to this accuracy, in radii.
constexpr double aside_share = 0.3, aside_accuracy = 7e-4;
/// By planes it ends, too, where no more than this share of the accuracy can be gained; so many steps are
/// taken without halving, and none nearer than this share of what is left to its ends.
constexpr double value_share = 0.1, min_shrink = 0.02;
constexpr int plane_steps = 3;
/// The end of a pass is found to this many halvings of a step.
constexpr int end_halvings = 8;
/// A flank whose normal meets the fitted vector at no more than this cosine does not hold the cutter up.
constexpr double spot_facing = 0.01;

} // namespace

ValleySpots::ValleySpots(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                         const Progress& progress)
    : with_(with), curve_(curve), along_(tangents(curve)), radius_(with.cover->radius()),
      lift_of_(lifts_along(with, curve, band, progress)) {}

ValleySpots::Place ValleySpots::place(std::size_t i) const {
    const std::size_t count = curve_.points.size();
    const bool corner =
        !curve_.closed && ((i == 0 && curve_.node[0] >= 0) || (i + 1 == count && curve_.node[1] >= 0));
    return {curve_.points[i], along_[i], lift_of_[i].get(), corner};
}

ValleySpots::Place ValleySpots::between(std::size_t i, std::size_t k, double t) const {
    Place p = place(i);
    const PencilPoint &a = curve_.points[i], &b = curve_.points[k];
    p.corner = false;
    p.point.center += t * (b.center - a.center);
    p.point.from += t * (b.from - a.from);
    p.point.up = ((1 - t) * a.up + t * b.up).normalized();
    p.point.on_part = a.on_part && b.on_part;
    return p;
}

ValleySpot ValleySpots::spot(const Place& of, double offset) const {
    ValleySpot s;
    const PencilPoint& p = of.point;
    const Vec3 left = left_of(of.along, p.up);
    if (left == Vec3::Zero() || !of.lift) return s;
    if (!(with_.along_z ? place_along_z(p, left, offset, s) : place_along_vector(of, left, offset, s)))
        return s;
    // The lift over the whole part has the last word.
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

/// Lifted along the fitted vector from the plane across it.
bool ValleySpots::place_along_vector(const Place& of, const Vec3& left, double offset, ValleySpot& s) const {
    const PencilPoint& p = of.point;
    const Vec3 base = p.center + offset * left;
    Vec3 tip = base + with_.cover->tip_offset(p.up);
    if (offset == 0) tip += lowest(of, tip, left);
    const VectorContact c = of.lift->contact({tip, Vec3::UnitZ(), p.up});
    // Past the end of the flanks it would slide on to whatever comes.
    if (!(c.lift > -(p.on_part ? max_sink : max_sink_beyond) * radius_)) return false;
    s.touch = c.point;
    // A hair off what it touches: an upright wall would hold it up to its top else.
    s.tip = tip + (c.lift + tolerance::contact_distance) * p.up;
    return true;
}

/// Touching both flanks, or the flank at the place beside the centre.
bool ValleySpots::place_along_z(const PencilPoint& p, const Vec3& left, double offset, ValleySpot& s) const {
    const auto lack = [&](const Vec3& n) { return with_.cover->tip_offset(n).dot(n) + with_.allowance; };
    if (offset == 0) {
        double k = 0;
        for (const Vec3& n : p.normal)
            if (const double c = p.up.dot(n); c > spot_facing && n.z() >= 0) k = std::max(k, lack(n) / c);
        s.tip = p.center + (k + tolerance::contact_distance) * p.up;
        return true;
    }
    const Vec3 base = p.center + offset * left;
    const Vec3 from = base + (p.from - p.center).dot(p.up) * p.up;
    const auto hit = with_.grid->first_hit(from, -p.up, 4 * (p.from - p.center).norm() + 4 * radius_);
    if (!hit) return false;
    const Vec3 on = from - hit->distance * p.up;
    const Vec3 n = with_.side->towards_tool(with_.mesh->facet_normal(hit->facet));
    if (!(n.z() >= 0)) return false;
    s.tip = on + with_.cover->tip_offset(n) + (with_.allowance + tolerance::contact_distance) * n;
    return true;
}

/// The lift beside a centre, and how it rises to the left: what is touched there is a plane for the cutter's
/// next step.
struct ValleySpots::Sloping {
    double at, lift, slope;
};
std::optional<ValleySpots::Sloping> ValleySpots::sloping(const Place& of, const Vec3& from, const Vec3& left,
                                                         double at) const {
    const Vec3 tip = from + at * left;
    const VectorContact c = of.lift->contact({tip, Vec3::UnitZ(), of.point.up});
    if (!(c.lift > -infinity)) return std::nullopt;
    const auto normal = with_.cover->contact_normal(c.point - tip - c.lift * of.point.up);
    if (!normal || !(normal->dot(of.point.up) > spot_facing)) return std::nullopt;
    return Sloping{at, c.lift, -normal->dot(left) / normal->dot(of.point.up)};
}

/// The low place where both flanks are touched is where the planes that are touched beside it meet: mostly
/// the first guess is right. Nothing where a slope is not known.
std::optional<LowPlace> ValleySpots::lowest_by_slopes(const Place& of, const Vec3& from,
                                                      const Vec3& left) const {
    const double aside = aside_share * radius_, accuracy = aside_accuracy * radius_;
    const auto middle = sloping(of, from, left, 0);
    if (!middle) return std::nullopt;
    if (middle->slope == 0) return LowPlace{0, middle->lift};
    const bool to_left = middle->slope < 0;
    const auto end = sloping(of, from, left, to_left ? aside : -aside);
    if (!end) return std::nullopt;
    // As on a rim that the cutter rolls over.
    if (end->slope == 0 || (end->slope > 0) != to_left) return LowPlace{0, middle->lift};
    Sloping falls = to_left ? *middle : *end, rises = to_left ? *end : *middle;
    for (int step = 0; rises.at - falls.at > accuracy; ++step) {
        const double width = rises.at - falls.at,
                     ahead = (falls.lift - rises.lift + rises.slope * width) / (rises.slope - falls.slope),
                     low = falls.lift + falls.slope * ahead;
        const bool meets = ahead >= 0 && ahead <= width;
        if (meets && std::min(falls.lift, rises.lift) - low < value_share * accuracy) break;
        // On rough flanks planes say little: then what is left is halved, too.
        const double share = step >= plane_steps && step % 2 == 0
                                 ? 0.5
                                 : std::clamp(ahead / width, min_shrink, 1 - min_shrink);
        const auto next = sloping(of, from, left, falls.at + share * width);
        if (!next) return std::nullopt;
        (next->slope < 0 ? falls : rises) = *next;
    }
    const Sloping& best = falls.lift < rises.lift ? falls : rises;
    if (!(best.lift < middle->lift)) return LowPlace{0, middle->lift};
    return LowPlace{best.at, best.lift};
}

/// How far to the left the cutter comes lowest against the fitted vector: there it touches both flanks,
/// though noise has moved the centre. The lift has one low place, as the valley has. In a corner it is looked
/// for along the curve, too: there it touches all three flanks.
Vec3 ValleySpots::lowest(const Place& of, const Vec3& tip, const Vec3& left) const {
    const double aside = aside_share * radius_, accuracy = aside_accuracy * radius_;
    const auto lowest_on = [&](const Vec3& from) {
        if (const auto low = lowest_by_slopes(of, from, left)) return *low;
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
    const LowPlace along = golden_minimum([&](double y) { return lowest_on(tip + y * ahead).value; }, -aside,
                                          aside, accuracy, -infinity);
    return along.at * ahead + lowest_on(tip + along.at * ahead).at * left;
}

std::optional<ValleySpot> ValleySpots::last_before(std::size_t i, std::size_t k, double offset) const {
    std::optional<ValleySpot> last;
    double lo = 0, hi = 1;
    for (int n = 0; n < end_halvings; ++n) {
        const double mid = 0.5 * (lo + hi);
        const ValleySpot s = spot(between(i, k, mid), offset);
        (s.free ? lo : hi) = mid;
        if (s.free) last = s;
    }
    return last;
}

std::optional<ValleySpot> ValleySpots::farthest(std::size_t i, double near, double& far) const {
    std::optional<ValleySpot> last;
    double beyond = far;
    for (int n = 0; n < end_halvings; ++n) {
        const double mid = 0.5 * (near + beyond);
        const ValleySpot s = spot(i, mid);
        (s.free ? near : beyond) = mid;
        if (!s.free) continue;
        last = s;
        far = mid;
    }
    return last;
}

} // namespace facetmill
