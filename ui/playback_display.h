// Playback in the 3D view: the tool at its place, the stock as it is cut so far, and the eye that goes round
// with the tool where the part turns.
#pragma once

#include "ui/playback_controller.h"
#include "viz/scene.h"

#include <optional>

namespace facetmill::ui {

class Viewport;

class PlaybackDisplay {
public:
    PlaybackDisplay(Viewport& viewport, const PlaybackController& playback)
        : viewport_(viewport), playback_(playback) {}

    /// The tool at the position that is shown. `turns`: a part that turns is seen turning; `still`: the eye
    /// stays for this time.
    void show_tool(bool turns, bool still);
    void show_stock();
    /// The view was given another tool from elsewhere.
    void forget_tool() { shown_operation_ = std::size_t(-1); }

private:
    void turn_view(const std::optional<TurningAxis>& turning, const CutterLocation& tool, bool still);

    Viewport& viewport_;
    const PlaybackController& playback_;
    std::size_t shown_operation_ = std::size_t(-1); ///< whose tool the view has from here
    std::optional<Vec3> turned_to_;                 ///< the tool axis that the view stands to
    bool stock_shown_ = false, fine_shown_ = false;
};

} // namespace facetmill::ui
