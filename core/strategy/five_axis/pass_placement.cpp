#include "core/strategy/five_axis/pass_placement.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// How far a pass goes on beyond the part's border at most, in radii of the cutter.
constexpr double max_extension_share = 2;
/// Largest distance of contact places beyond the part's border, in radii of the cutter.
constexpr double beyond_spacing_share = 0.2;

class Placement {
public:
    Placement(const FiveAxisField& field, const PassEstimator& passes, const EstimatedPass& pass,
              const std::vector<double>& border_lo, const std::vector<double>& border_hi)
        : field_(field), passes_(passes), pass_(pass), border_lo_(border_lo), border_hi_(border_hi) {}

    PlacedLine place(std::size_t l) const {
        const SurfaceLine& line = pass_.lines[l];
        PlacedLine placed;
        placed.line = line;
        placed.travel = pass_.travel;
        placed.cut_short = pass_.cut_short[l];
        if (pass_.travel < 0) std::swap(placed.cut_short[0], placed.cut_short[1]);
        const auto add = [&](double s) {
            ContactPlace p = field_.place(line, s, pass_.v, pass_.travel);
            const auto [lo, hi] = strip(p.u);
            p.v_lo = std::min(lo, pass_.v);
            p.v_hi = std::max(hi, pass_.v);
            placed.places.push_back(p);
        };
        const double front = beyond(l, true), back = beyond(l, false);
        const double longest = beyond_spacing_share * field_.radius();
        const auto pieces = [&](double length) { return std::size_t(std::ceil(length / longest)); };
        for (std::size_t k = pieces(front); k > 0; --k)
            add(-front * double(k) / double(pieces(front)));
        for (const auto& c : pass_.contacts[l]) {
            add(c.place.s);
            ContactPlace& p = placed.places.back();
            if (c.usable) p.estimated = {c.posture.lead, c.posture.yaw};
            if (!c.left) continue;
            // As much as it can do in passing.
            p.v_lo = std::max(p.v_lo, pass_.v - c.width_lo);
            p.v_hi = std::min(p.v_hi, pass_.v + c.width_hi);
        }
        for (std::size_t k = 1; k <= pieces(back); ++k)
            add(line.length() + back * double(k) / double(pieces(back)));
        if (pass_.travel < 0) std::reverse(placed.places.begin(), placed.places.end());
        return placed;
    }

private:
    /// Where the tool reaches the strip's borders, beside and behind the contact, each pass takes the
    /// farthest, which its widths allow (PassEstimator).
    std::array<double, 2> strip(double u) const {
        std::array<double, 2> strip{field_.lines().lo(), field_.lines().hi()};
        const auto [from, to] = passes_.cleared(u, pass_.travel);
        const std::size_t first = passes_.bins().at(from), last = passes_.bins().at(to);
        if (!border_lo_.empty())
            strip[0] =
                *std::min_element(border_lo_.begin() + long(first), border_lo_.begin() + long(last) + 1);
        if (!border_hi_.empty())
            strip[1] =
                *std::max_element(border_hi_.begin() + long(first), border_hi_.begin() + long(last) + 1);
        return strip;
    }

    /// How far a line goes on beyond its first point, or its last.
    double beyond(std::size_t l, bool first) const {
        if (pass_.cut_short[l][first ? 0 : 1]) return 0.0;
        const SurfaceLine& line = pass_.lines[l];
        const auto [lo, hi] = strip(first ? line.points.front().u : line.points.back().u);
        return extension(line, first, std::min(lo, pass_.v), std::max(hi, pass_.v));
    }

    /// How much farther than its own end the strip of a line reaches, along u; plus, where the pass ends,
    /// what the tool lags behind at the strip's borders. Where it begins that lies outside.
    double extension(const SurfaceLine& line, bool first, double v_lo, double v_hi) const {
        const auto& lines = field_.lines();
        const SlicePoint& end = first ? line.points.front() : line.points.back();
        const double r = field_.radius();
        double farther = 0;
        const long step = std::max(1L, std::lround(field_.fineness() * r / 16 / lines.spacing()));
        for (long k = lines.beyond(v_lo, v_hi) / step * step; lines.v(k) <= v_hi; k += step)
            for (const SurfaceSlice::End& other : lines.slice(k)->ends())
                if (other.first == first && (other.point - end.point).norm() <= 2 * r)
                    farther = std::max(farther, field_.reaches_beyond(line, other));
        const bool begins = first == (pass_.travel > 0);
        const double aside = begins ? 0 : std::min(std::max(pass_.v - v_lo, v_hi - pass_.v), r);
        const double lag = r - std::sqrt(r * r - aside * aside);
        return std::min(farther + lag, max_extension_share * r);
    }

    const FiveAxisField& field_;
    const PassEstimator& passes_;
    const EstimatedPass& pass_;
    const std::vector<double>&border_lo_, &border_hi_;
};

} // namespace

std::vector<PlacedLine> place_pass(const FiveAxisField& field, const PassEstimator& passes,
                                   const EstimatedPass& pass, const std::vector<double>& border_lo,
                                   const std::vector<double>& border_hi) {
    const Placement placement(field, passes, pass, border_lo, border_hi);
    std::vector<PlacedLine> lines;
    for (std::size_t i = 0; i < pass.lines.size(); ++i)
        lines.push_back(placement.place(pass.travel > 0 ? i : pass.lines.size() - 1 - i));
    return lines;
}

} // namespace facetmill
