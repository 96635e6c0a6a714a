// The judge of every tool path: an independent model of the stock is cut with the motions, and what is left
// is compared with the part. Two methods check each other:
//
//   probes   Through samples of the part's surface run lines along the surface's normal. The swept tool is
//   exact on
//            them, so gouges and what is left (cusps) are known to rounding at the samples; between samples
//            they can be larger, by what `sample_spacing` lets through.
//   stock    Rays on a lattice (stock_model.h) hold the stock as it is at each moment: for shank, holder and
//   rapids,
//            which must not touch it, for playback, and for the surface that is written.
//
// Where the axis turns, a motion is cut into straight ones with a fixed axis, short enough that no point of
// the cutting tool is farther than `motion_bound` from where it should be; probes cut finer where it matters.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/outward.h"
#include "core/verify/loose_pieces.h"
#include "core/verify/program.h"
#include "core/verify/removal.h"
#include "core/verify/stock_model.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// How much a verification does, estimated before it begins: orders of magnitude.
struct VerifyWork {
    double rays_asked = 0; ///< MaterialRemoval::rays_asked
    double places = 0;     ///< of the part, compared
    double bytes = 0;      ///< of the stock's rays and the places, at most
    double seconds = 0;    ///< with as many threads as loops use
};

/// What is asked of the judge. Lengths in mm.
struct VerifySettings {
    double resolution = 0; ///< of the stock's lattice; 0: a twentieth of the smallest cutter's radius,
                           ///< coarser where the stock would have more than `usual_rays`
    double sample_spacing =
        0; ///< of the probes; 0: as the resolution. Coarser where they would be more than `max_samples`
    double motion_bound = 0; ///< 0: half the resolution
    double tolerance = 0; ///< what may be left: more counts as over, more than twice as uncut; 0: not judged
    double gouge_limit = 0; ///< surface that came deeper inside a cutter is gouged
    /// The share of the area to be cut (seen by a tool axis, away from open borders) that may stay uncut.
    double uncut_limit = 0.02;
    OpenSide open_side = OpenSide::found; ///< of the part's open surfaces: which side is outside
    /// The stock was cut before: surface that it falls short of by no more than the resolution, which is what
    /// its own surface is known to, has been cut already, and is not one that the stock does not reach.
    bool cut_before = false;
    bool look_for_pieces = false; ///< whether what is left of the stock is several pieces, see loose_pieces.h
    double allowance = 0;         ///< what is to be made is the part grown by this along its normals
    std::size_t usual_rays = 30'000'000;
    /// Coarser as well where cutting would ask rays more often (MaterialRemoval::rays_asked), down to an
    /// eighth of the narrowest cutter's radius.
    double usual_rays_asked = infinity;
    /// 0: two million; half a million where axes turn, which takes longer. Up to four times as many where
    /// fewer would be too far apart for a verdict.
    std::size_t max_samples = 0;
    /// Told how much is to be done before anything is; what it throws, `verify` throws.
    std::function<void(const VerifyWork&)> before_work = nullptr;
    /// Told before the stock is cut, where it is known by then that faults may be found, but nothing can be
    /// verified: why, as in Verification::not_judged. What it throws, `verify` throws.
    std::function<void(const std::string&)> cannot_verify = nullptr;
    /// Memory of the stock's rays, which are kept only where something is cut; beyond it `verify` refuses.
    std::size_t max_stock_bytes = 2'500'000'000;
    LengthUnit unit = LengthUnit::mm; ///< of lengths in remarks and errors; figures are in mm all the same
};

/// What became of the part's surface. Positive: so much stands on it, along its outward normal; where that is
/// more than twice the tolerance, so far from all of the part. Negative: so deep (the distance to the
/// cutter's surface) it came to lie inside a cutter.
struct DeviationSurface {
    enum Flag : std::uint8_t {
        counted = 0, ///< in all figures
        border =
            1,    ///< within a cutter's radius of the part's open border, where no path goes on: gouges only
        away = 2, ///< faces no tool axis of the programs (walls, undersides): gouges only
        bare = 4, ///< the stock itself does not reach the surface here
        hidden = 8, ///< no tool axis of the programs comes here past the part: gouges only
        gouges_only = away | bare | hidden,
    };
    std::vector<std::array<float, 3>> points, normals;
    std::vector<float> deviation;
    std::vector<std::uint8_t> flags;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< the part's facets, the larger ones divided
};

/// What the samples of some of the surface say. Lengths in mm; percentiles are of the area.
struct DeviationFigures {
    std::size_t samples = 0;
    double area = 0;      ///< mm^2 the samples stand for
    double gouge_max = 0; ///< >= 0
    double excess_p50 = 0, excess_p95 = 0, excess_p99 = 0, excess_p999 = 0, excess_max = 0;
    double over_fraction = 0;  ///< of the area: more than the tolerance is left
    double uncut_fraction = 0; ///< of the area: more than twice the tolerance is left
};

