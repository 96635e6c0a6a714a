#include "core/strategy/preview/pass_preview.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/curves/pencil.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/global_local/global_local.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/lathe/lathe_rough.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/preview/preview_curves.h"
#include "core/strategy/preview/preview_flow.h"
#include "core/strategy/preview/preview_levels.h"
#include "core/strategy/preview/preview_rings.h"
#include "core/strategy/preview/preview_scallop.h"
#include "core/strategy/preview/preview_turning.h"
#include "core/strategy/preview/preview_valleys.h"
#include "core/strategy/rough/rough.h"
#include "core/strategy/steep_shallow/steep_shallow.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace facetmill {

namespace {

/// Strips of a tilted cutter are no wider than this share of its diameter.
constexpr double widest_strip = 0.9;
/// A needle, in cells of the ground: its tips are the ground itself.
constexpr double needle_cells = 0.25;
/// Between lines of roughing, in diameters of the cutter (Lu's c).
constexpr double rough_stepover = 0.95;
/// Layers of finer parts are asked of the ground as a mesh, which is quicker.
constexpr std::size_t max_layered_facets = 30'000;

class PreviewMaker {
public:
    PreviewMaker(const Operation& operation, const PreviewRequest& request)
        : operation_(operation), common_(operation.common()), request_(request),
          cutter_(request.context.tool.cutter()),
          kept_off_(common_.allowance + request.context.tessellation_tolerance[1]) {}

    PassPreview run(const Progress& progress) {
        if (const auto* o = as<LatheFinish>())
            return preview_turning(o->settings(), kept_off_, 0, request_.context, *request_.turned, progress);
        if (const auto* o = as<LatheRough>())
            return preview_turning(o->settings(), kept_off_ + o->settings().finishing_allowance,
                                   o->settings().depth_of_cut, request_.context, *request_.turned, progress);
        make(progress);
        preview_.spacing = std::max(preview_.spacing, request_.ground->grid().cell);
        const Mat3 back = request_.turn.transpose();
        if (request_.turn != Mat3::Identity())
            for (auto& line : preview_.lines)
                for (Vec3& p : line)
                    p = back * p;
        return std::move(preview_);
    }

private:
    template <class O>
    const O* as() const {
        return dynamic_cast<const O*>(&operation_);
    }

    void make(const Progress& progress) {
        if (const auto* o = as<Finish3>())
            return parallel(o->settings().chord_tolerance, o->settings().stepover, every_slope, progress);
        if (const auto* o = as<Waterline>())
            return levels(o->settings().chord_tolerance, o->settings().stepdown, o->settings().max_stepdown,
                          {o->settings().slope_limits[0], o->settings().slope_limits[1]}, progress);
        if (const auto* o = as<Scallop>()) return scallops(o->settings(), progress);
        if (const auto* o = as<SteepShallow>()) return both(o->settings(), progress);
        if (const auto* o = as<Rough>()) return layers(*o, progress);
        if (const auto* o = as<GlobalLocal>())
            return tilted(o->settings(), {0, o->settings().lead_limit}, progress);
        if (const auto* o = as<Finish5>())
            return tilted(o->settings(), {o->settings().lead_limits[0], o->settings().lead_limits[1]},
                          progress);
        if (const auto* o = as<Cleanup>()) return clean_up(o->settings(), progress);
        along_curves(progress);
    }

    void along_curves(const Progress& progress) {
        if (const auto* o = as<Radial>()) return about(o->settings(), false, progress);
        if (const auto* o = as<Spiral>()) return about(o->settings(), true, progress);
        if (const auto* o = as<Morph>()) return blend(o->settings(), progress);
        if (const auto* o = as<AlongCurve>()) return along(o->settings(), progress);
        if (const auto* o = as<Pencil>()) return pencil(o->settings(), progress);
        throw Error(ErrorCode::internal, common_.name,
                    "operations of this kind have no preview of their passes", "report this");
    }

