#include "ui/playback_display.h"

#include "ui/viewport.h"

#include <cmath>
#include <utility>

namespace facetmill::ui {

void PlaybackDisplay::show_tool(bool turns, bool still) {
    const PlaybackTrack& track = playback_.track();
    const std::size_t program = track.place(playback_.position()).program;
    Scene& scene = viewport_.scene();
    if (shown_operation_ != program || !scene.has(Layer::tool)) {
        shown_operation_ = program;
        try {
            scene.tool().set(track.operation(program).tool);
        } catch (const Error&) {
            scene.tool().set(std::nullopt);
        }
    }
    const CutterLocation tool = playback_.tool();
    scene.tool().set_pose(tool);
    turn_view(turns ? track.operation(program).turning : std::nullopt, tool, still);
}

/// The eye goes round with the tool, so that on the screen the tool stands and the part turns, as on the
/// machine.
void PlaybackDisplay::turn_view(const std::optional<TurningAxis>& turning, const CutterLocation& tool,
                                bool still) {
    const std::optional<Vec3> before =
        std::exchange(turned_to_, turning ? std::optional(tool.axis) : std::nullopt);
    if (!turning || !before || still) return;
    const Vec3& d = turning->direction;
    const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(d) * d); };
    const Vec3 a = across(*before), b = across(tool.axis);
    const double angle = std::atan2(d.dot(a.cross(b)), a.dot(b));
    if (angle == 0) return;
    const Eigen::AngleAxisd turn(angle, d);
    CameraPlace place = viewport_.scene().camera().place();
    place.target = turning->point + turn * (place.target - turning->point);
    place.toward_eye = turn * place.toward_eye;
    place.up = turn * place.up;
    viewport_.scene().camera().look_at(place);
}

void PlaybackDisplay::show_stock() {
    const auto stock = playback_.stock(), fine = playback_.fine_stock();
    Scene& scene = viewport_.scene();
    // What is all new comes by steps; a few patches more or less are drawn at once.
    const bool fresh = (!stock.empty() && !stock_shown_) || (!fine.empty() && !fine_shown_);
    stock_shown_ = !stock.empty();
    fine_shown_ = !fine.empty();
    scene.stock().set_cut(stock, fine);
    if (fresh)
        viewport_.content_changed();
    else
        viewport_.refresh();
}

} // namespace facetmill::ui
