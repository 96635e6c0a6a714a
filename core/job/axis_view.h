// A setup as the tool of an indexed operation sees it ("3+2"): part, stock, fixtures and boundaries turned so
// that its axis is +Z, which is how all planners of upright tools are asked. What they answer is turned back.
// Below the bottom of the stock stands the table, as one fixture more. Millimetres; coordinates of the view,
// or of the setup where that is said.
#pragma once

#include "core/job/bounds.h"
#include "core/job/planner.h"

#include <memory>
#include <string>

namespace facetmill {

/// The shortest turn that brings a tool axis (unit, in the setup) to +Z; one upside down goes over about X.
Mat3 turn_upright(const Vec3& axis);

/// What planning along one tool axis works on.
struct AxisView {
    Mat3 turn = Mat3::Identity(); ///< from the setup's coordinates
    std::shared_ptr<const PreparedPart> part;
    ContactIndexPtr index;    ///< of part->mesh, or null
    ContactIndexPtr kept_off; ///< of part->kept_off, or null; the same without fixtures
    ContactIndexPtr fixtures; ///< of the grown fixtures alone; null without
    BoundsCache bounds;
    std::string key; ///< of the view; another text where anything of it is another
    bool used = false;

    AxisView() = default;
    /// The view of an indexed operation; `stock`: box of the raw material in the setup.
    AxisView(const PreparedPart& part, const Project& project, const Operation& operation, const Box3& stock,
             const Progress& progress);

    bool is_upright() const { return turn == Mat3::Identity(); }
    /// Indexes what has none yet. Throws Cancelled; what there is stays good then.
    void index_part(const Progress& progress);
};

/// Text of all that the view of an operation depends on beside part and fixtures; empty for the axis +Z.
std::string axis_view_key(const Project& project, const Operation& operation, const Box3& stock);

/// What an operation's tool is kept within, as its planning made it: of a part in the setup, for a view
/// turned by `turn`. Null where it names no boundary. Throws what BoundsCache::of does.
std::shared_ptr<const KeptWithin> kept_within_of(const Project& project, const Operation& operation,
                                                 const PreparedPart& part, const Mat3& turn,
                                                 const Progress& progress);

/// A raw material turned; but by quarter turns a closed mesh, where a cylinder becomes a prism round it.
StockSolid turned_stock(const StockSolid& stock, const Mat3& turn);
MeshPtr turned_mesh(const MeshPtr& mesh, const Mat3& turn);

/// A path as it was planned in a view, in the coordinates of the setup.
StrategyResult turned_path(const StrategyResult& path, const Mat3& turn);
ToolMotions turned_motions(ToolMotions motions, const Mat3& turn);

/// The part with normals all over it where an operation of the project turns its axis; else as it is. Those
/// that keep their axis hardly ask for any, and make them for themselves: for a million facets they take 36
/// MB.
std::shared_ptr<const PreparedPart> with_normals(std::shared_ptr<const PreparedPart> part,
                                                 const Project& project, const Progress& progress);

} // namespace facetmill