    PreviewField field(const CutterProfile& cutter, const Interval& slopes, const Progress& progress) {
        PreviewField field(request_, common_, cutter, kept_off_, slopes, progress);
        preview_.spacing = std::max(preview_.spacing, field.grid().cell);
        return field;
    }
    void need(const PreviewField& field) const {
        if (!field.any_kept())
            throw Error(ErrorCode::empty_result, common_.name, "nothing of the part is to be cut",
                        "check boundary, slopes and tool");
    }
    [[noreturn]] void need_slopes() const {
        throw Error(ErrorCode::empty_result, common_.name, "nothing of the part is as steep as asked for",
                    "choose other slopes");
    }
    auto laying(const PreviewField& field) const {
        return [&field](const PlanLine& line, std::vector<std::vector<Vec3>>& lines) {
            field.lay(line, 0, -infinity, lines);
        };
    }
    PreviewStep step_of(const NumberOrWord& asked, const NumberOrWord& chord) {
        const PreviewStep step = preview_step(common_, asked, chord, request_.context);
        preview_.step = step.level;
        return step;
    }

    void parallel(const NumberOrWord& chord, const NumberOrWord& stepover, const Interval& slopes,
                  const Progress& progress) {
        const PreviewStep step = step_of(stepover, chord);
        const PreviewField field = this->field(cutter_, slopes, progress.part(0, 0.5));
        need(field);
        lay_lines(parallel_lines(field, request_.travel, step, progress), laying(field), preview_,
                  progress.part(0.5, 1));
    }

    void levels(const NumberOrWord& chord, const NumberOrWord& stepdown, const NumberOrWord& max_stepdown,
                const Interval& slopes, const Progress& progress) {
        PreviewLevels levels;
        levels.step = step_of({0, "adaptive"}, chord);
        const PreviewField field = this->field(cutter_, slopes, progress.part(0, 0.5));
        if (stepdown.is_number()) levels.fixed = stepdown.number;
        levels.deepest = max_stepdown.is_number() ? max_stepdown.number : 2 * cutter_.max_radius();
        levels.slopes = slopes;
        const std::size_t before = preview_.lines.size();
        lay_levels(field, levels, preview_, progress.part(0.5, 1));
        if (preview_.lines.size() == before) need_slopes();
    }

    void both(const SteepShallowSettings& s, const Progress& progress) {
        bool any = false;
        for (const bool steep : {true, false}) {
            const Interval slopes = steep ? s.steep() : s.shallow();
            const Progress part = progress.part(steep ? 0 : 0.5, steep ? 0.5 : 1);
            try {
                if (steep)
                    levels(s.chord_tolerance, s.stepdown, s.max_stepdown, slopes, part);
                else if (s.shallow_by == SteepShallowSettings::Shallow::scallop)
                    scallops(shallow_scallop(s), part);
                else
                    parallel(s.chord_tolerance, s.stepover, slopes, part);
                any = true;
            } catch (const Error& e) {
                // The other side may have something.
                if (e.code() != ErrorCode::empty_result || (!steep && !any)) throw;
            }
        }
    }

    void scallops(const ScallopSettings& s, const Progress& progress) {
        const PreviewStep step = step_of(s.stepover, s.chord_tolerance);
        const PreviewField field = this->field(cutter_, {0, s.slope_limit}, progress.part(0, 0.4));
        need(field);
        lay_scallops(field, s, request_, step, preview_, progress.part(0.4, 1));
        if (s.spiral) preview_.without.emplace_back("turns of the spiral");
    }

    void layers(const Rough& rough, const Progress& progress) {
        PlanContext context = request_.context;
        if (context.part->facet_count() > max_layered_facets) {
            context.part = std::make_shared<const Mesh>(request_.ground->mesh());
            context.geometry = nullptr;
        }
        const LayerPreview layers = rough.preview_layers(context, progress.part(0, 0.4));
        const PreviewField field = this->field(cutter_, every_slope, progress.part(0.4, 0.7));
        Box3 stock = layers.stock.empty() ? request_.context.stock_box : layers.stock;
        if (stock.empty()) stock = request_.context.part_box;
        const NumberOrWord& asked = rough.settings().stepover;
        preview_.step = asked.is_number() ? asked.number : rough_stepover * 2 * cutter_.max_radius();
        lay_layers(field, stock, layers.heights, request_.travel, preview_.step, preview_,
                   progress.part(0.7, 1));
        preview_.without.emplace_back("what operations before have cut");
    }

