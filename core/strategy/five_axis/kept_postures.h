// Postures kept by hand on their way into a plan: each goes to the contact point that it is for, and what
// becomes of it is told.
#pragma once

#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/five_axis/posture_study.h"

#include <string>
#include <vector>

namespace facetmill {

class KeptPostures {
public:
    /// Those of the field's settings.
    explicit KeptPostures(const FiveAxisField& field);

    /// Gives postures to the contact places of one pass: each to the nearest whose strip holds its point,
    /// within a radius of the cutter; in the first pass that has one.
    void hand_over(std::vector<PlacedLine>& pass);
    /// Notes which of a line's kept postures are not free, and why.
    void check(const PlacedLine& line, const PostureStudy& study);

    /// One for every posture that is not used.
    std::vector<std::string> warnings() const;
    /// For a part that is cut piece by piece: takes over what was kept in another piece.
    void add(const KeptPostures& other);

private:
    const FiveAxisField* field_; ///< not asked for `warnings`
    std::vector<ManualPosture> postures_;
    LengthUnit unit_;
    std::vector<double> v_; ///< per posture
    std::vector<bool> met_; ///< per posture: it belongs to a contact point
    std::vector<std::string> warnings_;
};

} // namespace facetmill
