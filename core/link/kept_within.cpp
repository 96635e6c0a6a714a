#include "core/link/kept_within.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// How far apart places of a pass are looked at, and how well its ends are known, in radii of the cutter.
constexpr double look_share = 0.05, end_share = 0.001;
/// How far apart they are looked at least where the depth in the plan tells of what lies between.
constexpr double step_share = 0.002;
/// A tilted cutter is looked at in so many places along its flutes.
constexpr int places_along = 8;

/// An upright tool in a boundary.
class UprightWithin {
public:
    UprightWithin(const KeptWithin& within, const UprightContact& contact, std::size_t part_facets)
        : within_(within), contact_(contact), part_facets_(part_facets),
          radius_(contact.profile().max_radius()) {}

    bool operator()(const Vec3& tip) const {
        if (within_.contain != Containment::contact)
            return within_.region->depth(tip.head<2>()) >= within_.min_depth();
        Index facet = no_index;
        const CutterContact at = contact_.at(tip, facet);
        if (facet == no_index) return false; // nothing of the part is below
        Index hint = facet < part_facets_ ? facet : no_index;
        return within_.region->holds(at.point, hint);
    }
    double spacing() const { return look_share * radius_; }

    PassPieces divide(const Pass& pass, const Progress& progress) const {
        if (pass.layer >= 0) { // a level: planned within it
            PassPieces whole;
            whole.kept.push_back(pass);
            return whole;
        }
        const std::vector<double> arc = arc_lengths(pass);
        std::vector<Interval> ranges = free_ranges(
            pass, arc, spacing(), [&](const Vec3& tip) { return (*this)(tip); }, progress);
        for (Interval& r : ranges) {
            r.lo = border(pass, arc, r.lo, std::max(0.0, r.lo - spacing()));
            r.hi = border(pass, arc, r.hi, std::min(arc.back(), r.hi + spacing()));
        }
        // Ends that were widened may meet.
        for (std::size_t i = 1; i < ranges.size(); ++i)
            ranges[i].lo = std::max(ranges[i].lo, ranges[i - 1].hi);
        return pieces_over(pass, arc, std::move(ranges), contact_);
    }

    /// Depth changes by no more than the tip moves: so far every place is as the one looked at. What is
    /// shorter than a step may be missed.
    std::vector<Interval> ranges_by_depth(const Pass& pass, std::span<const double> arc,
                                          const Progress& progress) const {
        std::vector<Interval> ranges;
        bool was_within = false;
        for (double at = 0;;) {
            progress.check();
            const double depth =
                within_.region->depth(place_on(pass, arc, at).head<2>()) - within_.min_depth();
            if (depth >= 0 && !was_within) ranges.push_back({at, at});
            if (depth >= 0) ranges.back().hi = at;
            was_within = depth >= 0;
            if (at >= arc.back()) return ranges;
            at = std::min(at + std::max(std::abs(depth), step_share * radius_), arc.back());
        }
    }

    /// Whether the tool may go straight from one to the other, lowered onto the surface.
    bool link(const Vec3& from, const Vec3& to) const {
        const double n = std::max(1.0, std::ceil((to - from).head<2>().norm() / spacing()));
        for (double k = 0; k <= n; ++k)
            if (!(*this)(from + (k / n) * (to - from))) return false;
        return true;
    }

private:
    /// The last place from `in` towards `out` that is within.
    double border(const Pass& pass, std::span<const double> arc, double in, double out) const {
        while (std::abs(out - in) > end_share * radius_) {
            const double middle = 0.5 * (in + out);
            ((*this)(place_on(pass, arc, middle)) ? in : out) = middle;
        }
        return in;
    }

    const KeptWithin& within_;
    const UprightContact& contact_;
    std::size_t part_facets_;
    double radius_;
};

/// A tilted tool in a boundary: its locations, and the ways between them.
class TiltedWithin {
public:
    TiltedWithin(const KeptWithin& within, const PlanContext& context)
        : within_(within), height_(context.tool.flute_length),
          radius_(CutterProfile(context.tool.cutter()).max_radius()) {}

