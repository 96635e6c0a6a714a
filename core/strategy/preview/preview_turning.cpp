#include "core/strategy/preview/preview_turning.h"

#include "core/base/parallel.h"
#include "core/strategy/preview/preview_lines.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// What a field of tips may cost; a grid of so few rows is not halved.
constexpr double turning_work = 25e6;
constexpr int smallest_turned_grid = 40;
/// A sample of a facet in every cell, a little nearer than cells are to each other.
constexpr double sample_share = 0.7;
constexpr std::size_t max_turns = 700, max_counted = 1'000'000;
constexpr double min_feed = 0.1; ///< of the feed on a cylinder

/// A cutter's lower surface by the distance from its axis, looked up.
class ProfileTable {
public:
    explicit ProfileTable(const CutterProfile& cutter) : radius_(cutter.max_radius()) {
        for (std::size_t k = 0; k < heights_.size(); ++k)
            heights_[k] = float(cutter.height_at(radius_ * double(k) / double(heights_.size() - 1)));
    }
    double radius() const { return radius_; }
    float at(double distance) const {
        return heights_[std::size_t(distance / radius_ * double(heights_.size() - 1))];
    }

private:
    double radius_;
    std::array<float, 1024> heights_{};
};

/// Where the tip stands over a part that turns, by angle and place along the axis.
class TurnedTips {
public:
    TurnedTips(const LatheFrame& frame, const TurnedGround& ground, const CutterProfile& cutter, double core,
               const Progress& progress)
        : offset_(frame.offset()), core_(core), ground_(ground) {
        const double r = cutter.max_radius();
        // Half of a turn can be seen from the tool.
        while (ground_.rows > smallest_turned_grid
               && double(ground_.rows) * ground_.columns * (0.5 * ground_.columns)
                          * (2 * r / ground_.cell + 1)
                      > turning_work)
            ground_ = ground_.halved();
        let_down(ProfileTable(cutter), progress);
    }

    const Interval& along() const { return ground_.along; }
    double outer() const { return ground_.outer; }
    double cell() const { return ground_.cell; }
    /// The tip's place at an angle and a place along the axis; nothing where the part ends.
    std::optional<double> tip(double angle, double y) const {
        const double x = angle / (2 * pi) * ground_.columns - 0.5,
                     t = (y - ground_.along.lo) / ground_.cell - 0.5;
        const int x0 = int(std::floor(x)), y0 = int(std::floor(t));
        double sum = 0, weight = 0;
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
                const int row = std::clamp(y0 + dy, 0, ground_.rows - 1);
                const float u = tip_[ground_.index(x0 + dx, row)];
                if (!is_there(u)) continue;
                const double w = (dx ? x - x0 : 1 - (x - x0)) * (dy ? t - y0 : 1 - (t - y0));
                sum += w * double(u);
                weight += w;
            }
        if (!(weight > 1e-9)) return std::nullopt;
        return std::max(sum / weight, core_);
    }
    double lowest() const {
        double low = infinity;
        for (const float u : tip_)
            if (is_there(u)) low = std::min(low, std::max(double(u), core_));
        return low;
    }

