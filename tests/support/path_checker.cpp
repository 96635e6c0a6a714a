#include "tests/support/path_checker.h"

#include "core/base/parallel.h"
#include "tests/support/convex_bound.h"

#include <map>
#include <optional>

namespace facetmill::test {

namespace {

struct Sample {
    Vec3 point, normal;
    double area = 0;     ///< 0: on an edge or corner, for gouges only
    bool judged = false; ///< for cusps and uncut area
};

struct Piece {
    Vec3 from, to;
};

/// Not std::hypot, which took a fifth of the time for sizes that no part has.
double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// The cutter's lower boundary as a table-free function of the profile's pieces, endless upward.
class Moved {
public:
    explicit Moved(const AptCutter& cutter) : profile_(cutter), radius_(profile_.max_radius()) {}

    double radius() const { return radius_; }
    double height(double rho) const { return rho > radius_ ? infinity : profile_.height_at(rho); }

    /// Lowest height of the moved cutter over (x, y): convex along the piece. A height of at most `enough`
    /// will do where there is one, and one above it where there is none.
    double lowest_over(const Piece& piece, double x, double y, double enough) const {
        const double dx = piece.to.x() - piece.from.x(), dy = piece.to.y() - piece.from.y();
        const double ex = x - piece.from.x(), ey = y - piece.from.y();
        const double a = dx * dx + dy * dy, b = dx * ex + dy * ey, c = ex * ex + ey * ey - radius_ * radius_;
        double lo = 0, hi = 1;
        if (a > 0) {
            const double disc = b * b - a * c;
            if (disc < 0) return infinity;
            lo = std::max(0.0, (b - std::sqrt(disc)) / a);
            hi = std::min(1.0, (b + std::sqrt(disc)) / a);
            if (lo > hi) return infinity;
        } else if (c > 0) {
            return infinity;
        }
        const double dz = piece.to.z() - piece.from.z();
        const auto over = [&](double s) {
            return piece.from.z() + s * dz + height(std::min(length(ex - s * dx, ey - s * dy), radius_));
        };
        constexpr double golden = 0.6180339887498949;
        double x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo), f1 = over(x1), f2 = over(x2);
        double at_lo = over(lo), at_hi = over(hi);
        double least = std::min({at_lo, at_hi, f1, f2});
        // The minimum is flat: a place found to 1e-4 of a short piece gives the height to 1e-8 of it.
        for (int i = 0; i < 40 && hi - lo > 1e-4 && least > enough; ++i) {
            if (no_lower(lo, x1, x2, hi, at_lo, f1, f2, at_hi) > enough) return least;
            if (f1 < f2) {
                hi = x2;
                at_hi = f2;
                x2 = x1;
                f2 = f1;
                x1 = hi - golden * (hi - lo);
                f1 = over(x1);
                least = std::min(least, f1);
            } else {
                lo = x1;
                at_lo = f1;
                x1 = x2;
                f1 = f2;
                x2 = lo + golden * (hi - lo);
                f2 = over(x2);
                least = std::min(least, f2);
            }
        }
        return least;
    }

    /// A height that the moved cutter does not reach down to over any place within `around` of one that is
    /// `distance` from the piece, seen from above.
    double bound(const Piece& piece, double distance, double around) const {
        return std::min(piece.from.z(), piece.to.z()) + height(std::max(0.0, distance - std::abs(around)));
    }

