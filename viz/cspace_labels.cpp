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

constexpr double note_half = 8; ///< of a note's height

constexpr double line_spare = 3; ///< of a note's line, above and below its letters, pixels
constexpr double note_gap = 5;   ///< between two notes side by side, pixels

bool covers(const LayoutRect& a, const LayoutRect& b) {
    return a.x0 < b.x1 && a.x1 > b.x0 && a.y0 < b.y1 && a.y1 > b.y0;
}

LayoutRect note_rect(const OverlayNote& n, const std::function<double(const std::string&)>& width) {
    const double w = width(n.text), x = n.at.x() - (n.end < 0 ? 0 : n.end > 0 ? w : w / 2);
    const double aside = n.framed ? 3 : 0;
    return {x - aside, n.at.y() - note_half, x + w + aside, n.at.y() + note_half};
}

LayoutRect spot_rect(const OverlaySpot& spot) {
    return {spot.at.x() - 7, spot.at.y() - 7, spot.at.x() + 7, spot.at.y() + 7};
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
    const bool stopped = std::any_of(content.block.begin(), content.block.end(),
                                     [](PostureBlock b) { return b != PostureBlock::free; });
    entries.push_back({Sample::line, colors_of(palette).feature_edges, 1,
                       stopped ? "Lowest free lift, stopped by:" : "Lowest free lift"});
    for (std::size_t b = 0; b < posture_blocks; ++b)
        if (has(PostureBlock(b)))
            entries.push_back({Sample::surface, posture_block_color(PostureBlock(b)), 1,
                               posture_block_label(PostureBlock(b))});
    for (const CSpaceMarker& marker : cspace_markers(content, [](const PostureValue&) { return Vec2(0, 0); }))
        entries.push_back({Sample::spot, marker.color, 1, "Chosen: " + marker.name});
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
    constexpr double margin = 10, half = note_half, line = 2 * half + 1, beside = 13;
    std::vector<LayoutRect> taken;
    for (const auto& spot : content.spots)
        taken.push_back(spot_rect(spot));
    std::vector<LayoutRect> written;
    for (const OverlayNote& n : content.notes)
        written.push_back(note_rect(n, name_width));
    const double width = content.width / content.ratio;
    for (const CSpaceMarker& m : markers) {
        if (m.name.empty()) continue;
        const double w = name_width(m.name);
        const double right = m.at.x() + beside, left = m.at.x() - beside - w;
        Vec2 place(right + w > width - margin ? std::max(4.0, left) : right, m.at.y());
        const auto panel = [&](const Vec2& at) {
            return LayoutRect{at.x() - 3, at.y() - half, at.x() + w + 3, at.y() + half};
        };
        const auto free = [&](const std::vector<LayoutRect>& of, const Vec2& at) {
            return std::none_of(of.begin(), of.end(),
                                [&](const LayoutRect& r) { return covers(panel(at), r); });
        };
        const auto find = [&](bool beside_numbers) {
            for (const double down : {0.0, line, -line, 2 * line, -2 * line, 3 * line})
                for (const double x : {right, left}) {
                    const Vec2 at(x, m.at.y() + down);
                    if (x < 4 || x + w > width - margin || !free(taken, at)) continue;
                    if (beside_numbers && !free(written, at)) continue;
                    place = at;
                    return true;
                }
            return false;
        };
        if (!find(true)) (void)find(false);
        taken.push_back(panel(place));
        content.notes.push_back({place, -1, m.name, true, true});
    }
}

void leave_out_covered(OverlayContent& content, const std::function<double(const std::string&)>& name_width) {
    std::vector<LayoutRect> over;
    for (const OverlaySpot& spot : content.spots)
        over.push_back(spot_rect(spot));
    for (const OverlayNote& n : content.notes)
        if (n.framed) over.push_back(note_rect(n, name_width));
    std::erase_if(content.notes, [&](const OverlayNote& n) {
        const LayoutRect own = note_rect(n, name_width);
        return !n.framed
               && std::any_of(over.begin(), over.end(), [&](const LayoutRect& r) { return covers(r, own); });
    });
}

bool lies_on_another(const OverlayContent& content, const OverlayNote& note,
                     const std::function<double(const std::string&)>& name_width) {
    // Letters are lower than the line that they stand in; from one note to the next there is a gap.
    LayoutRect own = note_rect(note, name_width);
    own.y0 += line_spare;
    own.y1 -= line_spare;
    own.x0 -= note_gap;
    own.x1 += note_gap;
    return std::ranges::any_of(content.notes,
                               [&](const OverlayNote& n) { return covers(own, note_rect(n, name_width)); });
}

} // namespace facetmill
