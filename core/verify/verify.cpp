#include "core/verify/verify.h"

#include "core/base/figures.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/mesh/mesh_area.h"
#include "core/mesh/outward.h"
#include "core/mesh/triangle_distance.h"
#include "core/verify/deviation.h"
#include "core/verify/fixture_touch.h"
#include "core/verify/judged_radius.h"
#include "core/verify/removal.h"
#include "core/verify/stock_tiles.h"
#include "core/verify/uncut_reasons.h"
#include "core/verify/winding_number.h"
#include "core/verify/working_radius.h"

#include <chrono>
#include <cmath>
#include <map>
#include <tuple>

namespace facetmill {

namespace {

/// The resolution that is used unless one is given, in radii of the smallest cutter: its cusps and what it
/// leaves in corners span some rays.
constexpr double resolution_share = 0.05;
/// The same where cutting would take long and the stock is not judged.
constexpr double lightest_share = 0.125;
/// By how much bodies that must not touch the stock are made smaller at least, in resolutions: above the
/// rounding of rays, and far below the depth that the rays tell.
constexpr double touch_share = 0.02;
/// What probes may be off where the axis turns, in tolerances: it adds nothing to a figure that is shown.
constexpr double probe_share = 0.01;
/// Samples at most: a minute or two of probing. Where axes turn, each takes some times as long.
constexpr std::size_t samples_fixed = 2'000'000, samples_turning = 500'000;
/// Lines keep off sharp edges: farther than the skin that paths leave on the wall beyond them, and rounding.
constexpr double inset_limits = 2, min_inset = 1e-3; // of the gouge limit; mm
/// How far apart places looked at may be, in radii of the narrowest cutter: a hollow, or a cutter's mark, is
/// some times as wide.
constexpr double coarsest_look = 0.5;
/// How many times as many places as else are looked at where fewer would leave the verdict open.
constexpr std::size_t times_to_judge = 4;
constexpr double finest_probe = 1e-4; // mm: what a probe may be off where the axis turns

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Radii {
    double min = infinity, max = 0;
    double narrowest = infinity; ///< of cutters as a whole: a pointed one works with next to none
};

VerifySettings completed(VerifySettings s, const StockSolid& stock, const Radii& radii, bool turns) {
    if (s.max_samples == 0) s.max_samples = turns ? samples_turning : samples_fixed;
    if (!(s.resolution > 0)) {
        s.resolution = resolution_share * radii.min;
        for (int round = 0; round < 100; ++round) {
            const double rays = StockLattice::rays_over(stock.box, s.resolution);
            if (rays <= double(s.usual_rays)) break;
            s.resolution *= std::max(1.01, std::sqrt(rays / double(s.usual_rays)));
        }
    }
    if (!(s.sample_spacing > 0)) s.sample_spacing = s.resolution;
    if (!(s.motion_bound > 0)) s.motion_bound = default_bound_share * s.resolution;
    return s;
}

void check_resolution(const VerifySettings& used, const StockSolid& stock, const Radii& radii) {
    if (used.resolution < stock.box.size().maxCoeff()) return;
    throw Error(ErrorCode::out_of_range, "resolution",
                length_text(used.resolution, used.unit)
                    + " is as long as the stock, in which nothing is seen then",
                "use at most " + length_text(coarsest_look * radii.min, used.unit, 3)
                    + ", half of the narrowest cutter's radius");
}

void check_memory(double needed, const VerifySettings& used) {
    const double most = double(used.max_stock_bytes);
    if (needed <= most) return;
    throw Error(ErrorCode::limit_exceeded, "resolution",
                length_text(used.resolution, used.unit) + " needs about " + format_number(needed / 1e9, 3)
                    + " GB for the stock, more than " + format_number(most / 1e9, 3) + " GB",
                "use at least "
                    + length_text(used.resolution * std::sqrt(needed / most) * 1.05, used.unit, 3));
}

/// Where the cutter of a program may be, all motions at feed.
struct Reach {
    std::size_t cuts = 0,
                outside =
                    0;  ///< CL points cut, and of those the ones from which nothing of the stock is reached
    bool turns = false; ///< some axis, on the way
};

Reach reach_of(const VerifyProgram& program, const Box3& stock, const Progress& progress) {
    Reach reach;
    const double across = program.tool.cutter.max_radius(), up = program.tool.cutter.height();
    const auto& motions = program.motions->motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % 4096 == 0) progress.check();
        if (motions[i].kind == MotionKind::rapid) continue;
        ++reach.cuts;
        reach.turns = reach.turns || (i > 0 && motions[i].to.axis != motions[i - 1].to.axis);
        Box3 box;
        for (const Motion& m : {motions[i > 0 ? i - 1 : 0], motions[i]}) {
            box.add(m.to.tip);
            box.add(Vec3(m.to.tip + up * m.to.axis));
        }
        const bool apart = ((box.lo.array() - across) > stock.hi.array()).any()
                           || ((box.hi.array() + across) < stock.lo.array()).any();
        reach.outside += apart;
    }
    return reach;
}

