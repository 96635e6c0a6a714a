#include "core/strategy/curves/plan_curve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace facetmill {

namespace {

/// Ends of edges that are nearer to each other than this share of their coordinates' size are the same.
constexpr double same_share = 2e-6;

Vec3 on_plane(const Vec2& p) {
    return {p.x(), p.y(), 0};
}

Box3 box_of_piece(const PlanLine& line, std::size_t i) {
    Box3 box;
    box.add(on_plane(line[i]));
    box.add(on_plane(line[i + 1]));
    return box;
}

BoxTree tree_of_pieces(const PlanLine& line, const Progress& progress) {
    std::vector<Box3> boxes(line.size() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = box_of_piece(line, i);
    return {boxes, progress};
}

/// The share of piece i of a line at which it crosses piece k of another one.
std::optional<double> crossing_share(const PlanLine& a, std::size_t i, const PlanLine& b, std::size_t k) {
    const Vec2 d = a[i + 1] - a[i], e = b[k + 1] - b[k], to = b[k] - a[i];
    const double cross = plane_cross(d, e);
    if (cross == 0) return std::nullopt;
    const double t = plane_cross(to, e) / cross, u = plane_cross(to, d) / cross;
    if (!(t >= 0 && t <= 1 && u >= 0 && u <= 1)) return std::nullopt;
    return t;
}

/// The shifted pieces of a line one after another, with arcs round its outer corners, broken at its inner
/// ones: they may cross one another there.
std::vector<PlanLine> raw_beside(const CurveCourse& course, double left, double detail) {
    const PlanLine& line = course.line();
    const double radius = std::abs(left);
    const double step = 2 * std::acos(std::clamp(1 - detail / radius, 0.0, 1.0));
    const auto shift = [&](std::size_t i) {
        const Vec2 d = (line[i + 1] - line[i]).normalized();
        return Vec2(left * Vec2(-d.y(), d.x()));
    };
    std::vector<PlanLine> raw(1);
    const auto turn = [&](const Vec2& corner, const Vec2& from, const Vec2& to) {
        const double angle = std::atan2(plane_cross(from, to), from.dot(to));
        if (angle * left > 0) {
            raw.emplace_back();
            return;
        }
        for (double k = 1, n = std::ceil(std::abs(angle) / step); k < n; ++k) {
            const double a = angle * k / n, c = std::cos(a), s = std::sin(a);
            raw.back().push_back(corner + Vec2(c * from.x() - s * from.y(), s * from.x() + c * from.y()));
        }
    };
    const std::size_t pieces = line.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        if (i > 0) turn(line[i], shift(i - 1), shift(i));
        raw.back().push_back(line[i] + shift(i));
        raw.back().push_back(line[i + 1] + shift(i));
    }
    if (course.closed()) {
        const std::size_t runs = raw.size();
        turn(line.front(), shift(pieces - 1), shift(0));
        if (raw.size() == runs) raw.back().push_back(raw.front().front());
        if (raw.back().empty()) raw.pop_back();
    }
    return raw;
}

/// What of a line is nowhere nearer to another than that.
struct ClearOf {
    const LineDistance& distance;
    double enough, look; ///< mm; the latter how often it is asked