    /// Lowers `best` to the t at which p + t n enters the moved cutter, if that is smaller; p is `distance`
    /// from the piece, seen from above.
    void lower(const Piece& piece, double distance, const Vec3& p, const Vec3& n, double reach,
               double& best) const {
        if (bound(piece, distance, best * length(n.x(), n.y())) > p.z() + std::max(best, 0.0) * n.z()) return;
        const auto gap = [&](double t) {
            const Vec3 q = p + t * n;
            return lowest_over(piece, q.x(), q.y(), q.z()) - q.z(); // its sign counts
        };
        if (gap(best) > 0) return;
        // Inside at `best`: the line is inside from some smaller t on, and outside far enough below.
        double outside = best > 0 && gap(0) > 0 ? 0 : -reach, inside = best;
        if (outside == -reach && gap(outside) <= 0) {
            best = -reach;
            return;
        }
        while (inside - outside > 1e-6) {
            const double mid = 0.5 * (inside + outside);
            (gap(mid) <= 0 ? inside : outside) = mid;
        }
        best = inside;
    }

private:
    CutterProfile profile_;
    double radius_;
};

/// From a place to a piece, seen from above.
double distance_above(const Piece& piece, const Vec3& p) {
    const Vec2 d = (piece.to - piece.from).head<2>(), e = (p - piece.from).head<2>();
    const double length2 = d.squaredNorm();
    const double s = length2 > 0 ? std::clamp(e.dot(d) / length2, 0.0, 1.0) : 0.0;
    return (e - s * d).norm();
}

/// Pieces near a place, through square cells.
class Cells {
public:
    Cells(const std::vector<Piece>& pieces, double cell, double margin) : cell_(cell) {
        for (const Piece& p : pieces) {
            box_.add(p.from);
            box_.add(p.to);
        }
        box_.lo.array() -= margin;
        box_.hi.array() += margin;
        nx_ = std::size_t((box_.hi.x() - box_.lo.x()) / cell_) + 1;
        ny_ = std::size_t((box_.hi.y() - box_.lo.y()) / cell_) + 1;
        lists_.resize(nx_ * ny_);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Vec3 &a = pieces[i].from, &b = pieces[i].to;
            const std::size_t x0 = column(std::min(a.x(), b.x()) - margin, box_.lo.x(), nx_);
            const std::size_t x1 = column(std::max(a.x(), b.x()) + margin, box_.lo.x(), nx_);
            const std::size_t y0 = column(std::min(a.y(), b.y()) - margin, box_.lo.y(), ny_);
            const std::size_t y1 = column(std::max(a.y(), b.y()) + margin, box_.lo.y(), ny_);
            for (std::size_t y = y0; y <= y1; ++y)
                for (std::size_t x = x0; x <= x1; ++x)
                    lists_[y * nx_ + x].push_back(std::uint32_t(i));
        }
    }
    const std::vector<std::uint32_t>& near(const Vec3& p) const {
        static const std::vector<std::uint32_t> nothing;
        if (p.x() < box_.lo.x() || p.x() > box_.hi.x() || p.y() < box_.lo.y() || p.y() > box_.hi.y())
            return nothing;
        return lists_[column(p.y(), box_.lo.y(), ny_) * nx_ + column(p.x(), box_.lo.x(), nx_)];
    }

private:
    std::size_t column(double v, double lo, std::size_t n) const {
        return std::min(std::size_t(std::max(0.0, (v - lo) / cell_)), n - 1);
    }
    Box3 box_;
    double cell_;
    std::size_t nx_ = 0, ny_ = 0;
    std::vector<std::vector<std::uint32_t>> lists_;
};

/// Normal of a facet as it counts, or zero for one that faces down.
Vec3 upward_normal(const Mesh& part, std::size_t f, const PathCheckOptions& options) {
    constexpr double upright = 1e-6;
    const Vec3 n = part.facet_normal(f);
    if (n.z() >= -upright) return n;
    return options.either_side ? Vec3(-n) : Vec3(Vec3::Zero());
}

