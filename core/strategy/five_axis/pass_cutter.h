// Placed passes to cut ones, in machining order: configuration spaces, postures, joined motion. The postures
// of a line are chosen when the first points of the next one are known, so that the tool ends where that is
// best begun.
#pragma once

#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/kept_postures.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/five_axis/posture_study.h"
#include "core/strategy/five_axis/unfree_points.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// What the passes of an operation have become.
struct CutPasses {
    std::vector<Pass> passes;
    std::vector<CutterContact> uncut;                 ///< contact points left to clean-up
    double cusp_max = 0;                              ///< without the chord's share, mm
    double lead_min = infinity, lead_max = -infinity; ///< leads used, radians
    struct Seconds {
        double bottom = 0, top = 0, postures = 0;
    } seconds; ///< wall time
};

class PassCutter {
public:
    explicit PassCutter(const FiveAxisField& field);

    /// The lines of a pass, placed; cuts all but the last of them, after what was left of the pass before.
    void add(std::vector<PlacedLine> pass, int drive, double v, const Progress& progress);
    /// Cuts the line that is left.
    void finish(const Progress& progress);

    CutPasses& done() { return done_; }
    const std::shared_ptr<FiveAxisRecord>& record() const { return record_; }
    const UnfreePoints& unfree() const { return unfree_; }
    const KeptPostures& kept() const { return kept_; }

private:
    /// A line whose postures are chosen when the one after it is known.
    struct Pending {
        PlacedLine placed;
        PostureStudy study;
        int drive = 0;
        double v = 0;
    };
    PostureStudy study(PlacedLine& line, const Progress& progress);
    /// Chooses the postures of a line and makes its passes. `next`: points of the line that comes after.
    void cut(Pending& line, std::span<const PassPoint> next, const Progress& progress);
    void add_run_outs(PlacedLine& line) const;
    std::optional<ToolPose> last_pose() const;

    const FiveAxisField& field_;
    std::shared_ptr<FiveAxisRecord> record_;
    std::unique_ptr<Pending> pending_;
    KeptPostures kept_;
    UnfreePoints unfree_;
    CutPasses done_;
};

} // namespace facetmill