    bool is_clear(const Vec2& p) const { return distance.near(p).distance >= enough; }
    Vec2 border(Vec2 clear, Vec2 other) const {
        constexpr int halvings = 30;
        for (int k = 0; k < halvings; ++k) {
            const Vec2 middle = 0.5 * (clear + other);
            (is_clear(middle) ? clear : other) = middle;
        }
        return clear;
    }
    void add_pieces(const PlanLine& line, std::vector<PlanLine>& pieces, const Progress& progress) const {
        PlanLine piece;
        const auto end = [&] {
            if (piece.size() > 1) pieces.push_back(piece);
            piece.clear();
        };
        Vec2 last = line.front();
        if (is_clear(last)) piece.push_back(last);
        for (std::size_t i = 1; i < line.size(); ++i) {
            progress.check();
            const Vec2& from = line[i - 1];
            const Vec2 d = line[i] - from;
            if (d == Vec2::Zero()) continue;
            // Between inner corners only its middle may be clear.
            const double parts = std::max(4.0, std::ceil(d.norm() / look));
            for (double k = 1; k <= parts; ++k) {
                const Vec2 p = from + k / parts * d;
                const bool was = !piece.empty(), clear = is_clear(p);
                if (clear && !was) piece.push_back(border(p, last));
                if (clear && (k == parts || !was) && piece.back() != p) piece.push_back(p);
                if (!clear && was) {
                    piece.push_back(border(last, p));
                    end();
                }
                last = p;
            }
        }
        end();
    }
};

/// Goes on from the end of a line with another that begins where it ends: where they cross near these ends,
/// or as near as `same`. False where they do not meet.
bool append_meeting(PlanLine& line, const PlanLine& next, double same) {
    // So many pieces from either end, and no more than half of them.
    const auto looked_at = [](const PlanLine& l) {
        return std::clamp<std::size_t>((l.size() - 1) / 2, 1, 64);
    };
    const std::size_t last = line.size() - 1, first = last - looked_at(line);
    for (std::size_t j = 0; j < looked_at(next); ++j)
        for (std::size_t i = last; i-- > first;) {
            const auto t = crossing_share(line, i, next, j);
            if (!t) continue;
            const Vec2 at = line[i] + *t * (line[i + 1] - line[i]);
            line.resize(i + 1);
            line.push_back(at);
            line.insert(line.end(), next.begin() + std::ptrdiff_t(j) + 1, next.end());
            return true;
        }
    if ((line.back() - next.front()).norm() > same) return false;
    line.insert(line.end(), next.begin() + 1, next.end());
    return true;
}

} // namespace

double turned_area(const PlanCurve& curve) {
    double sum = 0;
    for (std::size_t i = 0; i < curve.points.size(); ++i)
        sum += plane_cross(curve.points[i], curve.points[(i + 1) % curve.points.size()]);
    return sum;
}

PlanCurve reversed(PlanCurve curve) {
    std::reverse(curve.points.begin(), curve.points.end());
    return curve;
}

std::vector<PlanCurve> ready_to_follow(std::vector<PlanCurve> curves, bool open) {
    for (PlanCurve& curve : curves) {
        if (open)
            curve.closed = false;
        else if (curve.closed && turned_area(curve) < 0)
            curve = reversed(std::move(curve));
    }
    std::erase_if(curves, [](const PlanCurve& c) { return c.points.size() < 2; });
    return curves;
}