private:
    void let_down(const ProfileTable& cutter, const Progress& progress) {
        const int reach_y = int(std::ceil(cutter.radius() / ground_.cell)), columns = ground_.columns;
        struct Turn {
            int by;
            float cosine;
            double sine;
        };
        // From straight below outward: what is found there rules out most of the rest.
        std::vector<Turn> turns;
        for (int k = 0; k <= columns / 4; ++k)
            for (const int by : {k, -k}) {
                const double angle = 2 * pi * by / columns;
                if (k > 0 || by >= 0) turns.push_back({by, float(std::cos(angle)), std::sin(angle)});
            }
        tip_.assign(ground_.away.size(), nothing_there);
        parallel_for(std::size_t(ground_.rows), 1, progress, [&](std::size_t row) {
            const int y0 = std::max(0, int(row) - reach_y),
                      y1 = std::min(ground_.rows - 1, int(row) + reach_y);
            for (int x = 0; x < columns; ++x) {
                float best = nothing_there;
                for (const Turn& turn : turns)
                    for (int y = y0; y <= y1; ++y) {
                        const float away = ground_.away[ground_.index(x + turn.by, y)];
                        const float out = turn.cosine * away;
                        if (!is_there(away) || out <= best) continue;
                        const double beside = turn.sine * double(away) - offset_,
                                     apart = ground_.cell * (y - int(row)),
                                     far = std::sqrt(beside * beside + apart * apart);
                        if (far <= cutter.radius()) best = std::max(best, out - cutter.at(far));
                    }
                tip_[ground_.index(x, int(row))] = best;
            }
        });
    }

    double offset_, core_;
    TurnedGround ground_;
    std::vector<float> tip_;
};

/// One turn, ring or line, from a place to another.
struct TurnedLine {
    LathePlace from, to;
};

class TurningPreview {
public:
    TurningPreview(const LatheCommon& settings, double allowance, const PlanContext& context,
                   const TurnedGround& ground, const Progress& progress)
        : settings_(settings), context_(context), allowance_(std::max(allowance, 0.0)),
          step_(preview_step(settings, {0, "adaptive"}, settings.chord_tolerance, context)),
          frame_(settings, context),
          grid_(frame_, ground, CutterProfile(context.tool.cutter()).grown(allowance_),
                std::max(settings.core_radius - allowance_, 0.0), progress) {
        find_range();
    }

    PassPreview run(double depth_of_cut, const Progress& progress) {
        const std::vector<TurnedLine> course = this->course(progress);
        std::vector<double> levels{-infinity};
        if (depth_of_cut > 0) {
            const double top = stock_radius(), low = grid_.lowest() + allowance_;
            const double passes = std::max(1.0, std::ceil((top - low) / depth_of_cut));
            if (passes * double(course.size()) > double(max_counted))
                throw Error(ErrorCode::limit_exceeded, "depth_of_cut",
                            "the depth of cut asks for too many passes", "choose a larger depth of cut");
            levels.clear();
            for (int k = 1; k <= int(passes); ++k)
                levels.push_back(k == int(passes) ? low : top - k * depth_of_cut);
        }
        PassPreview preview;
        preview.spacing = grid_.cell();
        preview.step = step_.level;
        const std::size_t all = course.size() * levels.size();
        const std::size_t every = std::max<std::size_t>(1, (all + max_turns - 1) / max_turns);
        std::vector<std::vector<std::vector<Vec3>>> laid((all + every - 1) / every);
        parallel_for(laid.size(), 1, progress, [&](std::size_t i) {
            const std::size_t level = i * every / course.size(), line = i * every % course.size();
            lay(course[line], levels[level], level > 0 ? levels[level - 1] : infinity, laid[i]);
        });
        std::size_t cut = 0;
        for (auto& pieces : laid) {
            cut += pieces.empty() ? 0 : 1;
            for (auto& piece : pieces)
                preview.lines.push_back(std::move(piece));
        }
        preview.passes = cut * every;
        preview.drawn_every = every;
        if (settings_.tilt != 0) preview.without.emplace_back("the tilt of the tool");
        return preview;
    }

private:
    void find_range() {
        range_ = grid_.along();
        if (settings_.start.is_number()) range_.lo = std::max(range_.lo, settings_.start.number);
        if (settings_.stop.is_number()) range_.hi = std::min(range_.hi, settings_.stop.number);
        const double r = CutterProfile(context_.tool.cutter()).max_radius();
        Interval stock = grid_.along();
        if (!context_.stock_box.empty())
            for (const Vec3& p : {context_.stock_box.lo, context_.stock_box.hi}) {
                stock.lo = std::min(stock.lo, frame_.along(p));
                stock.hi = std::max(stock.hi, frame_.along(p));
            }
        if (settings_.chuck[0] > 0) range_.lo = std::max(range_.lo, stock.lo + settings_.chuck[0] + r);
        if (settings_.tailstock[0] > 0)
            range_.hi = std::min(range_.hi, stock.hi - settings_.tailstock[0] - r);
        if (!(range_.hi > range_.lo))
            throw Error(ErrorCode::empty_result, settings_.name, "nothing is left between its ends",
                        "check start, stop, chuck and tailstock");
    }

