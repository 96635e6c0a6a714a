#include "viz/cspace_labels.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

bool same(const ChosenPosture& a, const ChosenPosture& b) {
    return a.free && b.free && std::abs(a.posture.lead - b.posture.lead) < 1e-6
           && std::abs(a.posture.yaw - b.posture.yaw) < 1e-6
           && std::abs(a.posture.delta - b.posture.delta) < 1e-6;
}

} // namespace

std::vector<LegendEntry> cspace_legend(const CSpaceContent& content, Palette palette) {
    std::vector<LegendEntry> entries;
    using Sample = LegendEntry::Sample;
    const auto has = [&](PostureBlock b) {
        return std::find(content.block.begin(), content.block.end(), b) != content.block.end();
    };
    entries.push_back({Sample::box, cspace_top_color(), 1, "Highest lift that clears the strip"});
    if (has(PostureBlock::free))
        entries.push_back({Sample::box, posture_block_color(PostureBlock::free), 1, "Free volume"});
    entries.push_back({Sample::line, colors_of(palette).feature_edges, 1, "Lowest free lift, stopped by:"});
    for (std::size_t b = 0; b < posture_blocks; ++b)
        if (has(PostureBlock(b)))
            entries.push_back({Sample::surface, posture_block_color(PostureBlock(b)), 1,
                               posture_block_label(PostureBlock(b))});
    for (std::size_t k = 0; k < cspace_choices; ++k) {
        bool merged = false;
        for (std::size_t l = 0; l < k; ++l)
            merged = merged || same(content.choices[l], content.choices[k]);
        if (content.choices[k].free && !merged)
            entries.push_back(
                {Sample::spot, cspace_choice_color(k), 1, std::string("Chosen: ") + cspace_choice_label(k)});
    }
    return entries;
}

std::vector<CSpaceMarker> cspace_markers(const CSpaceContent& content,
                                         const std::function<Vec2(const PostureValue&)>& shown) {
    std::vector<CSpaceMarker> markers;
    std::array<bool, cspace_choices> done{};
    for (std::size_t k = 0; k < cspace_choices; ++k) {
        const ChosenPosture& choice = content.choices[k];
        if (!choice.free || done[k]) continue;
        std::string name = cspace_choice_label(k);
        for (std::size_t l = k + 1; l < cspace_choices; ++l)
            if (same(choice, content.choices[l])) {
                done[l] = true;
                name += std::string(", ") + cspace_choice_label(l);
            }
        markers.push_back({shown(choice.posture), cspace_choice_color(k), std::move(name)});
    }
    return markers;
}

void add_markers(OverlayContent& content, std::vector<CSpaceMarker> markers,
                 const std::function<double(const std::string&)>& name_width) {
    for (const CSpaceMarker& m : markers)
        content.spots.push_back({m.at, m.color});
    // From the upper one on.
    std::sort(markers.begin(), markers.end(),
              [](const CSpaceMarker& a, const CSpaceMarker& b) { return a.at.y() < b.at.y(); });
    constexpr double margin = 10, half = 8, line = 2 * half + 1, beside = 13;
    std::vector<LayoutRect> taken;
    for (const auto& spot : content.spots)
        taken.push_back({spot.at.x() - 7, spot.at.y() - 7, spot.at.x() + 7, spot.at.y() + 7});
    const double width = content.width / content.ratio;
    for (const CSpaceMarker& m : markers) {
        const double w = name_width(m.name);
        const double right = m.at.x() + beside, left = m.at.x() - beside - w;
        Vec2 place(right + w > width - margin ? std::max(4.0, left) : right, m.at.y());
        const auto free = [&](double x, double y) {
            if (x < 4 || x + w > width - margin) return false;
            return std::none_of(taken.begin(), taken.end(), [&](const LayoutRect& r) {
                return x < r.x1 && x + w > r.x0 && y - half < r.y1 && y + half > r.y0;
            });
        };
        const auto find = [&] {
            for (const double down : {0.0, line, -line, 2 * line, -2 * line, 3 * line})
                for (const double x : {right, left})
                    if (free(x, m.at.y() + down)) {
                        place = {x, m.at.y() + down};
                        return;
                    }
        };
        find();
        taken.push_back({place.x() - 3, place.y() - half, place.x() + w + 3, place.y() + half});
        content.notes.push_back({place, -1, m.name, true, true});
    }
}

} // namespace facetmill
