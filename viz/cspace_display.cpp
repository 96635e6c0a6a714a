#include "viz/cspace_display.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

const char* posture_block_label(PostureBlock block) {
    switch (block) {
    case PostureBlock::free:
        return "Free";
    case PostureBlock::local:
        return "Cutter, near the contact";
    case PostureBlock::global:
        return "Cutter, elsewhere";
    case PostureBlock::shank:
        return "Shank";
    case PostureBlock::holder:
        return "Holder";
    case PostureBlock::lift:
        return "Leaves too much";
    case PostureBlock::machine:
        return "Beyond the machine";
    }
    return "";
}

Rgb posture_block_color(PostureBlock block) {
    const auto& colors = fixed_colors().postures;
    switch (block) {
    case PostureBlock::free:
        return colors.free;
    case PostureBlock::local:
        return colors.near_contact;
    case PostureBlock::global:
        return colors.elsewhere;
    case PostureBlock::shank:
        return colors.shank;
    case PostureBlock::holder:
        return colors.holder;
    case PostureBlock::lift:
        return colors.lift;
    case PostureBlock::machine:
        return colors.machine;
    }
    return {};
}

Rgb cspace_top_color() {
    return fixed_colors().postures.top;
}

const char* cspace_choice_label(std::size_t choice) {
    constexpr const char* labels[] = {"CM2", "local", "global", "planned"};
    return labels[choice];
}

Rgb cspace_choice_color(std::size_t choice) {
    return fixed_colors().postures.choices[choice];
}

CSpaceContent CSpaceContent::of(const FiveAxisStudy::Point& point) {
    CSpaceContent c;
    c.grid = point.grid;
    c.bottom = point.space.bottom;
    c.top = point.space.top;
    c.block = point.space.block;
    c.choices = {point.chosen[0], point.chosen[1], point.chosen[2], point.planned};
    c.free_nodes = std::size_t(std::count(c.block.begin(), c.block.end(), PostureBlock::free));
    return c;
}

void CSpaceTriangles::add(const Vec3& a, const Vec3& b, const Vec3& c, const Rgb& color, double alpha) {
    for (const Vec3* v : {&a, &b, &c})
        for (int k = 0; k < 3; ++k)
            points.push_back(float((*v)[k]));
    for (const double v : {color.r, color.g, color.b, alpha})
        colors.push_back(std::uint8_t(std::lround(255 * v)));
}

namespace {

constexpr double top_alpha = 0.30, wall_alpha = 0.38, blocked_top_alpha = 0.16;
constexpr std::size_t max_lines = 24; // of a surface in each direction

/// The largest of 1, 2, 5 times a power of ten that is not above `x`.
double round_step(double x) {
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    for (const double step : {5.0, 2.0})
        if (step * power <= x * (1 + 1e-12)) return step * power;
    return power;
}

/// What has to fit into the box: the free volume; of a point without one the top and where the bottom
/// begins, or else the bottom.
double wanted_height(const CSpaceContent& c) {
    double free = 0, top = 0;
    std::vector<double> bottoms;
    for (std::size_t n = 0; n < c.block.size(); ++n) {
        if (c.block[n] == PostureBlock::free) {
            if (std::isfinite(c.bottom[n])) free = std::max(free, c.bottom[n]);
            if (std::isfinite(c.top[n])) free = std::max(free, c.top[n]);
        }
        if (std::isfinite(c.top[n])) top = std::max(top, c.top[n]);
        if (std::isfinite(c.bottom[n]) && c.bottom[n] > 0) bottoms.push_back(c.bottom[n]);
    }
    if (free > 0) return free;
    if (bottoms.empty()) return top > 0 ? top : 1;
    // So that one sees by how much the bottom is above the top.
    const double lowest = *std::min_element(bottoms.begin(), bottoms.end());
    if (top > 0) return std::max(top, 1.3 * lowest);
    const auto middle = bottoms.begin() + std::ptrdiff_t(bottoms.size() / 2);
    std::nth_element(bottoms.begin(), middle, bottoms.end());
    return *middle;
}

/// One direction of the grid: where its nodes stand. A single node stands on both sides of the box.
struct Side {
    std::vector<double> at;
    std::vector<std::size_t> node;
};

/// Round angles within the limits.
std::vector<double> angle_ticks(double lo, double hi) {
    const double span = degrees(hi - lo);
    if (!(span > 0)) return {lo};
    double step = 1;
    for (const double s : {90.0, 45.0, 30.0, 15.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1})
        if (span / s <= 6.01) step = s;
    std::vector<double> ticks;
    for (double v = std::ceil(degrees(lo) / step - 1e-6) * step; v <= degrees(hi) + 1e-6; v += step)
        ticks.push_back(radians(v));
    return ticks;
}

/// A corner of the volume: where it stands, its bottom and top (box z).
struct Post {
    Vec2 at;
    double low, high;
};
Post between(const Post& a, const Post& b, double t) {
    return {a.at + t * (b.at - a.at), a.low + t * (b.low - a.low), a.high + t * (b.high - a.high)};
}

} // namespace

