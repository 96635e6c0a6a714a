#include "viz/strip_display.h"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_check = 20'000;
/// Handles of a boundary: at least this share of its length apart, and no more than so many.
constexpr double handles_share = 1.0 / 48;

/// Corners that are the same place become one point: a third of what the facets bring.
class Points {
public:
    Points(std::vector<float>& to, const Vec3& center) : to_(to), center_(center) {}
    std::int32_t add(const Vec3& p) {
        const auto [it, is_new] =
            made_.try_emplace(std::tuple(p.x(), p.y(), p.z()), std::int32_t(to_.size() / 3));
        if (is_new) append(p);
        return it->second;
    }
    std::int32_t append(const Vec3& p) {
        const Vec3 q = p - center_;
        to_.insert(to_.end(), {float(q.x()), float(q.y()), float(q.z())});
        return std::int32_t(to_.size() / 3) - 1;
    }

private:
    std::vector<float>& to_;
    Vec3 center_;
    std::map<std::tuple<double, double, double>, std::int32_t> made_;
};

} // namespace

Rgb strip_color(std::size_t number, bool enabled, Palette palette) {
    const Colors& colors = colors_of(palette);
    return enabled ? colors.strips[number % colors.strips.size()] : colors.strip_off;
}

StripDisplayPtr prepare_strip_display(const std::vector<Strip>& strips, LengthUnit unit,
                                      const Progress& progress) {
    auto display = std::make_shared<StripDisplay>();
    for (const Strip& s : strips)
        for (const auto& facet : s.band)
            for (const Vec3& p : facet)
                display->box.add(p);
    for (const Strip& s : strips)
        for (const auto& curve : s.centers)
            for (const Vec3& p : curve)
                display->box.add(p);
    if (!display->box.empty()) display->center = display->box.center();
    std::size_t number = 0;
    for (const Strip& s : strips) {
        StripDisplay::One one;
        one.color = number++;
        one.enabled = s.enabled;
        one.area = s.area;
        one.name = s.name + " · " + area_text(s.area, unit, 3);
        one.detail = (s.enabled ? "" : "switched off · ") + s.reason
                     + (s.tool > 0 ? " · tool " + std::to_string(s.tool) : std::string(" · no tool yet"));
        Points points(one.points, display->center);
        Vec3 middle = Vec3::Zero();
        double weight = 0;
        for (std::size_t f = 0; f < s.band.size(); ++f) {
            if (f % facets_per_check == 0) progress.check();
            const auto& [a, b, c] = s.band[f];
            for (const Vec3* p : {&a, &b, &c})
                one.triangles.push_back(points.add(*p));
            const double area = 0.5 * (b - a).cross(c - a).norm();
            middle += area * (a + b + c) / 3;
            weight += area;
        }
        if (weight > 0) middle /= weight;
        // A ring's middle is not on it.
        double nearest = infinity;
        for (const auto& [a, b, c] : s.band) {
            const Vec3 at = (a + b + c) / 3;
            if ((at - middle).norm() < nearest) {
                nearest = (at - middle).norm();
                one.label_at = at;
            }
        }
        Points lines(one.line_points, display->center), handles(one.handles, display->center);
        const auto add_line = [&](const std::vector<Vec3>& line, bool closed) {
            std::int32_t first = -1, last = -1;
            for (const Vec3& p : line) {
                const std::int32_t at = lines.append(p);
                if (last >= 0) one.segments.insert(one.segments.end(), {last, at});
                if (first < 0) first = at;
                last = at;
            }
            if (closed && last > first) one.segments.insert(one.segments.end(), {last, first});
        };
        for (const auto& loop : s.boundaries) {
            progress.check();
            add_line(loop, true);
            double length = 0, route = infinity;
            for (std::size_t i = 0; i < loop.size(); ++i)
                length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                if (i > 0) route += (loop[i] - loop[i - 1]).norm();
                if (route < handles_share * length) continue;
                handles.append(loop[i]);
                route = 0;
            }
        }
        for (const auto& curve : s.centers)
            add_line(curve, false);
        display->strips.push_back(std::move(one));
    }
    return display;
}

} // namespace facetmill
