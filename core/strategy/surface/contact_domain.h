// Where the tip has to go, seen from above, so that every upward-facing place of the part is touched.
//
// A facet with unit normal n is touched by tips over the facet moved by the cutter's tip offset for n
// (CutterCover): downhill, by the radius at which the cutter touches a plane of that slope. The domain is the
// union of the moved facets, stretched over edges and vertices, where the cutter rolls from one facet to the
// next. So it ends where the cutter touches the part's border with the border's own normal: the passes reach
// far enough to cut borders fully, and no farther than that.
//
//  - Facets that face down or stand upright (tolerance::vertical_normal_z) ask for nothing. An upright wall
//  between two
//    levels lies between the moved facets of both and is cut as the tip comes down along it; the outer walls
//    of a part are not cut, since nothing says how deep to go.
//  - A mesh is a sheet, either side of which may be up: a facet with a downward normal counts with the
//  opposite one. On
//    a solid its underside thus asks again for places that its top asks for; asking twice makes no second
//    pass.
//  - Facets under an overhang ask for tip places that are blocked there; the axial lift passes over what
//  blocks.
#pragma once

#include "core/strategy/surface/box_rows.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/drive_frame.h"

#include "core/mesh/mesh.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace facetmill {

struct Interval {
    double lo = 0, hi = 0;
    double length() const { return hi - lo; }
};

class ContactDomain {
public:
    /// Outlines of so many facets are kept. Where there are more, nearly all facets lie wholly in a strip or
    /// in what those before them cover, and the others' are found when they are asked for, the same: to find
    /// and keep all of them would take longer, and as much memory as the index of the part.
    static constexpr std::size_t max_kept_outlines = 2'000'000;

    /// `allowance`: stock left along the surface normal. `mesh` must outlive the domain.
    ContactDomain(const Mesh& mesh, const DriveFrame& frame, const CutterCover& cover, double allowance,
                  const Progress& progress, std::size_t max_kept = max_kept_outlines);

    bool empty() const { return index_.empty(); }
    /// Range of v over the domain.
    double lo() const { return index_.lo(); }
    double hi() const { return index_.hi(); }
    /// Smallest tip height that any contact in the domain asks for.
    double lowest_tip() const { return lowest_tip_; }
    /// Facets that face up, down (either counts) and stand upright or have no area.
    std::size_t usable_facets() const { return usable_; }

    /// Ranges of u that the domain covers anywhere in the strip v0 <= v <= v1, in order, with gaps of at most
    /// `merge` closed. With `within` they are only true there: what lies outside may be missing.
    std::vector<Interval> strip(double v0, double v1, double merge, const Interval* within = nullptr) const;
    std::vector<Interval> line(double v, double merge, const Interval* within = nullptr) const {
        return strip(v, v, merge, within);
    }

private:
    class Fans;
    using Corner = std::array<float, 2>; ///< (u, v) from the facet's first vertex

    Vec2 first_vertex(std::size_t facet) const {
        const Vec3& p = mesh_.corner(facet, 0);
        return {frame_.u(p), frame_.v(p)};
    }
    std::vector<FlatBox> boxes_of_facets(const Progress& progress) const;
    void find_outline(std::size_t facet, std::vector<Vec2>& corners) const;
    void keep_outlines(const Progress& progress);
    /// Where outlines are found that are not kept.
    struct Room {
        std::vector<Vec2> corners;
        std::vector<Corner> outline;
    };
    Interval whole(std::size_t facet) const;
    Interval clipped(std::size_t facet, double v0, double v1, Room& room) const;

    const Mesh& mesh_;
    DriveFrame frame_;
    std::shared_ptr<const Fans> fans_; ///< where outlines are not kept
    /// Convex outlines of what each facet asks for: from outline_start_[facet] to that of the next one.
    std::vector<std::uint32_t> outline_start_;
    std::vector<Corner> outlines_;
    double lowest_tip_ = infinity;
    std::size_t usable_ = 0;
    BoxRows index_;
};

/// Joins overlapping intervals, and those at most `merge` apart; the result is sorted.
std::vector<Interval> joined(std::vector<Interval> intervals, double merge);

} // namespace facetmill