    /// Contacts on drive planes, as far apart as the strips of a tool that leans as little as it may.
    void tilted(const Finish5Settings& s, const Interval& leads, const Progress& progress) {
        const double budget = cusp_budget(common_, request_.context);
        const double cusp = standing_cusp(budget, chord_budget(s.chord_tolerance, budget));
        const AptCutter shape = cutter_.cutter();
        const double rounding = std::min(shape.r, cutter_.max_radius()),
                     disc = cutter_.max_radius() - rounding;
        // The cutter's ellipse seen along the travel bends as a circle of this radius.
        const double lead = std::max(leads.lo, radians(1));
        const double bend = 1 / std::max(rounding + disc / std::sin(lead), 1e-9);
        const double widest = widest_strip * 2 * cutter_.max_radius();
        const CutterProfile needle(
            AptCutter::flat(needle_cells * request_.ground->grid().cell, request_.ground->grid().cell));
        const PreviewField field(request_, common_, needle, 0, every_slope, progress.part(0, 0.4));
        need(field);
        preview_.spacing = field.grid().cell;
        const bool fixed = s.stepover.is_number();
        double step = fixed ? s.stepover.number : widest;
        if (!fixed) {
            const double surface = convex_bend(field);
            step = std::min(widest, std::sqrt(8 * cusp / std::max(bend + surface, 1e-12)));
        }
        preview_.step = step;
        // A tool that leans with the surface leaves strips as wide on any slope.
        const PreviewStep strips{cusp, step, step, fixed};
        using Passes = Finish5Settings::Passes;
        PreviewRings rings;
        if (s.passes == Passes::around)
            rings = preview_rings(request_, step, cutter_.max_radius(), progress.part(0.4, 0.5));
        const std::vector<PlanLine> lines =
            s.passes == Passes::parallel
                ? parallel_lines(field, request_.travel, strips, progress)
                : flow_lines(field, request_, strips, rings.facets, progress.part(0.5, 0.6));
        lay_lines(lines, laying(field), preview_, progress.part(0.6, 1));
        add_rings(std::move(rings));
        preview_.without.emplace_back(as<GlobalLocal>() ? "regions of rework" : "postures");
    }
    void add_rings(PreviewRings&& rings) {
        preview_.passes += rings.passes;
        preview_.drawn_every = std::max(preview_.drawn_every, rings.drawn_every);
        preview_.spacing = std::max(preview_.spacing, rings.spacing);
        std::move(rings.lines.begin(), rings.lines.end(), std::back_inserter(preview_.lines));
    }
    /// How much most of the surface bends away from a plane across the travel, 1/mm: all but a quarter.
    double convex_bend(const PreviewField& field) const {
        const DriveFrame frame(request_.travel);
        const double apart = std::max(0.5 * cutter_.max_radius(), 2 * field.grid().cell);
        std::vector<double> bends;
        for (std::size_t i = 0; i < field.grid().size(); ++i) {
            if (!field.kept(i)) continue;
            const Vec2 p = field.grid().middle(i), d = apart * frame.across;
            if (!field.kept(p + d) || !field.kept(p - d)) continue;
            const auto a = field.tips().height(p - d), b = field.tips().height(p + d);
            if (!a || !b) continue;
            const double rise = (*b - *a) / (2 * apart), z = double(field.tips().z(i));
            bends.push_back(
                std::max(0.0, (2 * z - *a - *b) / (apart * apart) / std::pow(1 + rise * rise, 1.5)));
        }
        return bends.empty() ? 0 : share_below(bends, 0.75);
    }

    void about(const RadialCommon& settings, bool winding, const Progress& progress) {
        const PreviewStep apart = step_of(settings.stepover, settings.chord_tolerance);
        const PreviewField field = this->field(cutter_, every_slope, progress.part(0, 0.5));
        need(field);
        const auto lines = winding ? turn_lines(settings, request_, field, apart, progress)
                                   : spoke_lines(settings, request_, field, apart);
        lay_lines(lines, laying(field), preview_, progress.part(0.5, 1));
    }

    void blend(const MorphSettings& settings, const Progress& progress) {
        const PreviewStep apart = step_of(settings.stepover, settings.chord_tolerance);
        const PreviewField field = this->field(cutter_, every_slope, progress.part(0, 0.5));
        need(field);
        lay_lines(blend_lines(settings, request_, field, apart, progress), laying(field), preview_,
                  progress.part(0.5, 1));
    }

