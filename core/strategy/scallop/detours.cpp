#include "core/strategy/scallop/detours.h"

#include "core/base/parallel.h"
#include "core/strategy/scallop/field_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// Detours end so far on the way from the line to the highest place of a spot; the first that does is taken.
constexpr std::array<double, 7> detour_shares{0.3, 0.45, 0.6, 0.75, 0.9, 1.05, 1.25};
/// The tip is known at so many places of one.
constexpr int detour_places = 5;

struct Detour {
    LeftByLines::Near from;
    Vec2 to = Vec2::Zero();
};

class DetourFinder {
public:
    DetourFinder(const ScallopField& field, const AxialLift& lift, const SpotsLeft& spots)
        : field_(field), lift_(lift), spots_(spots) {}

    std::optional<Detour> to(const std::vector<std::size_t>& spot) const {
        Vec2 lo = field_.place(spot.front()), hi = lo;
        std::size_t top = spot.front();
        for (const std::size_t i : spot) {
            lo = lo.cwiseMin(field_.place(i));
            hi = hi.cwiseMax(field_.place(i));
            if (spots_.heights[i] > spots_.heights[top]) top = i;
        }
        if ((hi - lo).maxCoeff() > spots_.largest) return std::nullopt;
        const auto from = spots_.left.nearest(field_.touch(top).tip);
        if (!from) return std::nullopt;
        const Vec2 begin = from->place.head<2>(), aside = field_.place(top) - begin;
        for (const double share : detour_shares)
            if (const Vec2 end = begin + share * aside; serves(spot, begin, end)) return Detour{*from, end};
        return std::nullopt;
    }

private:
    bool serves(const std::vector<std::size_t>& spot, const Vec2& begin, const Vec2& end) const {
        std::vector<Vec3> course;
        for (int k = 0; k <= detour_places; ++k) {
            const Vec2 p = begin + double(k) / detour_places * (end - begin);
            if (!field_.cut_at(p)) return false;
            course.emplace_back(p.x(), p.y(), lift_.tip_z(p.x(), p.y()));
            if (!std::isfinite(course.back().z())) return false;
        }
        return std::all_of(spot.begin(), spot.end(), [&](std::size_t i) {
            return spots_.left.high_by(i, spots_.cusp, course) <= spots_.cusp;
        });
    }

    const ScallopField& field_;
    const AxialLift& lift_;
    const SpotsLeft& spots_;
};

void lengthen(FieldContour& line, std::vector<Detour> detours) {
    std::stable_sort(detours.begin(), detours.end(), [](const Detour& a, const Detour& b) {
        return std::pair(a.from.piece, a.from.t) < std::pair(b.from.piece, b.from.t);
    });
    std::vector<Vec2> places;
    auto next = detours.begin();
    const std::size_t n = line.places.size();
    for (std::size_t i = 0; i < n; ++i) {
        places.push_back(line.places[i]);
        for (; next != detours.end() && next->from.piece == i; ++next) {
            const Vec2 at = next->from.place.head<2>();
            places.insert(places.end(), {at, next->to, at});
        }
    }
    line.places = std::move(places);
}

} // namespace

void add_detours(const ScallopField& field, const AxialLift& lift, const SpotsLeft& spots,
                 std::vector<FieldContour>& lines, std::vector<char>& marks, const Progress& progress) {
    const auto pieces = connected(field, marks);
    const DetourFinder finder(field, lift, spots);
    std::vector<std::optional<Detour>> found(pieces.size());
    parallel_for(pieces.size(), 1, progress, [&](std::size_t k) { found[k] = finder.to(pieces[k]); });
    std::vector<std::vector<Detour>> of_line(lines.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (!found[k]) continue;
        of_line[found[k]->from.line].push_back(*found[k]);
        for (const std::size_t i : pieces[k])
            marks[i] = 0;
    }
    for (std::size_t k = 0; k < lines.size(); ++k)
        if (!of_line[k].empty()) lengthen(lines[k], std::move(of_line[k]));
}

} // namespace facetmill