void merge(std::vector<Collision>& all, const std::vector<Collision>& more) {
    std::map<std::tuple<std::size_t, std::size_t, Collision::Kind, std::string>, Collision> map;
    for (const std::vector<Collision>* list : {static_cast<const std::vector<Collision>*>(&all), &more})
        for (const Collision& c : *list) {
            const auto [at, is_new] = map.try_emplace({c.at.program, c.at.motion, c.kind, c.fixture}, c);
            if (is_new) continue;
            const bool part = at->second.with_part || c.with_part;
            if (c.depth > at->second.depth) at->second = c;
            at->second.with_part = part;
        }
    all.clear();
    for (const auto& [key, c] : map)
        all.push_back(c);
}

std::shared_ptr<const DeviationSurface> published(SurfaceSamples&& samples,
                                                  const std::vector<double>& deviation) {
    auto surface = std::make_shared<DeviationSurface>();
    const std::size_t n = samples.points.size();
    surface->points.resize(n);
    surface->normals.resize(n);
    surface->deviation.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            surface->points[i][k] = float(samples.points[i][Eigen::Index(k)]);
            surface->normals[i][k] = float(samples.normals[i][Eigen::Index(k)]);
        }
        surface->deviation[i] = float(deviation[i]);
    }
    surface->flags = std::move(samples.flags);
    surface->triangles = std::move(samples.triangles);
    return surface;
}

/// What was not judged, and why.
/// `asked`: the spacing wanted was asked for, not the resolution.
std::vector<std::string> remarks_on(const SurfaceSamples& samples, const VerifySettings& used, bool asked,
                                    bool border) {
    double area = 0, away = 0, bare = 0, hidden = 0, counted = 0;
    for (std::size_t i = 0; i < samples.weights.size(); ++i) {
        area += samples.weights[i];
        if (samples.flags[i] & DeviationSurface::away) away += samples.weights[i];
        if (samples.flags[i] & DeviationSurface::bare) bare += samples.weights[i];
        if (samples.flags[i] & DeviationSurface::hidden) hidden += samples.weights[i];
        if (samples.flags[i] == DeviationSurface::counted) counted += samples.weights[i];
    }
    std::vector<std::string> remarks;
    if (border)
        remarks.emplace_back(
            "Within a cutter's radius of the part's open border no path goes on: that zone has figures "
            "of its own.");
    if (away > 0)
        remarks.push_back(
            percent_text(away / area)
            + " of the part's area faces no tool axis of the programs (walls, undersides): there only "
              "gouges count.");
    if (hidden > 0)
        remarks.push_back(percent_text(hidden / area)
                          + " of the part's area is hidden from all tool axes by other parts of it: there "
                            "only gouges count.");
    if (bare > 0)
        remarks.push_back("The stock does not reach " + percent_text(bare / area)
                          + " of the part's area: there only gouges count.");
    if (area > 0 && counted == 0)
        remarks.emplace_back("That is the whole part: nowhere is what the programs leave held against the "
                             "tolerance, only gouges are judged.");
    if (samples.spacing > 1.001 * used.sample_spacing)
        remarks.push_back("The probes are up to " + length_text(samples.spacing, used.unit, 3) + " apart, "
                          + format_number(samples.spacing / used.sample_spacing, 3) + " times farther than "
                          + (asked ? "asked" : "the stock's rays") + ": else there would be more than "
                          + std::to_string(std::max(used.max_samples, samples.points.size()))
                          + ". What is narrower may be missed.");
    return remarks;
}

