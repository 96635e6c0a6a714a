#include "core/strategy/scallop/scallop_field.h"

#include "core/base/parallel.h"
#include "core/strategy/scallop/cut_places.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace facetmill {

namespace {

/// What the touched place moves for what the tip moves: less is an edge, more a jump across a hollow.
constexpr double min_bend = 0.0025, max_bend = 4;
/// Within so many radii of the border places may be those of a cutter that rolls over the rim: they touch
/// nearly the same place, less than that share of the tip's way apart.
constexpr double rim_radii = 0.22, rolling_share = 0.3;
constexpr std::size_t field_block = 1024;
/// What rises by so much of a place's width beside a place at the border is a wall.
constexpr double foot_rise = 1;
/// To places beside one.
constexpr std::array<std::array<int, 2>, 4> four_aside{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

using Mat2 = Eigen::Matrix2d;

Mat2 matrix(const std::array<double, 3>& m) {
    return (Mat2() << m[0], m[1], m[1], m[2]).finished();
}

/// Of a tangent plane with this normal: lengths of displacements that are given seen from above.
std::array<double, 3> lengths_on(const Vec3& n) {
    const double a = -n.x() / n.z(), b = -n.y() / n.z();
    return {1 + a * a, a * b, 1 + b * b};
}

/// The inverse of the square root of a positive matrix, and its square root.
std::pair<Mat2, Mat2> roots(const Mat2& m) {
    const Eigen::SelfAdjointEigenSolver<Mat2> e(m);
    const Eigen::Vector2d root = e.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
    const Mat2& v = e.eigenvectors();
    return {v * root.cwiseInverse().asDiagonal() * v.transpose(), v * root.asDiagonal() * v.transpose()};
}

Mat2 bounded(const Mat2& m, double least, double most) {
    const Eigen::SelfAdjointEigenSolver<Mat2> e(m);
    const Mat2& v = e.eigenvectors();
    return v * e.eigenvalues().cwiseMax(least).cwiseMin(most).asDiagonal() * v.transpose();
}

} // namespace

ScallopField::ScallopField(const AxialLift& lift, const TouchTeller& tell, const ScallopSteps& steps,
                           const Box3& box, const Options& options, const Progress& progress)
    : steps_(steps), origin_(box.center()), spacing_(options.spacing), steepest_(options.steepest),
      allowance_(tell.allowance()) {
    const LevelField field(
        lift, tell, box, options.beyond, spacing_,
        [&](int first, std::span<const TipTouch> touches) { look(first, touches); }, progress.part(0, 0.5));
    lo_ = field.place(0, 0);
    columns_ = field.columns();
    rows_ = field.rows();
    CutPlaces places(columns_, spacing_, cut_, touched_, normal_, tip_);
    places.fill_lone_gaps();
    if (tell.cover().has_flat_bottom()) places.join_level_bottoms();
    places.part_at_walls(std::min(steepest_, ScallopSteps::steepest));
    places.leave_outer_edges(lift.profile().max_radius(), progress.part(0.5, 0.5));
    if (options.within) keep_within(*options.within, progress.part(0.5, 0.6));
    touch_under_flat_bottoms(tell.cover());
    make_metric(options, lift.profile().max_radius(), progress.part(0.6, 1));
}

void ScallopField::look(int first, std::span<const TipTouch> touches) {
    // Bands overlap by a row.
    const std::size_t known = first > 0 ? cut_.size() / std::size_t(first + 1) : 0;
    for (std::size_t i = known; i < touches.size(); ++i) {
        const TipTouch& t = touches[i];
        cut_.push_back(!t.any || t.slope() > steepest_ ? not_cut : t.surface ? cut_surface : rolling);
        touched_.push_back((t.point - origin_).cast<float>());
        normal_.push_back(t.normal.cast<float>());
        tip_.push_back(float(t.tip_z - origin_.z()));
    }
}

/// A flat bottom that lies on level surface cuts what is under its middle, wherever it touches first.
void ScallopField::touch_under_flat_bottoms(const CutterCover& cover) {
    for (std::size_t i = 0; i < size(); ++i) {
        if (!cut_[i]) continue;
        const Vec3 n = normal_[i].cast<double>(), offset = cover.tip_offset(n);
        if (offset.x() != 0 || offset.y() != 0) continue;
        touched_[i] = (tip(i) - offset - allowance_ * n - origin_).cast<float>();
    }
}

void ScallopField::keep_within(const KeptWithin& within, const Progress& progress) {
    parallel_blocks(size(), field_block, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!cut_[i]) continue;
            Index hint = no_index;
            cut_[i] = within.contain == Containment::contact
                          ? within.region->holds(touched(i), hint)
                          : within.region->depth(place(i)) >= within.min_depth();
        }
    });
}

