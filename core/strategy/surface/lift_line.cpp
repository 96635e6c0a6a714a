#include "core/strategy/surface/lift_line.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/holder_reach.h"

namespace facetmill {

namespace {

constexpr std::size_t block_segments = 8;
constexpr int deepest = 40;

class Refiner {
public:
    Refiner(const LiftField& field, const Vec2& origin, const Vec2& direction, const LineTolerance& tolerance,
            const Progress& progress)
        : field_(field), origin_(origin), direction_(direction), tolerance_(tolerance), progress_(progress) {}

    LinePoint at(double s, LiftHint& hint) const { return {s, field_.tip_z(origin_ + s * direction_, hint)}; }

    LinePoint middle(const LinePoint& a, const LinePoint& b, LiftHint& hint) const {
        return at(0.5 * (a.s + b.s), hint);
    }

    /// Appends what lies between a and b, with `mid` half-way, and b.
    void add(const LinePoint& a, const LinePoint& mid, const LinePoint& b, std::vector<LinePoint>& out,
             LiftHint& hint, int depth = 0) const {
        if (b.s - a.s <= tolerance_.shortest() || depth >= deepest) {
            if (b.z < a.z)
                out.push_back({b.s, a.z});
            else if (b.z > a.z)
                out.push_back({a.s, b.z});
            out.push_back(b);
            return;
        }
        if (depth % 8 == 7) progress_.check();
        const LinePoint before = middle(a, mid, hint), after = middle(mid, b, hint);
        if (is_straight(a, before, mid, after, b)) {
            out.insert(out.end(), {before, mid, after, b});
            return;
        }
        add(a, before, mid, out, hint, depth + 1);
        add(mid, after, b, out, hint, depth + 1);
    }

private:
    /// Whether quarters of a piece are all near its chord, and short. The middle alone does not tell: down a
    /// steep wall the path bends over the wall's edge and back at its foot, and what the one bend lifts the
    /// middle over the chord the other may lower it. Of the height of a single kink, wherever it is, the
    /// nearest quarter shows four fifths; half of what is allowed leaves room for a second one beside it.
    bool is_straight(const LinePoint& a, const LinePoint& before, const LinePoint& mid,
                     const LinePoint& after, const LinePoint& b) const {
        const double ds = b.s - a.s, dz = b.z - a.z, across = ds / std::hypot(ds, dz);
        const LinePoint* const quarter[] = {&a, &before, &mid, &after, &b};
        for (std::size_t k = 1; k < 5; ++k) {
            const LinePoint &p = *quarter[k - 1], &q = *quarter[k];
            // Along the path itself, not as seen from above: that is what the cutter may pass unseen.
            if (std::hypot(q.s - p.s, q.z - p.z) > tolerance_.spacing) return false;
            const double off = (q.z - a.z - 0.25 * double(k) * dz) * across;
            if (off > 0.5 * tolerance_.below || off < -0.5 * tolerance_.above) return false;
        }
        return true;
    }

    const LiftField& field_;
    Vec2 origin_, direction_;
    LineTolerance tolerance_;
    const Progress& progress_;
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
    const Refiner refiner(field, origin, direction, tolerance, progress);
    LiftHint first;
    if (!(s1 > s0)) return {refiner.at(s0, first)};
    const auto n = std::size_t(std::ceil((s1 - s0) / (2 * tolerance.spacing)));
    const auto node = [&](std::size_t i) { return i == n ? s1 : s0 + (s1 - s0) * (double(i) / double(n)); };
    const std::size_t blocks = (n - 1) / block_segments + 1;
    std::vector<std::vector<LinePoint>> parts(blocks);
    parallel_blocks(n, block_segments, progress, [&](std::size_t begin, std::size_t end) {
        auto& part = parts[begin / block_segments];
        LiftHint hint;
        LinePoint last = refiner.at(node(begin), hint);
        if (begin == 0) part.push_back(last);
        for (std::size_t i = begin; i < end; ++i) {
            const LinePoint next = refiner.at(node(i + 1), hint);
            refiner.add(last, refiner.middle(last, next, hint), next, part, hint);
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