    void along(const AlongCurveSettings& settings, const Progress& progress) {
        const CoarseTips tips(request_.ground, cutter_, kept_off_, progress.part(0, 0.5));
        preview_.spacing = tips.spacing();
        std::vector<PlanLine> lines = beside_lines(settings, request_, tips, progress);
        for (long k = settings.cuts - 1; k >= 0; --k)
            lay_lines(
                lines,
                [&](const PlanLine& line, std::vector<std::vector<Vec3>>& laid) {
                    lay_everywhere(tips, line, double(k) * settings.cut_depth - settings.depth, laid);
                },
                preview_, progress);
    }

    void pencil(const PencilSettings& settings, const Progress& progress) {
        const PreviewStep apart = step_of(settings.stepover, settings.chord_tolerance);
        const PreviewField field = this->field(cutter_, every_slope, progress.part(0, 0.5));
        const double left = cusp_budget(common_, request_.context);
        const double shortest =
            settings.smallest_valley.is_number() ? settings.smallest_valley.number : cutter_.max_radius();
        const auto valleys = preview_valleys(field, left, shortest, progress.part(0.5, 0.7));
        if (valleys.empty())
            throw Error(ErrorCode::empty_result, common_.name,
                        "the cutter touches no two flanks of a valley that it leaves",
                        "choose a larger tool or a smaller tolerance");
        std::vector<PlanLine> lines;
        for (const PreviewValley& valley : valleys)
            for (long k = -settings.side_passes; k <= settings.side_passes; ++k)
                for (PlanLine& line : valley_lines(valley, double(k) * apart.level, false))
                    lines.push_back(std::move(line));
        lay_lines(lines, laying(field), preview_, progress.part(0.7, 1));
    }

    void clean_up(const CleanupSettings& settings, const Progress& progress) {
        if (request_.context.further_tools.empty())
            throw Error(ErrorCode::missing_reference, "previous_tool", "the previous tool is not in the list",
                        "choose one that is");
        const CutterProfile before(request_.context.further_tools.front().cutter());
        const PreviewStep step = step_of({0, "adaptive"}, {0, "auto"});
        const double left = cusp_budget(common_, request_.context);
        const double shortest =
            settings.smallest_strip.is_number() ? settings.smallest_strip.number : cutter_.max_radius();
        std::vector<PreviewValley> valleys;
        {
            const PreviewField field = this->field(before, every_slope, progress.part(0, 0.4));
            valleys = preview_valleys(field, left, shortest, progress.part(0.4, 0.5));
        }
        if (valleys.empty())
            throw Error(ErrorCode::empty_result, common_.name,
                        "the previous tool leaves nothing above the tolerance",
                        "nothing has to be cleaned up, or allow less");
        const PreviewField field = this->field(cutter_, every_slope, progress.part(0.5, 0.8));
        std::vector<PlanLine> lines;
        for (const PreviewValley& valley : valleys) {
            double widest = 0;
            for (const PreviewTouch& t : valley.touches)
                widest = std::max(widest, t.half);
            const long beside = std::max(0L, std::lround(std::floor(widest / step.level)));
            for (long k = -beside; k <= beside; ++k)
                for (PlanLine& line : valley_lines(valley, double(k) * step.level, k != 0))
                    lines.push_back(std::move(line));
        }
        lay_lines(lines, laying(field), preview_, progress.part(0.8, 1));
        if (settings.left_points || settings.rest_material)
            preview_.without.emplace_back("strips around what operations before left");
    }

    const Operation& operation_;
    const OperationCommon& common_;
    const PreviewRequest& request_;
    CutterProfile cutter_;
    double kept_off_;
    PassPreview preview_;
};

} // namespace

double PassPreview::length() const {
    double sum = 0;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            sum += (line[i] - line[i - 1]).norm();
    return sum;
}

PassPreview preview_passes(const Operation& operation, const PreviewRequest& request,
                           const Progress& progress) {
    check_plannable(request.context, operation.common());
    PassPreview preview = PreviewMaker(operation, request).run(progress);
    if (preview.lines.empty())
        throw Error(ErrorCode::empty_result, operation.common().name, "the preview found nothing to cut",
                    "plan the operation to see why");
    return preview;
}

} // namespace facetmill