std::vector<PlanCurve> joined_loops(std::span<const PlanEdge> edges) {
    double size = 0;
    for (const PlanEdge& e : edges)
        size = std::max({size, e[0].cwiseAbs().maxCoeff(), e[1].cwiseAbs().maxCoeff()});
    // Ends that belong together were computed from either side; where edges cross at a sharp angle they
    // differ.
    const double same = std::max(same_share * size, 1e-12);
    const auto key = [&](const Vec2& p) {
        return std::pair(std::llround(p.x() / same), std::llround(p.y() / same));
    };
    // Where facets lie over one another the same edge may be there twice.
    std::set<std::array<std::pair<long long, long long>, 2>> known;
    const auto is_known = [&](const PlanEdge& e) {
        return !known.insert({std::min(key(e[0]), key(e[1])), std::max(key(e[0]), key(e[1]))}).second;
    };
    using Ends = std::multimap<std::pair<long long, long long>, std::size_t>;
    Ends ends;
    std::vector<char> used(edges.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        used[i] = key(edges[i][0]) == key(edges[i][1]) || is_known(edges[i]);
        for (const Vec2& p : edges[i])
            ends.emplace(key(p), i);
    }
    const auto next = [&](const Vec2& at) -> std::optional<Vec2> {
        const auto [x, y] = key(at);
        for (long long dx = -1; dx <= 1; ++dx)
            for (long long dy = -1; dy <= 1; ++dy) {
                const auto range = ends.equal_range({x + dx, y + dy});
                for (auto e = range.first; e != range.second; ++e) {
                    if (used[e->second] != 0) continue;
                    used[e->second] = 1;
                    const PlanEdge& edge = edges[e->second];
                    return (edge[0] - at).squaredNorm() <= (edge[1] - at).squaredNorm() ? edge[1] : edge[0];
                }
            }
        return std::nullopt;
    };
    std::vector<PlanCurve> curves;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (used[i] != 0) continue;
        used[i] = 1;
        PlanCurve curve{{edges[i][0], edges[i][1]}, false};
        while (const auto p = next(curve.points.back()))
            curve.points.push_back(*p);
        curve.closed =
            curve.points.size() > 3 && (curve.points.front() - curve.points.back()).norm() <= 2 * same;
        if (curve.closed)
            curve.points.pop_back();
        else
            for (std::reverse(curve.points.begin(), curve.points.end());;) {
                const auto p = next(curve.points.back());
                if (!p) break;
                curve.points.push_back(*p);
            }
        if (curve.closed && turned_area(curve) < 0) curve = reversed(std::move(curve));
        curves.push_back(std::move(curve));
    }
    return curves;
}

CurveCourse::CurveCourse(const PlanCurve& curve) : closed_(curve.closed) {
    const auto add = [&](const Vec2& p) {
        if (!line_.empty() && p == line_.back()) return;
        arc_.push_back(line_.empty() ? 0 : arc_.back() + (p - line_.back()).norm());
        line_.push_back(p);
    };
    for (const Vec2& p : curve.points)
        add(p);
    if (closed_) add(line_.front());
}

double CurveCourse::around(double s) const {
    if (!closed_) return std::clamp(s, 0.0, length());
    const double rest = s - length() * std::floor(s / length());
    return std::min(rest, length());
}

std::size_t CurveCourse::piece(double s) const {
    const auto after = std::upper_bound(arc_.begin(), arc_.end(), s);
    const std::size_t i = after == arc_.begin() ? 0 : std::size_t(after - arc_.begin()) - 1;
    return std::min(i, line_.size() - 2);
}

Vec2 CurveCourse::at(double s) const {
    const double on = around(s);
    const std::size_t i = piece(on);
    const double t = (on - arc_[i]) / (arc_[i + 1] - arc_[i]);
    return line_[i] + std::clamp(t, 0.0, 1.0) * (line_[i + 1] - line_[i]);
}

Vec2 CurveCourse::direction(double s) const {
    const std::size_t i = piece(around(s));
    return (line_[i + 1] - line_[i]).normalized();
}

PlanLine CurveCourse::stretch(double s0, double s1) const {
    PlanLine part{at(s0)};
    const auto add = [&](const Vec2& p) {
        if (p != part.back()) part.push_back(p);
    };
    const double turns = closed_ ? std::floor(s0 / length()) : 0;
    for (double turn = turns; turn * length() <= s1; ++turn) {
        for (std::size_t i = 0; i < line_.size(); ++i)
            if (const double s = turn * length() + arc_[i]; s > s0 && s < s1) add(line_[i]);
        if (!closed_) break;
    }
    add(at(s1));
    return part;
}

LineDistance::LineDistance(const PlanLine& line, const Progress& progress)
    : line_(line), tree_(tree_of_pieces(line, progress)) {}

