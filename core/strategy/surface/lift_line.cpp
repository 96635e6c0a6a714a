#include "core/strategy/surface/lift_line.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/line_refiner.h"

namespace facetmill {

namespace {

constexpr std::size_t block_segments = 8;
/// One line over a field, for one thread.
struct FieldLine {
    using Point = LinePoint;
    const LiftField& field;
    Vec2 origin, direction;
    const Progress& progress;
    LiftHint hint;

    LinePoint at(double s) { return {s, field.tip_z(origin + s * direction, hint)}; }
    LinePoint middle(const LinePoint& a, const LinePoint& b) { return at(0.5 * (a.s + b.s)); }
    static LinePoint flat(const LinePoint& from, const LinePoint& p) { return {p.s - from.s, p.z}; }
    static LinePoint over(const LinePoint& high, const LinePoint& low) { return {low.s, high.z}; }
    void check() const { progress.check(); }
};

} // namespace

double LiftField::tip_z(const Vec2& p, LiftHint& hint) const {
    const double z = std::max(lift->tip_z(p.x(), p.y(), hint), floor);
    if (!bodies || bodies->empty()) return z;
    HolderReach::Hints hints;
    return bodies->raised(p, z, hints);
}

double safe_spacing(const CutterProfile& profile, double below) {
    const auto round = [below](double radius) { return std::sqrt(8 * radius * below); };
    double spacing = 0.25 * profile.max_radius(), slope = 0; // slopes as angles
    for (const ProfilePiece& p : profile.lower_pieces()) {
        if (p.kind == ProfilePiece::Kind::arc) {
            // At a sharp corner it is the roundness of its rim, sideways, that counts.
            spacing = std::min(spacing, round(std::max(p.radius, 0.5 * (p.center.x() + p.radius))));
        } else if (p.angle_at_start() > slope + tolerance::cutter_angle) {
            // A cone is as round as its inner rim. Of a peak too thin to be seen at the ends and the middle
            // of a piece of length c, a pointed one passes at most c / 4 times the sine of its slope,
            // measured across its side.
            const double thin = 4 * below / std::sin(p.angle_at_start());
            spacing = std::min(spacing, std::max(round(0.5 * p.from.x()), thin));
        }
        slope = p.angle_at_end();
    }
    if (slope < 0.5 * pi - tolerance::cutter_angle)
        spacing = std::min(spacing, round(0.5 * profile.max_radius()));
    return spacing;
}

std::vector<LinePoint> lift_line(const LiftField& field, const Vec2& origin, const Vec2& direction, double s0,
                                 double s1, const LineTolerance& tolerance, const Progress& progress) {
    if (!(s1 > s0)) return {FieldLine{field, origin, direction, progress, {}}.at(s0)};
    const auto n = std::size_t(std::ceil((s1 - s0) / (2 * tolerance.spacing)));
    const auto node = [&](std::size_t i) { return i == n ? s1 : s0 + (s1 - s0) * (double(i) / double(n)); };
    const std::size_t blocks = (n - 1) / block_segments + 1;
    std::vector<std::vector<LinePoint>> parts(blocks);
    parallel_blocks(n, block_segments, progress, [&](std::size_t begin, std::size_t end) {
        auto& part = parts[begin / block_segments];
        FieldLine on{field, origin, direction, progress, {}};
        const LineRefiner refiner(on, tolerance);
        LinePoint last = on.at(node(begin));
        if (begin == 0) part.push_back(last);
        for (std::size_t i = begin; i < end; ++i) {
            const LinePoint next = on.at(node(i + 1));
            refiner.add(last, on.middle(last, next), next, part);
            last = next;
        }
    });
    std::vector<LinePoint> line;
    for (const auto& part : parts)
        line.insert(line.end(), part.begin(), part.end());
    return line;
}

std::vector<LinePoint> thinned(const std::vector<LinePoint>& line, double below, double above) {
    if (line.size() < 3) return line;
    std::vector<LinePoint> kept{line.front()};
    std::size_t from = 0;
    while (from + 1 < line.size()) {
        // Slopes of a chord from `from` that respect all points passed so far.
        double low = -infinity, high = infinity;
        std::size_t best = from + 1;
        for (std::size_t k = from + 1; k < line.size(); ++k) {
            const double ds = line[k].s - line[from].s, dz = line[k].z - line[from].z;
            if (!(ds > 0)) break;
            const double slope = dz / ds;
            if (slope >= low && slope <= high) best = k;
            low = std::max(low, (dz - below) / ds);
            high = std::min(high, (dz + above) / ds);
            if (low > high) break;
        }
        kept.push_back(line[best]);
        from = best;
    }
    return kept;
}

} // namespace facetmill
