// Where a radial cutter is stopped over a turning part: by the part, by what holds it, or by the core radius.
// Millimetres, radians; frame and letters as in lathe.h.
#pragma once

#include "core/gouge/tool_lift.h"
#include "core/strategy/lathe/lathe.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/surface/cutter_cover.h"

#include <memory>
#include <vector>

namespace facetmill {

/// One place of a path over the field.
struct LathePoint {
    /// `shaft`: the part holds the shank or the holder.
    enum class HeldBy : std::uint8_t { part, shaft, core, zone };
    LathePlace place;
    double u = 0;
    CutterContact cc; ///< where the part does not hold the cutter: the tip, and the tool axis
    HeldBy held = HeldBy::part;
};

/// The raw material, chuck or tailstock as facets around the turning axis.
Mesh lathe_stock_mesh(const StockSolid& stock, const Box3& stock_box);
/// Cylinders where the chuck and the tailstock hold the stock, grown by `clearance`; without facets where
/// there are none. They reach from the stock's ends outward as far as the part is long.
Mesh lathe_zone_mesh(const LatheCommon& settings, const LatheFrame& frame, const Mesh& stock,
                     double clearance);
/// Largest distance of a mesh's corners from the turning axis; 0 without any.
double radius_about(const LatheFrame& frame, const Mesh& mesh);

class LatheField {
public:
    /// `allowance`: what the cutter keeps from the part, the part's inner tessellation tolerance included.
    /// Throws what LatheFrame and ToolLift throw.
    LatheField(const LatheCommon& settings, const PlanContext& context, double allowance,
               const Progress& progress);

    struct Hint {
        ToolLift::Hint part, zone;
    };
    LathePoint point(const LathePlace& place, Hint& hint) const;
    double u(const LathePlace& place, Hint& hint) const;
    /// Tip height that chuck and tailstock ask for; -inf away from them.
    double zone_u(const LathePlace& place, Hint& hint) const;

    const LatheFrame& frame() const { return frame_; }
    const CutterCover& cover() const { return cover_; }
    double floor() const { return floor_; }
    double allowance() const { return allowance_; }
    double part_radius() const { return part_radius_; }
    double stock_radius() const { return stock_radius_; } ///< the raw material's
    double zone_radius() const { return zone_radius_; }   ///< chuck's and tailstock's; 0: none
    bool has_zones() const { return zone_ != nullptr; }
    /// Ends of the stock along the axis; the part's, where the stock has no size.
    double stock_from() const { return stock_from_; }
    double stock_to() const { return stock_to_; }

private:
    LatheFrame frame_;
    ContactIndexPtr contact_;
    CutterCover cover_;
    std::unique_ptr<ToolLift> part_, zone_;
    double allowance_ = 0, floor_ = 0, part_radius_ = 0, stock_radius_ = 0, zone_radius_ = 0, stock_from_ = 0,
           stock_to_ = 0;
};

/// Where the tool, or some of it, is stopped over the raw material: for what is air and how far in rapids may
/// go.
class LatheStock {
public:
    enum class Of { cutter, whole_tool, above_flutes };
    using Hint = std::vector<ToolLift::Hint>; ///< body by body
    LatheStock(const LatheFrame& frame, const PlanContext& context, Of of, const Progress& progress);
    /// -inf where it does not meet it.
    double u(const LathePlace& place, Hint& hint) const;

private:
    struct Body {
        std::unique_ptr<ToolLift> lift;
        double base; ///< above the tip
    };
    const LatheFrame& frame_;
    std::vector<Body> bodies_;
};

} // namespace facetmill