    double stock_radius() const {
        const StockSolid& stock = context_.stock;
        if (stock.kind == StockSolid::Kind::cylinder
            && std::abs(frame_.axis().direction[stock.axis]) > 1 - 1e-9)
            return stock.radius;
        const Box3& box = context_.stock_box;
        double far = grid_.outer();
        for (int k = 0; k < 8 && !box.empty(); ++k)
            far = std::max(far, frame_.away({k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(),
                                             k & 4 ? box.hi.z() : box.lo.z()}));
        return far;
    }

    /// How much less than on a cylinder the tool may advance at a place along the axis.
    double nearer(double y) const {
        constexpr int looks = 32;
        std::vector<double> share;
        for (int k = 0; k < looks; ++k) {
            const double angle = 2 * pi * k / looks;
            const auto a = grid_.tip(angle, y - grid_.cell()), b = grid_.tip(angle, y + grid_.cell());
            if (!a || !b) continue;
            const double g = (*b - *a) / (2 * grid_.cell());
            share.push_back(1 / std::sqrt(1 + g * g));
        }
        if (share.empty()) return 1;
        // All round: the side feed minds every place of a turn.
        return std::max(*std::min_element(share.begin(), share.end()), min_feed);
    }

    std::vector<TurnedLine> course(const Progress& progress) const {
        using Pattern = LatheCommon::Pattern;
        const bool fixed = settings_.side_feed.is_number();
        std::vector<TurnedLine> lines;
        if (settings_.pattern == Pattern::lengthwise) {
            // Round the part the surface falls away from the cutter, too.
            const double bend = 8 * step_.cusp / (step_.level * step_.level) + 1 / grid_.outer();
            const double step = fixed ? settings_.side_feed.number : std::sqrt(8 * step_.cusp / bend);
            const double count = std::ceil(2 * pi * grid_.outer() / step);
            check(count);
            for (int k = 0; k < int(count); ++k) {
                const double angle = 2 * pi * k / count;
                lines.push_back(
                    {{angle, k % 2 ? range_.hi : range_.lo}, {angle, k % 2 ? range_.lo : range_.hi}});
            }
            return lines;
        }
        const double step = fixed ? settings_.side_feed.number : step_.level;
        check((range_.hi - range_.lo) / step);
        double angle = 0;
        for (double y = range_.lo;;) {
            progress.check();
            const double advance = fixed ? step : step * nearer(y);
            const bool ring = settings_.pattern == Pattern::rings || y >= range_.hi;
            const double to = std::min(y + advance, range_.hi);
            lines.push_back({{angle, y}, {angle + 2 * pi, ring ? y : to}});
            angle += ring ? 0 : 2 * pi;
            if (y >= range_.hi) break;
            y = to;
            check(double(lines.size()));
        }
        return lines;
    }

    static void check(double lines) {
        if (lines > double(max_counted))
            throw Error(ErrorCode::limit_exceeded, "side_feed", "it asks for too many turns",
                        "allow a larger tolerance or set a side feed");
    }

    /// What of a line lies deeper than the pass before.
    void lay(const TurnedLine& line, double level, double before,
             std::vector<std::vector<Vec3>>& lines) const {
        const double length = std::max(std::abs(line.to.angle - line.from.angle) * grid_.outer(),
                                       std::abs(line.to.y - line.from.y));
        const int steps = std::clamp(int(std::ceil(length / grid_.cell())), 24, 400);
        std::vector<Vec3> run;
        const auto end_run = [&] {
            if (run.size() > 1) lines.push_back(std::move(run));
            run.clear();
        };
        for (int k = 0; k <= steps; ++k) {
            const double t = double(k) / steps;
            const LathePlace place{line.from.angle + t * (line.to.angle - line.from.angle),
                                   line.from.y + t * (line.to.y - line.from.y)};
            const auto u = grid_.tip(place.angle, place.y);
            if (!u || *u + allowance_ >= before) {
                end_run();
                continue;
            }
            run.push_back(frame_.at(place, std::max(*u + allowance_, level)).tip);
        }
        end_run();
    }

