// What a contact point can clear, while the step-over is sought: an estimated posture, and how wide a strip
// it has to either side.
//
// The estimate is the least inclined posture, at yaw 0, that need hardly be lifted: CM2 as the part itself
// allows it. Where its strip is too narrow for the gap to the neighbouring pass, yaws are tried as well.
#pragma once

#include "core/strategy/five_axis/five_axis_field.h"

#include <span>
#include <vector>

namespace facetmill {

struct EstimatedContact {
    ContactPlace place;
    PostureValue posture;
    bool known = false;                ///< what follows was found
    bool usable = false;               ///< some posture stays within the tolerance
    bool left = false;                 ///< its strip is too narrow to be worth it: left to others
    double width_lo = 0, width_hi = 0; ///< towards smaller and larger v; +inf: the surface ends before
    double end_lo = 0, end_hi = 0;     ///< where it ends, if it does
};

class ContactWidths {
public:
    /// Strips narrower than `leave`, mm on the surface, are left to others.
    ContactWidths(const FiveAxisField& field, double leave);

    /// Contacts that are neighbours on a line: postures, widths, whether they are left. `gap`: how far away
    /// the neighbouring pass is, mm; strips that are wide enough for it need no yaw.
    void find(std::vector<EstimatedContact>& contacts, double gap, const Progress& progress) const;
    /// How many blocks of contacts a line has that are found together; a block has the contacts of `block`.
    static std::size_t blocks(std::size_t contacts);
    static std::span<EstimatedContact> block(std::vector<EstimatedContact>& contacts, std::size_t number);
    /// The contacts of one block, which `find` leaves as they are after that.
    void find_block(std::span<EstimatedContact> block, double gap, const Progress& progress) const;
    /// One contact; the search begins at `lead`, which becomes the lead found. Says nothing of `left`.
    void find(EstimatedContact& contact, double gap, double& lead, ToolLift::Hint& hint) const;

    /// Whether yaws are tried.
    bool yawed() const { return !yaws_.empty(); }

private:
    void find_posture(EstimatedContact& contact, double& lead, ToolLift::Hint& hint) const;
    /// The widths of its posture; where they are not enough for a gap (mm), of the one that comes nearest to
    /// that.
    void find_widths(EstimatedContact& contact, double gap, ToolLift::Hint& hint) const;

    const FiveAxisField& field_;
    double leave_;
    bool is_ball_;             ///< at its tip
    std::vector<double> yaws_; ///< from yaw 0 outward; none where postures have none
};

} // namespace facetmill