bool ScallopField::cut_at(const Vec2& p) const {
    const Vec2 at = (p - lo_) / spacing_;
    const auto c = int(std::lround(at.x())), r = int(std::lround(at.y()));
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ && cut_[number(c, r)];
}

bool ScallopField::any() const {
    return std::any_of(cut_.begin(), cut_.end(), [](char c) { return c; });
}

std::vector<std::size_t> ScallopField::around(const Vec2& p) const {
    const Vec2 at = (p - lo_) / spacing_;
    const auto column = int(std::floor(at.x())), row = int(std::floor(at.y()));
    std::vector<std::size_t> all;
    for (const int r : {row, row + 1})
        for (const int c : {column, column + 1})
            if (c >= 0 && r >= 0 && c < columns_ && r < rows_ && cut_[number(c, r)])
                all.push_back(number(c, r));
    return all;
}

double ScallopField::steps(std::size_t i, const Vec2& by) const {
    return std::sqrt(std::max(0.0, by.dot(matrix(metric_[i]) * by)));
}

std::vector<std::size_t> ScallopField::border() const {
    std::vector<std::size_t> all;
    for (int r = 0; r < rows_; ++r)
        for (int c = 0; c < columns_; ++c) {
            const std::size_t i = number(c, r);
            if (!cut_[i]) continue;
            const bool inner = c > 0 && r > 0 && c + 1 < columns_ && r + 1 < rows_ && cut_[i - 1]
                               && cut_[i + 1] && cut_[number(c, r - 1)] && cut_[number(c, r + 1)];
            if (!inner || at_foot(i)) all.push_back(i);
        }
    return all;
}

Vec2 ScallopField::towards_wall(std::size_t i) const {
    const auto column = int(i % std::size_t(columns_)), row = int(i / std::size_t(columns_));
    Vec2 sum = Vec2::Zero(), last = sum;
    for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
            if (const std::size_t n = number(c, r);
                !cut_[n] && double(tip_[n] - tip_[i]) > foot_rise * spacing_)
                sum += last = place(n) - place(i);
    // Between two walls: to either of them.
    return sum == Vec2::Zero() ? last : sum;
}

std::size_t ScallopField::nearest(const Vec3& p) const {
    std::size_t best = 0;
    double best2 = infinity;
    for (std::size_t i = 0; i < size(); ++i) {
        if (!cut_[i]) continue;
        const double d2 = (touched(i) - p).squaredNorm();
        if (!(d2 < best2)) continue;
        best2 = d2;
        best = i;
    }
    return best;
}

/// Displacement of the tip times that of the touched place. `jump`: what moves farther than so many times the
/// tip has jumped across a hollow, and says nothing of how the surface bends.
ScallopField::Metric ScallopField::displacement(std::size_t i, double jump) const {
    const Vec3 n = normal_[i].cast<double>();
    const std::array<Vec3, 2> tip{Vec3(1, 0, -n.x() / n.z()), Vec3(0, 1, -n.y() / n.z())};
    const auto column = int(i % std::size_t(columns_)), row = int(i / std::size_t(columns_));
    std::array<Vec3, 2> touched = tip;
    for (int k = 0; k < 2; ++k) {
        const int at = k == 0 ? column : row, last = (k == 0 ? columns_ : rows_) - 1;
        const std::size_t by = k == 0 ? 1 : std::size_t(columns_);
        const std::size_t before = at > 0 && cut_[i - by] ? i - by : i,
                          after = at < last && cut_[i + by] ? i + by : i;
        if (before == after) continue;
        const std::size_t cells = (after - before) / by; // one or two
        const double apart = spacing_ * double(cells);
        const Vec3 moved = (touched_[after] - touched_[before]).cast<double>() / apart;
        if (moved.norm() <= jump * tip[std::size_t(k)].norm()) touched[std::size_t(k)] = moved;
    }
    return {tip[0].dot(touched[0]), 0.5 * (tip[0].dot(touched[1]) + tip[1].dot(touched[0])),
            tip[1].dot(touched[1])};
}

