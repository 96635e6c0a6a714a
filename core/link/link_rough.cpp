#include "core/base/tolerances.h"
#include "core/link/beside_places.h"
#include "core/link/link.h"
#include "core/link/straight_up.h"
#include "core/strategy/lathe/lathe.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/rough/rough_reach.h"
#include "core/strategy/surface/stock_before.h"

#include <cmath>

namespace facetmill {

namespace {

/// Passes whose ends are nearer than this, in diameters of the cutter, are joined at feed where that way is
/// free: up and down again takes longer.
constexpr double feed_link = 2;
/// The length of the pieces of a motion, in radii of the cutter, of which it is asked whether they cut. It
/// only says how much of a path is counted as air.
constexpr double air_piece = 0.5;
/// What may stand where a tool goes on at feed beside a pass, in diameters of the cutter: as little as
/// roughing takes for nothing to cut. The tool cuts it at feed.
constexpr double min_share = 2e-3;

class RoughLinker {
public:
    RoughLinker(const StrategyResult& path, const PlanContext& context, double allowance,
                const LinkOptions& options, const Progress& progress)
        : path_(path), options_(options), progress_(progress), profile_(context.tool.cutter()),
          cutter_(profile_), bodies_(context.tool, profile_, path.as<RoughPath>()->depth_max),
          up_(context.tool),
          field_(stock_before(context, path.as<RoughPath>()->stock_cell, progress.part(0, 0.1))),
          // Links keep from the part what cuts keep.
          reach_(context.contact, context, allowance + context.tessellation_tolerance[1],
                 std::max(path.chord_tolerance, tolerance::smallest_chord), -infinity) {
        const double top =
            std::max({context.kept_off_box().hi.z() + allowance, context.stock_box.hi.z(), field_.highest()});
        result_.clearance_z = top + options.clearance;
    }

    ToolMotions run() {
        for (std::size_t i = 0; i < path_.passes.size(); ++i) {
            progress_.part(0.1, 1).set(double(i) / double(path_.passes.size()));
            if (path_.passes[i].cl.empty()) continue;
            add(path_.passes[i], Index(i));
        }
        if (started_) {
            cut_fed();
            up_to(result_.clearance_z);
            cut_fed();
        }
        progress_.set(1);
        return std::move(result_);
    }

private:
    void add(const Pass& pass, Index index) {
        cut_fed();
        const CutterLocation& first = pass.cl.front();
        const Vec3 start = pass.entry.empty() ? first.tip : pass.entry.front().tip;
        if (!join_at_feed(pass, start)) {
            travel_over(start);
            feed(MotionKind::approach, start);
        }
        for (std::size_t k = 1; k < pass.entry.size(); ++k)
            feed(MotionKind::approach, pass.entry[k].tip);
        result_.motions.back().pass = index;
        result_.motions.back().point = 0;
        for (std::size_t k = 1; k < pass.cl.size(); ++k) {
            feed(MotionKind::cut, pass.cl[k].tip);
            result_.motions.back().pass = index;
            result_.motions.back().point = Index(k);
        }
    }

    /// Over a short way where nothing stands any more.
    bool join_at_feed(const Pass& pass, const Vec3& start) {
        if (!started_ || !pass.entry.empty()) return false;
        const Vec2 a = at_.head<2>(), b = start.head<2>();
        if ((b - a).norm() > feed_link * 2 * profile_.max_radius()) return false;
        const double z = std::max(at_.z(), start.z());
        if (!(field_.stand_height(cutter_, a, b) <= z + least()) || !bodies_.clear(field_, a, b, z)
            || !reach_.is_free(a, b, z, hints_))
            return false;
        if (at_.z() < z) feed(MotionKind::link, Vec3(a.x(), a.y(), z));
        if (a != b || start.z() < z) feed(MotionKind::link, Vec3(b.x(), b.y(), z));
        if (start.z() < z) feed(MotionKind::link, start);
        return true;
    }

    void travel_over(const Vec3& start) {
        const Vec3 in = over(start);
        const Vec2 b = in.head<2>();
        if (!started_) {
            rapid(Vec3(b.x(), b.y(), result_.clearance_z));
            started_ = true;
        } else {
            const Vec2 a = at_.head<2>();
            const double over = reach_.highest(a, b, hints_, clear_height(a, b));
            const double z =
                std::clamp(over + options_.clearance, std::max(at_.z(), start.z()), result_.clearance_z);
            up_to(z);
            cut_fed();
            rapid(Vec3(b.x(), b.y(), at_.z()));
        }
        if (in.z() < at_.z()) rapid(in);
    }

