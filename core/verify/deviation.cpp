#include "core/verify/deviation.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/verify/motion_shadows.h"
#include "core/verify/moving_bodies.h"
#include "core/verify/standing.h"

#include <cmath>
#include <numeric>

namespace facetmill {

namespace {

/// Probes that a thread takes at a time: some milliseconds of work.
constexpr std::size_t probes_per_block = 256;
/// Of those, probes that look for motions nearby together.
constexpr std::size_t probes_per_patch = 32;
/// Extremes that a report lists: as many as someone looks at one by one.
constexpr std::size_t max_extremes = 10;
/// Bands of slope from level to upright, 15 degrees each.
constexpr int band_count = 6;

/// All bodies of a program that are asked.
struct ProgramProbes {
    MotionProbes cutting;
    MotionShadows shadows;           ///< of `cutting`
    std::vector<MovingBody> watched; ///< must not touch the part

    static ProgramProbes of(const VerifyProgram& program, double bound, const Progress& progress) {
        std::vector<MovingBody> bodies = moving_bodies(program, bound, progress);
        const MotionProbes& cutting = bodies.front().probes; // the cutter at feed
        ProgramProbes p{cutting, MotionShadows(cutting, progress), {}};
        bodies.erase(bodies.begin());
        std::erase_if(bodies, [](const MovingBody& b) { return b.probes.motions().empty(); });
        p.watched = std::move(bodies);
        return p;
    }
};

using CollisionKey = std::tuple<std::size_t, std::size_t, Collision::Kind>;
using CollisionMap = std::map<CollisionKey, Collision>;

void keep_deepest(CollisionMap& map, const Collision& c) {
    const auto [at, is_new] = map.try_emplace({c.at.program, c.at.motion, c.kind}, c);
    if (!is_new && c.depth > at->second.depth) at->second = c;
}

} // namespace

std::vector<std::uint32_t> neighbors_together(const std::vector<Vec3>& points, const Progress& progress) {
    constexpr int bits = 21;
    Box3 box;
    for (const Vec3& p : points)
        box.add(p);
    const double size = std::max(box.size().maxCoeff(), tolerance::smallest_extent);
    const double scale = double((1 << bits) - 1) / size;
    const auto spread = [](std::uint64_t v) { // two zeros after each bit
        v = (v | v << 32) & 0x001F00000000FFFFu;
        v = (v | v << 16) & 0x001F0000FF0000FFu;
        v = (v | v << 8) & 0x100F00F00F00F00Fu;
        v = (v | v << 4) & 0x10C30C30C30C30C3u;
        return (v | v << 2) & 0x1249249249249249u;
    };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 q = (points[i] - box.lo) * scale;
        keys[i] = {spread(std::uint64_t(q.x())) | spread(std::uint64_t(q.y())) << 1
                       | spread(std::uint64_t(q.z())) << 2,
                   std::uint32_t(i)};
    }
    progress.check();
    std::sort(keys.begin(), keys.end());
    progress.check();
    std::vector<std::uint32_t> order(points.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        order[i] = keys[i].second;
    return order;
}

double collision_limit(double gouge_limit) {
    return std::clamp(gouge_limit, tolerance::collision_depth, tolerance::max_collision_depth);
}

namespace {

/// What thread-blocks of probes leave besides their samples' own values.
struct BlockFindings {
    CollisionMap collisions;
    std::vector<double> program_gouges;
};

/// Asks the programs at single samples. Not for two threads at once: what cut the neighbour most likely cuts
/// here, so each thread remembers it.
class SampleProbe {
public:
    SampleProbe(const std::vector<ProgramProbes>& bodies, const StockExit& exit_of, const MeshSight& sight,
                const ProbeAims& aims)
        : bodies_(bodies), exit_of_(exit_of), sight_(sight), standing_(sight, aims.allowance, aims.far),
          aims_(aims), collision_limit_(collision_limit(aims.gouge_limit)),
          deep_hints_(bodies.size(), no_index), hints_(bodies.size(), no_index), nearby_(bodies.size()),
          block_(bodies.size()) {
        findings_.program_gouges.assign(bodies.size(), 0);
    }
    BlockFindings take() { return std::move(findings_); }

    /// All samples from now on are within `radius` of `center`, and off the places where their lines start by
    /// at most `off`.
    void begin_block(const Vec3& center, double radius, double off) {
        const double far = aims_.far < infinity ? off + aims_.far : 0;
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            block_[b] = bodies_[b].cutting.near(center, radius + aims_.allowance + far, 0);
    }