LineDistance::Near LineDistance::near(const Vec2& p) const {
    Near found;
    double near2 = infinity;
    tree_.nearest(on_plane(p), near2, [&](std::size_t i) {
        const Vec2 d = line_[i + 1] - line_[i];
        const double square = d.squaredNorm();
        const double t = square > 0 ? std::clamp((p - line_[i]).dot(d) / square, 0.0, 1.0) : 0;
        const double d2 = (p - line_[i] - t * d).squaredNorm();
        if (d2 < near2 || (d2 == near2 && i < found.piece)) {
            near2 = d2;
            found = {std::sqrt(d2), i, t};
        }
    });
    return found;
}

PlanCurve longest_of(const std::vector<PlanCurve>& curves) {
    const PlanCurve* best = &curves.front();
    for (const PlanCurve& c : curves)
        if (CurveCourse(c).length() > CurveCourse(*best).length()) best = &c;
    return *best;
}

PlanCurve begun_near(PlanCurve curve, const Vec2& p) {
    const auto nearest = std::ranges::min_element(
        curve.points, [&](const Vec2& a, const Vec2& b) { return (a - p).norm() < (b - p).norm(); });
    std::rotate(curve.points.begin(), nearest, curve.points.end());
    return curve;
}

std::array<PlanCurve, 2> halves_of(const PlanCurve& outline, const Vec2& along) {
    std::size_t low = 0, high = 0;
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        if (outline.points[i].dot(along) < outline.points[low].dot(along)) low = i;
        if (outline.points[i].dot(along) > outline.points[high].dot(along)) high = i;
    }
    const auto from_to = [&](std::size_t a, std::size_t b) {
        PlanCurve half{{outline.points[a]}, false};
        for (std::size_t i = a; i != b;) {
            i = (i + 1) % outline.points.size();
            half.points.push_back(outline.points[i]);
        }
        return half;
    };
    return {from_to(low, high), reversed(from_to(high, low))};
}

std::vector<PlanCurve> curves_beside(const PlanCurve& curve, double left, double detail,
                                     const Progress& progress) {
    if (left == 0) return {curve};
    const CurveCourse course(curve);
    const LineDistance distance(course.line(), progress);
    const ClearOf clear_of{distance, std::abs(left) - detail, std::max(0.1 * std::abs(left), detail)};
    std::vector<PlanLine> pieces;
    for (const PlanLine& run : raw_beside(course, left, detail))
        clear_of.add_pieces(run, pieces, progress);
    // At an inner corner two pieces end where they meet.
    std::vector<PlanCurve> joined;
    for (PlanLine& piece : pieces)
        if (joined.empty() || !append_meeting(joined.back().points, piece, 8 * detail))
            joined.push_back({std::move(piece), false});
    if (!curve.closed || joined.empty()) return joined;
    if (joined.size() > 1 && append_meeting(joined.back().points, joined.front().points, 8 * detail)) {
        joined.front() = std::move(joined.back());
        joined.pop_back();
    }
    // Its end and its beginning meet as well: at the end of the first half, put behind the second.
    if (PlanCurve& c = joined.front(); joined.size() == 1 && c.points.size() > 3) {
        const auto half = c.points.begin() + std::ptrdiff_t(c.points.size() / 2);
        PlanLine end(half, c.points.end());
        const PlanLine begin(c.points.begin(), half + 1);
        if (append_meeting(end, begin, 8 * detail)) {
            end.pop_back();
            c = {std::move(end), true};
        }
    }
    return joined;
}

std::optional<Vec2> crossing_of(const PlanLine& a, const PlanLine& b, const Progress& progress) {
    const BoxTree tree = tree_of_pieces(b, progress);
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
        progress.check();
        const Box3 own = box_of_piece(a, i);
        std::optional<double> first;
        tree.each(
            [&](const Box3& box) {
                return (box.lo.array() <= own.hi.array()).all() && (own.lo.array() <= box.hi.array()).all();
            },
            [&](std::size_t k) {
                if (const auto t = crossing_share(a, i, b, k); t && (!first || *t < *first)) first = t;
            });
        if (first) return a[i] + *first * (a[i + 1] - a[i]);
    }
    return std::nullopt;
}

} // namespace facetmill
