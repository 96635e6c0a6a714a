#include "core/strategy/surface/lift_line.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/line_refiner.h"

namespace facetmill {

namespace {

/// Segments that a thread takes at a time: their places are asked together, those of a halving after those of
/// the one before.
constexpr std::size_t block_segments = 32;

/// One line over a field.
struct FieldLine {
    using Point = LinePoint;
    const LiftField& field;
    Vec2 origin, direction;
    const Progress& progress;

    static LinePoint flat(const LinePoint& from, const LinePoint& p) { return {p.s - from.s, p.z}; }
    static LinePoint over(const LinePoint& high, const LinePoint& low) { return {low.s, high.z}; }
};

/// What LineRefiner makes of the segments of a block, halving by halving.
class RefinedBlock {
public:
    RefinedBlock(FieldLine& line, const LineTolerance& tolerance) : line_(line), refiner_(line_, tolerance) {}

    /// `nodes`: where on the line the segments end, two at least. Appends what lies on them, without the
    /// first end.
    void add(const std::vector<double>& nodes, std::vector<LinePoint>& out) {
        std::vector<double> s;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (i > 0) s.push_back(0.5 * (nodes[i - 1] + nodes[i]));
            s.push_back(nodes[i]);
        }
        const std::vector<LinePoint> first = asked(s);
        for (std::size_t i = 0; i + 2 < first.size(); i += 2)
            pieces_.push_back({first[i], first[i + 1], first[i + 2], {}, {}, 0});
        const std::size_t segments = pieces_.size();
        for (std::size_t begin = 0; begin < pieces_.size();)
            begin = divide(begin);
        for (std::size_t i = 0; i < segments; ++i)
            append(i, out);
    }
    /// The first end.
    LinePoint start() const { return pieces_.front().a; }

private:
    struct Piece {
        LinePoint a, mid, b;
        LinePoint before{}, after{}; ///< a quarter from either end
        int depth = 0;
        enum class Kind { jump, straight, divided } kind = Kind::jump;
        std::size_t half = 0; ///< divided: its first half; the second one is next to it
    };

    std::vector<LinePoint> asked(const std::vector<double>& s) const {
        std::vector<Vec2> places;
        places.reserve(s.size());
        for (const double x : s)
            places.push_back(line_.origin + x * line_.direction);
        std::vector<double> z(s.size());
        line_.field.tip_z(places, z, line_.progress);
        std::vector<LinePoint> points(s.size());
        for (std::size_t i = 0; i < s.size(); ++i)
            points[i] = {s[i], z[i]};
        return points;
    }
    /// Looks at all pieces from `begin` on, the halves of which come after them. Where those begin.
    std::size_t divide(std::size_t begin) {
        const std::size_t end = pieces_.size();
        std::vector<double> s;
        for (std::size_t i = begin; i < end; ++i) {
            const Piece& p = pieces_[i];
            if (refiner_.is_undivided(p.a, p.b, p.depth)) continue;
            s.push_back(0.5 * (p.a.s + p.mid.s));
            s.push_back(0.5 * (p.mid.s + p.b.s));
        }
        const std::vector<LinePoint> quarters = asked(s);
        std::size_t next = 0;
        for (std::size_t i = begin; i < end; ++i) {
            Piece p = pieces_[i];
            if (refiner_.is_undivided(p.a, p.b, p.depth)) continue;
            p.before = quarters[next++];
            p.after = quarters[next++];
            if (refiner_.is_straight(p.a, p.before, p.mid, p.after, p.b)) {
                p.kind = Piece::Kind::straight;
            } else {
                p.kind = Piece::Kind::divided;
                p.half = pieces_.size();
                pieces_.push_back({p.a, p.before, p.mid, {}, {}, p.depth + 1});
                pieces_.push_back({p.mid, p.after, p.b, {}, {}, p.depth + 1});
            }
            pieces_[i] = p;
        }
        return end;
    }
    void append(std::size_t i, std::vector<LinePoint>& out) const {
        const Piece& p = pieces_[i];
        switch (p.kind) {
        case Piece::Kind::jump:
            refiner_.add_jump(p.a, p.b, out);
            break;
        case Piece::Kind::straight:
            out.insert(out.end(), {p.before, p.mid, p.after, p.b});
            break;
        case Piece::Kind::divided:
            append(p.half, out);
            append(p.half + 1, out);
        }
    }

    FieldLine& line_;
    LineRefiner<FieldLine> refiner_;
    std::vector<Piece> pieces_;
};

} // namespace

void LiftField::tip_z(std::span<const Vec2> places, std::span<double> heights,
                      const Progress& progress) const {
    lift->tip_z(places, heights, progress);
    HolderReach::Hints hints;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        heights[i] = std::max(heights[i], floor);
        if (bodies && !bodies->empty()) heights[i] = bodies->raised(places[i], heights[i], hints);
    }
}

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
    if (!(s1 > s0)) return {{s0, field.tip_z(origin + s0 * direction)}};
    const auto n = std::size_t(std::ceil((s1 - s0) / (2 * tolerance.spacing)));
    const auto node = [&](std::size_t i) { return i == n ? s1 : s0 + (s1 - s0) * (double(i) / double(n)); };
    const std::size_t blocks = (n - 1) / block_segments + 1;
    std::vector<std::vector<LinePoint>> parts(blocks);
    parallel_blocks(n, block_segments, progress, [&](std::size_t begin, std::size_t end) {
        auto& part = parts[begin / block_segments];
        const Progress here = progress.part(0, 0);
        FieldLine on{field, origin, direction, here};
        RefinedBlock block(on, tolerance);
        std::vector<double> nodes;
        for (std::size_t i = begin; i <= end; ++i)
            nodes.push_back(node(i));
        std::vector<LinePoint> behind;
        block.add(nodes, behind);
        if (begin == 0) part.push_back(block.start());
        part.insert(part.end(), behind.begin(), behind.end());
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
