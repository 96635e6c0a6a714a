#include "ui/camera_flight.h"

#include "ui/viewport.h"

#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {

/// Directions of unit length that are as near are the same.
constexpr double same_sight = 1e-6;

} // namespace

CameraFlight::CameraFlight(Viewport& viewport) : QObject(&viewport), viewport_(viewport) {
    animation_.setDuration(200);
    animation_.setEasingCurve(QEasingCurve::InOutQuad);
    animation_.setStartValue(0.0);
    animation_.setEndValue(1.0);
    connect(&animation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
        const double t = value.toDouble();
        CameraPlace at = to_;
        at.target = from_.target + t * (to_.target - from_.target);
        at.height = from_.height * std::pow(to_.height / from_.height, t);
        // The axes of the screen turn along the shortest way.
        const auto frame = [](const CameraPlace& p) {
            Mat3 m;
            m << p.up.cross(p.toward_eye), p.up, p.toward_eye;
            return Eigen::Quaterniond(m);
        };
        const Mat3 turned = frame(from_).slerp(t, frame(to_)).toRotationMatrix();
        at.up = turned.col(1);
        at.toward_eye = turned.col(2);
        viewport_.scene().camera().look_at(t >= 1 ? to_ : at);
        viewport_.camera_moved();
    });
}

void CameraFlight::fly_to(const CameraPlace& place) {
    animation_.stop();
    from_ = viewport_.scene().camera().place();
    to_ = place;
    animation_.start();
}

bool CameraVisit::undisturbed() const {
    const CameraPlace now = viewport_.scene().camera().place();
    return flight_.flying()
           || ((now.toward_eye - at_.toward_eye).norm() < same_sight
               && (now.up - at_.up).norm() < same_sight);
}

void CameraVisit::to(const CameraPlace& place) {
    if (!before_ || !undisturbed()) before_ = viewport_.scene().camera().place();
    at_ = place;
    flight_.fly_to(place);
}

void CameraVisit::back() {
    const bool leads_back = before_ && undisturbed();
    const auto before = std::exchange(before_, std::nullopt);
    if (!leads_back) return;
    flight_.stop();
    viewport_.scene().camera().look_at(*before);
    viewport_.camera_moved();
    viewport_.fit();
}

} // namespace facetmill::ui
