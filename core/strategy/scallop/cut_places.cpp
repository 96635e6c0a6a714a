#include "core/strategy/scallop/cut_places.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// A place between two others is as high as they are if it is by so much of a place's width.
constexpr double lone_gap = 0.1;
/// Normals of what is level, and how little two heights differ on it, of a place's width.
constexpr float level_bottom = 1 - 1e-6F;
constexpr double same_level = 1e-4;
/// Tips of places side by side that are so much farther apart than on the steepest slope stand above and
/// below a wall.
constexpr double wall_jump = 1.5;
/// To half of the places round one; to the others they lead back.
constexpr std::array<std::array<int, 2>, 4> four_directions{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
constexpr std::array<std::array<int, 2>, 4> beside_a_place{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

} // namespace

/// A bottom that touches several facets tells one of them, which may be a wall's: what lies between places
/// that are cut, as high as they are, is cut.
void CutPlaces::fill_lone_gaps() {
    const std::vector<char> found = cut_;
    for (int r = 1; r + 1 < rows_; ++r)
        for (int c = 1; c + 1 < columns_; ++c) {
            const std::size_t i = number(c, r);
            if (found[i] != not_cut) continue;
            for (const auto& [dc, dr] : four_directions) {
                const std::size_t a = number(c - dc, r - dr), b = number(c + dc, r + dr);
                if (found[a] != cut_surface || found[b] != cut_surface
                    || !(std::abs(tip_[i] - 0.5F * (tip_[a] + tip_[b])) < float(lone_gap * spacing_)))
                    continue;
                cut_[i] = cut_surface;
                touched_[i] = 0.5F * (touched_[a] + touched_[b]);
                normal_[i] = (normal_[a] + normal_[b]).normalized();
                break;
            }
        }
}

/// So does one over the corner of a level face: beside a place where it lies on the face, as high, it does
/// too.
void CutPlaces::join_level_bottoms() {
    const auto level = [&](std::size_t i) { return normal_[i].z() > level_bottom; };
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < size(); ++i)
        if (cut_[i] == cut_surface && level(i)) found.push_back(i);
    for (std::size_t k = 0; k < found.size(); ++k) {
        const auto c = int(found[k] % std::size_t(columns_)), r = int(found[k] / std::size_t(columns_));
        for (const auto& [dc, dr] : beside_a_place) {
            if (c + dc < 0 || r + dr < 0 || c + dc >= columns_ || r + dr >= rows_) continue;
            const std::size_t n = number(c + dc, r + dr);
            if (cut_[n] != rolling || !level(n)
                || !(std::abs(tip_[n] - tip_[found[k]]) < float(same_level * spacing_)))
                continue;
            cut_[n] = cut_surface;
            found.push_back(n);
        }
    }
}

/// A flat end jumps from the floor to the top of a wall: nothing goes on there, across corners neither, as
/// places along the wall may stand above it or below.
void CutPlaces::part_at_walls(double steepest) {
    const double steep = wall_jump * std::tan(steepest) * spacing_;
    std::vector<char> kept = cut_;
    for (int r = 0; r < rows_; ++r)
        for (int c = 0; c < columns_; ++c)
            for (const auto& [dc, dr] : four_directions) {
                if (c + dc < 0 || c + dc >= columns_ || r + dr >= rows_) continue;
                const std::size_t i = number(c, r), n = number(c + dc, r + dr);
                const double jump = std::hypot(dc, dr) * steep;
                if (cut_[i] == not_cut || cut_[n] == not_cut || !(double(std::abs(tip_[i] - tip_[n])) > jump))
                    continue;
                kept[tip_[i] > tip_[n] ? i : n] = not_cut;
            }
    cut_ = std::move(kept);
}

/// Where the cutter rolls over an edge it is on its way to other surface, or there is nothing to cut: over
/// outer edges no line goes on.
void CutPlaces::leave_outer_edges(double radius, const Progress& progress) {
    const int far = std::max(1, int(std::ceil(2 * radius / spacing_)));
    const auto meets = [&](int c, int r, int dc, int dr) {
        for (int k = 1; k <= far; ++k) {
            c += dc;
            r += dr;
            if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return false;
            const char there = cut_[number(c, r)];
            if (there != rolling) return there == cut_surface;
        }
        return false;
    };
    std::vector<char> kept(size());
    parallel_for(std::size_t(rows_), 1, progress, [&](std::size_t row) {
        const int r = int(row);
        for (int c = 0; c < columns_; ++c) {
            const std::size_t i = number(c, r);
            kept[i] = cut_[i] == cut_surface
                      || (cut_[i] == rolling
                          && std::any_of(four_directions.begin(), four_directions.end(), [&](const auto& d) {
                                 return meets(c, r, d[0], d[1]) && meets(c, r, -d[0], -d[1]);
                             }));
        }
    });
    cut_ = std::move(kept);
}

} // namespace facetmill