    /// Samples within `radius` of `center` come next, `off` that of the places where their lines start.
    void begin_patch(const Vec3& center, double radius, double off) {
        // Lines that are higher than `far` where the motion before has cut ask all motions.
        const double along = radius + off + aims_.allowance + aims_.far;
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const ProgramProbes& body = bodies_[b];
            Nearby& nearby = nearby_[b];
            const double reach = aims_.far < infinity ? along : radius + aims_.allowance;
            nearby.one_by_one = nearby.motions.find(body.cutting, center, reach, 0, block_[b]);
            if (!nearby.one_by_one) {
                nearby.deep = body.cutting.near(center, radius, -aims_.allowance);
                if (aims_.far < infinity) nearby.along = body.cutting.near(center, along, 0);
            }
            nearby.watched.resize(body.watched.size());
            for (std::size_t k = 0; k < body.watched.size(); ++k)
                nearby.watched[k] = body.watched[k].probes.near(center, radius, collision_limit_);
        }
    }

    /// How deep the sample's point comes to lie inside a cutter, as a deviation below 0; where it never does,
    /// what is left on it. Sets the flag `bare`.
    /// `place`: where lines start, off sharp edges.
    double operator()(const Vec3& surface, const Vec3& place, const Vec3& normal, std::uint8_t& flags,
                      MotionPlace& by) {
        const Vec3 p = place + aims_.allowance * normal;
        double value = exit_of_(p, normal);
        if (value < 0) {
            // The stock may well end between the part and the part grown.
            const double below = aims_.allowance == 0 ? value : exit_of_(place, normal);
            if (below < -aims_.short_by) flags |= DeviationSurface::bare;
            value = 0;
        }
        collide(surface);
        const double depth = gouge(surface, by);
        if (depth > 0) return -depth;
        // Beyond where the line meets the part again nothing stands on this place.
        double next = infinity;
        if (value > aims_.far) {
            next = sight_.first_hit(p, normal, value);
            value = std::min(value, std::max(next, std::nextafter(aims_.far, infinity)));
        }
        value = left(p, normal, value, by);
        return value > aims_.far ? standing_.off_part(p, normal, std::min(value, next)) : value;
    }

private:
    /// The deepest gouge of the part grown by the allowance. A point that is inside the cutter by d asks for
    /// no direction: whatever the facet's winding, material that was to stay is gone.
    double gouge(const Vec3& surface, MotionPlace& by) {
        double deepest = 0;
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            DepthProbe probe{-aims_.allowance, no_index};
            if (!deepen(b, surface, probe)) continue;
            deep_hints_[b] = probe.motion;
            const double depth = probe.depth + aims_.allowance;
            findings_.program_gouges[b] = std::max(findings_.program_gouges[b], depth);
            if (!(depth > deepest)) continue;
            deepest = depth;
            by = {b,
                  depth > aims_.gouge_limit ? bodies_[b].cutting.first_as_deep(surface, probe) : probe.motion,
                  probe.course};
        }
        return deepest;
    }
    bool deepen(std::size_t b, const Vec3& surface, DepthProbe& probe) {
        Nearby& nearby = nearby_[b];
        return nearby.one_by_one ? bodies_[b].cutting.deepen(surface, deep_hints_[b], probe, nearby.motions)
                                 : bodies_[b].cutting.deepen(surface, deep_hints_[b], probe, nearby.deep);
    }
    double left(const Vec3& p, const Vec3& normal, double value, MotionPlace& by) {
        for (std::size_t b = bodies_.size(); b-- > 0 && value > 0;) { // the last to cut likely cuts lowest
            LineProbe probe{value, no_index};
            if (!lower(b, p, normal, probe)) continue;
            value = std::max(probe.value, 0.0);
            by = {b, probe.motion};
            hints_[b] = probe.motion;
        }
        return value;
    }
    bool lower(std::size_t b, const Vec3& p, const Vec3& normal, LineProbe& probe) {
        const MotionProbes& cutting = bodies_[b].cutting;
        bool lowered = hints_[b] != no_index && cutting.lower(p, normal, hints_[b], probe, {}, &recent_);
        if (probe.value <= aims_.far && aims_.far < infinity) {
            Nearby& nearby = nearby_[b];
            return (nearby.one_by_one ? cutting.lower(p, normal, probe, nearby.motions, recent_)
                                      : cutting.lower(p, normal, no_index, probe, nearby.along, &recent_))
                   || lowered;
        }
        const MotionShadows& shadows = bodies_[b].shadows;
        return (shadows.know(p, normal, probe.value)
                    ? shadows.lower(cutting, p, normal, probe, recent_)
                    : cutting.lower(p, normal, no_index, probe, MotionProbes::all_nodes, &recent_))
               || lowered;
    }
    void collide(const Vec3& surface) {
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            for (std::size_t k = 0; k < bodies_[b].watched.size(); ++k) {
                const auto& watch = bodies_[b].watched[k];
                DepthProbe probe{collision_limit_, no_index};
                if (!watch.probes.deepen(surface, no_index, probe, nearby_[b].watched[k])) continue;
                const Index motion = watch.probes.first_as_deep(surface, probe);
                keep_deepest(findings_.collisions,
                             {watch.kind, true, {b, motion, probe.course}, surface, probe.depth});
            }
    }