struct CSpaceDisplay::Builder {
    const CSpaceContent& content;
    CSpaceDisplay& display;
    Side lead, yaw;

    std::size_t node(std::size_t i, std::size_t j) const {
        return content.grid.node(lead.node[i], yaw.node[j]);
    }
    Vec2 at(std::size_t i, std::size_t j) const { return {lead.at[i], yaw.at[j]}; }
    double z(double delta) const { return delta / display.delta_max * height; }
    /// So that steep walls of a surface stay surfaces, without numbers that no picture holds.
    double bounded(double delta) const { return std::clamp(z(delta), -20 * height, 20 * height); }

    /// A triangle of a surface, cut off at z = lo and at z = hi.
    static void add_between(CSpaceTriangles& to, std::vector<Vec3> polygon, double lo, double hi,
                            const Rgb& color, double alpha) {
        for (const double sign : {1.0, -1.0}) {
            const double limit = sign > 0 ? hi : -lo;
            std::vector<Vec3> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                const double da = limit - sign * a.z(), db = limit - sign * b.z();
                if (da >= 0) kept.push_back(a);
                if ((da < 0) != (db < 0)) kept.push_back(a + da / (da - db) * (b - a));
            }
            polygon = std::move(kept);
            if (polygon.size() < 3) return;
        }
        for (std::size_t i = 2; i < polygon.size(); ++i)
            to.add(polygon[0], polygon[i - 1], polygon[i], color, alpha);
    }

    static void add_line(CSpaceSegments& to, Vec3 a, Vec3 b, double lo, double hi) {
        if (a.z() > b.z()) std::swap(a, b);
        if (b.z() < lo || a.z() > hi) return;
        const Vec3 from = a, route = b - a;
        if (a.z() < lo) a = from + (lo - from.z()) / route.z() * route;
        if (b.z() > hi) b = from + (hi - from.z()) / route.z() * route;
        for (const Vec3* v : {&a, &b})
            for (int k = 0; k < 3; ++k)
                to.push_back(float((*v)[k]));
    }

    /// Each node has the quarters of the cells around it.
    template <class Add>
    void quarters(std::size_t i, std::size_t j, const Add& add) const {
        const Vec2 lo = at(i, j), hi = at(i + 1, j + 1), mid = (lo + hi) / 2;
        for (int p = 0; p < 2; ++p)
            for (int q = 0; q < 2; ++q)
                add(i + std::size_t(p), j + std::size_t(q), p, q, lo, mid, hi);
    }

    void add_bottom() {
        for (std::size_t i = 0; i + 1 < lead.at.size(); ++i)
            for (std::size_t j = 0; j + 1 < yaw.at.size(); ++j) {
                double h[2][2];
                bool finite = true;
                for (std::size_t p = 0; p < 2; ++p)
                    for (std::size_t q = 0; q < 2; ++q) {
                        const double v = content.bottom[node(i + p, j + q)];
                        finite = finite && std::isfinite(v);
                        h[p][q] = finite ? bounded(v) : 0;
                    }
                if (!finite) continue;
                const double center = (h[0][0] + h[0][1] + h[1][0] + h[1][1]) / 4;
                quarters(i, j,
                         [&](std::size_t ni, std::size_t nj, int p, int q, const Vec2& lo, const Vec2& mid,
                             const Vec2& hi) {
                             const double x = p ? hi.x() : lo.x(), y = q ? hi.y() : lo.y();
                             const std::vector<Vec3> quad{
                                 {x, y, h[p][q]},
                                 {mid.x(), y, (h[0][q] + h[1][q]) / 2},
                                 {mid.x(), mid.y(), center},
                                 {x, mid.y(), (h[p][0] + h[p][1]) / 2},
                             };
                             const Rgb color = posture_block_color(content.block[node(ni, nj)]);
                             add_between(display.bottom, {quad[0], quad[1], quad[2]}, 0, height, color, 1);
                             add_between(display.bottom, {quad[0], quad[2], quad[3]}, 0, height, color, 1);
                         });
            }
    }

    void add_map() {
        for (std::size_t i = 0; i + 1 < lead.at.size(); ++i)
            for (std::size_t j = 0; j + 1 < yaw.at.size(); ++j)
                quarters(i, j,
                         [&](std::size_t ni, std::size_t nj, int p, int q, const Vec2& lo, const Vec2& mid,
                             const Vec2& hi) {
                             const double x = p ? hi.x() : lo.x(), y = q ? hi.y() : lo.y();
                             const Rgb color = posture_block_color(content.block[node(ni, nj)]);
                             const Vec3 a(x, y, floor), b(mid.x(), y, floor), c(mid.x(), mid.y(), floor),
                                 d(x, mid.y(), floor);
                             display.map.add(a, b, c, color);
                             display.map.add(a, c, d, color);
                         });
    }

    void add_lines(const std::vector<double>& values, CSpaceSegments& to) {
        const auto line = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
            const double a = values[node(i, j)], b = values[node(k, l)];
            if (!std::isfinite(a) || !std::isfinite(b)) return;
            const Vec2 p = at(i, j), q = at(k, l);
            add_line(to, {p.x(), p.y(), bounded(a)}, {q.x(), q.y(), bounded(b)}, 0, height);
        };
        const std::size_t ni = lead.at.size(), nj = yaw.at.size();
        const std::size_t si = (ni - 1) / max_lines + 1, sj = (nj - 1) / max_lines + 1;
        for (std::size_t i = 0; i < ni; ++i)
            for (std::size_t j = 0; j < nj; ++j) {
                if (i + 1 < ni && (j % sj == 0 || j + 1 == nj)) line(i, j, i + 1, j);
                if (j + 1 < nj && (i % si == 0 || i + 1 == ni)) line(i, j, i, j + 1);
            }
    }

    /// How far the node is from the border of what is free, in box z; below 0 outside.
    double freedom(std::size_t n) const {
        if (content.block[n] == PostureBlock::free)
            return std::max(1e-6, bounded(content.top[n]) - bounded(content.bottom[n]));
        const double gap = bounded(content.top[n]) - bounded(content.bottom[n]);
        return gap < 0 ? gap : -height / 4; // the machine's limit is somewhere between the nodes
    }
    Post post(std::size_t i, std::size_t j) const {
        const std::size_t n = node(i, j);
        const double low = std::isfinite(content.bottom[n]) ? bounded(content.bottom[n]) : 20 * height;
        const double high = std::isfinite(content.top[n]) ? bounded(content.top[n])
                            : content.top[n] > 0          ? 20 * height
                                                          : -20 * height;
        return {at(i, j), low, high};
    }

    void add_wall(const Post& a, const Post& b) {
        const Rgb green = posture_block_color(PostureBlock::free);
        const Vec3 al(a.at.x(), a.at.y(), a.low), ah(a.at.x(), a.at.y(), std::max(a.low, a.high)),
            bl(b.at.x(), b.at.y(), b.low), bh(b.at.x(), b.at.y(), std::max(b.low, b.high));
        add_between(display.volume, {al, bl, bh, ah}, 0, height, green, wall_alpha);
    }

    /// Free and not: S1, and the walls where the free volume ends.
    void add_volume() {
        const Rgb blue = cspace_top_color();
        const std::size_t ni = lead.at.size(), nj = yaw.at.size();
        for (std::size_t i = 0; i + 1 < ni; ++i)
            for (std::size_t j = 0; j + 1 < nj; ++j) {
                const std::size_t corners[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
                constexpr int halves[2][3] = {{0, 1, 2}, {0, 2, 3}};
                for (const auto& half : halves) {
                    Post posts[3];
                    double free[3];
                    bool border[3], finite = true;
                    for (int k = 0; k < 3; ++k) {
                        const auto& c = corners[half[k]];
                        const auto& d = corners[half[(k + 1) % 3]];
                        posts[k] = post(c[0], c[1]);
                        free[k] = freedom(node(c[0], c[1]));
                        finite = finite && std::isfinite(content.top[node(c[0], c[1])]);
                        border[k] = (c[0] == d[0] && (c[0] == 0 || c[0] + 1 == ni))
                                    || (c[1] == d[1] && (c[1] == 0 || c[1] + 1 == nj));
                    }
                    add_triangle(posts, free, border, finite, blue);
                }
            }
    }

    void add_triangle(const Post (&posts)[3], const double (&free)[3], const bool (&border)[3], bool finite,
                      const Rgb& blue) {
        std::vector<Post> inside;
        std::vector<Vec3> outside;
        std::vector<Post> cut;
        const auto top_of = [](const Post& p) { return Vec3(p.at.x(), p.at.y(), p.high); };
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            (free[k] > 0 ? inside.push_back(posts[k]) : outside.push_back(top_of(posts[k])));
            if ((free[k] > 0) != (free[next] > 0)) {
                const Post p = between(posts[k], posts[next], free[k] / (free[k] - free[next]));
                inside.push_back(p);
                outside.push_back(top_of(p));
                cut.push_back(p);
            }
            if (border[k]) {
                // The side of the box, as far as it is free.
                Post a = posts[k], b = posts[next];
                if (free[k] <= 0 && free[next] <= 0) continue;
                const double t = free[k] / (free[k] - free[next]);
                if (free[k] <= 0) a = between(posts[k], posts[next], t);
                if (free[next] <= 0) b = between(posts[k], posts[next], t);
                add_wall(a, b);
            }
        }
        if (inside.size() >= 3) {
            std::vector<Vec3> polygon;
            for (const Post& p : inside)
                polygon.push_back(Vec3(p.at.x(), p.at.y(), std::min(p.high, height)));
            add_between(display.volume, polygon, 0, height, blue, top_alpha);
        }
        if (finite && outside.size() >= 3)
            add_between(display.volume, outside, 0, height, blue, blocked_top_alpha);
        if (cut.size() == 2) add_wall(cut[0], cut[1]);
    }
};

