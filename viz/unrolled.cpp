#include "viz/unrolled.h"

#include "viz/palette.h"
#include "viz/path_tint.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 16384;
constexpr float full_turn = 360;
/// A scale of one depth alone is this wide, in mm.
constexpr double min_scale = 1e-3;

} // namespace

UnrolledPathPtr prepare_unrolled(std::shared_ptr<const OperationResult> operation, LengthUnit unit,
                                 const Progress& progress) {
    const auto* path_on_axis = operation->path.as<TurnedPath>();
    if (!path_on_axis) return nullptr;
    const TurnedPath& t = *path_on_axis;
    const Vec3 &d = t.axis.direction, side = d.cross(t.zero);
    const double per = mm_per(unit);
    auto path = std::make_shared<UnrolledPath>();
    path->unit = unit_name(unit);
    path->low = infinity;
    path->high = -infinity;
    path->from = t.from / per;
    path->to = t.to / per;
    const auto& motions = operation->program.motions.motions;
    bool joined = false;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.check();
        const Motion& m = motions[i];
        if (m.kind != MotionKind::cut && !(m.kind == MotionKind::approach && m.pass != no_index)) {
            joined = false;
            continue;
        }
        const Vec3 tip = m.to.tip - t.axis.point;
        double angle = degrees(std::atan2(m.to.axis.dot(side), m.to.axis.dot(t.zero)));
        if (angle < 0) angle += double(full_turn);
        const Vec3 out = (m.to.axis - m.to.axis.dot(d) * d).normalized();
        const double depth = (std::max(t.stock_radius, t.part_radius) - tip.dot(out)) / per;
        const double along = tip.dot(d) / per;
        path->places.push_back(
            {float(along), std::min(float(angle), full_turn), float(depth), std::uint32_t(i), joined});
        path->low = std::min(path->low, depth);
        path->high = std::max(path->high, depth);
        path->from = std::min(path->from, along);
        path->to = std::max(path->to, along);
        joined = true;
    }
    if (path->places.empty()) return nullptr;
    if (path->high - path->low < min_scale / per) path->high = path->low + min_scale / per;
    if (!(path->from < path->to)) path->to = path->from + 1;
    path->feed = operation->path.stepover_max / per;
    // Lines along the axis keep their angle for most of their way.
    double turned = 0, moved = 0;
    for (std::size_t i = 1; i < path->places.size(); ++i) {
        const auto &a = path->places[i - 1], &b = path->places[i];
        turned += std::abs(std::remainder(double(b.angle - a.angle), double(full_turn))) * pi / 180
                  * t.part_radius / per;
        moved += std::abs(double(b.along - a.along));
    }
    path->lengthwise = moved > turned;
    path->feed_angle = t.part_radius > 0 ? degrees(operation->path.stepover_max / t.part_radius) : 0;
    for (const UnreachedRegion& r : t.unreached) {
        const double low = degrees(r.angle_from), high = degrees(r.angle_to);
        const double turn = double(full_turn);
        path->unreached.push_back({r.from / per, r.to / per, low, std::min(high, turn)});
        if (high > turn) path->unreached.push_back({r.from / per, r.to / per, 0, high - turn});
    }
    path->operation = std::move(operation);
    return path;
}

double unrolled_share(const UnrolledPath& path, double depth) {
    return std::clamp((depth - path.low) / (path.high - path.low), 0.0, 1.0);
}

UnrolledWindow unrolled_whole(const UnrolledPath& path) {
    return {path.from, path.to, 0, double(full_turn)};
}