    const std::vector<ProgramProbes>& bodies_;
    const StockExit& exit_of_;
    const MeshSight& sight_;
    StandingMaterial standing_;
    const ProbeAims& aims_;
    double collision_limit_;
    std::vector<Index> deep_hints_, hints_;
    RecentSweeps recent_;
    /// Nodes of the trees of motions that can matter to the samples of a patch.
    struct Nearby {
        bool one_by_one = false; ///< `motions` are all; else nodes are asked
        NearMotions motions;
        std::vector<Index> deep, along;
        std::vector<std::vector<Index>> watched;
    };
    std::vector<Nearby> nearby_;            ///< per program
    std::vector<std::vector<Index>> block_; ///< the same for all samples
    BlockFindings findings_;
};

/// What holds some samples, and how far the lines of any of them begin from it.
struct Ball {
    Vec3 center;
    double radius = 0, off = 0;
};

Ball ball_of(const SurfaceSamples& samples, const std::vector<std::uint32_t>& order, std::size_t begin,
             std::size_t end) {
    Box3 box;
    for (std::size_t j = begin; j < end; ++j)
        box.add(samples.points[order[j]]);
    Ball ball{box.center()};
    for (std::size_t j = begin; j < end; ++j) {
        ball.radius = std::max(ball.radius, (samples.points[order[j]] - ball.center).norm());
        ball.off = std::max(ball.off, (samples.places[order[j]] - samples.points[order[j]]).norm());
    }
    return ball;
}

} // namespace

Probed probe_samples(SurfaceSamples& samples, const MeshSight& sight, const StockSolid& stock,
                     std::span<const VerifyProgram> programs, const ProbeAims& aims,
                     const Progress& progress) {
    std::vector<ProgramProbes> bodies;
    for (const VerifyProgram& program : programs)
        bodies.push_back(ProgramProbes::of(program, aims.bound, progress));
    const StockExit exit_of(stock, progress);
    const std::size_t n = samples.points.size();
    const std::vector<std::uint32_t> order = neighbors_together(samples.points, progress);

    Probed probed;
    probed.deviation.assign(n, 0);
    probed.by.assign(n, {});
    probed.program_gouges.assign(bodies.size(), 0);
    std::vector<BlockFindings> found((n + probes_per_block - 1) / probes_per_block);
    parallel_blocks(n, probes_per_block, progress.part(0.05, 1.0), [&](std::size_t begin, std::size_t end) {
        SampleProbe probe(bodies, exit_of, sight, aims);
        const Ball all = ball_of(samples, order, begin, end);
        probe.begin_block(all.center, all.radius, all.off);
        for (std::size_t k = begin; k < end; ++k) {
            if ((k - begin) % probes_per_patch == 0) {
                const Ball ball = ball_of(samples, order, k, std::min(end, k + probes_per_patch));
                probe.begin_patch(ball.center, ball.radius, ball.off);
            }
            const std::size_t i = order[k];
            probed.deviation[i] = probe(samples.points[i], samples.places[i], samples.normals[i],
                                        samples.flags[i], probed.by[i]);
        }
        found[begin / probes_per_block] = probe.take();
    });
    CollisionMap map;
    for (const BlockFindings& block : found) {
        for (const auto& [key, c] : block.collisions)
            keep_deepest(map, c);
        for (std::size_t b = 0; b < bodies.size(); ++b)
            probed.program_gouges[b] = std::max(probed.program_gouges[b], block.program_gouges[b]);
    }
    for (const auto& [key, collision] : map)
        probed.collisions.push_back(collision);
    return probed;
}

