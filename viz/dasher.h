// Lines cut into dashes.
#pragma once

#include "viz/path_display.h"

namespace facetmill {

/// Dashes of 3/5 of a period, mm, as polylines of two points relative to a centre.
class Dasher {
public:
    Dasher(Polylines& out, const Vec3& center, double dash) : out_(out), center_(center), dash_(dash) {}

    void restart() { phase_ = 0.0; }
    /// Cuts the segment into dashes of 3/5 of the period; the pattern runs on from segment to segment.
    void add(const Vec3& from, const Vec3& to) {
        const double length = (to - from).norm();
        if (!(length > 0.0)) return;
        const double on = 0.6 * dash_;
        double at = 0.0;
        while (at < length) {
            const bool drawing = phase_ < on;
            const double step = std::min(length - at, (drawing ? on : dash_) - phase_);
            if (drawing)
                segment(from + (to - from) * (at / length), from + (to - from) * ((at + step) / length));
            at += step;
            phase_ += step;
            if (phase_ >= dash_ * (1.0 - 1e-12)) phase_ = 0.0;
            if (!(step > 0.0)) break; // below the resolution of `at`
        }
    }

private:
    void segment(const Vec3& a, const Vec3& b) {
        for (const Vec3& p : {a, b}) {
            const Vec3 at = p - center_;
            out_.points.insert(out_.points.end(), {float(at.x()), float(at.y()), float(at.z())});
        }
        out_.offsets.push_back(std::int32_t(out_.points.size() / 3));
    }
    Polylines& out_;
    const Vec3 center_;
    const double dash_;
    double phase_ = 0.0;
};

} // namespace facetmill
