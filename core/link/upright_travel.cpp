#include "core/link/upright_travel.h"

#include "core/link/beside_places.h"
#include "core/strategy/surface/stock_before.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// What a route out of or in to such places may cost at most, in what the one straight up and down does.
constexpr double aside_share = 0.75;
/// The size of the field's cells in radii of the cutter. What it tells is never too low.
constexpr double field_cell_share = 0.1;
/// What a level rapid keeps from the part sideways, in radii: what lies between two places that are looked at
/// may take it.
constexpr double level_share = 0.02;
/// A tip that is off part and stock by so much of what a rapid keeps from them is out of the cut, as at the
/// end of a lead: in or out at feed it goes no more than the second share.
constexpr double out_of_cut_share = 0.5, touch_share = 0.1;
/// What a rapid takes, in what the same length takes at feed: an order of magnitude is enough to choose by.
constexpr double rapid_share = 0.1;

} // namespace

UprightTravel::UprightTravel(const PlanContext& context, double allowance, const LinkOptions& options,
                             double lowest, double top, const Progress& progress)
    : profile_(context.tool.cutter()), cutter_(profile_), stock_bodies_(context.tool, profile_, 0),
      lift_(context.contact, profile_, allowance),
      bodies_(context.contact, context.tool, allowance + options.holder_clearance, options.chord_tolerance),
      part_{&lift_, -infinity, &bodies_},
      spacing_(std::min(safe_spacing(profile_, 0.5 * options.chord_tolerance), bodies_.spacing())),
      wide_lift_(context.contact, profile_, allowance + level_share * profile_.max_radius()),
      wide_bodies_(context.contact, context.tool, allowance + options.holder_clearance,
                   level_share * profile_.max_radius()),
      wide_spacing_(std::min(safe_spacing(wide_lift_.profile(), level_share * profile_.max_radius()),
                             wide_bodies_.spacing())),
      up_(context.tool), clearance_(up_.near_to_stock(options.clearance)),
      level_clearance_(options.clearance), top_(top), reach_(2 * profile_.max_radius()) {
    if (context.stock.box.empty() && context.earlier.empty()) return;
    for (const HolderSection& s : context.tool.holder)
        reach_ = std::max(reach_, 0.5 * s.diameter + profile_.max_radius());
    reach_ = std::max(reach_, 0.5 * context.tool.shank_diameter + profile_.max_radius());
    stock_.emplace(stock_before(context, field_cell_share * profile_.max_radius(), progress), profile_,
                   lowest, progress);
}

/// What tips must stay above on a level way, for the whole tool, where that is above `known`. Of what was cut
/// farther away than the cutter reaches only shank and holder ask, where something stands as high as they.
double UprightTravel::clear_height(const Vec2& a, const Vec2& b, double known) {
    const double by_cutter =
        std::max(known, stock_->about(a, b, cutter_.radius()).clear_height(cutter_, a, b));
    if (stock_->highest() - stock_bodies_.lowest_base() <= by_cutter) return by_cutter;
    return stock_bodies_.clear_height(stock_->about(a, b, reach_), a, b, by_cutter);
}

double UprightTravel::touch() const {
    return touch_share * clearance_;
}

double UprightTravel::down_to(const Vec3& tip, double top) {
    if (!stock_) return top;
    const Vec2 p = tip.head<2>();
    const double stands = std::min(clear_height(p, p, tip.z() - clearance_), been_at(p));
    if (!(stands < tip.z() && is_off(tip, stands)))
        return std::min(top, std::max(stands, tip.z()) + clearance_);
    return std::min(top, std::max(stands + clearance_, tip.z() + touch()));
}

std::optional<double> UprightTravel::fall_to(const Vec3& from, const Vec3& tip) {
    if (!stock_ || from.head<2>() != tip.head<2>()) return std::nullopt;
    const Vec2 p = tip.head<2>();
    const double end = std::max(been_at(p), tip.z()) + clearance_;
    if (!(from.z() - end > clearance_)) return std::nullopt;
    // Shank and holder may have been brought into stock that nobody roughed.
    if (stock_bodies_.clear_height(stock_->about(p, p, reach_), p, p) > end) return std::nullopt;
    return end;
}

/// Whether a tip is out of the cut: so high over the part, and over what stands as high as that.
bool UprightTravel::is_off(const Vec3& tip, double stands) const {
    const double most = tip.z() - out_of_cut_share * clearance_;
    return stands <= most && lift_.tip_z(tip.x(), tip.y()) <= most;
}

double UprightTravel::up_from(const Vec3& tip, double top) {
    if (!stock_ || up_.is_undercut()) return top;
    const double out = tip.z() + (is_off(tip, -infinity) ? touch() : clearance_);
    // Mostly nothing stands as high as they begin, and what was cut where need not be known.
    const double above = stock_->highest() - tip.z();
    if (above <= std::min(stock_bodies_.lowest_base(), cutter_.height())) return std::min(top, out);
    // Shank and holder may have been brought into stock that nobody roughed.
    const Vec2 p = tip.head<2>();
    const StockField& field = stock_->about(p, p, reach_);
    if (!up_.is_free(field, tip) || stock_bodies_.clear_height(field, p, p) > tip.z())
        return down_to(tip, top);
    return std::min(top, out);
}