    /// Where a rapid down ends, over a place or, much lower, beside it: cells that a wall crosses are as high
    /// as the wall for ever, so that along a wall nothing is known to be gone.
    Vec3 over(const Vec3& start) {
        const Vec2 b = start.head<2>();
        const double near = up_.near_to_stock(options_.clearance);
        const auto down = [&](const Vec2& p) {
            return std::max({clear_height(p, p), reach_.tip_z(p, hints_), start.z()}) + near;
        };
        Vec3 best(b.x(), b.y(), down(b));
        double least = beside_worth * (best.z() - start.z());
        if (least <= near) return best;
        for (const Vec2& p : places_around(b, profile_.max_radius())) {
            const Vec3 place(p.x(), p.y(), down(p));
            const double length = (place - start).norm();
            if (!(length < least) || !leads_in(p, start)) continue;
            least = length;
            best = place;
        }
        return best;
    }

    /// Whether the tool goes from over a place beside it to a start without cutting anything.
    bool leads_in(const Vec2& p, const Vec3& start) {
        const Vec2 b = start.head<2>();
        return field_.stand_height(cutter_, p, b) <= start.z() + least()
               && bodies_.clear(field_, p, b, start.z()) && reach_.is_free(p, b, start.z(), hints_);
    }

    /// What tips must stay above on a level way, for the whole tool.
    double clear_height(const Vec2& a, const Vec2& b) const {
        return bodies_.clear_height(field_, a, b, field_.clear_height(cutter_, a, b));
    }

    /// Out of the cut at feed, the rest in a rapid.
    void up_to(double z) {
        // A pass along a wall is nearer to it than links keep, all the way up: that alone asks for no feed.
        // Beside a slim shank stock may stand above the flutes, where nothing was cut yet.
        const Vec2 p = at_.head<2>();
        const double from =
            up_.is_free(field_, at_)
                ? at_.z()
                : std::max({at_.z(), reach_.tip_z(p, hints_), field_.clear_height(cutter_, p, p)});
        const double out = from + up_.near_to_stock(options_.clearance);
        if (z > at_.z()) feed(MotionKind::retract, Vec3(at_.x(), at_.y(), std::min(z, out)));
        if (z > at_.z()) rapid(Vec3(at_.x(), at_.y(), z));
    }

    void rapid(const Vec3& to) { put(MotionKind::rapid, to); }
    void feed(MotionKind kind, const Vec3& to) {
        const Vec3 route = to - at_;
        const double n = std::max(1.0, std::ceil(route.norm() / (air_piece * profile_.max_radius())));
        for (double k = 0; k < n; ++k)
            fed_.push_back({at_ + (k / n) * route, at_ + ((k + 1) / n) * route});
        put(kind, to);
    }
    /// What was fed since the last time, before the stock is asked again.
    void cut_fed() {
        const std::vector<char> work = field_.cut_telling_work(cutter_, fed_, least(), progress_.part(0, 0));
        for (std::size_t i = 0; i < fed_.size(); ++i)
            if (!work[i]) result_.air_length += (fed_[i][1] - fed_[i][0]).norm();
        fed_.clear();
    }
    void put(MotionKind kind, const Vec3& to) {
        result_.motions.push_back({kind, {to, Vec3(0, 0, 1)}, no_index, no_index});
        at_ = to;
    }
    double least() const { return min_share * 2 * profile_.max_radius(); }

    const StrategyResult& path_;
    LinkOptions options_;
    const Progress& progress_;
    CutterProfile profile_;
    StockCutter cutter_;
    UprightBodies bodies_;
    StraightUp up_;
    StockField field_;
    RoughReach reach_;
    RoughReach::Hints hints_;
    ToolMotions result_;
    Vec3 at_ = Vec3::Zero();
    bool started_ = false;
    std::vector<StockField::Motion> fed_; ///< and not yet cut
};

} // namespace

ToolMotions link_rough(const StrategyResult& path, const PlanContext& context, double allowance,
                       const LinkOptions& options, const Progress& progress) {
    check_link_options(options);
    if (path.passes.empty()) return {};
    return RoughLinker(path, context, allowance, options, progress).run();
}

ToolMotions link_operation(const Operation& operation, const StrategyResult& path, const PlanContext& context,
                           const Progress& progress) {
    return link_operation(operation, operation.linking(), path, context, progress);
}

ToolMotions link_operation(const Operation& operation, Linking linking, const StrategyResult& path,
                           const PlanContext& context, const Progress& progress) {
    const OperationCommon& common = operation.common();
    LinkOptions options = default_link_options(path, context, common);
    const double clearance = options.holder_clearance = operation.holder_clearance();
    switch (linking) {
    case Linking::upright:
        return link_three_axis(path, context, common.allowance, options, progress);
    case Linking::tilted:
        return link_five_axis(path, context,
                              {common.allowance + context.tessellation_tolerance[1], clearance, clearance},
                              options, progress);
    case Linking::over_stock:
        return link_rough(path, context, common.allowance, options, progress);
    case Linking::about_axis:
        return link_lathe(path, context, *operation.turning(), options, progress);
    }
    throw Error(ErrorCode::internal, "link", "unknown kind of linking", "report this");
}

} // namespace facetmill
