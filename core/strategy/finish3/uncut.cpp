#include "core/strategy/finish3/uncut.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/part_distance.h"
#include "core/strategy/surface/facet_rows.h"
#include "core/strategy/surface/lift_line.h"
#include "core/strategy/surface/stock_field.h"
#include "core/strategy/surface/up_side.h"

#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// Facets that a thread takes at a time, at least, in so many blocks at most, and those between two looks at
/// the cancel flag.
constexpr std::size_t block_facets = 64, max_blocks = 4096;
constexpr std::size_t check_every = 8192;
/// Samples beyond one a facet: some seconds of work.
constexpr double max_samples = 4e6;
/// Where the part holds the cutter up by more than this share of the allowed height, that is why too much
/// stays.
constexpr double reach_share = 0.25;
/// So many ways round a flat bottom is asked to stand over a place.
constexpr int flat_places = 24;
/// Samples of a row between two looks at the cancel flag.
constexpr std::size_t row_part = 512;

/// Which facets count, and with which side up.
class UpwardFacets {
public:
    UpwardFacets(const Mesh& mesh, const Progress& progress) : mesh_(mesh), side_(mesh, progress) {}

    bool closed() const { return side_.closed(); }
    /// The facet's unit normal with the side up that counts; zero: the facet asks for nothing.
    Vec3 normal(std::size_t f) const {
        const Vec3 n = side_.towards_tool(mesh_.facet_normal(f));
        return n.z() >= tolerance::vertical_normal_z ? n : Vec3(Vec3::Zero());
    }

private:
    const Mesh& mesh_;
    UpSide side_;
};

/// The passes of one drive plane.
struct Line {
    double v = 0;
    std::vector<std::vector<LinePoint>> runs; ///< s is u, never falling
    std::vector<std::vector<double>> lowest;  ///< of each run, over so many pieces at a time
};
constexpr std::size_t pieces_together = 8;

/// The lowest height over each `pieces_together` pieces.
std::vector<double> lowest_of(const std::vector<LinePoint>& run) {
    std::vector<double> lowest((run.size() + pieces_together - 1) / pieces_together, infinity);
    for (std::size_t i = 0; i < run.size(); ++i) {
        double& own = lowest[i / pieces_together];
        own = std::min(own, run[i].z);
        // The first of some pieces is the last of those before.
        if (i % pieces_together == 0 && i > 0) {
            double& before = lowest[i / pieces_together - 1];
            before = std::min(before, run[i].z);
        }
    }
    return lowest;
}

/// Passes in drive planes.
class Swept : public SweptPasses {
public:
    Swept(const UncutInput& input, std::span<const Pass> passes, const Progress& progress)
        : frame_(input.frame), profile_(input.cover->profile()), table_(profile_),
          radius_(input.cover->radius()) {
        std::vector<Line> lines;
        for (const Pass& pass : passes) {
            progress.check();
            Line line{pass.offset, {run_of(pass)}, {}};
            if (!line.runs.front().empty()) lines.push_back(std::move(line));
        }
        std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.v < b.v; });
        for (Line& line : lines) {
            if (!lines_.empty() && lines_.back().v == line.v)
                lines_.back().runs.push_back(std::move(line.runs.front()));
            else
                lines_.push_back(std::move(line));
        }
        for (Line& line : lines_)
            for (const auto& run : line.runs)
                line.lowest.push_back(lowest_of(run));
    }

    /// Asked whether it is above `enough` it says no more than that, where it is.
    double lowest(const Vec3& q, const Vec3& hint, double enough) const override {
        const double v_q = frame_.v(q), v = frame_.v(hint), u = frame_.u(hint);
        auto after = std::lower_bound(lines_.begin(), lines_.end(), v,
                                      [](const Line& l, double x) { return l.v < x; });
        auto before = after;
        double best = enough > -infinity ? std::nextafter(enough, infinity) : infinity;
        for (;;) {
            // From the hint to both sides.
            const bool right = after != lines_.end() && after->v <= v_q + radius_;
            const bool left = before != lines_.begin() && std::prev(before)->v >= v_q - radius_;
            if (!right && !left) return best;
            const bool take_right = right && (!left || after->v - v <= v - std::prev(before)->v);
            lower(take_right ? *after++ : *--before, q, u, enough, best);
            if (best <= enough) return best;
        }
    }

