#include "core/mesh/relief.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr std::size_t rows_per_block = 64;
/// Each evens out over about a pixel more; together they reach across six.
constexpr int smoothing_passes = 64;

/// A pass that moves nothing by more than this share of the bound is the last.
constexpr double settled = 1e-3;

/// The mean of a point and its neighbours before and behind it, (1 2 1) / 4. Behind the end of a line it goes
/// on as its last two points do, so that a slope stays one up to the border.
double mean_of(double before, double here, double behind) {
    return 0.5 * here + 0.25 * (before + behind);
}
double mean_at_end(double end, double next, double second) {
    return 0.5 * end + next - 0.5 * second;
}

void filter_line(const double* from, double* to, std::size_t count) {
    for (std::size_t i = 1; i + 1 < count; ++i)
        to[i] = mean_of(from[i - 1], from[i], from[i + 1]);
    to[0] = count > 2 ? mean_at_end(from[0], from[1], from[2]) : from[0];
    to[count - 1] = count > 2 ? mean_at_end(from[count - 1], from[count - 2], from[count - 3]) : from[1];
}

} // namespace

void check_picture_size(const MeshSource& source, std::uint64_t columns, std::uint64_t rows) {
    const std::string size = std::to_string(columns) + " × " + std::to_string(rows) + " pixels";
    if (columns < 2 || rows < 2)
        throw Error(ErrorCode::no_facets, source.name, "the picture has " + size,
                    "a relief needs two columns and two rows");
    if (std::max(columns, rows) > max_picture_side || columns > max_picture_pixels / rows)
        throw Error(ErrorCode::too_large, source.name,
                    "the picture has " + size + ", more than 100 million in all or 100 000 a side",
                    "make it smaller in a picture editor");
}

/// In whole numbers, so that a grid of as many points as pixels has their very values.
class ReliefBuilder::Share {
public:
    Share(std::size_t pixels, std::size_t points) : steps_(pixels - 1), spans_(points - 1) {}
    void advance(std::size_t by = 1) {
        part_ += by * spans_;
        point_ += part_ / steps_;
        part_ %= steps_;
    }
    std::size_t point() const { return std::min(point_, spans_ - 1); }
    double of_next() const { return point_ == spans_ ? 1 : double(part_) / double(steps_); }

private:
    std::size_t steps_, spans_; ///< from the first pixel to the last, and from the first point to the last
    std::size_t point_ = 0, part_ = 0;
};

ReliefBuilder::ReliefBuilder(const MeshSource& source, std::size_t columns, std::size_t rows)
    : source_(source), columns_(columns), rows_(rows), grid_columns_(columns), grid_rows_(rows) {
    if (columns * rows > max_relief_points) {
        const double share = std::sqrt(double(max_relief_points) / (double(columns) * double(rows)));
        grid_rows_ = std::clamp<std::size_t>(std::size_t(double(rows) * share), 2, rows);
        grid_columns_ = std::clamp<std::size_t>(max_relief_points / grid_rows_, 2, columns);
    }
    heights_.assign(grid_columns_ * grid_rows_, 0.0);
    row_weights_.assign(grid_rows_, 0.0);
    column_weights_.assign(grid_columns_, 0.0);
    Share share(columns, grid_columns_);
    for (std::size_t c = 0; c < columns; ++c, share.advance()) {
        column_weights_[share.point()] += 1 - share.of_next();
        column_weights_[share.point() + 1] += share.of_next();
    }
}

void ReliefBuilder::add_row(std::span<const double> brightness, std::span<const double> opacity) {
    row_values_.assign(grid_columns_, 0.0);
    const bool invert = source_.reading.relief.invert;
    Share share(columns_, grid_columns_);
    for (std::size_t c = 0; c < columns_; ++c, share.advance()) {
        double height = invert ? 1 - brightness[c] : brightness[c];
        if (!opacity.empty()) height *= opacity[c];
        row_values_[share.point()] += (1 - share.of_next()) * height;
        row_values_[share.point() + 1] += share.of_next() * height;
    }
    Share rows(rows_, grid_rows_);
    rows.advance(row_++);
    const std::size_t above = rows.point();
    const double of_below = rows.of_next();
    double* grid = &heights_[above * grid_columns_];
    row_weights_[above] += 1 - of_below;
    row_weights_[above + 1] += of_below;
    for (std::size_t c = 0; c < grid_columns_; ++c) {
        grid[c] += (1 - of_below) * row_values_[c];
        grid[grid_columns_ + c] += of_below * row_values_[c];
    }
    if (row_ == rows_) divide_by_weights();
}