/// Programs whose first location is within the part. Motions that begin in there may never meet the surface,
/// on which all other findings rest.
void find_starts_inside(Verification& v, const Mesh& part, std::span<const VerifyProgram> programs,
                        const Progress& progress) {
    constexpr double inside = 0.75; // below a large sheet it is a half
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const Vec3& tip = programs[i].motions->motions.front().to.tip;
        double distance = infinity;
        std::size_t nearest = 0;
        for (std::size_t f = 0; f < part.facet_count(); ++f) {
            if (f % 65536 == 0) progress.check();
            const double d =
                std::sqrt(squared_distance(tip, part.corner(f, 0), part.corner(f, 1), part.corner(f, 2)));
            if (d < distance) {
                distance = d;
                nearest = f;
            }
        }
        // On the surface it is neither.
        if (!(distance > v.used.gouge_limit) || !(winding_number(part, tip, progress) > inside)) continue;
        v.program_gouges[i] = std::max(v.program_gouges[i], distance);
        v.figures.gouge_max = std::max(v.figures.gouge_max, distance);
        v.gouges.insert(v.gouges.begin(), {tip, part.facet_normal(nearest), -distance, {i, 0}});
        v.remarks.push_back("'" + printable(programs[i].name) + "' begins inside the part.");
    }
}

/// Why nothing can be said of the whole, as it is known before anything is cut; empty where it may be.
std::string cannot_verify_why(const VerifySettings& used, double sample_spacing, double min_radius) {
    const double spacing = std::max(sample_spacing, used.resolution);
    if (spacing > coarsest_look * min_radius)
        return "places looked at are " + length_text(spacing, used.unit, 3)
               + " apart, and a cutter has a radius of " + length_text(min_radius, used.unit, 3)
               + ": a resolution and a spacing of at most "
               + length_text(coarsest_look * min_radius, used.unit, 3) + " would do";
    constexpr double deepest_limit = 0.25; // nothing lies deeper in a cutter than its radius
    if (used.gouge_limit > deepest_limit * min_radius)
        return "the gouge limit is " + length_text(used.gouge_limit, used.unit, 3)
               + ", and a cutter has a radius of " + length_text(min_radius, used.unit, 3)
               + ": allow at most " + length_text(deepest_limit * min_radius, used.unit, 3);
    return {};
}

/// Why what was looked at says nothing of the whole; empty where it does.
std::string not_judged_why(const Verification& v, const SurfaceSamples& samples, double min_radius) {
    if (std::string why = cannot_verify_why(v.used, samples.spacing, min_radius); !why.empty()) return why;
    const double seen = v.figures.area + v.border.area;
    if (v.used.tolerance > 0 && v.border.uncut_fraction * v.border.area > v.used.uncut_limit * seen)
        return "more than twice the tolerance stays on "
               + percent_text(v.border.uncut_fraction * v.border.area / seen)
               + " of the surface near the part's open borders, where paths may end";
    if (v.used.tolerance > 0
        && std::find(samples.flags.begin(), samples.flags.end(), DeviationSurface::counted)
               == samples.flags.end())
        return "nowhere on the part, away from its open borders, is what the programs leave held against "
               "the tolerance";
    return {};
}

/// Places on the part's surface, near enough to each other to judge if that is to be had.
SurfaceSamples samples_of(const Mesh& part, const VerifySettings& used, double min_radius,
                          const Progress& progress) {
    const double inset = std::max(inset_limits * used.gouge_limit, min_inset),
                 coarsest = coarsest_look * min_radius;
    SurfaceSamples usual =
        sample_surface(part, used.sample_spacing, used.max_samples, progress.part(0, 0.5), inset);
    if (usual.spacing <= coarsest || std::max(used.resolution, used.sample_spacing) > coarsest) return usual;
    SurfaceSamples more =
        sample_surface(part, coarsest, times_to_judge * used.max_samples, progress.part(0.5, 1), inset);
    return more.spacing <= coarsest ? more : usual;
}

