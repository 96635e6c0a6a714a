// Cuts a StockModel with the motions of programs, in order, and reports what must not touch: shank, holder,
// and the whole tool in rapids, against the stock as it is at that moment.
#pragma once

#include "core/base/progress.h"
#include "core/verify/cutting_load.h"
#include "core/verify/program.h"
#include "core/verify/stock_model.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

struct RemovalItem; // removal_batch.h
struct RemovalTouch;
struct StraightMove; // sweep.h

struct Collision {
    /// The body that touches in a motion at feed; `rapid`: some part of the tool, in a rapid.
    /// `cutter`: against fixtures alone; what it does to the part is a gouge.
    enum class Kind : std::uint8_t { shank, holder, rapid, cutter };
    Kind kind = Kind::rapid;
    bool with_part = false; ///< reaches into the part itself, not only into stock
    MotionPlace at;
    Vec3 place = Vec3::Zero();
    double depth = 0; ///< mm; in stock known to about the resolution, in the part as exactly as probes are
    std::string fixture = {}; ///< name of the fixture that is touched; empty: part or stock
};

/// The share of the lattice's resolution that `motion_bound` is unless something else is asked for.
inline constexpr double default_bound_share = 0.5;

/// Rounding of ends of rays and of coordinates; mm.
inline constexpr double air_depth = 1e-3;

/// Checks the programs before anything is cut: throws Error(non_finite, coordinate_range, out_of_range,
/// empty_result) that names program and GOTO.
void check_programs(std::span<const VerifyProgram> programs);

/// Cuts a stock. Not for two threads at once; a call spreads its work over threads.
class MaterialRemoval {
public:
    /// Motions whose axis turns are cut as straight ones that keep within `motion_bound` (mm) of the cutter's
    /// true place. Bodies that must not touch are made smaller by `touch` (mm), and by the bound where the
    /// axis turns, so that sliding along what the same tool has just cut is no collision. The programs must
    /// outlive this. `max_bytes`: see `cut`.
    MaterialRemoval(std::span<const VerifyProgram> programs, double motion_bound, double touch,
                    std::size_t max_bytes = std::size_t(-1));
    ~MaterialRemoval();

    /// From now on only the rays along this axis (0: x) are cut, a tenth of the work where cutters are long:
    /// for `air_length`. The other two families are no part of the stock any more.
    void cut_only_along(int axis) { only_ = axis; }

    /// Bytes that the rays of a stock will have when all motions that cut are done, estimated from the tiles
    /// that the motions' boxes reach. That is mostly more than is needed; it is less where rays are cut into
    /// many stretches.
    std::size_t bytes_needed(const StockModel& stock, const Progress& progress) const;

    /// How many times a ray of a stock is asked for what is cut from it: what cutting takes its time for, a
    /// third of a microsecond each. Estimated from the tools' shadows; rays of `resolution` (mm) in `stock`.
    double rays_asked(const Box3& stock, double resolution) const;

    /// Cuts with the motions [first, last) of a program, with the last one only up to the share `until` of
    /// it. A cancelled call leaves the stock partly cut. With `watch` the collisions are kept for
    /// `collisions`. Throws Error(limit_exceeded) as soon as the rays have grown by more than `max_bytes`.
    void cut(StockModel& stock, std::size_t program, std::size_t first, std::size_t last, double until,
             bool watch, const Progress& progress);
    /// Length of the motions of a program at feed, so far, that took nothing away: of pieces no longer than
    /// the cutter is wide, those in which it met no ray of the stock as it stood then. What is thinner than
    /// `air_depth` is nothing; where the axis turns, what the bound leaves of an earlier motion is something.
    double air_length(std::size_t program) const { return air_[program]; }
    /// What a program's cutter has taken away so far, and how much of it at once: of stretches of the path as
    /// long as the cutter is wide (cutting_load.h).
    const CuttingLoad& load(std::size_t program) const { return meters_[program].load(); }
    /// The collisions so far: the deepest of each motion and kind, in the order of motions.
    std::vector<Collision> collisions() const;

private:
    struct Bodies;
    /// What a meter is told once it is known what was cut: of a piece of a motion at feed, or a rapid.
    struct Step {
        std::size_t program, motion;
        double length = 0;                  ///< mm
        std::size_t item = std::size_t(-1); ///< that cuts it; -1: none does
        bool lifts = false;                 ///< a rapid
    };
    void add_cut(const StraightMove& move, std::size_t program, std::size_t motion, const Box3& stock_box,
                 std::vector<RemovalItem>& items);
    void flush(StockModel& stock, std::vector<RemovalItem>& items, const Progress& progress);
    void tell_meters(const std::vector<double>& volumes);
    void keep(const std::vector<std::vector<RemovalTouch>>& touches, const RemovalItem& first);

    std::span<const VerifyProgram> programs_;
    double motion_bound_, touch_;
    std::size_t max_bytes_;
    std::ptrdiff_t grown_ = 0;      ///< bytes of the rays cut so far
    std::vector<Bodies> bodies_;    ///< per program
    std::vector<double> air_;       ///< per program, mm
    std::vector<LoadMeter> meters_; ///< per program
    std::vector<Step> steps_;       ///< since the last flush
    int only_ = -1;                 ///< see cut_only_along
    std::vector<RemovalTouch> touches_;
};

} // namespace facetmill
