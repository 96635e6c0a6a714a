// All motions of a plan in a row, for playback: which one is under way at a position, where the tool is, how
// long it has taken. Position p + s, 0 < s <= 1, is s of the way through motion p, so that a whole position n
// is "n motions are done" and belongs to the operation whose motion ended there. Position 0 is before
// everything.
#pragma once

#include "core/job/planner.h"
#include "core/setup/tool.h"
#include "core/verify/program.h"

#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace facetmill::ui {

class PlaybackTrack {
public:
    struct Operation {
        int id = 0; ///< in the document
        std::string name;
        std::optional<Tool> tool; ///< to be shown; none where it makes no cutter
        std::shared_ptr<const OperationResult> result;
        std::optional<TurningAxis> turning; ///< how the part turns, as the stock is cut with it
        bool accelerations = false;         ///< its time counts them
    };

    /// The operations of a plan in its order. When each motion has ended is followed on the machine in a
    /// thread of its own, which takes a while for a long path of five axes; whoever asks for it earlier
    /// waits.
    PlaybackTrack(std::vector<Operation> operations, const Machine& machine);
    ~PlaybackTrack();
    PlaybackTrack(const PlaybackTrack&) = delete;
    PlaybackTrack& operator=(const PlaybackTrack&) = delete;

    std::size_t motion_count() const { return first_.back(); }
    std::size_t operation_count() const { return operations_.size(); }
    const Operation& operation(std::size_t i) const { return operations_[i]; }
    std::size_t motions_of(std::size_t operation) const { return first_[operation + 1] - first_[operation]; }
    /// Motion that is under way or has just ended; of position 0 the first.
    MotionPlace place(double position) const;
    /// Where motion `place` has ended; its GOTO number is place.motion + 1.
    double position_of(const MotionPlace& place) const {
        return double(first_[place.program] + place.motion + 1);
    }
    const Motion& motion(const MotionPlace& place) const {
        return operations_[place.program].result->program.motions.motions[place.motion];
    }
    CutterLocation location(double position) const;
    /// Machining time from the start, seconds.
    double time_at(double position) const;
    double position_at(double seconds) const;
    /// All motions take so long, as the plan says; never waits.
    double seconds() const;

private:
    struct Times;
    const std::vector<double>& ends() const; ///< when each motion has ended
    std::vector<Operation> operations_;
    std::vector<std::size_t> first_; ///< motion of each operation, and the number of all
    std::shared_ptr<Times> times_;
    std::thread follower_;
};

using PlaybackTrackPtr = std::shared_ptr<const PlaybackTrack>;

} // namespace facetmill::ui