/// Over a square of the places that are cut, `half` to each side.
std::vector<ScallopField::Metric> ScallopField::averaged(const std::vector<Metric>& field, int half,
                                                         const Progress& progress) const {
    using Sum = std::array<double, 4>; // the last counts
    std::vector<Sum> along(size());
    const auto add = [](Sum& to, const Sum& from, double sign) {
        for (std::size_t k = 0; k < 4; ++k)
            to[k] += sign * from[k];
    };
    const auto own = [&](std::size_t i) {
        return cut_[i] ? Sum{field[i][0], field[i][1], field[i][2], 1} : Sum{};
    };
    parallel_for(std::size_t(rows_), 1, progress.part(0, 0.5), [&](std::size_t r) {
        for (int c = 0; c < columns_; ++c) {
            Sum sum{};
            for (int k = std::max(0, c - half); k <= std::min(columns_ - 1, c + half); ++k)
                add(sum, own(number(k, int(r))), 1);
            along[number(c, int(r))] = sum;
        }
    });
    std::vector<Metric> all(size());
    parallel_for(std::size_t(rows_), 1, progress.part(0.5, 1), [&](std::size_t r) {
        for (int c = 0; c < columns_; ++c) {
            const std::size_t i = number(c, int(r));
            if (!cut_[i]) continue;
            Sum sum{};
            for (int k = std::max(0, int(r) - half); k <= std::min(rows_ - 1, int(r) + half); ++k)
                add(sum, along[number(c, k)], 1);
            all[i] = {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
        }
    });
    return all;
}

/// Places at the border at which the cutter rolls over the rim, by so little that it counts as on the
/// surface.
std::vector<char> ScallopField::over_rim(double radius, const Progress& progress) const {
    std::vector<char> rolls(size(), 0);
    std::vector<std::size_t> front = border(), next;
    const auto inner = [&](std::size_t i, int dc, int dr) -> std::optional<std::size_t> {
        const auto c = int(i % std::size_t(columns_)) + dc, r = int(i / std::size_t(columns_)) + dr;
        if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return std::nullopt;
        const std::size_t n = number(c, r);
        return cut_[n] && !rolls[n] ? std::optional(n) : std::nullopt;
    };
    for (int k = int(std::ceil(rim_radii * radius / spacing_)); k > 0 && !front.empty(); --k) {
        progress.check();
        std::vector<std::size_t> found;
        for (const std::size_t i : front)
            if (std::any_of(four_aside.begin(), four_aside.end(), [&](const auto& by) {
                    const auto in = inner(i, by[0], by[1]);
                    if (!in || inner(i, -by[0], -by[1])) return false;
                    return (touched(*in) - touched(i)).norm() < rolling_share * (tip(*in) - tip(i)).norm();
                }))
                found.push_back(i);
        for (const std::size_t i : found)
            rolls[i] = 1;
        next.clear();
        for (const std::size_t i : found)
            for (const auto& by : four_aside)
                if (const auto in = inner(i, by[0], by[1])) next.push_back(*in);
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        front = next;
    }
    return rolls;
}

void ScallopField::make_metric(const Options& options, double radius, const Progress& progress) {
    std::vector<Metric> moved(size()), plane(size());
    // There is nothing beyond the rim for which passes might lie farther apart.
    const std::vector<char> rolls = over_rim(radius, progress);
    parallel_blocks(size(), field_block, progress.part(0, 0.2), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!cut_[i]) continue;
            plane[i] = lengths_on(normal_[i].cast<double>());
            moved[i] = rolls[i] ? plane[i] : displacement(i, max_bend);
        }
    });
    const double usual = std::min(options.step ? *options.step : steps_.down(0).apart, radius);
    const int half = half_step_ = std::max(1, int(std::lround(0.5 * usual / spacing_)));
    const std::vector<Metric> mean_moved = averaged(moved, half, progress.part(0.2, 0.5)),
                              mean_plane = averaged(plane, half, progress.part(0.5, 0.8));
    metric_.resize(size());
    parallel_blocks(size(), field_block, progress.part(0.8, 1), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!cut_[i]) continue;
            const Mat2 flat = matrix(plane[i]);
            if (options.step) {
                const Mat2 same = flat / (*options.step * *options.step);
                metric_[i] = {same(0, 0), same(0, 1), same(1, 1)};
                continue;
            }
            const auto [unplane, unused] = roots(matrix(mean_plane[i]));
            const Mat2 bend = bounded(unplane * matrix(mean_moved[i]) * unplane, min_bend, max_bend);
            const auto [inverse, root] = roots(flat);
            const Mat2 here = root * bend * root;
            // Into directions down the slope and along the level, in which the cutter has its steps.
            const Vec3 n = normal_[i].cast<double>();
            const double slope = std::acos(std::clamp(n.z(), -1.0, 1.0)), level = n.head<2>().norm();
            const Vec2 fall = level > 1e-6 ? Vec2(n.head<2>() / level) : Vec2(1, 0);
            Mat2 basis;
            basis << std::cos(slope) * fall.x(), -fall.y(), std::cos(slope) * fall.y(), fall.x();
            Mat2 own = basis.transpose() * here * basis;
            const ScallopSteps::Step down = steps_.down(slope), across = steps_.across(slope);
            // What is round leaves in proportion to the bend, a corner to its square.
            const double a = std::pow(own(0, 0), down.power - 0.5) / down.apart,
                         b = std::pow(own(1, 1), across.power - 0.5) / across.apart;
            own(0, 0) *= a * a;
            own(0, 1) *= a * b;
            own(1, 0) *= a * b;
            own(1, 1) *= b * b;
            const Mat2 back = basis.inverse();
            const Mat2 m = back.transpose() * own * back;
            metric_[i] = {m(0, 0), m(0, 1), m(1, 1)};
        }
    });
}