    const LatheCommon& settings_;
    const PlanContext& context_;
    double allowance_;
    PreviewStep step_;
    LatheFrame frame_;
    TurnedTips grid_;
    Interval range_;
};

} // namespace

TurnedGround::TurnedGround(const LatheCommon& settings, const PlanContext& context, int cells,
                           const Progress& progress) {
    const LatheFrame frame(settings, context);
    const Mesh& mesh = *context.part;
    const Vec3 &point = frame.axis().point, &direction = frame.axis().direction, &zero = frame.zero();
    const Vec3 side = direction.cross(zero);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 8192 == 0) progress.check();
        for (int k = 0; k < 3; ++k) {
            const Vec3& p = mesh.corner(f, k);
            along.lo = std::min(along.lo, frame.along(p));
            along.hi = std::max(along.hi, frame.along(p));
            outer = std::max(outer, frame.away(p));
        }
    }
    if (!(along.hi > along.lo))
        throw Error(ErrorCode::empty_result, "preview", "the part has no extent along the turning axis",
                    "turn the part or choose another axis");
    // A disc has few rows: its cells are no smaller than its width asks for.
    cell = std::max(along.hi - along.lo, outer) / cells;
    rows = std::max(1, int(std::ceil((along.hi - along.lo) / cell - 1e-9)));
    columns = std::clamp(int(std::ceil(2 * pi * outer / cell)), 48, cells);
    away.assign(std::size_t(rows) * std::size_t(columns), nothing_there);
    const auto put = [&](const Vec3& p) {
        const Vec3 v = p - point;
        const double a = v.dot(zero), b = v.dot(side);
        const int row = std::clamp(int(std::floor((v.dot(direction) - along.lo) / cell)), 0, rows - 1);
        const int column = int(std::floor(std::atan2(b, a) / (2 * pi) * columns));
        float& out = away[index(column, row)];
        out = std::max(out, float(std::sqrt(a * a + b * b)));
    };
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 256 == 0) progress.check();
        const Vec3 a = mesh.corner(f, 0), b = mesh.corner(f, 1) - a, c = mesh.corner(f, 2) - a;
        const double longest = std::sqrt(std::max({b.squaredNorm(), c.squaredNorm(), (b - c).squaredNorm()}));
        const int n = int(std::ceil(longest / (sample_share * cell)));
        if (n <= 1) {
            put(a + (b + c) / 3);
            continue;
        }
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k + i <= n; ++k)
                put(a + double(i) / n * b + double(k) / n * c);
    }
}

TurnedGround TurnedGround::halved() const {
    TurnedGround half = *this;
    half.cell = 2 * cell;
    half.rows = (rows + 1) / 2;
    half.columns = (columns + 1) / 2;
    half.away.assign(std::size_t(half.rows) * std::size_t(half.columns), nothing_there);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            // The number of columns may be odd: by angle.
            const int column = int((double(x) + 0.5) / columns * half.columns);
            float& out = half.away[half.index(column, y / 2)];
            out = std::max(out, away[index(x, y)]);
        }
    return half;
}

PassPreview preview_turning(const LatheCommon& settings, double allowance, double depth_of_cut,
                            const PlanContext& context, const TurnedGround& ground,
                            const Progress& progress) {
    TurningPreview preview(settings, allowance, context, ground, progress.part(0, 0.7));
    return preview.run(depth_of_cut, progress.part(0.7, 1));
}

} // namespace facetmill
