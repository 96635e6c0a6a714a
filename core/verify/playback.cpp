#include "core/verify/playback.h"

#include "core/base/parallel.h"
#include "core/verify/removal.h"
#include "core/verify/stock_surface.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {
/// Stocks that are kept over the programs: to go back costs at most a 64th of all cutting.
constexpr std::size_t checkpoints = 64;
} // namespace

struct StockPlayback::State {
    std::vector<VerifyProgram> programs;
    std::vector<std::size_t> first; ///< of each program, and the number of all motions
    StockModel stock;
    MaterialRemoval removal;
    StockSurface surface;
    double position = 0;
    std::map<std::size_t, StockModel> kept; ///< by whole motions that are cut
    std::size_t keep_every = 1;
    std::vector<std::shared_ptr<const StockPatch>> patches;
    std::vector<std::uint64_t> stamps;

    State(const StockSolid& solid, std::vector<VerifyProgram> all, double resolution,
          const Progress& progress)
        : programs(std::move(all)), stock(solid, StockLattice::over(solid.box, resolution), progress),
          removal(programs, default_bound_share * resolution, 0), surface(stock.lattice()) {
        for (const VerifyProgram& p : programs) {
            first.push_back(total);
            total += p.motions->motions.size();
        }
        first.push_back(total);
        keep_every = std::max<std::size_t>(1, total / checkpoints);
        kept.emplace(0, stock);
        patches.resize(surface.patch_count());
        stamps.resize(surface.patch_count(), std::uint64_t(-1));
    }
    std::size_t total = 0;
};

StockPlayback::StockPlayback(const StockSolid& stock, std::vector<VerifyProgram> programs, double resolution,
                             const Progress& progress) {
    check_programs(programs);
    state_ = std::make_unique<State>(stock, std::move(programs), resolution, progress);
}

StockPlayback::~StockPlayback() = default;

std::size_t StockPlayback::motion_count() const {
    return state_->total;
}

std::size_t StockPlayback::first_motion(std::size_t program) const {
    return state_->first[program];
}

MotionPlace StockPlayback::place(double position) const {
    const auto motion = std::size_t(std::clamp(position, 0.0, double(state_->total - 1)));
    const auto& first = state_->first;
    const auto program =
        std::size_t(std::upper_bound(first.begin(), first.end() - 1, motion) - first.begin()) - 1;
    return {program, motion - first[program]};
}

CutterLocation StockPlayback::location(double position) const {
    position = std::clamp(position, 0.0, double(state_->total));
    const MotionPlace at = place(position);
    const VerifyProgram& program = state_->programs[at.program];
    const auto& motions = program.motions->motions;
    const double share = position - double(state_->first[at.program] + at.motion);
    return location_between(motions[at.motion > 0 ? at.motion - 1 : 0].to, motions[at.motion].to,
                            program.turning, share);
}

MotionKind StockPlayback::kind(double position) const {
    const MotionPlace at = place(position);
    return state_->programs[at.program].motions->motions[at.motion].kind;
}

double StockPlayback::position() const {
    return state_->position;
}

const StockModel& StockPlayback::stock() const {
    return state_->stock;
}

void StockPlayback::forward(double position, const Progress& progress) {
    State& s = *state_;
    const double start = s.position;
    while (s.position < position) {
        const MotionPlace at = place(s.position);
        const std::size_t before = s.first[at.program];
        // To the end of the program, the next checkpoint or the position asked for.
        const auto whole = std::size_t(s.position);
        std::size_t end = std::min(s.first[at.program + 1], (whole / s.keep_every + 1) * s.keep_every);
        double until = 1;
        if (double(end) > position) {
            end = std::size_t(std::ceil(position));
            until = position - double(end - 1);
        }
        const double reached = std::min(double(end), position), route = position - start;
        s.removal.cut(s.stock, at.program, at.motion, end - before, until, false,
                      progress.part((s.position - start) / route, (reached - start) / route));
        s.position = reached;
        if (s.position == double(end) && end % s.keep_every == 0) s.kept.try_emplace(end, s.stock);
    }
}

void StockPlayback::go_to(double position, const Progress& progress) {
    State& s = *state_;
    position = std::clamp(position, 0.0, double(s.total));
    const auto restore = [&](double at) {
        const auto checkpoint = std::prev(s.kept.upper_bound(std::size_t(at)));
        s.stock = checkpoint->second;
        s.position = double(checkpoint->first);
    };
    // From the checkpoint before, where that is nearer or the only way.
    if (position < s.position
        || double(std::prev(s.kept.upper_bound(std::size_t(position)))->first) > s.position)
        restore(position);
    try {
        forward(position, progress);
    } catch (...) {
        restore(s.position); // what was cut beyond it is not known
        throw;
    }
    progress.set(1.0);
}

const std::vector<std::shared_ptr<const StockPatch>>& StockPlayback::patches(const Progress& progress) {
    State& s = *state_;
    std::vector<std::size_t> stale;
    std::vector<std::uint64_t> stamps(s.patches.size());
    for (std::size_t k = 0; k < s.patches.size(); ++k) {
        stamps[k] = s.surface.stamp(s.stock, k);
        if (stamps[k] != s.stamps[k]) stale.push_back(k);
    }
    std::vector<std::shared_ptr<const StockPatch>> fresh(stale.size());
    parallel_for(stale.size(), 1, progress,
                 [&](std::size_t n) { fresh[n] = sparse_patch(s.surface.patch(s.stock, stale[n])); });
    for (std::size_t n = 0; n < stale.size(); ++n) {
        s.patches[stale[n]] = std::move(fresh[n]);
        s.stamps[stale[n]] = stamps[stale[n]];
    }
    return s.patches;
}

} // namespace facetmill