void ReliefBuilder::divide_by_weights() {
    for (std::size_t r = 0; r < grid_rows_; ++r)
        for (std::size_t c = 0; c < grid_columns_; ++c)
            heights_[r * grid_columns_ + c] /= row_weights_[r] * column_weights_[c];
}

void ReliefBuilder::stretch() {
    const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
    const double from = *low, range = *high - *low;
    for (double& h : heights_)
        h = range > 0 ? (h - from) / range : 0;
}

void ReliefBuilder::smooth(double bound, const Progress& progress) {
    const std::vector<double> given = heights_;
    std::vector<double> across(heights_.size());
    for (int pass = 0; pass < smoothing_passes; ++pass) {
        const Progress part =
            progress.part(double(pass) / smoothing_passes, double(pass + 1) / smoothing_passes);
        parallel_blocks(
            grid_rows_, rows_per_block, part.part(0, 0.4), [&](std::size_t begin, std::size_t end) {
                for (std::size_t r = begin; r < end; ++r)
                    filter_line(&heights_[r * grid_columns_], &across[r * grid_columns_], grid_columns_);
            });
        const double moved = parallel_reduce(
            grid_rows_, rows_per_block, 0.0, part.part(0.4, 1),
            [&](std::size_t begin, std::size_t end) {
                double largest = 0;
                for (std::size_t r = begin; r < end; ++r) {
                    // The row itself and the two that count for it, at the border both on the same side.
                    const bool first = r == 0, border = first || r + 1 == grid_rows_;
                    const double* here = &across[r * grid_columns_];
                    const std::ptrdiff_t step =
                        first ? std::ptrdiff_t(grid_columns_) : -std::ptrdiff_t(grid_columns_);
                    for (std::size_t c = 0; c < grid_columns_; ++c) {
                        const std::size_t i = r * grid_columns_ + c;
                        const double* at = here + c;
                        const double mean = grid_rows_ < 3 ? *at
                                            : border       ? mean_at_end(*at, at[step], at[2 * step])
                                                           : mean_of(at[step], *at, at[-step]);
                        const double height = std::clamp(mean, given[i] - bound, given[i] + bound);
                        largest = std::max(largest, std::abs(height - heights_[i]));
                        heights_[i] = height;
                    }
                }
                return largest;
            },
            [](double a, double b) { return std::max(a, b); });
        if (moved <= settled * bound) break;
    }
}

TriangleSoup ReliefBuilder::finish(const std::string& format, std::set<std::string> warnings,
                                   const Progress& progress) {
    const Relief& relief = source_.reading.relief;
    if (!relief.width || !relief.height) warnings.insert("picture_size_assumed");
    if (heights_.size() < columns_ * rows_) warnings.insert("picture_reduced");
    const double width = relief.width.value_or(usual_relief_width);
    const double length = relief.length.value_or(width * double(rows_ - 1) / double(columns_ - 1));
    const double height = relief.height.value_or(usual_relief_height);
    if (relief.smoothing > 0) {
        smooth(relief.smoothing / height, progress.part(0, 0.8));
        warnings.erase("picture_steps");
    }

    TriangleSoup soup;
    soup.format = format;
    soup.warnings = std::move(warnings);
    soup.is_relief = true;
    soup.indexed = true;
    const double per = mm_per(source_.reading.unit.value_or(LengthUnit::mm));
    soup.points.reserve(heights_.size());
    for (std::size_t r = 0; r < grid_rows_; ++r) {
        progress.set(0.8 + 0.1 * double(r) / double(grid_rows_));
        const double y = length * (double(grid_rows_ - 1 - r) / double(grid_rows_ - 1));
        for (std::size_t c = 0; c < grid_columns_; ++c)
            soup.points.emplace_back(width * (double(c) / double(grid_columns_ - 1)) / per, y / per,
                                     height * heights_[r * grid_columns_ + c] / per);
    }
    soup.facets.reserve(2 * (grid_rows_ - 1) * (grid_columns_ - 1));
    for (std::size_t r = 0; r + 1 < grid_rows_; ++r) {
        progress.set(0.9 + 0.1 * double(r) / double(grid_rows_));
        for (std::size_t c = 0; c + 1 < grid_columns_; ++c) {
            const auto a = Index(r * grid_columns_ + c), b = a + 1;
            const auto d = Index(a + grid_columns_), e = d + 1; // below them
            // Along the diagonal that climbs less: edges follow ridges and valleys.
            if (std::abs(heights_[d] - heights_[b]) <= std::abs(heights_[a] - heights_[e])) {
                soup.facets.push_back({a, d, b});
                soup.facets.push_back({b, d, e});
            } else {
                soup.facets.push_back({a, d, e});
                soup.facets.push_back({a, e, b});
            }
        }
    }
    return soup;
}

} // namespace facetmill::detail