    PassPieces operator()(const Pass& pass, const Progress& progress) const {
        Index hint = no_index;
        return pieces_of_locations(
            pass, [&](std::size_t i) { return may(place(pass, i, 1), hint); },
            [&](std::size_t i) { return path_is_within(pass, i, hint); }, progress);
    }

private:
    struct Place {
        CutterLocation cl;
        Vec3 contact;
    };
    /// A share of the way from the location before.
    static Place place(const Pass& pass, std::size_t i, double t) {
        const auto contact = [&](std::size_t k) {
            return k < pass.cc.size() ? pass.cc[k].point : pass.cl[k].tip;
        };
        if (i == 0 || t == 1) return {pass.cl[i], contact(i)};
        const CutterLocation &a = pass.cl[i - 1], &b = pass.cl[i];
        return {{a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()},
                contact(i - 1) + t * (contact(i) - contact(i - 1))};
    }
    /// The way to a location from the one before.
    bool path_is_within(const Pass& pass, std::size_t i, Index& hint) const {
        const CutterLocation &a = pass.cl[i - 1], &b = pass.cl[i];
        const double length = (b.tip - a.tip).norm();
        if (within_.contain == Containment::contact) {
            const double n = std::ceil(length / (look_share * radius_));
            for (double k = 1; k < n; ++k)
                if (!may(place(pass, i, k / n), hint)) return false;
            return true;
        }
        // No place of the tool that is looked at moves farther than this; turning axes are longest apart in
        // the middle.
        constexpr double middle = 1.5;
        const double most = length + middle * height_ * (b.axis - a.axis).norm();
        for (double t = 0; t < 1;) {
            const double depth = depth_of(place(pass, i, t).cl);
            if (depth < 0) return false;
            t += std::max(depth, step_share * radius_) / most;
        }
        return true;
    }
    bool may(const Place& at, Index& hint) const {
        return within_.contain == Containment::contact ? within_.region->holds(at.contact, hint)
                                                       : depth_of(at.cl) >= 0;
    }
    /// By how much the place of what is kept within is deeper than it has to be; below 0: it is not.
    double depth_of(const CutterLocation& at) const {
        const Vec2 tip = at.tip.head<2>();
        if (within_.contain == Containment::tip) return within_.region->depth(tip);
        const Vec2 leans = height_ * at.axis.head<2>();
        double least = infinity;
        for (int k = 0; k <= places_along; ++k)
            least = std::min(least, within_.region->depth(tip + double(k) / places_along * leans));
        return least - within_.min_depth() - 0.5 * leans.norm() / places_along;
    }

    const KeptWithin& within_;
    double height_, radius_;
};

} // namespace

void keep_within(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                 const KeptWithin& within, const Progress& progress) {
    std::optional<UprightContact> contact;
    if (is_upright(path.passes))
        contact.emplace(context.contact, context.tool, common.allowance + context.tessellation_tolerance[1]);
    std::erase_if(path.cleanup, [&, hint = no_index](const CutterContact& c) mutable {
        return !within.region->holds(c.point, hint);
    });
    path.cleanup_points = std::min(path.cleanup_points, path.cleanup.size());
    std::optional<UprightWithin> upright;
    if (contact) upright.emplace(within, *contact, within.region->facets().size());
    PassPieces pieces =
        upright ? divide_passes(
            path.passes, [&](const Pass& pass, const Progress& p) { return upright->divide(pass, p); },
            progress.part(0, 0.7))
                : divide_passes(path.passes, TiltedWithin(within, context), progress.part(0, 0.7));
    if (pieces.kept.empty())
        throw Error(ErrorCode::empty_result, boundary_place(within.region->name()), "no pass lies within it",
                    within.contain == Containment::contact
                        ? "widen it, or take a tool that reaches what lies in it"
                        : "widen it, take a smaller tool, or keep only the contact within");
    if (pieces.all) return;
    path.passes = std::move(pieces.kept);
    settle_pieces(path, context, common, contact ? &*contact : nullptr, progress.part(0.7, 1));
    if (!upright) return;
    for (std::size_t i = 1; i < path.passes.size(); ++i)
        if (!(path.passes[i].layer >= 0 && path.passes[i - 1].layer >= 0)
            && !upright->link(path.passes[i - 1].cl.back().tip, path.passes[i].cl.front().tip))
            path.passes[i].from_above = true;
}

} // namespace facetmill
