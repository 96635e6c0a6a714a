// Moves the view to a place in a fifth of a second, so that one sees where it is.
#pragma once

#include "viz/scene.h"

#include <QVariantAnimation>

namespace facetmill::ui {

class Viewport;

class CameraFlight : public QObject {
    Q_OBJECT
public:
    explicit CameraFlight(Viewport& viewport);
    /// From where the camera is now; a flight under way gives way.
    void fly_to(const CameraPlace& place);
    /// Where it has come to.
    void stop() { animation_.stop(); }
    bool flying() const { return animation_.state() == QAbstractAnimation::Running; }

private:
    Viewport& viewport_;
    CameraPlace from_, to_;
    QVariantAnimation animation_;
};

} // namespace facetmill::ui
