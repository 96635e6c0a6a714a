// Moves the view to a place in a fifth of a second, so that one sees where it is.
#pragma once

#include "viz/scene.h"

#include <QVariantAnimation>

#include <optional>

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

/// Looks at something for a while, and back again.
class CameraVisit {
public:
    CameraVisit(Viewport& viewport, CameraFlight& flight) : viewport_(viewport), flight_(flight) {}
    /// Flies there; from one visit to the next it is still the first place that `back` leads to.
    void to(const CameraPlace& place);
    /// At once, and fitted; not where the view was turned since.
    void back();

private:
    bool undisturbed() const;

    Viewport& viewport_;
    CameraFlight& flight_;
    std::optional<CameraPlace> before_;
    CameraPlace at_;
};

} // namespace facetmill::ui
