#include "core/strategy/scallop/field_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill {

std::vector<char> pieces_above(const ScallopField& field, const std::vector<double>& values, double level,
                               double top) {
    std::vector<char> seen(field.size(), 0), in(field.size(), 0);
    std::vector<std::size_t> piece;
    for (std::size_t first = 0; first < field.size(); ++first) {
        if (seen[first] || !field.cut(first) || !(values[first] > level)) continue;
        piece.assign(1, first);
        seen[first] = 1;
        double most = 0;
        for (std::size_t k = 0; k < piece.size(); ++k) {
            const std::size_t i = piece[k];
            most = std::max(most, values[i]);
            const auto column = int(i % std::size_t(field.columns())),
                       row = int(i / std::size_t(field.columns()));
            for (const auto& [c, r] : {std::pair(column - 1, row), std::pair(column + 1, row),
                                       std::pair(column, row - 1), std::pair(column, row + 1)}) {
                if (c < 0 || r < 0 || c >= field.columns() || r >= field.rows()) continue;
                const std::size_t n = field.number(c, r);
                if (seen[n] || !field.cut(n) || !(values[n] > level)) continue;
                seen[n] = 1;
                piece.push_back(n);
            }
        }
        if (most > top)
            for (const std::size_t i : piece)
                in[i] = 1;
    }
    return in;
}

std::vector<std::vector<std::size_t>> connected(const ScallopField& field, const std::vector<char>& marks) {
    std::vector<std::vector<std::size_t>> all;
    std::vector<char> seen(field.size(), 0);
    for (std::size_t first = 0; first < field.size(); ++first) {
        if (!marks[first] || seen[first]) continue;
        std::vector<std::size_t> piece{first};
        seen[first] = 1;
        for (std::size_t k = 0; k < piece.size(); ++k) {
            const auto column = int(piece[k] % std::size_t(field.columns())),
                       row = int(piece[k] / std::size_t(field.columns()));
            for (int r = std::max(0, row - 1); r <= std::min(field.rows() - 1, row + 1); ++r)
                for (int c = std::max(0, column - 1); c <= std::min(field.columns() - 1, column + 1); ++c) {
                    const std::size_t n = field.number(c, r);
                    if (!marks[n] || seen[n]) continue;
                    seen[n] = 1;
                    piece.push_back(n);
                }
        }
        all.push_back(std::move(piece));
    }
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