private:
    std::vector<LinePoint> run_of(const Pass& pass) const {
        const double longest = 0.2 * radius_; // of which a parabola finds the lowest place
        std::vector<LinePoint> run;
        const std::size_t n = pass.cl.size();
        const bool forward = n == 0 || frame_.u(pass.cl.front().tip) <= frame_.u(pass.cl.back().tip);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3& tip = pass.cl[forward ? i : n - 1 - i].tip;
            const LinePoint next{frame_.u(tip), tip.z()};
            if (!run.empty()) {
                const LinePoint from = run.back();
                const auto parts = std::size_t(std::hypot(next.s - from.s, next.z - from.z) / longest) + 1;
                for (std::size_t k = 1; k < parts; ++k) {
                    const double x = double(k) / double(parts);
                    run.push_back({from.s + x * (next.s - from.s), from.z + x * (next.z - from.z)});
                }
            }
            run.push_back(next);
        }
        return run;
    }

    void lower(const Line& line, const Vec3& q, double u, double enough, double& best) const {
        const double across = line.v - frame_.v(q), square = across * across, u_q = frame_.u(q);
        if (square > radius_ * radius_) return;
        const double half = std::sqrt(radius_ * radius_ - square); // tips beyond do not reach over q
        const auto over = [&](double s, double z) {
            const double rho = std::sqrt(square + (s - u_q) * (s - u_q));
            return rho <= radius_ ? z + profile_.height_at(rho) : infinity;
        };
        // Convex along a piece, because a swept convex body is convex.
        const auto piece = [&](const LinePoint& a, const LinePoint& b) {
            const double low = std::min(a.z, b.z);
            if (low >= best || a.s > u_q + half || b.s < u_q - half) return;
            const double beside = std::max({a.s - u_q, u_q - b.s, 0.0});
            if (low + table_.at_least(square + beside * beside) >= best) return;
            const double from = std::max(a.s, u_q - half), to = std::min(b.s, u_q + half);
            const auto at = [&](double s) {
                const double x = b.s > a.s ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 0;
                return over(s, a.s < b.s ? a.z + x * (b.z - a.z) : std::min(a.z, b.z));
            };
            const double f0 = at(from), f1 = at(0.5 * (from + to)), f2 = at(to);
            best = std::min({best, f0, f1, f2});
            const double bend = f0 - 2 * f1 + f2;
            if (!(bend > 0) || bend == infinity) return;
            const double x = 0.5 + 0.25 * (f0 - f2) / bend;
            if (x > 0 && x < 1) best = std::min(best, at(from + x * (to - from)));
        };
        for (std::size_t r = 0; r < line.runs.size(); ++r) {
            const auto& run = line.runs[r];
            if (run.front().s > u_q + half || run.back().s < u_q - half) continue;
            const auto first = [&](double s) {
                const auto p = std::lower_bound(run.begin(), run.end(), s,
                                                [](const LinePoint& l, double x) { return l.s < x; });
                return std::size_t(p - run.begin());
            };
            if (run.size() == 1) piece(run[0], run[0]);
            const std::size_t k =
                std::clamp<std::size_t>(first(u), 1, std::max<std::size_t>(run.size() - 1, 1));
            if (run.size() > 1) piece(run[k - 1], run[k]);
            for (std::size_t i = std::max<std::size_t>(first(u_q - half), 1);
                 best > enough && i < run.size() && run[i - 1].s <= u_q + half; ++i) {
                const bool together = (i - 1) % pieces_together == 0;
                if (together && line.lowest[r][(i - 1) / pieces_together] >= best)
                    i += pieces_together - 1;
                else
                    piece(run[i - 1], run[i]);
            }
            if (best <= enough) return;
        }
    }

    DriveFrame frame_;
    const CutterProfile& profile_;
    StockCutter table_;
    double radius_;
    std::vector<Line> lines_;
};

