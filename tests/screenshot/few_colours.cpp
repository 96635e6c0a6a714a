#include "tests/screenshot/few_colours.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace facetmill::test {

namespace {

constexpr std::size_t most_colours = 256;

struct CountedColour {
    std::array<int, 3> rgb{};
    double count = 0;
};

/// Colours from `begin` to `end`, and how far they spread along the channel that spreads most.
struct ColourBox {
    std::size_t begin = 0, end = 0;
    int channel = 0;
    double spread = 0;
};

ColourBox measured_box(const std::vector<CountedColour>& colours, std::size_t begin, std::size_t end) {
    ColourBox box{begin, end};
    for (int c = 0; c < 3; ++c) {
        const auto k = std::size_t(c);
        double sum = 0, squares = 0, count = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const double v = colours[i].rgb[k], n = colours[i].count;
            sum += n * v;
            squares += n * v * v;
            count += n;
        }
        const double spread = squares - sum * sum / count;
        if (spread > box.spread) {
            box.channel = c;
            box.spread = spread;
        }
    }
    return box;
}

/// Where the two halves have the same weight; both have something.
std::size_t middle_of(std::vector<CountedColour>& colours, const ColourBox& box) {
    const auto first = colours.begin();
    std::sort(first + std::ptrdiff_t(box.begin), first + std::ptrdiff_t(box.end),
              [k = std::size_t(box.channel)](const CountedColour& a, const CountedColour& b) {
                  return std::tie(a.rgb[k], a.rgb) < std::tie(b.rgb[k], b.rgb);
              });
    double all = 0, below = 0;
    for (std::size_t i = box.begin; i < box.end; ++i)
        all += colours[i].count;
    std::size_t at = box.begin;
    while (at + 1 < box.end && below + colours[at].count <= all / 2)
        below += colours[at++].count;
    return std::max(at, box.begin + 1);
}

QRgb mean_colour(const std::vector<CountedColour>& colours, const ColourBox& box) {
    std::array<double, 3> sum{};
    double count = 0;
    for (std::size_t i = box.begin; i < box.end; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += colours[i].count * colours[i].rgb[k];
        count += colours[i].count;
    }
    return qRgb(int(sum[0] / count + 0.5), int(sum[1] / count + 0.5), int(sum[2] / count + 0.5));
}

} // namespace

QImage in_few_colours(const QImage& picture) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB32);
    std::map<QRgb, double> counts;
    for (int y = 0; y < rgb.height(); ++y)
        for (int x = 0; x < rgb.width(); ++x)
            ++counts[rgb.pixel(x, y) | 0xff000000U];
    std::vector<CountedColour> colours;
    colours.reserve(counts.size());
    for (const auto& [colour, count] : counts)
        colours.push_back({{qRed(colour), qGreen(colour), qBlue(colour)}, count});
    std::vector<ColourBox> boxes{measured_box(colours, 0, colours.size())};
    while (boxes.size() < most_colours) {
        const auto widest = std::max_element(
            boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.spread < b.spread; });
        if (widest->spread <= 0) break;
        const ColourBox box = *widest;
        const std::size_t middle = middle_of(colours, box);
        *widest = measured_box(colours, box.begin, middle);
        boxes.push_back(measured_box(colours, middle, box.end));
    }
    std::map<QRgb, uint> places;
    QList<QRgb> table;
    for (const ColourBox& box : boxes) {
        for (std::size_t i = box.begin; i < box.end; ++i)
            places[qRgb(colours[i].rgb[0], colours[i].rgb[1], colours[i].rgb[2])] = uint(table.size());
        table << mean_colour(colours, box);
    }
    QImage few(rgb.size(), QImage::Format_Indexed8);
    few.setColorTable(table);
    for (int y = 0; y < rgb.height(); ++y)
        for (int x = 0; x < rgb.width(); ++x)
            few.setPixel(x, y, places[rgb.pixel(x, y) | 0xff000000U]);
    return few;
}

} // namespace facetmill::test
