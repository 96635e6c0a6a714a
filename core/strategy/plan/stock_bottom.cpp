#include "core/strategy/plan/stock_bottom.h"

#include "core/base/tolerances.h"
#include "core/strategy/plan/plan_text.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

double stock_bottom(const PlanContext& context) {
    return (context.stock_box.empty() ? context.part_box : context.stock_box).lo.z();
}

bool is_upright(const std::vector<CutterLocation>& locations) {
    return std::all_of(locations.begin(), locations.end(),
                       [](const CutterLocation& c) { return c.axis == Vec3::UnitZ(); });
}

/// What became of the locations of a path.
struct Kept {
    std::size_t all = 0, changed = 0;
    double deepest = 0; ///< how far below the limit one of them would have been
    void see(double below) {
        ++all;
        if (!(below > tolerance::contact_distance)) return;
        ++changed;
        deepest = std::max(deepest, below);
    }
};

/// Whether a location cuts surface of which something stays when it is raised: not where nothing is below it,
/// and of walls, which face no tool from above, the verification asks for nothing either.
bool cuts_floor(const Pass& pass, std::size_t i) {
    if (i >= pass.cc.size()) return true;
    return pass.cc[i].normal.z() > tolerance::vertical_normal_z && pass.cc[i].point != pass.cl[i].tip;
}

/// Where a pass crosses the level between location i - 1 and this one.
void add_crossing(const Pass& pass, std::size_t i, double lowest, Pass& raised) {
    const Vec3 &from = pass.cl[i - 1].tip, &to = pass.cl[i].tip;
    const double high = std::max(from.z(), to.z()), low = std::min(from.z(), to.z());
    if (high - lowest <= tolerance::contact_distance || lowest - low <= tolerance::contact_distance) return;
    const double t = (lowest - from.z()) / (to.z() - from.z());
    raised.cl.push_back({from + t * (to - from), pass.cl[i].axis});
    raised.cl.back().tip.z() = lowest;
    if (i >= pass.cc.size()) return;
    const CutterContact &a = pass.cc[i - 1], &b = pass.cc[i];
    const Vec3 normal = a.normal + t * (b.normal - a.normal);
    CutterContact& between = raised.cc.emplace_back(t < 0.5 ? a : b);
    between.point = a.point + t * (b.point - a.point);
    if (normal.norm() > tolerance::level_angle) between.normal = normal.normalized();
}

/// With a location where the way crosses the level: from a raised end the tool would leave a wall that leans
/// on its whole way to the next one.
void raise(Pass& pass, double lowest, Kept& kept) {
    Pass raised;
    for (std::size_t i = 0; i < pass.cl.size(); ++i) {
        if (i > 0) add_crossing(pass, i, lowest, raised);
        CutterLocation c = pass.cl[i];
        kept.see(cuts_floor(pass, i) ? lowest - c.tip.z() : 0);
        c.tip.z() = std::max(c.tip.z(), lowest);
        raised.cl.push_back(c);
        if (i < pass.cc.size()) raised.cc.push_back(pass.cc[i]);
    }
    pass.cl = std::move(raised.cl);
    pass.cc = std::move(raised.cc);
    for (CutterLocation& c : pass.entry)
        c.tip.z() = std::max(c.tip.z(), lowest);
}

/// The pieces of a pass of a tilted tool that are high enough.
void add_pieces(const Pass& pass, const CutterProfile& profile, double lowest, Kept& kept,
                std::vector<Pass>& pieces) {
    Pass piece;
    const auto begin = [&] {
        piece.drive = pass.drive;
        piece.offset = pass.offset;
        piece.layer = pass.layer;
        piece.cc.clear();
        piece.cl.clear();
    };
    const auto end = [&] {
        // One location cuts nothing that its neighbours, which are left out, would not have cut.
        if (piece.cl.size() > 1 || piece.cl.size() == pass.cl.size()) pieces.push_back(piece);
        begin();
    };
    begin();
    for (std::size_t i = 0; i < pass.cl.size(); ++i) {
        const CutterLocation& c = pass.cl[i];
        const double below = lowest - (c.tip.z() - reach_below_tip(profile, c.axis));
        kept.see(below);
        if (below > tolerance::contact_distance) {
            if (!piece.cl.empty()) end();
            continue;
        }
        piece.cl.push_back(c);
        if (i < pass.cc.size()) piece.cc.push_back(pass.cc[i]);
    }
    if (!piece.cl.empty()) end();
}

} // namespace

double lowest_allowed(const PlanContext& context, const OperationCommon& common) {
    return stock_bottom(context) - common.below_bottom;
}

double reach_below_tip(const CutterProfile& profile, const Vec3& axis) {
    const double cosine = axis.z(), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto below = [&](const Vec2& p) { return p.x() * sine - p.y() * cosine; };
    double most = 0;
    for (const ProfilePiece& piece : profile.pieces()) {
        most = std::max({most, below(piece.from), below(piece.to)});
        if (piece.kind != ProfilePiece::Kind::arc) continue;
        const Vec2 lowest = piece.center + piece.radius * Vec2(sine, -cosine);
        const auto between = [](double a, double x, double b) {
            return std::min(a, b) <= x && x <= std::max(a, b);
        };
        if (between(piece.from.x(), lowest.x(), piece.to.x())
            && between(piece.from.y(), lowest.y(), piece.to.y()))
            most = std::max(most, below(lowest));
    }
    return most;
}

void keep_above_bottom(StrategyResult& path, const PlanContext& context, const OperationCommon& common) {
    const double lowest = lowest_allowed(context, common), bottom = stock_bottom(context);
    const CutterProfile profile(context.tool.cutter());
    const PlanText text{context.unit, context.to_setup};
    Kept raised, left_out, under;
    std::vector<Pass> passes;
    for (Pass& pass : path.passes) {
        if (is_upright(pass.cl) && is_upright(pass.entry)) {
            raise(pass, lowest, raised);
            passes.push_back(std::move(pass));
        } else {
            add_pieces(pass, profile, lowest, left_out, passes);
        }
    }
    path.passes = std::move(passes);
    if (path.passes.empty() && left_out.changed > 0)
        throw Error(ErrorCode::empty_result, common.name,
                    "everywhere on the path the cutter would be below the bottom of the stock",
                    "use a stock that reaches lower, or allow it by 'Below the bottom'");
    for (const Pass& pass : path.passes)
        for (const CutterLocation& c : pass.cl)
            under.see(bottom - (c.tip.z() - reach_below_tip(profile, c.axis)));
    const auto share = [](const Kept& kept) { return share_text(double(kept.changed), double(kept.all)); };
    if (raised.deepest > common.tolerance)
        path.warnings.push_back("the tip is kept from going below the bottom of the stock, by up to "
                                + text(raised.deepest) + " at " + share(raised)
                                + " of the points: so much stays on the surface there unless "
                                  "'Below the bottom' allows it");
    if (left_out.changed > 0)
        path.warnings.push_back(
            "the passes end where the cutter would go below the bottom of the stock, by up to "
            + text(left_out.deepest) + ": " + share(left_out)
            + " of the points are left out unless 'Below the bottom' allows them");
    if (under.deepest > common.tolerance)
        path.warnings.push_back("the cutter goes " + text(under.deepest)
                                + " below the bottom of the stock, as 'Below the bottom' allows");
}

} // namespace facetmill
