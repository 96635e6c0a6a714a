#include "core/strategy/scallop/field_marks.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// The places that are `in` and hang together with the first one, over corners too where `corners`; they are
/// `seen` then.
template <class In>
std::vector<std::size_t> piece_of(const ScallopField& field, std::size_t first, bool corners, const In& in,
                                  std::vector<char>& seen) {
    std::vector<std::size_t> piece{first};
    seen[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const auto column = int(piece[k] % std::size_t(field.columns())),
                   row = int(piece[k] / std::size_t(field.columns()));
        for (int r = std::max(0, row - 1); r <= std::min(field.rows() - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(field.columns() - 1, column + 1); ++c) {
                const std::size_t n = field.number(c, r);
                if ((!corners && r != row && c != column) || seen[n] || !in(n)) continue;
                seen[n] = 1;
                piece.push_back(n);
            }
    }
    return piece;
}

} // namespace

std::vector<char> pieces_above(const ScallopField& field, const std::vector<double>& values, double level,
                               double top) {
    const auto is_high = [&](std::size_t i) { return field.cut(i) && values[i] > level; };
    std::vector<char> seen(field.size(), 0), marks(field.size(), 0);
    for (std::size_t first = 0; first < field.size(); ++first) {
        if (seen[first] || !is_high(first)) continue;
        const auto piece = piece_of(field, first, false, is_high, seen);
        if (std::none_of(piece.begin(), piece.end(), [&](std::size_t i) { return values[i] > top; }))
            continue;
        for (const std::size_t i : piece)
            marks[i] = 1;
    }
    return marks;
}

std::vector<std::vector<std::size_t>> connected(const ScallopField& field, const std::vector<char>& marks) {
    const auto is_marked = [&](std::size_t i) { return marks[i] != 0; };
    std::vector<std::vector<std::size_t>> all;
    std::vector<char> seen(field.size(), 0);
    for (std::size_t first = 0; first < field.size(); ++first)
        if (is_marked(first) && !seen[first]) all.push_back(piece_of(field, first, true, is_marked, seen));
    return all;
}

std::vector<char> grown(const ScallopField& field, const std::vector<char>& marks, double steps,
                        const Progress& progress) {
    std::vector<char> all(field.size(), 0);
    const int by = std::max(1, int(std::lround(2 * steps * field.half_step())));
    for (std::size_t i = 0; i < field.size(); ++i) {
        if (!marks[i]) continue;
        progress.check();
        const auto column = int(i % std::size_t(field.columns())),
                   row = int(i / std::size_t(field.columns()));
        for (int r = std::max(0, row - by); r <= std::min(field.rows() - 1, row + by); ++r)
            for (int c = std::max(0, column - by); c <= std::min(field.columns() - 1, column + by); ++c)
                if (field.cut(field.number(c, r))
                    && (r - row) * (r - row) + (c - column) * (c - column) <= by * by)
                    all[field.number(c, r)] = 1;
    }
    return all;
}

} // namespace facetmill