/// The part's surface as it is looked at.
struct LookedAt {
    LookedAt(const Mesh& given, const VerifySettings& used, double min_radius, const Progress& progress) {
        const OutwardSides sides = outward_sides(given, progress.part(0.0, 0.5), used.open_side);
        // Borrowed: it lives as long as the verification.
        part = wound_outward(MeshPtr(std::shared_ptr<const Mesh>(), &given), sides);
        turned_facets = sides.turned_facets;
        samples = samples_of(*part, used, min_radius, progress.part(0.5, 1));
    }
    MeshPtr part; ///< wound outward
    std::size_t turned_facets = 0;
    SurfaceSamples samples;
};

/// Looks at the part's surface: all of `v` that does not come from the stock.
void compare(Verification& v, LookedAt&& looked, const StockSolid& stock, const StocksBefore& before,
             std::span<const VerifyProgram> programs, const Radii& radii, bool spacing_asked,
             const Progress& progress) {
    const Mesh& part = *looked.part;
    SurfaceSamples& samples = looked.samples;
    const std::vector<Vec3> axes = looking_axes(programs, progress);
    const MeshSight sight(part, progress);
    flag_samples(samples, part, sight, radii.max, axes, progress.part(0.0, 0.1));
    ProbeAims aims;
    aims.allowance = v.used.allowance;
    aims.gouge_limit = v.used.gouge_limit;
    if (v.used.cut_before) aims.short_by = v.used.resolution;
    aims.bound = finest_probe;
    if (v.used.tolerance > 0) {
        aims.bound = std::clamp(probe_share * v.used.tolerance, tolerance::smallest_chord, finest_probe);
        aims.far = 2 * v.used.tolerance;
    }
    const Probed probed = probe_samples(samples, sight, stock, programs, aims, progress.part(0.1, 0.95));
    merge(v.collisions, probed.collisions);
    fill_figures(v, samples, probed, radii.min, progress);
    find_uncut_reasons(v, samples, probed, before, programs, progress.part(0.95, 0.99));
    v.remarks = remarks_on(samples, v.used, spacing_asked, v.border.samples > 0);
    for (const UncutReason& r : v.uncut)
        if (r.why == UncutReason::Why::upright)
            v.remarks.push_back("Upright walls ask for no pass of their own: more than twice the tolerance "
                                "stays on "
                                + area_text(r.area, v.used.unit, 3) + " of them, up to "
                                + length_text(r.excess_max, v.used.unit, 3)
                                + ", which is no part of the verdict.");
    if (looked.turned_facets > 0)
        v.remarks.push_back(std::to_string(looked.turned_facets)
                            + " facets are wound inward and were judged from the side that is outside.");
    find_starts_inside(v, part, programs, progress);
    v.not_judged = not_judged_why(v, samples, radii.min);
    v.not_judged_share = !v.not_judged.empty() ? 1
                         : v.border.area > 0   ? v.border.area / (v.border.area + v.figures.area)
                                               : 0;
    v.used.sample_spacing = samples.spacing;
    v.surface = published(std::move(samples), probed.deviation);
}

std::string loose_remark(const LoosePieces& loose, std::span<const VerifyProgram> programs, LengthUnit unit) {
    const std::string when = "GOTO " + std::to_string(loose.at.motion + 1) + " of '"
                             + printable(programs[loose.at.program].name) + "'";
    if (loose.part_is_free)
        return "The part is cut free at " + when
               + ": what stood round it holds it no longer. Hold it from then on, or leave something between "
                 "them.";
    const std::string size = length_text(loose.largest.box.size().maxCoeff(), unit, 3);
    return (loose.count == 1 ? "A piece of the stock, " + size + " long, comes off at " + when
                             : std::to_string(loose.count) + " pieces of the stock, up to " + size
                                   + " long, come off, the first at " + when)
           + ".";
}

/// What is known before anything is cut.
struct Prepared {
    VerifySettings used;
    Radii radii;
    std::vector<std::string> outside; ///< a sentence for each program that goes beside the stock
};

MaterialRemoval removal_of(std::span<const VerifyProgram> programs, const VerifySettings& used) {
    const double touch = std::max(touch_share * used.resolution, collision_limit(used.gouge_limit));
    return {programs, used.motion_bound, touch, used.max_stock_bytes};
}