std::vector<Sample> sample_part(const Mesh& part, const PathCheckOptions& options) {
    std::vector<Sample> samples;
    // On edges and corners a line along one facet's normal may run within another facet; the sum of the
    // normals around leads into the material.
    std::vector<Vec3> corner_sum(part.vertices.size(), Vec3::Zero());
    std::map<std::pair<Index, Index>, Vec3> edge_sum;
    for (std::size_t f = 0; f < part.facet_count(); ++f) {
        const Vec3 n = upward_normal(part, f, options);
        for (int k = 0; k < 3; ++k) {
            const Index a = part.facets[f][std::size_t(k)], b = part.facets[f][std::size_t((k + 1) % 3)];
            const Vec3 p = (part.corner(f, (k + 1) % 3) - part.corner(f, k)).normalized(),
                       q = (part.corner(f, (k + 2) % 3) - part.corner(f, k)).normalized();
            corner_sum[a] += std::acos(std::clamp(p.dot(q), -1.0, 1.0)) * n;
            edge_sum.try_emplace(std::minmax(a, b), Vec3::Zero()).first->second += n;
        }
    }
    for (std::size_t f = 0; f < part.facet_count(); ++f) {
        const Vec3 n = upward_normal(part, f, options);
        if (n == Vec3::Zero()) continue;
        const bool judged = n.z() >= options.lowest_normal;
        // The longest edge first: rows of samples parallel to it.
        int longest = 0;
        double edge[3];
        for (int k = 0; k < 3; ++k) {
            edge[k] = (part.corner(f, (k + 1) % 3) - part.corner(f, k)).norm();
            if (edge[k] > edge[longest]) longest = k;
        }
        const Vec3 a = part.corner(f, longest), b = part.corner(f, (longest + 1) % 3),
                   c = part.corner(f, (longest + 2) % 3);
        const double area = 0.5 * part.facet_cross(f).norm(), height = 2 * area / edge[longest];
        const int columns = int(edge[longest] / options.spacing) + 1,
                  rows = int(height / options.spacing) + 1;
        double weight = 0;
        for (int j = 0; j < rows; ++j)
            weight += (1 - (j + 0.5) / rows) * columns;
        for (int j = 0; j < rows; ++j) {
            const double t = (j + 0.5) / rows;
            for (int i = 0; i < columns; ++i) {
                const double s = (i + 0.5) / columns;
                samples.push_back(
                    {a + t * (c - a) + s * (1 - t) * (b - a), n, area * (1 - t) / weight, judged});
            }
        }
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = part.corner(f, k), q = part.corner(f, (k + 1) % 3);
            const Index ia = part.facets[f][std::size_t(k)], ib = part.facets[f][std::size_t((k + 1) % 3)];
            const int steps = int(edge[k] / options.spacing) + 1;
            for (int i = 0; i < steps; ++i) {
                const Vec3 sum = i == 0 ? corner_sum[ia] : edge_sum[std::minmax(ia, ib)];
                if (sum.norm() < 1e-6) continue;
                samples.push_back({p + (q - p) * (double(i) / steps), sum.normalized(), 0, false});
            }
        }
    }
    return samples;
}

/// Edges with a facet that faces up on one side only.
std::vector<Piece> border_of(const Mesh& part, const PathCheckOptions& options) {
    std::map<std::pair<Index, Index>, int> up;
    for (std::size_t f = 0; f < part.facet_count(); ++f) {
        const Vec3 n = upward_normal(part, f, options);
        if (n == Vec3::Zero() || n.z() < std::max(options.lowest_normal, 0.02)) continue;
        for (int k = 0; k < 3; ++k) {
            const Index a = part.facets[f][std::size_t(k)], b = part.facets[f][std::size_t((k + 1) % 3)];
            ++up[std::minmax(a, b)];
        }
    }
    std::vector<Piece> border;
    for (const auto& [edge, count] : up)
        if (count == 1) border.push_back({part.vertices[edge.first], part.vertices[edge.second]});
    return border;
}

} // namespace

