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

/// The stock at a position. Positions count the motions of all programs, in order: position p + s, 0 <= s <
/// 1, is a share s of motion p, and motion_count() is the end; at position 0 the stock is whole. Not for two
/// threads at once.
class StockPlayback {
public:
    /// `resolution` (mm) is that of the stock's lattice. Throws as `verify`.
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

    /// Cuts on or takes back. A cancelled call leaves the playback at some position between, and whole.
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
