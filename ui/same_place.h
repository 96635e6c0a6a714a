// Playback and what inspects a path are at one point: where the tool is put in a view, a chart or the
// configuration space, playing goes on from there, and where a playback rests, the configuration space goes.
#pragma once

#include "ui/controller.h"

#include <QTimer>

namespace facetmill::ui {

class CSpaceController;
class PathController;
class VerificationController;

class SamePlace : public Controller {
    Q_OBJECT
public:
    SamePlace(const PathController& paths, VerificationController& verification, CSpaceController& cspace,
              QObject* window);

    void place_shown(std::size_t source, std::size_t motion, double share) override;
    bool busy() const override { return rest_.isActive(); }

private:
    /// A playback stands somewhere.
    void look();

    const PathController& paths_;
    VerificationController& verification_;
    CSpaceController& cspace_;
    QTimer rest_;
    std::size_t source_ = 0, motion_ = 0; ///< where it stands
};

} // namespace facetmill::ui
