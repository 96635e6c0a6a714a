// Where the tip of an upright cutter stands on a coarse ground, cell by cell, and which cell holds it up.
// Millimetres, coordinates of the view.
//
// Heights are off by what the part rises over a cell or two. Cells are doubled in size until a cutter is few
// of them wide: what it costs is then the same for any cutter.
#pragma once

#include "core/cutter/cutter.h"
#include "core/strategy/preview/coarse_ground.h"

#include <memory>
#include <optional>

namespace facetmill {

class CoarseTips {
public:
    /// `allowance`: kept from the part, >= 0.
    CoarseTips(std::shared_ptr<const CoarseGround> ground, const CutterProfile& profile, double allowance,
               const Progress& progress);

    /// The tips' own: that of the ground, and as many cells more on every side as the cutter reaches.
    const CoarseGrid& grid() const { return grid_; }
    const CoarseGround& ground() const { return *ground_; }
    const std::shared_ptr<const CoarseGround>& ground_ptr() const { return ground_; }
    double spacing() const { return grid_.cell; }
    double radius() const { return radius_; }

    float z(std::size_t tip) const { return z_[tip]; }
    /// The ground's cell that holds a tip up; below 0: none does.
    int holder(std::size_t tip) const { return holder_[tip]; }
    /// The ground's cell under a tip's cell; below 0: it lies beside the ground.
    int below(std::size_t tip) const;
    /// Height over any place, between cells; nothing where no cell about it has one.
    std::optional<double> height(const Vec2& p) const;
    /// How fast the tip rises about a cell, along x and y; jumps count.
    Vec2 rise(std::size_t tip) const;
    /// Slope of the surface that a tip touches, from level, radians.
    double slope(std::size_t tip) const;
    /// Whether a tip is held by the part where it rolls over the surface, not only over its border.
    bool on_surface(std::size_t tip) const;

    /// What the cutter leaves of the part where it has been everywhere, for every cell of `ground()`.
    std::vector<float> left_heights(const Progress& progress) const;
    /// Height of the cutter's lower surface over a place, its tip at a cell; infinite beside the cutter.
    double under(std::size_t tip, const Vec2& place) const {
        return double(z_[tip]) - lift_ + profile_.height_at((place - grid_.middle(tip)).norm());
    }

private:
    std::shared_ptr<const CoarseGround> ground_;
    CoarseGrid grid_;
    CutterProfile profile_;
    double radius_ = 0, lift_ = 0;
    int pad_ = 0;
    /// Cells within the cutter's reach and how high it is there, the nearest first.
    struct Offset {
        int x, y;
        double distance;
        float z;
    };
    std::vector<Offset> offsets_;
    std::vector<float> z_;
    std::vector<int> holder_;
};

} // namespace facetmill
