// What lines of a plan leave over places of the part: the contact of a tip, and the distance from there along
// the normal to the swept cutter of a line (CutterCover::ray_entry).
#pragma once

#include "core/mesh/geometry.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/lift_line.h"

#include <memory>
#include <vector>

namespace facetmill {

/// The tip's path in one drive plane.
struct DriveLine {
    double v = 0;
    /// How far before and behind the plane places are that it is to cut: its ends lie where the domain ends
    /// in this strip (a slanted border is met by each plane at another u).
    double back = 0, ahead = 0;
    std::vector<std::vector<LinePoint>> runs; ///< s is u; one per piece of the domain, in order
};

struct StepOverInput {
    const Mesh* mesh = nullptr;
    ContactIndexPtr contact;
    const AxialLift* lift = nullptr;
    const CutterCover* cover = nullptr;
    const ContactDomain* domain = nullptr;
    DriveFrame frame;
    double allowance = 0; ///< all that is left along the normal, as in `lift`
    double floor = 0;     ///< lowest height of the tip
    double cusp = 0.05;   ///< largest allowed
    double merge = 0;     ///< gaps of the domain up to this are passed over
    CuspLook look;
};

class CuspField {
public:
    explicit CuspField(const StepOverInput& input);

    /// Where a tip at (u, v) touches the part.
    struct Sample {
        Vec3 point, normal;
        double tip_z = 0;
        bool valid = false;
    };
    Sample sample(double u, double v, LiftHint& hint) const;
    /// At many (u, v) that are close together.
    std::vector<Sample> samples(const std::vector<Vec2>& places, const Progress& progress) const;
    /// A line near a place along it, looked up once for all that is asked there.
    struct Near {
        const DriveLine* line = nullptr;
        double u = 0;
        std::size_t begin = 0, end = 0; ///< runs that come near enough
        std::size_t piece = 0;          ///< of the first of them, at u
    };
    Near near(const DriveLine* line, double u) const;
    /// Height along n over p that a line leaves; infinite without a line or where it does not come by.
    double entry(const Near& near, const Vec3& p, const Vec3& n) const;
    /// Height that two lines leave over a sample.
    double left_at(const Near& a, const Near& b, const Sample& s) const {
        return std::min(entry(a, s.point, s.normal), entry(b, s.point, s.normal));
    }
    /// Height of a line's tip at u.
    double height_on(const DriveLine& line, double u) const;
    /// Height of the part, seen from above.
    double surface_z(double x, double y) const { return surface_.tip_z(x, y); }

    const StepOverInput& input() const { return in_; }
    const LiftField& lift() const { return field_; }
    /// Distance of places that are looked at along a line.
    double spacing() const { return grid_; }
    /// Step-over that leaves the allowed cusp on a level plane.
    double level_step() const { return level_; }
    /// True where the corner of the cutter's profile is sharp, or nearly so.
    bool sharp() const { return sharp_; }

private:
    Sample sample_of(const Vec2& xy, const AxialContact& contact) const;
    /// Entries at the ends of a piece; not a number where they are not known yet, or not wanted.
    struct Ends {
        double a = std::numeric_limits<double>::quiet_NaN(), b = a;
    };
    double piece_entry(const DriveLine& line, const std::vector<LinePoint>& run, std::size_t k, const Vec3& p,
                       const Vec3& n, Ends& ends) const;
    /// True where the entry surely does not become less from one tip to another; `entry` is that at the
    /// first.
    bool rises(const Vec3& from, const Vec3& to, const Vec3& p, const Vec3& n, double entry) const;
    /// The smallest along a run, on the piece k or where it leads to.
    double run_entry(const DriveLine& line, const std::vector<LinePoint>& run, std::size_t k, double u,
                     const Vec3& p, const Vec3& n) const;

    StepOverInput in_;
    LiftField field_;
    AxialLift surface_; ///< a needle's: the part seen from above
    double grid_, level_;
    bool sharp_;
};

} // namespace facetmill
