#include "ui/same_place.h"

#include "ui/cspace_controller.h"
#include "ui/path_controller.h"
#include "ui/verification_controller.h"

namespace facetmill::ui {

namespace {
constexpr int place_rest_ms = 150; // a slider that is dragged on does not rest
} // namespace

SamePlace::SamePlace(const PathController& paths, VerificationController& verification,
                     CSpaceController& cspace, QObject* window)
    : Controller(window), paths_(paths), verification_(verification), cspace_(cspace) {
    rest_.setSingleShot(true);
    rest_.setInterval(place_rest_ms);
    connect(&rest_, &QTimer::timeout, this, &SamePlace::look);
    connect(&verification_.playback(), &PlaybackController::loaded_changed, &rest_, &QTimer::stop);
}

void SamePlace::place_shown(std::size_t source, std::size_t motion, double) {
    PlaybackController& playback = verification_.playback();
    if (!playback.loaded() || source >= paths_.paths().size()) return;
    const PlaybackTrack& track = playback.track();
    std::size_t at = 0;
    while (at < track.operation_count() && track.operation(at).result != paths_.paths().programs()[source])
        ++at;
    if (at == track.operation_count() || motion >= track.motions_of(at)) return;
    if (verification_.engaged() && track.place(playback.position()) == MotionPlace{at, motion}) {
        source_ = source;
        motion_ = motion;
        if (!playback.put_by_others()) rest_.start();
        return;
    }
    // A path that has just come is seen at its first cut, and played from its start.
    const auto start = paths_.start();
    const bool at_start =
        start && start->source == source && paths_.paths().motion_of(*start) == motion && at == 0;
    playback.put(at_start ? 0 : track.position_of({at, motion}));
}

void SamePlace::look() {
    if (verification_.playback().playing()) return;
    if (const auto pick = paths_.paths().pick_at(source_, motion_))
        cspace_.tool_placed(paths_.paths(), *pick);
    emit settled();
}

} // namespace facetmill::ui