// ---- figures ----

namespace {

/// Gathers samples and gives their figures.
class Gathered {
public:
    void add(double deviation, double weight, bool gouges_only) {
        gouge_ = std::max(gouge_, -deviation);
        if (gouges_only) return;
        excess_.push_back({std::max(deviation, 0.0), weight});
    }
    DeviationFigures figures(double tolerance) {
        DeviationFigures f;
        f.gouge_max = gouge_;
        f.samples = excess_.size();
        std::sort(excess_.begin(), excess_.end());
        for (const auto& [value, weight] : excess_)
            f.area += weight;
        if (excess_.empty()) return f;
        f.excess_max = excess_.back().first;
        const auto quantile = [&](double share) {
            double sum = 0;
            for (const auto& [value, weight] : excess_)
                if ((sum += weight) >= share * f.area) return value;
            return f.excess_max;
        };
        f.excess_p50 = quantile(0.5);
        f.excess_p95 = quantile(0.95);
        f.excess_p99 = quantile(0.99);
        f.excess_p999 = quantile(0.999);
        if (tolerance > 0 && f.area > 0)
            for (const auto& [value, weight] : excess_) {
                if (value > tolerance) f.over_fraction += weight / f.area;
                if (value > 2 * tolerance) f.uncut_fraction += weight / f.area;
            }
        return f;
    }

private:
    double gouge_ = 0;
    std::vector<std::pair<double, double>> excess_;
};

/// The first of `candidates` that are far from one another.
std::vector<DeviationExtreme> extremes(const std::vector<std::size_t>& candidates,
                                       const SurfaceSamples& samples, const Probed& probed, double apart) {
    std::vector<DeviationExtreme> chosen;
    for (std::size_t i : candidates) {
        const Vec3& p = samples.points[i];
        const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const DeviationExtreme& e) {
            return (e.point - p).norm() < apart;
        });
        if (near) continue;
        chosen.push_back({p, samples.normals[i], probed.deviation[i], probed.by[i]});
        if (chosen.size() == max_extremes) break;
    }
    return chosen;
}

} // namespace

void fill_figures(Verification& v, const SurfaceSamples& samples, const Probed& probed, double apart,
                  const Progress& progress) {
    v.program_gouges = probed.program_gouges;
    Gathered all, border;
    std::array<Gathered, band_count> bands;
    std::vector<std::size_t> gouges, excess;
    const double band = 0.5 * pi / band_count;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        const double d = probed.deviation[i], weight = samples.weights[i];
        const std::uint8_t flags = samples.flags[i];
        const bool gouges_only = (flags & DeviationSurface::gouges_only) != 0;
        if (d < -v.used.gouge_limit) gouges.push_back(i);
        if (flags & DeviationSurface::border) {
            border.add(d, weight, gouges_only);
            continue;
        }
        all.add(d, weight, gouges_only);
        if (flags & (DeviationSurface::away | DeviationSurface::hidden)) continue;
        const auto k = std::size_t(std::clamp(int(samples.slopes[i] / band), 0, band_count - 1));
        bands[k].add(d, weight, gouges_only);
        if (!gouges_only && v.used.tolerance > 0 && d > v.used.tolerance) excess.push_back(i);
    }
    v.figures = all.figures(v.used.tolerance);
    progress.check();
    v.border = border.figures(v.used.tolerance);
    v.bands.clear();
    for (int k = 0; k < band_count; ++k)
        v.bands.push_back({k * band, (k + 1) * band, bands[std::size_t(k)].figures(v.used.tolerance)});
    progress.check();
    const auto by_deviation = [&](double sign) {
        return [&probed, sign](std::size_t a, std::size_t b) {
            const double x = sign * probed.deviation[a], y = sign * probed.deviation[b];
            return x < y || (x == y && a < b);
        };
    };
    std::sort(gouges.begin(), gouges.end(), by_deviation(1));
    std::sort(excess.begin(), excess.end(), by_deviation(-1));
    v.gouges = extremes(gouges, samples, probed, apart);
    v.excess = extremes(excess, samples, probed, apart);
}

} // namespace facetmill