CSpaceDisplay::CSpaceDisplay(const CSpaceContent& content, LengthUnit unit) {
    const PostureGrid& grid = content.grid;
    lead_lo_ = grid.lead.front();
    lead_hi_ = grid.lead.back();
    yaw_lo_ = grid.yaw.front();
    yaw_hi_ = grid.yaw.back();
    const double l = lead_hi_ - lead_lo_, o = yaw_hi_ - yaw_lo_, longest = std::max(l, o);
    constexpr double least = 0.45;
    size.x() = longest > 0 ? std::max(least, l / longest) : least;
    size.y() = longest > 0 ? std::max(least, o / longest) : least;

    const double mm = mm_per(unit), wanted = 1.08 * wanted_height(content) / mm;
    const double step = round_step(wanted / 3);
    const double steps = std::ceil(wanted / step - 1e-9);
    delta_max = steps * step * mm;
    for (int k = 0; k <= int(steps); ++k)
        delta_ticks.push_back(k * step * mm);
    lead_ticks = angle_ticks(lead_lo_, lead_hi_);
    yaw_ticks = angle_ticks(yaw_lo_, yaw_hi_);

    const auto side = [](const std::vector<double>& values, double length) {
        Side s;
        if (values.size() == 1) return Side{{0, length}, {0, 0}};
        for (std::size_t i = 0; i < values.size(); ++i) {
            s.at.push_back(length * (values[i] - values.front()) / (values.back() - values.front()));
            s.node.push_back(i);
        }
        return s;
    };
    Builder builder{content, *this, side(grid.lead, size.x()), side(grid.yaw, size.y())};
    builder.add_bottom();
    builder.add_map();
    builder.add_lines(content.bottom, bottom_lines);
    builder.add_lines(content.top, top_lines);
    builder.add_volume();
}