PathCheckResult check_path(const Mesh& part, const AptCutter& cutter, std::span<const TipLine> path,
                           const PathCheckOptions& options) {
    PathCheckResult result;
    const Moved moved(cutter);
    std::vector<Piece> pieces;
    for (const TipLine& line : path) {
        if (line.size() == 1) pieces.push_back({line[0], line[0]});
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            if (line[i] == line[i + 1]) continue;
            // In short pieces, whose bounds are close.
            const int parts = int((line[i + 1] - line[i]).norm() / (0.25 * moved.radius())) + 1;
            for (int k = 0; k < parts; ++k)
                pieces.push_back({line[i] + (line[i + 1] - line[i]) * (double(k) / parts),
                                  line[i] + (line[i + 1] - line[i]) * (double(k + 1) / parts)});
        }
    }
    if (pieces.empty()) {
        result.uncut_fraction = 1;
        return result;
    }
    const std::vector<Sample> samples = sample_part(part, options);
    const Cells cells(pieces, 0.25 * moved.radius(), moved.radius() + options.reach + options.allowance);
    std::vector<Piece> border;
    if (options.border > 0) border = border_of(part, options);
    std::optional<Cells> border_cells;
    if (!border.empty()) border_cells.emplace(border, options.border, options.border);

    std::vector<double> left(samples.size());
    std::vector<char> away(samples.size());
    parallel_for(samples.size(), 64, Progress(), [&](std::size_t i) {
        const Sample& s = samples[i];
        double best = options.reach;
        const Vec3 p = s.point + options.allowance * s.normal;
        // The likeliest piece first: with a low best, the bound turns nearly all others away.
        const auto& near = cells.near(p);
        struct Nearby {
            std::uint32_t piece;
            double distance, bound; ///< bound: of all places that the line along the normal passes
        };
        thread_local std::vector<Nearby> nearby;
        nearby.clear();
        const double aside = options.reach * length(s.normal.x(), s.normal.y());
        std::size_t first = 0;
        double least = infinity;
        for (const std::uint32_t k : near) {
            const double distance = distance_above(pieces[k], p);
            if (distance > moved.radius() + aside) continue;
            if (const double b = moved.bound(pieces[k], distance, 0); b < least) {
                least = b;
                first = nearby.size();
            }
            nearby.push_back({k, distance, moved.bound(pieces[k], distance, aside)});
        }
        if (!nearby.empty()) std::swap(nearby[0], nearby[first]);
        for (const Nearby& n : nearby)
            if (n.bound <= p.z() + std::max(best, 0.0) * s.normal.z())
                moved.lower(pieces[n.piece], n.distance, p, s.normal, options.reach, best);
        left[i] = best;
        away[i] = s.judged && s.area > 0 && !(options.no_cusp && options.no_cusp(s.point));
        if (!away[i] || !border_cells) return;
        for (const std::uint32_t k : border_cells->near(s.point))
            if (distance_above(border[k], s.point) < options.border) away[i] = 0;
    });

    double judged_area = 0, uncut_area = 0, cusp_area = 0;
    std::vector<std::pair<double, double>> cusps; // height, area
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& s = samples[i];
        ++result.samples;
        if (-left[i] > result.gouge_max) {
            result.gouge_max = -left[i];
            result.gouge_at = s.point;
        }
        if (!s.judged || s.area <= 0 || (options.no_cusp && options.no_cusp(s.point))) continue;
        judged_area += s.area;
        if (left[i] >= options.reach) {
            uncut_area += s.area;
            result.uncut_at = s.point;
        }
        if (!away[i]) continue;
        ++result.cusp_samples;
        cusps.emplace_back(left[i], s.area);
        cusp_area += s.area;
        if (left[i] > result.cusp_max) {
            result.cusp_max = left[i];
            result.cusp_at = s.point;
        }
    }
    if (judged_area > 0) result.uncut_fraction = uncut_area / judged_area;
    std::sort(cusps.begin(), cusps.end());
    double sum = 0;
    for (const auto& [height, area] : cusps) {
        sum += area;
        if (sum <= 0.5 * cusp_area) result.cusp_p50 = height;
        if (sum <= 0.999 * cusp_area) result.cusp_p999 = height;
    }
    // Where two swept arcs of radius r meet at height c above the part, they rise to it with slope sqrt(2 c /
    // r).
    const double r = std::max(cutter.r, 0.25 * moved.radius());
    result.resolution = 0.5 * std::sqrt(2.0) * options.spacing * std::sqrt(2 * result.cusp_max / r);
    return result;
}

} // namespace facetmill::test
