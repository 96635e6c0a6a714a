#include "core/strategy/surface/contact_domain.h"

#include "core/base/tolerances.h"

namespace facetmill {

namespace {

constexpr std::size_t pairs_per_check = 8192;
/// A fan with more facets than this is represented by its outermost moves in sixteen directions.
constexpr std::size_t large_fan = 16;

} // namespace

std::vector<Interval> joined(std::vector<Interval> intervals, double merge) {
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.lo != b.lo ? a.lo < b.lo : a.hi < b.hi; });
    std::vector<Interval> result;
    for (const Interval& i : intervals) {
        if (!result.empty() && i.lo <= result.back().hi + merge)
            result.back().hi = std::max(result.back().hi, i.hi);
        else
            result.push_back(i);
    }
    return result;
}

ContactDomain::ContactDomain(const Mesh& mesh, const DriveFrame& frame, const CutterCover& cover,
                             double allowance, const Progress& progress)
    : mesh_(mesh), frame_(frame), index_(
                                      0, [](std::size_t) { return std::pair(1.0, 0.0); }, progress) {
    const std::size_t n = mesh.facet_count();
    offset_.resize(n);
    fan_start_.assign(mesh.vertices.size() + 1, 0);
    const auto usable = [&](std::size_t f) { return offset_[f][0] == offset_[f][0]; };
    for (std::size_t f = 0; f < n; ++f) {
        if (f % pairs_per_check == 0) progress.check();
        Vec3 normal = mesh.facet_normal(f);
        if (normal.z() < 0) normal = -normal;
        if (!(normal.z() >= tolerance::vertical_normal_z)) {
            offset_[f] = {std::numeric_limits<float>::quiet_NaN(), 0};
            continue;
        }
        const Vec3 move = cover.tip_offset(normal) + allowance * normal;
        offset_[f] = {float(frame.u(move)), float(frame.v(move))};
        for (int k = 0; k < 3; ++k) {
            lowest_tip_ = std::min(lowest_tip_, mesh.corner(f, k).z() + move.z());
            ++fan_start_[mesh.facets[f][k] + 1];
        }
        ++usable_;
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (v % pairs_per_check == 0) progress.check();
        fan_start_[v + 1] += fan_start_[v];
    }
    fan_.resize(fan_start_.back());
    std::vector<std::uint32_t> next(fan_start_.begin(), fan_start_.end() - 1);
    for (std::size_t f = 0; f < n; ++f) {
        if (f % pairs_per_check == 0) progress.check();
        if (!usable(f)) continue;
        for (const Index v : mesh.facets[f])
            fan_[next[v]++] = std::uint32_t(f);
    }
    // Only the outermost moves of a large fan count; they are put first and the rest is cut off by an end
    // marker, so that the facets of a fan do not each look at all the others.
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (v % pairs_per_check == 0) progress.check();
        const std::uint32_t from = fan_start_[v], to = fan_start_[v + 1];
        if (to - from <= large_fan) continue;
        std::vector<std::uint32_t> outermost;
        for (int k = 0; k < 16; ++k) {
            const double a = k * pi / 8, c = std::cos(a), s = std::sin(a);
            std::uint32_t best = fan_[from];
            for (std::uint32_t i = from; i < to; ++i) {
                const auto &o = offset_[fan_[i]], &b = offset_[best];
                if (c * o[0] + s * o[1] > c * b[0] + s * b[1]) best = fan_[i];
            }
            outermost.push_back(best);
        }
        std::sort(outermost.begin(), outermost.end());
        outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
        std::copy(outermost.begin(), outermost.end(), fan_.begin() + from);
        std::fill(fan_.begin() + from + std::ptrdiff_t(outermost.size()), fan_.begin() + to, no_index);
    }
    Corners corners;
    index_ = IntervalIndex(
        n, [&](std::size_t f) { return v_range(f, corners); }, progress);
}

void ContactDomain::corners_of(std::size_t facet, Corners& corners) const {
    corners.clear();
    const auto& own = offset_[facet];
    for (const Index vertex : mesh_.facets[facet]) {
        const Vec3& p = mesh_.vertices[vertex];
        const double u = frame_.u(p), v = frame_.v(p);
        corners.emplace_back(u + own[0], v + own[1]);
        for (std::uint32_t i = fan_start_[vertex]; i < fan_start_[vertex + 1]; ++i) {
            const std::uint32_t f = fan_[i];
            if (f == no_index) break;
            const auto& o = offset_[f];
            if (f != facet && (o[0] != own[0] || o[1] != own[1])) corners.emplace_back(u + o[0], v + o[1]);
        }
    }
}

std::pair<double, double> ContactDomain::v_range(std::size_t facet, Corners& corners) const {
    if (!(offset_[facet][0] == offset_[facet][0])) return {1, 0};
    corners_of(facet, corners);
    std::pair<double, double> range(infinity, -infinity);
    for (const Vec2& c : corners) {
        range.first = std::min(range.first, c.y());
        range.second = std::max(range.second, c.y());
    }
    return range;
}

std::vector<Interval> ContactDomain::strip(double v0, double v1, double merge) const {
    std::vector<Interval> all;
    Corners corners;
    index_.visit(v0, v1, [&](std::size_t f) {
        corners_of(f, corners);
        // Range of u of the corners' convex hull within the strip: corners inside, and where the segments
        // between corners cross the strip's sides (those inside the hull add nothing beyond it).
        Interval r{infinity, -infinity};
        const auto add = [&](double u) {
            r.lo = std::min(r.lo, u);
            r.hi = std::max(r.hi, u);
        };
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2& a = corners[i];
            if (a.y() >= v0 && a.y() <= v1) add(a.x());
            for (std::size_t j = i + 1; j < corners.size(); ++j) {
                const Vec2& b = corners[j];
                for (const double side : {v0, v1})
                    if ((a.y() < side) != (b.y() < side))
                        add(a.x() + (b.x() - a.x()) * ((side - a.y()) / (b.y() - a.y())));
            }
        }
        if (r.lo <= r.hi) all.push_back(r);
    });
    return joined(std::move(all), merge);
}

} // namespace facetmill
