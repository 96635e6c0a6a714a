// The stock at any moment of the programs, for playback: forward by cutting, backward from checkpoints.
#pragma once

#include "core/base/progress.h"
#include "core/verify/stock_model.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// Not for two threads at once. Positions count motions over all programs, in order: position p + s, 0 <= s <
/// 1, is s of the way through motion p, p = motion_count() the end; before motion 0 the stock is whole.
class StockPlayback {
public:
    /// Throws as `verify`. Cancellation per tile.
    StockPlayback(const StockSolid& stock, std::vector<VerifyProgram> programs, double resolution,
                  const Progress& progress);
    ~StockPlayback();

    std::size_t motion_count() const;
    MotionPlace place(double position) const;
    /// The first position of a program; motion_count() for the number of programs.
    std::size_t first_motion(std::size_t program) const;
    CutterLocation location(double position) const;
    MotionKind kind(double position) const;
    double position() const;

    /// Cuts or takes back. Cancellation within 20 ms; a cancelled call leaves the playback somewhere on the
    /// way, whole.
    void go_to(double position, const Progress& progress);
    const StockModel& stock() const;

    /// The surface in patches, always the same number in the same order; a patch whose material has not
    /// changed since the last call is the same object, one without surface is null.
    const std::vector<std::shared_ptr<const StockPatch>>& patches(const Progress& progress);

private:
    void forward(double position, const Progress& progress);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace facetmill
