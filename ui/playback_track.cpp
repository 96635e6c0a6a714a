#include "ui/playback_track.h"

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/output/motion_time.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

namespace facetmill::ui {

/// What the thread aside follows and the track reads when that is done.
struct PlaybackTrack::Times {
    struct Followed {
        std::shared_ptr<const OperationResult> result;
        MotionTimeOptions options;
    };
    Job job;
    std::mutex mutex;
    std::condition_variable changed;
    bool done = false;
    std::vector<double> ends;
    std::exception_ptr failure;

    void follow(const std::vector<Followed>& programs, const Machine& machine) {
        std::vector<double> followed;
        std::exception_ptr failed;
        try {
            double time = 0;
            for (const auto& [result, options] : programs)
                for (const double seconds : motion_seconds(result->program, machine, options, Progress(job)))
                    followed.push_back(time += seconds);
        } catch (const Cancelled&) {
            return; // the track is gone
        } catch (...) {
            failed = std::current_exception(); // told to whoever asks
        }
        {
            const std::lock_guard lock(mutex);
            ends = std::move(followed);
            failure = failed;
            done = true;
        }
        changed.notify_all();
    }
};

PlaybackTrack::PlaybackTrack(std::vector<Operation> operations, const Machine& machine)
    : operations_(std::move(operations)), times_(std::make_shared<Times>()) {
    std::vector<Times::Followed> programs;
    std::size_t count = 0;
    for (const Operation& o : operations_) {
        first_.push_back(count);
        count += o.result->program.motions.motions.size();
        programs.push_back({o.result, {.accelerations = o.accelerations}});
    }
    first_.push_back(count);
    // Not by do_aside, where a disk may keep it waiting.
    follower_ = std::thread([times = times_, programs = std::move(programs), machine] {
        lower_thread_priority();
        times->follow(programs, machine);
    });
}

PlaybackTrack::~PlaybackTrack() {
    times_->job.cancel();
    follower_.join();
}

const std::vector<double>& PlaybackTrack::ends() const {
    std::unique_lock lock(times_->mutex);
    times_->changed.wait(lock, [this] { return times_->done; });
    if (times_->failure) std::rethrow_exception(times_->failure);
    return times_->ends; // which nobody changes any more
}

double PlaybackTrack::seconds() const {
    double sum = 0;
    for (const Operation& o : operations_)
        sum += o.result->totals.time_seconds;
    return sum;
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
    if (motion_count() == 0 || position <= 0) return 0;
    const std::vector<double>& ends = this->ends();
    const auto motion = std::min(std::size_t(std::ceil(position)), ends.size()) - 1;
    const double before = motion > 0 ? ends[motion - 1] : 0.0;
    return before + (ends[motion] - before) * std::clamp(position - double(motion), 0.0, 1.0);
}

double PlaybackTrack::position_at(double seconds) const {
    const std::vector<double>& ends = this->ends();
    if (ends.empty() || seconds >= ends.back()) return double(ends.size());
    // Motions that take no time have ended as soon as the ones before them.
    const auto motion = std::size_t(std::upper_bound(ends.begin(), ends.end(), seconds) - ends.begin());
    const double before = motion > 0 ? ends[motion - 1] : 0.0;
    return double(motion) + std::max(0.0, seconds - before) / (ends[motion] - before);
}

} // namespace facetmill::ui
