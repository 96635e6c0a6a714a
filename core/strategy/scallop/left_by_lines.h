// What lines leave over the places of a field: as the cutter leaves it, not as the metric says. Millimetres.
#pragma once

#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/scallop_field.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>
#include <span>

namespace facetmill {

class LeftByLines {
public:
    /// `usual`: about how far apart lines are; all that is given has to live as long as this.
    LeftByLines(const ScallopField& field, const CutterCover& cover, const AxialLift& lift, double usual,
                const std::vector<FieldContour>& lines, const Progress& progress);

    /// Along the normal, at a place that is cut; infinite where no line is near. Looks farther as long as
    /// that is more than `enough`. Any thread may ask.
    double over(std::size_t place, double enough) const { return over(field_.touch(place), enough); }
    /// What is left at a place and in the hollow beside it, measured so that `cusp` is what may be left: in a
    /// hollow that is what its depth leaves of it.
    double high(std::size_t place, double cusp) const;
    /// The highest that is left between the place and its two neighbours, one on each side.
    double crest(std::size_t place, std::size_t before, std::size_t after, double enough) const;
    /// What is left at a place of a cutter whose tip goes along `course` and nowhere else.
    double high_by(std::size_t place, double cusp, std::span<const Vec3> course) const;

    struct Near {
        std::size_t line = 0, piece = 0; ///< from which place of the line on
        double t = 0;                    ///< along the piece, from 0 to 1
        Vec3 place = Vec3::Zero();
    };
    /// The place of the lines that is nearest to a tip; none where no line is near.
    std::optional<Near> nearest(const Vec3& tip) const;

private:
    struct Piece {
        Vec3 a, b;
        std::size_t line, number;
    };
    double entry(const ScallopField::Touch& at, const Vec3& a, const Vec3& b) const;
    double over(const ScallopField::Touch& at, double enough) const;
    template <class Left>
    double highest(std::size_t place, double cusp, const Left& left) const;

    const ScallopField& field_;
    const CutterCover& cover_;
    double usual_;
    std::vector<Piece> pieces_;
    PointGrid middles_;
};

/// By how much steps over the field are to be shorter (above 1) or longer for the lines to leave `cusp`, from
/// what they leave now; smooth, 1 where nothing tells. `away`: from the nearest line, in steps.
std::vector<float> step_corrections(const ScallopField& field, const LeftByLines& left,
                                    const std::vector<double>& away, double cusp, const Progress& progress);

/// What is left at the places that are asked; 0 elsewhere.
std::vector<double> left_high(const ScallopField& field, const LeftByLines& left,
                              const std::vector<char>& asked, double cusp, const Progress& progress);

} // namespace facetmill
