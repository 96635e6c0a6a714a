// Samples of a turning part's surface, and those among them that the cutter does not serve where it would
// touch the facet's plane. Millimetres, radians.
#pragma once

#include "core/strategy/lathe/lathe_probe.h"

#include <vector>

namespace facetmill {

struct ReachSample {
    double angle = 0, y = 0, area = 0, distance = 0; ///< where on the part; angle from 0 up to a turn
    double half = 0;                                 ///< half the side of the square that it stands for
    bool alone = false; ///< no other sample says how far what it stands for reaches
    bool sure = false;  ///< searched thoroughly
    Vec3 p = Vec3::Zero(), n = Vec3::Zero();
    LathePoint at; ///< the cutter where it came nearest
    UnreachedRegion::Why why = UnreachedRegion::Why::narrow;
};

class ReachSampler {
public:
    /// All of it must outlive this.
    ReachSampler(const LatheCommon& settings, const LatheProbe& probe, const Mesh& mesh);

    /// Distance of samples: hollows of the allowed depth are as wide.
    double spacing() const { return spacing_; }

    struct Found {
        double area = 0; ///< all that was looked at, mm^2
        std::vector<ReachSample> doubtful;
    };
    Found facets(const Progress& progress) const;

    /// Adds p to `doubtful` where the cutter that would touch the facet's plane there does not serve it.
    void sample(const Vec3& p, const Vec3& facet_normal, double area, bool alone, LatheField::Hint& hint,
                std::vector<ReachSample>& doubtful) const;
    /// True for a facet that lies in an end of the part and faces along the axis.
    bool is_end(std::size_t f, const Vec3& n) const;
    /// True beyond a start or stop that the settings name.
    bool is_beyond(double along) const {
        return (named_from_ && along < probe_.range().from) || (named_to_ && along > probe_.range().to);
    }

private:
    const LatheProbe& probe_;
    const Mesh& mesh_;
    bool named_from_, named_to_;
    double spacing_ = 1, from_ = infinity, to_ = -infinity; ///< the part's ends along the axis
};

} // namespace facetmill
