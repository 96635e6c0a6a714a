// The tip's surface over a grid, and distances over it counted in steps: one step is how far apart two passes
// may lie there, whichever way, for the cusp between them to be the one allowed. Millimetres, part
// coordinates.
//
// A step over a plane is ScallopSteps'. Where the surface bends, the place that is touched moves by more or
// less than the tip, and what a round cutter leaves is by as much higher or lower: the tensor of the one
// displacement against the other, averaged over about a step, so that many small facets are as round as they
// are meant to be and a flat one is flat. It makes of the plane a metric (Kim 2007 has the like on the part's
// surface, with curvatures; here neither curvature nor mesh is asked, so noise, holes and sheets that
// intersect make no difference). What lines really leave corrects it (left_by_lines.h). Distances are
// field_distances.h's.
#pragma once

#include "core/strategy/scallop/metric_grid.h"
#include "core/strategy/scallop/scallop_steps.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/waterline/level_field.h"

#include <array>
#include <optional>
#include <vector>

namespace facetmill {

class ScallopField {
public:
    using Metric = MetricGrid::Metric;
    struct Options {
        double steepest = 0;        ///< slopes that are cut, radians
        std::optional<double> step; ///< the same everywhere, whatever cusp it leaves
        const KeptWithin* within = nullptr;
        double beyond = 0, spacing = 1; ///< of the grid round the box
    };
    /// `steps` has to live as long as this.
    ScallopField(const AxialLift& lift, const TouchTeller& tell, const ScallopSteps& steps, const Box3& box,
                 const Options& options, const Progress& progress);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    std::size_t size() const { return cut_.size(); }
    std::size_t number(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }
    Vec2 place(std::size_t i) const {
        return lo_ + spacing_ * Vec2(double(i % std::size_t(columns_)), double(i / std::size_t(columns_)));
    }
    double spacing() const { return spacing_; }
    /// Whether the tip may stand there to cut.
    bool cut(std::size_t i) const { return cut_[i]; }
    /// The same of the place nearest to p.
    bool cut_at(const Vec2& p) const;
    bool any() const;
    /// Places that are cut at the corners of the cell that holds p.
    std::vector<std::size_t> around(const Vec2& p) const;
    /// About how many steps a small displacement from a place is.
    double steps(std::size_t i, const Vec2& by) const;
    /// Places at the border of what is cut; at feet of walls across corners too, so that lines go on there.
    std::vector<std::size_t> border() const;
    /// Whether a place at the border stands at the foot of what rises too steeply to be cut.
    bool at_foot(std::size_t i) const { return towards_wall(i) != Vec2::Zero(); }
    /// From there to what rises, of any length; zero anywhere else.
    Vec2 towards_wall(std::size_t i) const;
    /// The place that is cut whose touched point is nearest.
    std::size_t nearest(const Vec3& p) const;

    /// The touched point, on the part.
    Vec3 touched(std::size_t i) const { return origin_ + touched_[i].cast<double>(); }
    struct Touch {
        Vec3 point, normal, tip; ///< the point as far from the part as the allowance
    };
    Touch touch(std::size_t i) const {
        const Vec3 n = normal_[i].cast<double>();
        return {touched(i) + allowance_ * n, n, tip(i)};
    }
    /// That on the way from a place to one beside it; nothing where the touch jumps in between.
    std::optional<Touch> between(std::size_t i, std::size_t j, double t) const;
    /// The power of a cusp in the distance of the lines that leave it: a half for what is round, up to 1 for
    /// corners, 0 where a flat bottom leaves a gap or nothing.
    double power(std::size_t i) const;
    bool flat_bottom() const { return steps_.flat_bottom(); }
    /// Weighted means over a step; 1 where nothing weighs.
    std::vector<float> smoothed(const std::vector<float>& values, const std::vector<float>& weights,
                                const Progress& progress) const;
    /// Makes every step shorter by its factor.
    void shorten_steps(const std::vector<float>& factors);

    using Seed = MetricGrid::Seed;
    /// Its metric measures displacements in steps; gone with this, or once steps are made shorter.
    MetricGrid grid() const { return {lo_, spacing_, columns_, rows_, cut_, metric_}; }
    /// Half of a usual step, in places.
    int half_step() const { return half_step_; }

private:
    void look(int first, std::span<const TipTouch> touches);
    void touch_under_flat_bottoms(const CutterCover& cover);
    void keep_within(const KeptWithin& within, const Progress& progress);
    std::vector<char> over_rim(double radius, const Progress& progress) const;
    Metric displacement(std::size_t i, double jump) const;
    void make_metric(const Options& options, double radius, const Progress& progress);
    std::vector<Metric> averaged(const std::vector<Metric>& field, int half, const Progress& progress) const;

    Vec3 tip(std::size_t i) const { return {place(i).x(), place(i).y(), origin_.z() + double(tip_[i])}; }

    const ScallopSteps& steps_;
    Vec3 origin_; ///< of what is stored in short numbers
    Vec2 lo_ = Vec2::Zero();
    double spacing_;
    int columns_ = 0, rows_ = 0;
    double steepest_;
    std::vector<char> cut_;
    std::vector<Eigen::Vector3f> touched_, normal_;
    std::vector<float> tip_; ///< heights over the origin
    double allowance_;
    int half_step_ = 1; ///< places
    std::vector<Metric> metric_;
};

} // namespace facetmill