struct SlopeBand {
    double from = 0, to = 0; ///< angle between normal and the nearest tool axis, radians
    DeviationFigures figures;
};

/// A place of the part and what happened there.
struct DeviationExtreme {
    Vec3 point, normal;
    double deviation = 0;
    MotionPlace by; ///< the motion that cut deepest there; unknown where none did
};

/// Why surface that a tool axis sees stays uncut.
struct UncutReason {
    enum class Why : std::uint8_t {
        not_cut,       ///< a tool fits in there, and no motion goes
        passes_apart,  ///< a tool fits in there, and what stands was left by a pass that goes by
        held,          ///< the cutter fits in there, shank or holder do not
        stock,         ///< a tool fits in there, its shank or holder in what is left of the stock
        below_bottom,  ///< a tool fits in there, lower than the stock's bottom and than its program goes
        fixture,       ///< a tool fits in there, nearer to a fixture than its clearance
        tab,           ///< a tool fits in there, and would cut a tab that is to stay
        boundary,      ///< a tool fits in there, and its operation is told to stay out
        no_operation,  ///< only a tool fits in there whose operation leaves more than counts as uncut
        no_tool,       ///< no cutter of the programs fits in there
        outside_stock, ///< the stock does not reach it
        not_seen,      ///< no tool axis sees it: told, and no part of the verdict
        upright,       ///< a wall along the tool axis, which asks for no pass of its own: told, no part of it
    };
    Why why = Why::not_cut;
    std::string program;       ///< whose tool fits, or its cutter; empty: none does
    double area = 0;           ///< mm^2
    double excess_max = 0;     ///< mm
    Vec3 place = Vec3::Zero(); ///< of the largest excess
    bool counts() const { return why != Why::not_seen && why != Why::upright; }
};

enum class Verdict : std::uint8_t { verified, failed, not_judged };

struct Verification {
    std::shared_ptr<const StockModel> stock;
    std::shared_ptr<const DeviationSurface> surface;
    DeviationFigures figures, border;       ///< away from open borders; near them
    std::vector<SlopeBand> bands;           ///< 0-15, 15-30, ... 75-90 degrees
    std::vector<double> program_gouges;     ///< deepest gouge that each program cut, >= 0
    std::vector<double> program_air;        ///< MaterialRemoval::air_length of each program, mm
    std::vector<CuttingLoad> program_loads; ///< MaterialRemoval::load of each program
    std::vector<DeviationExtreme>
        gouges; ///< the ten deepest beyond the limit, at least a cutter's radius apart
    std::vector<DeviationExtreme> excess; ///< the ten highest over the tolerance, likewise
    std::vector<Collision> collisions;    ///< in the order of motions; the deepest of each motion and kind
    std::vector<UncutReason> uncut;       ///< by reason and tool: what counts, then what is told
    double uncut_share = 0;               ///< of the area to be cut, in [0, 1]
    double not_judged_share = 0; ///< of the area that tool axes see: near open borders; 1: see `not_judged`
    std::string not_judged;      ///< why nothing can be said of the whole; empty where it can
    std::optional<LoosePieces> loose; ///< what is left is several pieces: told, and no part of the verdict
    std::vector<std::string> remarks; ///< one sentence each: what was not judged and why
    VerifySettings used;              ///< with what 0 stood for
    double seconds_cutting = 0, seconds_probing = 0;

    bool gouged() const {
        return figures.gouge_max > used.gouge_limit || border.gouge_max > used.gouge_limit;
    }
    bool left_uncut() const { return uncut_share > used.uncut_limit; }
    /// What was found stands, however coarsely it was looked for; that nothing was found may mean nothing.
    Verdict verdict() const { return verdict_where(gouged() || !collisions.empty()); }
    /// The verdict on a program, by whether it gouged or collided. What stays uncut is the fault of no single
    /// one: it is told of them all.
    Verdict verdict_where(bool found) const {
        if (found || left_uncut()) return Verdict::failed;
        return not_judged.empty() ? Verdict::verified : Verdict::not_judged;
    }
    bool passed() const { return verdict() == Verdict::verified; }
};

/// Cuts `stock` with the programs, in order, and compares what is left with `part`. Throws
/// Error(out_of_range, empty_result, limit_exceeded, non_finite) that names program and GOTO.
Verification verify(const Mesh& part, const StockSolid& stock, std::span<const VerifyProgram> programs,
                    const VerifySettings& settings, const Progress& progress);

/// The same cutting alone, without a look at the part: what the programs leave of the stock.
std::shared_ptr<const StockModel> stock_after(const StockSolid& stock,
                                              std::span<const VerifyProgram> programs,
                                              const VerifySettings& settings, const Progress& progress);

} // namespace facetmill