class Search {
public:
    Search(const UncutInput& input, const Progress& progress)
        : in_(input), up_(*input.mesh, progress), own_(input, input.passes, progress),
          own_left_out_(input, input.left_out, progress), swept_(input.swept ? *input.swept : own_),
          left_out_(input.swept_left_out ? *input.swept_left_out : own_left_out_),
          needle_(input.contact,
                  CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height))),
          limit_(2 * input.cover->radius()) {
        // Hollows as deep as the allowed height are about this wide.
        const double radius = in_.cover->radius();
        spacing_ = std::clamp(std::sqrt(2 * radius * in_.allowed), 0.05 * radius, 0.25 * radius);
        double area = 0, length = 0;
        const Mesh& mesh = *in_.mesh;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % check_every == 0) progress.check();
            if (up_.normal(f) == Vec3::Zero()) continue;
            area += 0.5 * mesh.facet_cross(f).norm();
            for (int k = 0; k < 3; ++k)
                length += (mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k)).norm() / 3;
        }
        spacing_ = std::max({spacing_, std::sqrt(area / max_samples), length / max_samples});
    }

    UncutReport run(const Progress& progress) {
        const std::size_t facets = in_.mesh->facet_count(),
                          size = std::max(block_facets, facets / max_blocks);
        std::vector<Block> blocks((facets + size - 1) / size);
        parallel_for(blocks.size(), 1, progress, [&](std::size_t b) {
            for (std::size_t f = b * size; f < std::min(facets, (b + 1) * size); ++f)
                facet(f, blocks[b], progress);
        });
        UncutReport all;
        for (const Block& block : blocks)
            add(all, block.report);
        return all;
    }