/// Those from which a tool goes to the tip, or back, clear of the part, in less than that at feed.
std::vector<Vec3> UprightTravel::places_beside(const Vec3& tip, double no_farther) {
    std::vector<Vec3> places;
    for (const Vec2& p : places_around(tip.head<2>(), profile_.max_radius())) {
        Vec3 place(p.x(), p.y(), tip.z());
        place.z() = down_to(place, infinity);
        if ((place - tip).norm() < no_farther && is_clear(place, tip)) places.push_back(place);
    }
    return places;
}

std::optional<Vec3> UprightTravel::beside(const Vec3& tip, double slow) {
    std::optional<Vec3> best;
    if (!stock_) return best;
    double least = beside_worth * slow;
    for (const Vec3& place : places_beside(tip, least))
        if (const double length = (place - tip).norm(); length < least) {
            least = length;
            best = place;
        }
    return best;
}

bool UprightTravel::is_level_free(const Vec2& a, const Vec2& b, double z) {
    if (!stock_) return false;
    const StockField& field = stock_->about(a, b, reach_);
    return stock_bodies_.clear_height(field, a, b) <= z && !up_.stands_above(field, a, b, z);
}

/// Straight down to a tip from beside it: cutter, shank and holder keep out of the part, the latter two of
/// the stock, too.
bool UprightTravel::is_clear(const Vec3& place, const Vec3& tip) {
    const Vec2 from = place.head<2>(), to = tip.head<2>();
    const StockField& field = stock_->about(to, to, reach_);
    if (stock_bodies_.clear_height(field, from, to) > tip.z()) return false;
    // A shank as wide as the cutter comes down in what that has cut, but not sideways.
    if (up_.stands_above(field, from, to, tip.z())) return false;
    const double parts = std::floor((place - tip).norm() / spacing_) + 1;
    LiftHint hint;
    for (double i = 0; i < parts; ++i) {
        const Vec3 at = place + i / parts * (tip - place);
        if (part_.tip_z(at.head<2>(), hint) > at.z()) return false;
    }
    return true;
}

/// The lowest tip of a level rapid, or `top_` where nothing is gained by knowing more.
double UprightTravel::level(const Vec2& a, const Vec2& b, const Progress& progress) {
    double z = clear_height(a, b, -infinity);
    const double n = std::max(1.0, std::ceil((b - a).norm() / wide_spacing_));
    LiftHint hint;
    HolderReach::Hints hints;
    for (double i = 0; i <= n && z + level_clearance_ < top_; ++i) {
        progress.check();
        const Vec2 p = a + (i / n) * (b - a);
        z = wide_bodies_.raised(p, wide_lift_.tip_z(p.x(), p.y(), hint, z), hints);
    }
    return std::min(z + level_clearance_, top_);
}

/// The place beside a tip above which the least stands.
std::optional<Vec3> UprightTravel::lowest_beside(const Vec3& tip, const Progress& progress) {
    std::optional<Vec3> best;
    double least = infinity;
    for (const Vec3& place : places_beside(tip, profile_.max_radius())) {
        const double z = level(place.head<2>(), place.head<2>(), progress) + (place - tip).norm();
        if (!(z < least)) continue;
        least = z;
        best = place;
    }
    return best;
}

/// What differs between one route and another: the level rapid hardly does.
double UprightTravel::cost(const Route& route, const Vec3& from, const Vec3& to) const {
    return (route.out - from).norm() + (route.in - to).norm()
           + rapid_share * (std::abs(route.z - route.out.z()) + std::abs(route.z - route.in.z()));
}

Vec3 UprightTravel::over(const Vec3& tip) {
    const Vec3 above(tip.x(), tip.y(), down_to(tip, top_));
    return beside(tip, above.z() - tip.z()).value_or(above);
}

UprightTravel::Route UprightTravel::route(const Vec3& from, const Vec3& to, const Progress& progress) {
    Route straight{from, over(to), top_};
    straight.out.z() = up_from(from, top_);
    if (!stock_) return straight;
    const auto set_level = [&](Route& r) {
        r.z = std::clamp(level(r.out.head<2>(), r.in.head<2>(), progress), std::max(r.out.z(), r.in.z()),
                         std::max({top_, r.out.z(), r.in.z()}));
    };
    set_level(straight);
    // A wall beside one of the ends: a little away from it less stands, or nothing.
    if (straight.z <= std::max(from.z(), to.z()) + level_clearance_ + clearance_) return straight;
    Route best = straight;
    double least = aside_share * cost(best, from, to);
    const auto out = up_.is_undercut() ? std::nullopt : lowest_beside(from, progress);
    const auto in = lowest_beside(to, progress);
    for (const bool other_out : {false, true})
        for (const bool other_in : {false, true}) {
            if ((other_out && !out) || (other_in && !in) || (!other_out && !other_in)) continue;
            Route r = straight;
            if (other_out) r.out = *out;
            if (other_in) r.in = *in;
            set_level(r);
            if (const double c = cost(r, from, to); c < least) {
                least = c;
                best = r;
            }
        }
    return best;
}

} // namespace facetmill