/// Coarser until cutting asks rays no more often than is usual.
void lighten(VerifySettings& used, const StockSolid& stock, std::span<const VerifyProgram> programs,
             double narrowest) {
    const double coarsest = std::max(used.resolution, lightest_share * narrowest);
    for (int round = 0; round < 10 && used.resolution < coarsest; ++round) {
        const double asked = removal_of(programs, used).rays_asked(stock.box, used.resolution);
        if (asked <= used.usual_rays_asked) return;
        const double factor = std::max(1.05, std::cbrt(asked / used.usual_rays_asked));
        used.resolution = std::min(coarsest, used.resolution * factor);
        used.motion_bound = default_bound_share * used.resolution;
    }
}

Prepared prepare(const StockSolid& stock, std::span<const VerifyProgram> programs,
                 const VerifySettings& settings, const Progress& progress) {
    check_programs(programs);
    Prepared p;
    std::size_t cuts = 0, misses = 0;
    bool turns = false;
    for (const VerifyProgram& program : programs) {
        p.radii.min = std::min(p.radii.min, working_radius(program.tool.cutter));
        p.radii.max = std::max(p.radii.max, program.tool.cutter.max_radius());
        p.radii.narrowest = std::min(p.radii.narrowest, program.tool.cutter.max_radius());
        const Reach reach = reach_of(program, stock.box, progress);
        turns = turns || reach.turns;
        cuts += reach.cuts;
        misses += reach.outside;
        if (reach.outside > 0)
            p.outside.push_back("'" + printable(program.name) + "': " + std::to_string(reach.outside) + " of "
                                + std::to_string(reach.cuts) + " motions at feed are outside the stock.");
    }
    if (misses == cuts)
        throw Error(ErrorCode::out_of_range, "'" + printable(programs.front().name) + "'",
                    "no motion at feed comes near the stock",
                    "check the units and the origin of the program");
    p.used = completed(settings, stock, p.radii, turns);
    if (!(settings.resolution > 0) && std::isfinite(settings.usual_rays_asked))
        lighten(p.used, stock, programs, p.radii.narrowest);
    check_resolution(p.used, stock, p.radii);
    return p;
}

/// Measured on reliefs, turned and five-axis parts; of a place for each program.
constexpr double seconds_a_ray = 3.5e-7, seconds_a_place = 3.5e-5, seconds_a_place_turning = 6e-5;
constexpr double bytes_a_place = 200;
/// From here on whoever waits is told how long.
constexpr double long_seconds = 60;

VerifyWork work_of(const Mesh& part, const StockSolid& stock, std::span<const VerifyProgram> programs,
                   const VerifySettings& used) {
    VerifyWork work;
    work.rays_asked = removal_of(programs, used).rays_asked(stock.box, used.resolution);
    double seconds_each = 0;
    work.places =
        std::min(double(used.max_samples), 2 * mesh_area(part) / (used.sample_spacing * used.sample_spacing));
    for (const VerifyProgram& program : programs) {
        const auto& motions = program.motions->motions;
        const bool turns = std::any_of(motions.begin(), motions.end(),
                                       [&](const Motion& m) { return m.to.axis != motions.front().to.axis; });
        seconds_each += turns ? seconds_a_place_turning : seconds_a_place;
    }
    const double rays = StockLattice::rays_over(stock.box, used.resolution);
    work.bytes = rays * sizeof(RayTile::Piece) + work.places * bytes_a_place;
    work.seconds = (work.rays_asked * seconds_a_ray + work.places * seconds_each) / thread_count();
    return work;
}

/// The stock, cut by all programs in order; with `before`, also what each of them begins with, as long as
/// there is room for it, and `removal` knows what it has found meanwhile.
std::shared_ptr<const StockModel> cut_all(const StockSolid& stock, std::span<const VerifyProgram> programs,
                                          const VerifySettings& used, MaterialRemoval& removal,
                                          StocksBefore* before, const Progress& progress) {
    const StockLattice lattice = StockLattice::over(stock.box, used.resolution, used.unit);
    const double all_rays = double(lattice.rays() * sizeof(RayTile::Piece));
    if (stock.kind == StockSolid::Kind::mesh) check_memory(all_rays, used); // all are kept from the start
    auto model = std::make_shared<StockModel>(stock, lattice, progress.part(0.0, 0.1));
    if (all_rays > 0.9 * double(used.max_stock_bytes))
        check_memory(double(removal.bytes_needed(*model, progress.part(0.1, 0.1))), used);
    for (std::size_t i = 0; i < programs.size(); ++i) {
        if (before && double(i + 1) * all_rays < double(used.max_stock_bytes))
            before->push_back(std::make_shared<const StockModel>(*model));
        removal.cut(*model, i, 0, programs[i].motions->motions.size(), 1, before != nullptr,
                    progress.part(0.1 + 0.9 * double(i) / double(programs.size()),
                                  0.1 + 0.9 * double(i + 1) / double(programs.size())));
    }
    return model;
}

} // namespace

