#include "viz/preview_display.h"

#include "viz/dasher.h"

#include <algorithm>

namespace facetmill {

namespace {

/// A period of the dashes, as a share of the lines' box; where lines are long there are at most so many.
constexpr double period_share = 1.0 / 110, max_dashes = 60'000;

} // namespace

PreviewDisplayPtr prepare_preview_display(const PassPreview& preview, const Progress& progress) {
    auto display = std::make_shared<PreviewDisplay>();
    Box3 box;
    for (const auto& line : preview.lines)
        for (const Vec3& p : line)
            box.add(p);
    if (box.empty()) return display;
    display->center = box.center();
    Dasher dasher(display->dashes, display->center,
                  std::max(period_share * box.diagonal(), preview.length() / max_dashes));
    for (const auto& line : preview.lines) {
        progress.check();
        dasher.restart();
        for (std::size_t i = 1; i < line.size(); ++i)
            dasher.add(line[i - 1], line[i]);
    }
    return display;
}

} // namespace facetmill
