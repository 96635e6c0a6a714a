// What stands of the stock above the flutes: shank and holder must not come into it. Millimetres, part
// coordinates, the tool's axis +Z.
//
// What roughing leaves on a wall may be higher than the flutes are long. A pass that runs down beside it cuts
// its own strip, and the skin beside that strip meets the shank; once the passes beside it have been there
// the tool may pass. So passes are followed one after the other through what stands, and what is held up is
// tried again when all others have cut.
#pragma once

#include "core/strategy/finish3/fine_stock.h"
#include "core/strategy/finish3/left_out.h"
#include "core/strategy/plan/operation.h"

#include <optional>
#include <string>
#include <vector>

namespace facetmill {

class LeftStock {
public:
    /// The stock as operations before left it, in cells of about `cell`, and those that are asked about in
    /// points `fine` apart. What stands no farther than `skin` from the part, or above it, is not
    /// asked: HolderReach answers for the part itself. No tip that is asked about is lower than the box
    /// `tips`, nor outside it seen along Z.
    LeftStock(const PlanContext& context, double cell, double fine, double skin, const Box3& tips,
              const Progress& progress);
    LeftStock(const LeftStock&) = delete;
    LeftStock& operator=(const LeftStock&) = delete;

    /// How much higher a tip would have to be for shank and holder to touch nothing that was left; 0 where
    /// they do not. Sees what is wider than `fine`.
    double lack(const Vec3& tip);
    /// Below this height of the tip shank or holder are lower than something within their reach of a line.
    double free_height(const Vec3& a, const Vec3& b) const;
    void cut(const Vec3& a, const Vec3& b) {
        field_.cut(cutter_, a, b);
        fine_.cut(a, b);
    }
    double spacing() const { return field_.cell(); } ///< how often a motion is looked at, mm
    double hop() const { return hop_; } ///< links that are no longer may go over what is in their way, mm
    /// The same pass over itself, from above, as often as flutes are long: what stands in the way of the
    /// shank of the next lower one, where that is as wide as the cutter, is cut by then. None of passes that
    /// are short, go up and down, or are free for the most part.
    std::vector<Pass> raised(const Pass& pass);

private:
    struct Body {
        double radius, base; ///< its lower face over the tip
    };
    static std::vector<Body> bodies_of(const Tool& tool); ///< from below
    static double widest_of(const std::vector<Body>& bodies);

    std::vector<Body> bodies_;
    double lowest_base_, widest_;
    Box3 near_; ///< where shank and holder come, seen along Z
    StockField field_;
    StockCutter cutter_;
    double hop_;
    FineStock fine_;
};

/// Passes that may be cut in the place of those that are held up, as clear of the part as they are: beside
/// them, say; in the order in which they are cut by a tool that comes from `end`.
using PassesInstead =
    std::function<std::vector<Pass>(const std::vector<Pass>& held, const std::optional<Vec3>& end)>;

/// What shank and holder keep passes from because something stands there.
struct ClearOfStock {
    std::vector<Pass> kept, left;
    double left_length = 0; ///< mm, less what is cut instead
    double lack = 0;        ///< mm: flutes longer by this would reach all of it
};

/// Follows the passes in their order. Pieces shorter than `shortest` are left out. Where others may be cut
/// for them, passes that are mostly held up are cut from above first, once every length of flutes; what is
/// held up in the end is asked for others, and so are these, once more, and tried again when they have cut.
/// Where shank or holder would touch something on the way from one pass to the next, its entry says how high
/// a link has to be, or it is come to from above.
ClearOfStock keep_clear_of_stock(std::vector<Pass> passes, LeftStock& stock, double shortest,
                                 const ContactAt& contact, const Progress& progress,
                                 const PassesInstead& instead = nullptr);

/// The same through the stock as operations before left it, for passes of an operation with this tolerance
/// and a cutter of this radius. Nothing where nothing is known of a stock, or none is higher than the flutes.
std::optional<ClearOfStock> keep_clear_of_left_stock(std::vector<Pass>& passes, const PlanContext& context,
                                                     double radius, double tolerance,
                                                     const ContactAt& contact, const Progress& progress,
                                                     const PassesInstead& instead = nullptr);
/// Warning of what was left out, and what would reach it.
std::string beside_stock_warning(const ClearOfStock& clear, const PlanContext& context);
[[noreturn]] void refuse_beside_stock(const std::string& operation, const ClearOfStock& clear,
                                      const PlanContext& context);

} // namespace facetmill