UnrolledImage unrolled_image(const UnrolledPath& path, const UnrolledWindow& window, int width, int height) {
    UnrolledImage image;
    image.width = std::max(width, 1);
    image.height = std::max(height, 1);
    const auto w = std::size_t(image.width), h = std::size_t(image.height);
    std::vector<float> deepest(w * h, -std::numeric_limits<float>::infinity());
    const double px = image.width / (window.to - window.from), py = image.height / (window.high - window.low);
    const double turn_rows = double(full_turn) * py;
    // Each line is as wide as the feed, so that the picture is filled.
    const int half_x = path.lengthwise ? 0 : int(std::ceil(0.5 * path.feed * px));
    const int half_y = path.lengthwise ? int(std::ceil(0.5 * path.feed_angle * py)) : 0;
    const auto put = [&](double x, double y, float depth) {
        const int cx = int(std::floor(x));
        for (const double over : {-turn_rows, 0.0, turn_rows}) { // it closes
            const double at = std::floor(y + over);
            if (at + half_y < 0 || at - half_y >= image.height) continue;
            const int cy = int(at);
            for (int row = std::max(cy - half_y, 0); row <= std::min(cy + half_y, image.height - 1); ++row)
                for (int column = std::max(cx - half_x, 0); column <= std::min(cx + half_x, image.width - 1);
                     ++column) {
                    float& here = deepest[std::size_t(row) * w + std::size_t(column)];
                    here = std::max(here, depth);
                }
        }
    };
    for (std::size_t i = 0; i < path.places.size(); ++i) {
        const UnrolledPath::Place& b = path.places[i];
        const UnrolledPath::Place& a = b.joined && i > 0 ? path.places[i - 1] : b;
        const double turn = std::remainder(double(b.angle - a.angle), double(full_turn));
        // In pixels; only what passes the window is drawn. (It may pass it a turn further up or down.)
        const double x0 = (double(a.along) - window.from) * px, dx = double(b.along - a.along) * px;
        const double y0 = (window.high - double(a.angle)) * py, dy = -turn * py;
        if (std::max(x0, x0 + dx) < -half_x - 1 || std::min(x0, x0 + dx) > image.width + half_x + 1) continue;
        bool seen = false;
        for (const double over : {-turn_rows, 0.0, turn_rows})
            seen = seen
                   || (std::max(y0, y0 + dy) + over >= -half_y - 1
                       && std::min(y0, y0 + dy) + over <= image.height + half_y + 1);
        if (!seen) continue;
        const double steps = std::max(1.0, std::ceil(std::max(std::abs(dx), std::abs(dy))));
        // A line that is far longer than the window has its steps within it alone.
        double first = 1, last = steps;
        if (std::abs(dx) > 1) {
            const double t0 = (-half_x - 1 - x0) / dx, t1 = (image.width + half_x + 1 - x0) / dx;
            first = std::max(first, std::floor(std::min(t0, t1) * steps));
            last = std::min(last, std::ceil(std::max(t0, t1) * steps));
        }
        for (double k = first; k <= last; ++k) {
            const double s = k / steps;
            put(x0 + s * dx, y0 + s * dy, float(double(a.depth) + s * double(b.depth - a.depth)));
        }
    }
    image.rgba.assign(4 * w * h, 0);
    for (std::size_t i = 0; i < w * h; ++i) {
        if (deepest[i] == -std::numeric_limits<float>::infinity()) continue;
        const Rgb c = path_tint_color(unrolled_share(path, double(deepest[i])));
        const auto byte = [](double v) { return std::uint8_t(std::lround(255 * v)); };
        image.rgba[4 * i] = byte(c.r);
        image.rgba[4 * i + 1] = byte(c.g);
        image.rgba[4 * i + 2] = byte(c.b);
        image.rgba[4 * i + 3] = 255;
    }
    return image;
}

std::optional<std::size_t> unrolled_pick(const UnrolledPath& path, const UnrolledWindow& window, double along,
                                         double angle, int width, int height) {
    const double px = std::max(width, 1) / (window.to - window.from),
                 py = std::max(height, 1) / (window.high - window.low);
    std::optional<std::size_t> best;
    double least = infinity;
    float depth = 0;
    for (const UnrolledPath::Place& p : path.places) {
        const double dx = (double(p.along) - along) * px;
        const double dy = std::remainder(double(p.angle) - angle, double(full_turn)) * py;
        const double away = dx * dx + dy * dy;
        // Where passes lie over each other, the deepest: it is the one that is seen.
        const bool nearer = away < least - 0.25, alike = away < least + 0.25;
        if (nearer || (alike && p.depth > depth)) {
            least = std::min(least, away);
            depth = p.depth;
            best = p.motion;
        }
    }
    return best;
}

std::optional<UnrolledPath::Place> unrolled_place(const UnrolledPath& path, std::size_t motion) {
    const auto at =
        std::lower_bound(path.places.begin(), path.places.end(), motion,
                         [](const UnrolledPath::Place& p, std::size_t m) { return p.motion < m; });
    if (at == path.places.end() || at->motion != motion) return std::nullopt;
    return *at;
}

} // namespace facetmill