std::shared_ptr<const StockModel> stock_after(const StockSolid& stock,
                                              std::span<const VerifyProgram> programs,
                                              const VerifySettings& settings, const Progress& progress) {
    const Prepared prepared = prepare(stock, programs, settings, progress);
    MaterialRemoval removal = removal_of(programs, prepared.used);
    return cut_all(stock, programs, prepared.used, removal, nullptr, progress);
}

Verification verify(const Mesh& part, const StockSolid& stock, std::span<const VerifyProgram> programs,
                    const VerifySettings& settings, const Progress& progress) {
    const Prepared prepared = prepare(stock, programs, settings, progress);
    Verification v;
    v.used = prepared.used;
    const VerifyWork work = work_of(part, stock, programs, v.used);
    if (settings.before_work) settings.before_work(work);
    const std::string long_work =
        work.seconds > long_seconds ? " (about " + duration_text(work.seconds) + " in all)" : "";
    auto start = std::chrono::steady_clock::now();
    LookedAt looked(part, v.used, prepared.radii.min, progress.part(0.0, 0.03, "Looking at the part"));
    if (const auto why = cannot_verify_why(v.used, looked.samples.spacing, prepared.radii.min);
        settings.cannot_verify && !why.empty())
        settings.cannot_verify(why);
    v.seconds_probing = seconds_since(start);

    start = std::chrono::steady_clock::now();
    MaterialRemoval removal = removal_of(programs, v.used);
    StocksBefore before;
    v.stock = cut_all(stock, programs, v.used, removal, &before,
                      progress.part(0.03, 0.6, "Removing material" + long_work));
    v.collisions = removal.collisions();
    for (std::size_t i = 0; i < programs.size(); ++i) {
        v.program_air.push_back(removal.air_length(i));
        v.program_loads.push_back(removal.load(i));
    }
    v.seconds_cutting = seconds_since(start);

    start = std::chrono::steady_clock::now();
    compare(v, std::move(looked), stock, before, programs, prepared.radii, settings.sample_spacing > 0,
            progress.part(0.6, 0.9, "Comparing with the part"));
    merge(v.collisions, fixture_touches(programs, finest_probe, progress.part(0.9, 0.92)));
    if (settings.look_for_pieces)
        v.loose =
            loose_pieces(part, *v.stock, programs, progress.part(0.92, 1.0, "Looking for loose pieces"));
    if (v.loose) v.remarks.push_back(loose_remark(*v.loose, programs, v.used.unit));
    v.remarks.insert(v.remarks.end(), prepared.outside.begin(), prepared.outside.end());
    v.seconds_probing += seconds_since(start);
    progress.set(1.0);
    return v;
}

bool can_be_judged(double radius, const DeviationSurface& part, const VerifySettings& used) {
    const auto vec = [](const std::array<float, 3>& p) { return Vec3(p[0], p[1], p[2]); };
    const double spacing = coarsest_look * radius;
    double places = 0;
    for (const auto& t : part.triangles) {
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k)
            length = std::max(length, (vec(part.points[t[k]]) - vec(part.points[t[(k + 1) % 3]])).norm());
        // As sample_surface divides it: a facet of curved surface more finely, and with places of its own.
        const bool curved =
            part.normals[t[0]] != part.normals[t[1]] || part.normals[t[0]] != part.normals[t[2]];
        const double parts = std::max(1.0, std::ceil(length / (curved ? 0.5 * spacing : spacing)));
        places += curved && parts > 1 ? 0.5 * (parts + 1) * (parts + 2) : 0.5 * parts * parts;
    }
    return places <= double(times_to_judge * used.max_samples);
}

} // namespace facetmill