private:
    /// What some facets leave, and where their last lifts came from.
    struct Block {
        UncutReport report;
        LiftHint lift, needle;
    };

    static void add(UncutReport& a, const UncutReport& b) {
        a.area += b.area;
        a.samples += b.samples;
        a.below += b.below;
        a.passed_tips.insert(a.passed_tips.end(), b.passed_tips.begin(), b.passed_tips.end());
        for (auto places : {&UncutReport::out_of_reach, &UncutReport::passed_by, &UncutReport::held,
                            &UncutReport::covered}) {
            UncutPlaces& mine = a.*places;
            const UncutPlaces& more = b.*places;
            mine.area += more.area;
            if (more.height > mine.height) {
                mine.height = more.height;
                mine.at = more.at;
            }
        }
    }

    void facet(std::size_t f, Block& block, const Progress& progress) {
        UncutReport& report = block.report;
        const Vec3 n = up_.normal(f);
        if (n == Vec3::Zero()) return;
        const FacetRows rows(*in_.mesh, f, spacing_);
        report.area += rows.area();
        const Vec3 tip_offset = in_.cover->tip_offset(n);
        for (std::size_t row = 0; row < rows.rows(); ++row)
            for (std::size_t column = 0; column < rows.columns(row); ++column) {
                if (column % row_part == 0) progress.check();
                ++report.samples;
                sample(rows.point(row, column), n, tip_offset, rows.weight(row), block);
            }
    }

    void sample(const Vec3& on_part, const Vec3& n, const Vec3& tip_offset, double area, Block& block) {
        UncutReport& report = block.report;
        // The cutter is convex: where it comes nearer to p along n than is allowed, it holds the place that
        // far above p.
        const Vec3 p = on_part + in_.allowance * n, tip = p + tip_offset;
        if (passes_hold(p + in_.allowed * n, tip)) return;
        if (tip.z() < in_.lowest_tip) {
            report.below += area;
            return;
        }
        UncutPlaces* places = &report.out_of_reach;
        const Vec3 highest = p + in_.allowed * n;
        if ((in_.swept_left_out || !in_.left_out.empty())
            && left_out_.lowest(highest, tip, highest.z()) <= highest.z()) {
            places = &report.held;
        } else if (needle_.is_above(p.x(), p.y(), p.z() + in_.allowed, block.needle)) {
            if (!up_.closed() && !in_.outside_up) return;
            places = &report.covered;
        } else {
            if (const auto reached = tip_that_reaches(p, n, tip, block.lift)) {
                places = &report.passed_by;
                if (in_.tell_passed) report.passed_tips.push_back(*reached);
            }
        }
        places->area += area;
        // How high exactly is asked only of the highest.
        if (places->height > 0 && passes_hold(p + places->height * n, tip)) return;
        const double left = height(p, n, tip, std::max(places->height, in_.allowed));
        if (left <= places->height) return;
        places->height = left;
        places->at = on_part;
    }

    /// A tip that comes down to p; none where the part around holds it up, wherever it stands.
    std::optional<Vec3> tip_that_reaches(const Vec3& p, const Vec3& n, const Vec3& tip,
                                         LiftHint& hint) const {
        const Vec3 q = p + reach_share * in_.allowed * n;
        const auto reaches = [&](const Vec2& at) {
            const double rho = (q.head<2>() - at).norm();
            return rho <= in_.cover->radius()
                   && !in_.lift->is_above(at.x(), at.y(), q.z() - in_.cover->profile().height_at(rho), hint);
        };
        if (reaches(tip.head<2>())) return tip;
        // A flat bottom on a level plane may stand any way over the place.
        if ((tip - p).head<2>().norm() > 0 || !in_.cover->has_flat_bottom()) return std::nullopt;
        for (const double far : {1.0, 0.5})
            for (int k = 0; k < flat_places; ++k) {
                const double angle = 2 * pi * k / flat_places;
                const Vec2 at =
                    p.head<2>() + far * in_.cover->flat_radius() * Vec2(std::cos(angle), std::sin(angle));
                if (reaches(at)) return Vec3(at.x(), at.y(), tip.z());
            }
        return std::nullopt;
    }

    bool passes_hold(const Vec3& q, const Vec3& tip) const { return swept_.lowest(q, tip, q.z()) <= q.z(); }

    /// How much stands over p, where that is more than `from`: along the normal, or upright where no pass
    /// crosses that soon; and no farther than its end is from all of the part, as the verifier says it.
    double height(const Vec3& p, const Vec3& n, const Vec3& tip, double from) const {
        const auto from_part = [&](double far, const Vec3& direction) {
            return far > 2 * in_.allowed ? std::min(far, distance(p + far * direction, far)) : far;
        };
        double low = from;
        for (double high = 1.25 * from; low < limit_; low = high, high *= 1.25) {
            if (!passes_hold(p + high * n, tip)) continue;
            while (high - low > 0.01 * high) {
                const double mid = 0.5 * (low + high);
                (passes_hold(p + mid * n, tip) ? high : low) = mid;
            }
            return from_part(high, n);
        }
        const double over = swept_.lowest(p, tip, -infinity);
        return from_part(over < infinity ? over - p.z() : in_.top - p.z(), Vec3::UnitZ());
    }

    /// From the part, but for what is to stay on it; `most` or more where that is farther.
    double distance(const Vec3& p, double most) const {
        const double allowance = in_.allowance;
        return std::max(part_distance(*in_.contact, p, most + allowance) - allowance, 0.0);
    }

    const UncutInput& in_;
    UpwardFacets up_;
    Swept own_, own_left_out_;
    const SweptPasses &swept_, &left_out_;
    AxialLift needle_;
    double limit_, spacing_ = 1;
};

} // namespace

UncutReport find_uncut(const UncutInput& input, const Progress& progress) {
    Search search(input, progress.part(0, 0.02));
    return search.run(progress.part(0.02, 1));
}

} // namespace facetmill