std::optional<ScallopField::Touch> ScallopField::between(std::size_t i, std::size_t j, double t) const {
    if (!cut_[i] || !cut_[j]) return std::nullopt;
    const Touch a = touch(i), b = touch(j);
    if ((b.point - a.point).norm() > max_bend * (b.tip - a.tip).norm()) return std::nullopt;
    return Touch{a.point + t * (b.point - a.point), (a.normal + t * (b.normal - a.normal)).normalized(),
                 a.tip + t * (b.tip - a.tip)};
}

double ScallopField::power(std::size_t i) const {
    const double slope = std::acos(std::clamp(double(normal_[i].z()), -1.0, 1.0));
    return 0.5 * (steps_.down(slope).power + steps_.across(slope).power);
}

std::vector<float> ScallopField::smoothed(const std::vector<float>& values, const std::vector<float>& weights,
                                          const Progress& progress) const {
    std::vector<Metric> weighted(size());
    for (std::size_t i = 0; i < size(); ++i)
        weighted[i] = {double(values[i]) * double(weights[i]), double(weights[i]), 0};
    weighted = averaged(weighted, half_step_, progress);
    std::vector<float> all(size(), 1);
    for (std::size_t i = 0; i < size(); ++i)
        if (weighted[i][1] > 1e-6) all[i] = float(weighted[i][0] / weighted[i][1]);
    return all;
}

void ScallopField::shorten_steps(const std::vector<float>& factors) {
    for (std::size_t i = 0; i < size(); ++i)
        for (double& m : metric_[i])
            m *= double(factors[i]) * double(factors[i]);
}

} // namespace facetmill
