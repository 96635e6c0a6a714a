// Tool paths ready to be drawn: polylines per kind of motion around a common centre.
#pragma once

#include "core/base/progress.h"
#include "core/setup/motion.h"
#include "core/strategy/plan/path.h"
#include "viz/palette.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

struct OperationResult; // core/job/planner.h

/// The path of one operation. Either may be missing.
struct PathSource {
    std::shared_ptr<const StrategyResult> contacts;
    std::shared_ptr<const ToolMotions> motions;
    /// The layer of a roughing path that alone is drawn and picked, with what leads to its cuts; -1: all.
    int layer = -1;
    std::shared_ptr<const std::vector<int>> motion_layers; ///< layer of every motion, where `layer` is one
    bool hidden = false; ///< nothing of it is drawn or picked; another's layer is seen alone

    bool shows(const Pass& pass) const { return !hidden && (layer < 0 || pass.layer == layer); }
    bool shows_motion(std::size_t motion) const {
        return !hidden && (layer < 0 || !motion_layers || (*motion_layers)[motion] == layer);
    }
};

/// Shares the operation's result.
PathSource path_source(const std::shared_ptr<const OperationResult>& operation, int layer = -1);

/// Open polylines in flat arrays: line i runs over points[offsets[i]] .. points[offsets[i + 1] - 1].
struct Polylines {
    std::vector<float> points; ///< 3 per point, relative to the display's centre
    std::vector<std::int32_t> offsets{0};
    bool empty() const { return offsets.size() < 2; }
};

struct PathDisplay {
    std::vector<PathSource> sources;
    Vec3 center = Vec3::Zero();
    Box3 box; ///< holds all CC and CL points
    Polylines contacts;
    /// Dots, 3 numbers each as in Polylines: contact points left to clean-up, and those of a posture kept by
    /// hand.
    std::vector<float> left_points, kept_points;
    double contact_spacing = 0;                  ///< mean distance of neighbours on a pass, mm
    std::array<Polylines, motion_kinds> motions; ///< one per MotionKind; rapids are dashed
    /// Fewer points, drawn while the view moves; of long paths only, otherwise empty.
    Polylines contacts_preview;
    std::array<Polylines, motion_kinds> motions_preview;
};

using PathDisplayPtr = std::shared_ptr<const PathDisplay>;

/// A kind of motion with more points than this has a preview of about as many.
inline constexpr std::size_t largest_path_without_preview = 60'000;

/// Points that are not finite are left out.
PathDisplayPtr prepare_path_display(std::vector<PathSource> sources, const Progress& progress);

} // namespace facetmill
