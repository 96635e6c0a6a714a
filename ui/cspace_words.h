// What the configuration space says of postures, in words.
#pragma once

#include "core/base/units.h"
#include "core/strategy/five_axis/five_axis_study.h"

#include <QString>

namespace facetmill::ui {

/// "-12.3°", with a real minus sign.
QString posture_angle_text(double radians);
/// As the readouts have coordinates: what is below their last digit is nothing.
QString lift_text(double mm, LengthUnit unit);
/// Lead, yaw and, if wanted, lift of a posture at a studied point, why it is free or not, and between which
/// lifts.
QString posture_reason_text(const FiveAxisStudy& study, const FiveAxisStudy::Point& point,
                            const PostureValue& posture, bool with_lift, LengthUnit unit);

} // namespace facetmill::ui
