#include "ui/playback_track.h"

#include "core/output/motion_time.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

PlaybackTrack::PlaybackTrack(std::vector<Operation> operations, const Machine& machine)
    : operations_(std::move(operations)) {
    double time = 0;
    for (const Operation& o : operations_) {
        first_.push_back(ends_.size());
        for (const double seconds : motion_seconds(o.result->program, machine))
            ends_.push_back(time += seconds);
    }
    first_.push_back(ends_.size());
}

MotionPlace PlaybackTrack::place(double position) const {
    const double last = double(std::max<std::size_t>(1, motion_count()));
    const auto motion = std::size_t(std::clamp(std::ceil(position), 1.0, last)) - 1;
    const auto after = std::upper_bound(first_.begin(), first_.end() - 1, motion);
    const auto program = std::size_t(after - first_.begin()) - 1;
    return {program, motion - first_[program]};
}

CutterLocation PlaybackTrack::location(double position) const {
    const MotionPlace at = place(position);
    const CutterLocation& to = motion(at).to;
    if (at.motion == 0) return to; // where the tool was before is not known
    const double share = std::clamp(position - (position_of(at) - 1), 0.0, 1.0);
    return location_between(motion({at.program, at.motion - 1}).to, to, operations_[at.program].turning,
                            share);
}

double PlaybackTrack::time_at(double position) const {
    if (ends_.empty() || position <= 0) return 0;
    const auto motion = std::min(std::size_t(std::ceil(position)), ends_.size()) - 1;
    const double before = motion > 0 ? ends_[motion - 1] : 0.0;
    return before + (ends_[motion] - before) * std::clamp(position - double(motion), 0.0, 1.0);
}

double PlaybackTrack::position_at(double seconds) const {
    if (ends_.empty() || seconds >= ends_.back()) return double(ends_.size());
    // Motions that take no time have ended as soon as the ones before them.
    const auto motion = std::size_t(std::upper_bound(ends_.begin(), ends_.end(), seconds) - ends_.begin());
    const double before = motion > 0 ? ends_[motion - 1] : 0.0;
    return double(motion) + std::max(0.0, seconds - before) / (ends_[motion] - before);
}

} // namespace facetmill::ui