Vec3 CSpaceDisplay::place(const PostureValue& p) const {
    const auto share = [](double v, double lo, double hi) { return hi > lo ? (v - lo) / (hi - lo) : 0.5; };
    return {size.x() * share(p.lead, lead_lo_, lead_hi_), size.y() * share(p.yaw, yaw_lo_, yaw_hi_),
            height * std::clamp(p.delta / delta_max, 0.0, 1.0)};
}

PostureValue CSpaceDisplay::value(const Vec3& at) const {
    const auto along = [](double x, double length, double lo, double hi) {
        return lo + std::clamp(x / length, 0.0, 1.0) * (hi - lo);
    };
    return {along(at.x(), size.x(), lead_lo_, lead_hi_), along(at.y(), size.y(), yaw_lo_, yaw_hi_),
            std::clamp(at.z() / height, 0.0, 1.0) * delta_max};
}

std::optional<CSpaceDisplay::Hit> CSpaceDisplay::hit(const Vec3& from, const Vec3& direction) const {
    double nearest = infinity;
    std::optional<Hit> best;
    const auto look = [&](const CSpaceTriangles& triangles, Hit::On on, bool opaque_enough) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            // What is almost not to be seen is looked through.
            if (!opaque_enough && triangles.colors[4 * t + 3] < std::lround(255 * top_alpha)) continue;
            Vec3 v[3];
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    v[k][int(c)] = triangles.points[9 * t + 3 * k + c];
            const Vec3 e = v[1] - v[0], f = v[2] - v[0], p = direction.cross(f);
            const double determinant = e.dot(p);
            if (std::abs(determinant) < 1e-14) continue;
            const Vec3 s = from - v[0], q = s.cross(e);
            const double a = s.dot(p) / determinant, b = direction.dot(q) / determinant;
            if (a < -1e-9 || b < -1e-9 || a + b > 1 + 1e-9) continue;
            const double along = f.dot(q) / determinant;
            if (!(along < nearest)) continue;
            nearest = along;
            best = Hit{value(from + along * direction), on};
        }
    };
    look(map, Hit::On::map, true);
    look(bottom, Hit::On::bottom, true);
    look(volume, Hit::On::volume, false);
    return best;
}

} // namespace facetmill
