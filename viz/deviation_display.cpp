#include "viz/deviation_display.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t samples_per_check = 1u << 16; // samples or triangles: a few ms

} // namespace

DeviationDisplayPtr prepare_deviation_display(std::shared_ptr<const DeviationSurface> surface,
                                              const DeviationScale& scale, const Progress& progress) {
    const DeviationSurface& s = *surface;
    const std::size_t n = s.points.size();
    if (s.normals.size() != n || s.deviation.size() != n || s.flags.size() != n)
        throw Error(ErrorCode::out_of_range, "deviation", "the surface's arrays do not fit each other", "");
    auto display = std::make_shared<DeviationDisplay>();
    display->scale = scale;
    const auto point = [&](std::size_t i) {
        return Vec3(double(s.points[i][0]), double(s.points[i][1]), double(s.points[i][2]));
    };
    display->lowest = infinity;
    display->highest = -infinity;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % samples_per_check == 0) progress.check();
        display->box.add(point(i));
        if (judged(s.flags[i], s.deviation[i], scale.gouge_limit)) {
            display->lowest = std::min(display->lowest, double(s.deviation[i]));
            display->highest = std::max(display->highest, double(s.deviation[i]));
        } else {
            display->has_unjudged = true;
        }
    }
    if (!(display->lowest <= display->highest)) display->lowest = display->highest = 0;
    display->center = n > 0 ? display->box.center() : Vec3(Vec3::Zero());
    display->points.resize(3 * n);
    display->normals.resize(3 * n);
    display->areas.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        if (i % samples_per_check == 0) progress.check();
        for (std::size_t k = 0; k < 3; ++k) {
            display->points[3 * i + k] = float(double(s.points[i][k]) - display->center[Eigen::Index(k)]);
            display->normals[3 * i + k] = s.normals[i][k];
        }
    }
    display->triangles.reserve(3 * s.triangles.size());
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        if (t % samples_per_check == 0) progress.check();
        const auto& [a, b, c] = s.triangles[t];
        if (std::max({a, b, c}) >= n)
            throw Error(ErrorCode::out_of_range, "deviation", "a triangle names a sample that there is not",
                        "");
        const double area = 0.5 * (point(b) - point(a)).cross(point(c) - point(a)).norm();
        for (const std::uint32_t corner : {a, b, c}) {
            display->triangles.push_back(std::int32_t(corner));
            display->areas[corner] += float(area / 3);
        }
    }
    display->colors = deviation_colors(s.deviation, s.flags, scale);
    if (s.triangles.size() > largest_part_without_preview) {
        std::vector<std::int32_t> merged;
        display->preview = make_preview(display->points, display->normals, display->triangles,
                                        display->box.size(), &merged, progress);
        const std::size_t m = display->preview.points.size() / 3;
        std::vector<double> sum(m, 0), count(m, 0);
        for (std::size_t i = 0; i < n; ++i) {
            if (!judged(s.flags[i], s.deviation[i], scale.gouge_limit)) continue;
            sum[std::size_t(merged[i])] += double(s.deviation[i]);
            count[std::size_t(merged[i])] += 1;
        }
        display->preview_deviation.resize(m);
        for (std::size_t i = 0; i < m; ++i)
            display->preview_deviation[i] =
                count[i] > 0 ? float(sum[i] / count[i]) : std::numeric_limits<float>::quiet_NaN();
        display->preview_colors = deviation_colors(display->preview_deviation, {}, scale);
    }
    display->surface = std::move(surface);
    return display;
}

DeviationDisplayPtr moved_display(const DeviationDisplay& display, const Mat3& turn, const Vec3& move) {
    auto moved = std::make_shared<DeviationDisplay>(display);
    moved->center = turn * display.center + move;
    moved->box = Box3();
    const Eigen::Matrix3f rotation = turn.cast<float>();
    using Vectors = Eigen::Map<Eigen::Matrix3Xf>;
    for (std::vector<float>* each :
         {&moved->points, &moved->normals, &moved->preview.points, &moved->preview.normals}) {
        Vectors vectors(each->data(), 3, Eigen::Index(each->size() / 3));
        vectors = (rotation * vectors).eval();
    }
    for (std::size_t i = 0; i + 2 < moved->points.size(); i += 3)
        moved->box.add(
            moved->center
            + Vec3(double(moved->points[i]), double(moved->points[i + 1]), double(moved->points[i + 2])));
    return moved;
}

DeviationHistogram deviation_histogram(const DeviationDisplay& display, const DeviationScale& scale,
                                       std::size_t bins) {
    DeviationHistogram h;
    h.scale = scale;
    h.bins.assign(std::max<std::size_t>(1, bins), 0);
    const DeviationSurface& s = *display.surface;
    const double per = double(h.bins.size()) / (scale.high - scale.low);
    for (std::size_t i = 0; i < s.deviation.size(); ++i) {
        if (!judged(s.flags[i], s.deviation[i], scale.gouge_limit)) continue;
        const double d = double(s.deviation[i]), area = double(display.areas[i]);
        h.total += area;
        if (d < scale.low)
            h.below += area;
        else if (d > scale.high)
            h.above += area;
        else
            h.bins[std::min(std::size_t((d - scale.low) * per), h.bins.size() - 1)] += area;
    }
    return h;
}

} // namespace facetmill
