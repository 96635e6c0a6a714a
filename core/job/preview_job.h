// The preview of an operation's passes (core/strategy/preview) as a project asks for it: its part, boundaries
// and tools on a coarse grid, kept from one change to the next.
#pragma once

#include "core/job/planner.h"
#include "core/setup/turning_axis.h"
#include "core/strategy/preview/pass_preview.h"

#include <memory>

namespace facetmill {

/// One preview at a time: not to be called from two threads at once.
class PassPreviewer {
public:
    /// The passes of operation `i` of the project's shown setup, in the setup's coordinates. `part` is the
    /// project's. Throws Error(limit_exceeded) for a part of more facets than `max_facets`,
    /// Error(missing_reference) for a boundary or tool that is not there, and what preview_passes does.
    PassPreview preview(const Project& project, std::size_t i, const PreparedPart& part,
                        const Progress& progress, std::size_t max_facets = max_previewed_facets);
    /// The part seen along Z, as previews have it.
    std::shared_ptr<const CoarseGround> ground(const PreparedPart& part, const Progress& progress) {
        return view(part, Mat3::Identity(), progress).ground;
    }

private:
    /// What the part is along one tool axis.
    struct View {
        MeshPtr kept_off; ///< what it was made of
        Mat3 turn = Mat3::Identity();
        MeshPtr part;
        std::shared_ptr<const CoarseGround> ground;
        std::optional<double> travel; ///< auto
    };
    View& view(const PreparedPart& part, const Mat3& turn, const Progress& progress);
    std::vector<char> cells(const Project& project, const std::string& boundary, const PreparedPart& part,
                            const View& view, const Progress& progress) const;

    std::shared_ptr<const TurnedGround> turned(const MeshPtr& part, const LatheCommon& settings,
                                               const PlanContext& context, const Progress& progress);

    std::vector<View> views_; ///< the last used first
    MeshPtr turned_part_;     ///< of `turned_`
    TurningAxis axis_;
    std::shared_ptr<const TurnedGround> turned_;
};

} // namespace facetmill
