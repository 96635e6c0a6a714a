#include "viz/deviation_colors.h"

#include "core/verify/verify.h"
#include "viz/palette.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr int table_size = 1024; // per side

double linear(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double encoded(double c) {
    c = std::clamp(c, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

Vec3 to_lab(const Rgb& c) {
    const double r = linear(c.r), g = linear(c.g), b = linear(c.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb from_lab(const Vec3& lab) {
    const auto cube = [](double v) { return v * v * v; };
    const double l = cube(lab.x() + 0.3963377774 * lab.y() + 0.2158037573 * lab.z());
    const double m = cube(lab.x() - 0.1055613458 * lab.y() - 0.0638541728 * lab.z());
    const double s = cube(lab.x() - 0.0894841775 * lab.y() - 1.2914855480 * lab.z());
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

using Table = std::array<Rgb, table_size + 1>;

/// Straight lines in OKLab from colour to colour, at a constant pace.
Table even(const std::array<Rgb, 4>& through) {
    std::vector<Vec3> lab;
    std::vector<double> at{0};
    for (const Rgb& c : through) {
        lab.push_back(to_lab(c));
        if (lab.size() > 1) at.push_back(at.back() + (lab.back() - lab[lab.size() - 2]).norm());
    }
    Table table;
    std::size_t k = 1;
    for (int i = 0; i <= table_size; ++i) {
        const double want = at.back() * i / table_size;
        while (k + 1 < at.size() && at[k] < want)
            ++k;
        const double t = (want - at[k - 1]) / (at[k] - at[k - 1]);
        table[std::size_t(i)] = from_lab(lab[k - 1] + t * (lab[k] - lab[k - 1]));
    }
    return table;
}

const Table& reds() {
    static const Table table = even(fixed_colors().missing);
    return table;
}
const Table& blues() {
    static const Table table = even(fixed_colors().standing);
    return table;
}

/// The least of 1, 2, 5 times a power of ten of `unit` that is not below `mm`.
double round_up(double mm, LengthUnit unit) {
    const double per = mm_per(unit), value = std::max(mm / per, 1e-6);
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= value * (1 - 1e-9)) return step * power * per;
    return 10 * power * per;
}

/// Colours looked up by place in the range, because a sample must not cost a search in the map.
class Lookup {
public:
    explicit Lookup(const DeviationScale& scale) : scale_(scale) {
        for (std::size_t i = 0; i <= size; ++i)
            table_[i] = bytes(deviation_color(scale, at(i)));
        gray_ = bytes(unjudged_color());
        red_ = bytes(deviation_color_at(-1));
        blue_ = bytes(deviation_color_at(1));
    }
    const std::array<std::uint8_t, 4>& operator()(double d) const {
        if (d < std::min(scale_.low, -scale_.gouge_limit)) return red_;
        if (d > std::max(scale_.high, scale_.tolerance)) return blue_;
        const double t = (d - scale_.low) / (scale_.high - scale_.low);
        return table_[std::size_t(std::clamp(t, 0.0, 1.0) * size + 0.5)];
    }
    const std::array<std::uint8_t, 4>& gray() const { return gray_; }

private:
    static constexpr std::size_t size = 4096;
    double at(std::size_t i) const { return scale_.low + (scale_.high - scale_.low) * double(i) / size; }
    static std::array<std::uint8_t, 4> bytes(const Rgb& c) {
        const auto byte = [](double v) { return std::uint8_t(std::lround(255 * v)); };
        return {byte(c.r), byte(c.g), byte(c.b), 255};
    }
    DeviationScale scale_;
    std::array<std::array<std::uint8_t, 4>, size + 1> table_;
    std::array<std::uint8_t, 4> gray_, red_, blue_;
};

} // namespace

DeviationScale default_scale(const Verification& verification, LengthUnit unit) {
    const VerifySettings& used = verification.used;
    DeviationScale scale;
    scale.gouge_limit = std::max(0.0, used.gouge_limit);
    scale.tolerance = std::max(0.0, used.tolerance);
    if (scale.tolerance > 0) {
        scale.high = 2 * scale.tolerance;
        scale.low = -std::max(scale.tolerance, 2 * scale.gouge_limit);
    } else {
        const double excess = verification.figures.excess_p99;
        const double gouge = std::max(verification.figures.gouge_max, verification.border.gouge_max);
        scale.high = round_up(std::max(excess, 0.1 * gouge), unit);
        scale.low = -round_up(std::max({gouge, 2 * scale.gouge_limit, 0.1 * scale.high}), unit);
    }
    return scale;
}

Rgb deviation_color_at(double t) {
    const Table& table = t < 0 ? reds() : blues();
    return table[std::size_t(std::lround(std::min(std::abs(t), 1.0) * table_size))];
}

Rgb deviation_color(const DeviationScale& scale, double d) {
    if (!std::isfinite(d)) return unjudged_color();
    const double low = -scale.gouge_limit, high = scale.tolerance;
    if (d >= low && d <= high) return deviation_color_at(0);
    // A range that ends within the limits leaves nothing to grade: beyond them all is the end's colour.
    if (d < low) return deviation_color_at(scale.low < low ? -(low - d) / (low - scale.low) : -1.0);
    return deviation_color_at(scale.high > high ? (d - high) / (scale.high - high) : 1.0);
}

Rgb unjudged_color() {
    return fixed_colors().unjudged;
}

std::vector<ScaleMark> scale_marks(const DeviationScale& scale, LengthUnit unit, double min_gap) {
    std::vector<ScaleMark> marks;
    const double gap = min_gap * (scale.high - scale.low);
    // In the order of their worth: what comes first keeps its place.
    for (const double v : {scale.low, scale.high, 0.0, scale.tolerance, -scale.gouge_limit}) {
        if (v < scale.low || v > scale.high) continue;
        const bool free = std::none_of(marks.begin(), marks.end(),
                                       [&](const ScaleMark& m) { return std::abs(m.value - v) < gap; });
        if (!free) continue;
        std::string label = format_number(v / mm_per(unit), 3);
        if (label[0] == '-') label.replace(0, 1, "\u2212");
        if (v > 0) label.insert(0, "+");
        marks.push_back({v, std::move(label)});
    }
    std::sort(marks.begin(), marks.end(),
              [](const ScaleMark& a, const ScaleMark& b) { return a.value < b.value; });
    return marks;
}

bool judged(std::uint8_t flags, float deviation, double gouge_limit) {
    if (!std::isfinite(deviation) || (flags & DeviationSurface::bare)) return false;
    return flags == DeviationSurface::counted || double(deviation) < -gouge_limit;
}

std::vector<std::uint8_t> deviation_colors(std::span<const float> deviation,
                                           std::span<const std::uint8_t> flags, const DeviationScale& scale) {
    const Lookup lookup(scale);
    std::vector<std::uint8_t> colors(4 * deviation.size());
    for (std::size_t i = 0; i < deviation.size(); ++i) {
        const std::uint8_t flag = flags.empty() ? std::uint8_t(DeviationSurface::counted) : flags[i];
        const auto& c =
            judged(flag, deviation[i], scale.gouge_limit) ? lookup(double(deviation[i])) : lookup.gray();
        std::copy(c.begin(), c.end(), colors.begin() + std::ptrdiff_t(4 * i));
    }
    return colors;
}

std::vector<VertexColor> deviation_vertex_colors(std::span<const float> deviation,
                                                 std::span<const std::uint8_t> flags,
                                                 const DeviationScale& scale) {
    const std::vector<std::uint8_t> rgba = deviation_colors(deviation, flags, scale);
    std::vector<VertexColor> colors(deviation.size());
    for (std::size_t v = 0; v < colors.size(); ++v)
        std::copy_n(rgba.begin() + std::ptrdiff_t(4 * v), 3, colors[v].begin());
    return colors;
}

} // namespace facetmill
