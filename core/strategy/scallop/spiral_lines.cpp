#include "core/strategy/scallop/spiral_lines.h"

#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// Of a line so many places tell which one is next to it.
constexpr std::size_t telling_places = 24;
/// One walks so far at a time, in places of the grid, and so many times at most.
constexpr double walk_step = 0.25;
constexpr int max_walks = 400;

class SpiralLines {
public:
    SpiralLines(const ScallopField& field, const std::vector<double>& distance,
                std::vector<FieldContour> lines)
        : field_(field), distance_(distance), lines_(std::move(lines)), near_(4 * field.spacing()) {
        for (std::size_t k = 0; k < lines_.size(); ++k)
            for (const Vec2& p : lines_[k].places) {
                near_.add(Vec3(p.x(), p.y(), 0));
                line_at_.push_back(k);
            }
    }

    std::vector<FieldContour> run(const Progress& progress) {
        std::vector<std::optional<std::size_t>> next(lines_.size());
        std::vector<int> before(lines_.size(), 0);
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            progress.check();
            next[k] = next_to(k);
            if (next[k]) ++before[*next[k]];
        }
        std::vector<char> joined(lines_.size(), 0);
        std::vector<FieldContour> all;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (joined[k]) continue;
            std::vector<std::size_t> chain{k};
            while (next[chain.back()] && before[*next[chain.back()]] == 1 && !joined[*next[chain.back()]])
                chain.push_back(*next[chain.back()]);
            for (const std::size_t i : chain)
                joined[i] = 1;
            all.push_back(chain.size() > 1 ? spiral(chain, progress) : std::move(lines_[k]));
        }
        return all;
    }

private:
    /// Bilinear in its cell; nothing where not all of its corners are reached.
    struct Value {
        double distance;
        Vec2 slope;
    };
    std::optional<Value> value(const Vec2& p) const {
        const Vec2 at = (p - field_.place(0)) / field_.spacing();
        const int c = int(std::floor(at.x())), r = int(std::floor(at.y()));
        if (c < 0 || r < 0 || c + 1 >= field_.columns() || r + 1 >= field_.rows()) return std::nullopt;
        const std::size_t a = field_.number(c, r), b = a + 1, d = field_.number(c, r + 1), e = d + 1;
        for (const std::size_t i : {a, b, d, e})
            if (!field_.cut(i) || !(distance_[i] < infinity)) return std::nullopt;
        const double x = at.x() - c, y = at.y() - r;
        const double va = distance_[a], vb = distance_[b], vd = distance_[d], ve = distance_[e];
        return Value{(1 - y) * ((1 - x) * va + x * vb) + y * ((1 - x) * vd + x * ve),
                     Vec2((1 - y) * (vb - va) + y * (ve - vd), (1 - x) * (vd - va) + x * (ve - vb))};
    }

    /// From p up to the place of that distance, or as far as it goes.
    Vec2 walked(Vec2 p, double to) const {
        for (int k = 0; k < max_walks; ++k) {
            const auto here = value(p);
            if (!here || here->distance >= to) return p;
            const double steep = here->slope.norm();
            if (!(steep > 0)) return p;
            const double far = std::min(walk_step, (to - here->distance) / steep);
            const Vec2 there = p + far * field_.spacing() / steep * here->slope;
            const auto then = value(there);
            if (!then || then->distance <= here->distance) return p;
            p = there;
            if (far < walk_step) return p;
        }
        return p;
    }

    std::optional<std::size_t> line_near(const Vec2& p, double value) const {
        std::optional<std::size_t> best;
        const double reach = 4 * field_.spacing();
        double best2 = reach * reach;
        near_.near(Vec3(p.x(), p.y(), 0), reach, [&](std::size_t i) {
            const double d2 = (near_.points()[i].head<2>() - p).squaredNorm();
            if (std::abs(lines_[line_at_[i]].value - value) > 0.5 || !(d2 < best2)) return;
            best2 = d2;
            best = line_at_[i];
        });
        return best;
    }

    std::optional<std::size_t> next_to(std::size_t k) const {
        const FieldContour& line = lines_[k];
        if (!line.closed) return std::nullopt;
        std::optional<std::size_t> next;
        const std::size_t every = std::max<std::size_t>(1, line.places.size() / telling_places);
        for (std::size_t i = 0; i < line.places.size(); i += every) {
            const auto there = line_near(walked(line.places[i], line.value + 1), line.value + 1);
            if (!there || !lines_[*there].closed || (next && next != there)) return std::nullopt;
            next = there;
        }
        return next;
    }

    static double turning(const std::vector<Vec2>& loop) {
        double area = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            area += a.x() * b.y() - a.y() * b.x();
        }
        return area;
    }

    /// Its places from the one nearest to `from` on, counter-clockwise, and that one again.
    std::vector<Vec2> turn_of(std::size_t k, const Vec2& from) const {
        std::vector<Vec2> loop = lines_[k].places;
        if (turning(loop) < 0) std::reverse(loop.begin(), loop.end());
        const auto nearest = std::min_element(loop.begin(), loop.end(), [&](const Vec2& a, const Vec2& b) {
            return (a - from).squaredNorm() < (b - from).squaredNorm();
        });
        std::rotate(loop.begin(), nearest, loop.end());
        loop.push_back(loop.front());
        return loop;
    }

    FieldContour spiral(const std::vector<std::size_t>& chain, const Progress& progress) const {
        FieldContour line;
        line.value = lines_[chain.front()].value;
        Vec2 at = lines_[chain.front()].places.front();
        line.places = turn_of(chain.front(), at);
        for (std::size_t n = 0; n + 1 < chain.size(); ++n) {
            progress.check();
            const std::vector<Vec2> turn = turn_of(chain[n], at);
            double length = 0, gone = 0;
            for (std::size_t i = 1; i < turn.size(); ++i)
                length += (turn[i] - turn[i - 1]).norm();
            for (std::size_t i = 1; i < turn.size(); ++i) {
                gone += (turn[i] - turn[i - 1]).norm();
                line.places.push_back(walked(turn[i], lines_[chain[n]].value + gone / length));
            }
            at = line.places.back();
        }
        const std::vector<Vec2> last = turn_of(chain.back(), at);
        line.places.insert(line.places.end(), last.begin(), last.end());
        return line;
    }

    const ScallopField& field_;
    const std::vector<double>& distance_;
    std::vector<FieldContour> lines_;
    PointGrid near_;
    std::vector<std::size_t> line_at_;
};

} // namespace

std::vector<FieldContour> spiral_lines(const ScallopField& field, const std::vector<double>& distance,
                                       std::vector<FieldContour> lines, const Progress& progress) {
    return SpiralLines(field, distance, std::move(lines)).run(progress);
}

} // namespace facetmill
