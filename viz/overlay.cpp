#include "viz/overlay.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr double margin = 12, padding = 9, row = 18, sample_width = 26, gap = 8;
constexpr double title_size = 15, text_size = 12;
constexpr double min_bar = 56, largest_bar = 150;
constexpr double scale_gap = 9; // between two scales of the legend

} // namespace

double axes_side(double width, double height) {
    const double side = std::min({96.0, 0.3 * width, 0.3 * height});
    return side >= 44 ? std::floor(side) : 0.0;
}

double round_length(double longest_mm, LengthUnit unit) {
    const double longest = longest_mm / mm_per(unit);
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    double best = power;
    for (const double step : {2.0, 5.0, 10.0})
        if (step * power <= longest * (1.0 + 1e-12)) best = step * power;
    return best * mm_per(unit);
}

OverlayLayout Overlay::layout(const OverlayContent& content) {
    return lay_out(content, false);
}

void Overlay::update(const OverlayContent& content) {
    canvas_.begin();
    lay_out(content, true);
    canvas_.end();
}

OverlayLayout Overlay::lay_out(const OverlayContent& content, bool draw) {
    canvas_.set_size(content.width, content.height, content.ratio);
    OverlayLayout layout;
    layout.covered = content.covered;
    lay_out_legend(content, draw, layout);
    lay_out_title(content, draw, layout);
    lay_out_axes(content, draw, layout);
    lay_out_scale(content, draw, layout);
    if (draw) {
        draw_marker(content);
        draw_notes(content);
        draw_empty_text(content);
    }
    return layout;
}

void Overlay::draw_marker(const OverlayContent& content) {
    if (!content.marker || !content.marker->allFinite()) return;
    const Colors& colors = colors_of(content.palette);
    const Vec2 at = *content.marker, end = at + 34 * content.marker_normal;
    if (content.marker_normal.norm() > 0.3) {
        canvas_.stroke(at, end, 4.5, colors.marker_ring);
        canvas_.stroke(at, end, 2.2, colors.marker);
    }
    canvas_.disc(at.x(), at.y(), 6.5, colors.marker_ring);
    canvas_.disc(at.x(), at.y(), 4.8, colors.marker);
}

void Overlay::draw_notes(const OverlayContent& content) {
    const Colors& colors = colors_of(content.palette);
    for (const OverlaySpot& s : content.spots) {
        if (!s.at.allFinite()) continue;
        canvas_.disc(s.at.x(), s.at.y(), 6.8, colors.text);
        canvas_.disc(s.at.x(), s.at.y(), 5.9, colors.marker_ring);
        canvas_.disc(s.at.x(), s.at.y(), 4.6, s.color);
    }
    for (const OverlayNote& n : content.notes) {
        if (!n.at.allFinite()) continue;
        if (n.framed) {
            const double w = canvas_.text_width(n.text, text_size, n.bold);
            const double x = n.end < 0 ? n.at.x() : n.end > 0 ? n.at.x() - w : n.at.x() - w / 2;
            canvas_.rectangle(x - 3, n.at.y() - 8, x + w + 3, n.at.y() + 8, colors.panel, 0.85);
        }
        canvas_.write({n.at.x(), n.at.y(),
                       n.end < 0   ? OverlayText::Align::left
                       : n.end > 0 ? OverlayText::Align::right
                                   : OverlayText::Align::center,
                       n.text, text_size, n.bold, colors.text});
    }
}

double Overlay::note_width(const std::string& text, bool bold) {
    return canvas_.text_width(text, text_size, bold);
}

void Overlay::draw_empty_text(const OverlayContent& content) {
    const double width = canvas_.width(), height = canvas_.height(), room = width - 2 * margin;
    std::vector<std::string> lines(1);
    for (std::size_t begin = 0; begin < content.empty_text.size();) {
        const std::size_t end = std::min(content.empty_text.find(' ', begin), content.empty_text.size());
        const std::string word = content.empty_text.substr(begin, end - begin);
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || canvas_.text_width(longer, title_size, false) <= room)
            lines.back() = longer;
        else
            lines.push_back(word);
        begin = end + 1;
    }
    const double line_height = 1.5 * title_size;
    double y = height / 2 - line_height * double(lines.size() - 1) / 2;
    if (y < title_size) return;
    for (const std::string& line : lines) {
        canvas_.write({width / 2, y, OverlayText::Align::center,
                       canvas_.shortened(line, room, title_size, false), title_size, false,
                       colors_of(content.palette).faint_text});
        y += line_height;
    }
}

void Overlay::lay_out_title(const OverlayContent& content, bool draw, OverlayLayout& layout) {
    const double width = canvas_.width(), height = canvas_.height();
    const double right = layout.legend.empty() ? width - margin : layout.legend.x0 - 2 * gap;
    const double room = right - margin;
    if (height < 150 || room < 100) return;
    const Colors& colors = colors_of(content.palette);
    double y = margin;
    const auto add = [&](const std::string& text, double size, bool bold, const Rgb& color) {
        const std::string fitted = text.empty() ? text : canvas_.shortened(text, room, size, bold);
        if (fitted.empty()) return;
        if (draw)
            canvas_.write({margin, y + 0.5 * size, OverlayText::Align::left, fitted, size, bold, color});
        const double w = canvas_.text_width(fitted, size, bold);
        layout.title = {margin, margin, std::max(layout.title.x1, margin + w), y + size};
        y += size + 7;
    };
    add(content.title, title_size, true, colors.text);
    add(content.subtitle, text_size, false, colors.faint_text);
}

void Overlay::lay_out_legend(const OverlayContent& content, bool draw, OverlayLayout& layout) {
    if (content.legend.empty() && content.color_bars.empty()) return;
    const double width = canvas_.width(), height = canvas_.height() - content.covered_below;
    // Below, the workbench has its cube, above what it has along the lower edge.
    const double widest = 0.45 * width, highest = std::min(0.6 * height, height - 170);
    const auto entries_width = [&] {
        double label = 0;
        for (const LegendEntry& e : content.legend)
            label = std::max(label, canvas_.text_width(e.label, text_size, false));
        return std::ceil(2 * padding + sample_width + gap + label);
    };
    // As many scales as there is room for. The rest: all of their height that cannot shrink.
    std::vector<double> bar_rests;
    double bar_width = 0, bar_rest = 0;
    const double frame = 2 * (padding - 3), entries_height = row * double(content.legend.size());
    for (const ColorBar& bar : content.color_bars) {
        double label = std::max(canvas_.text_width(bar.low_text, text_size, false),
                                canvas_.text_width(bar.high_text, text_size, false));
        for (const auto& [at, text] : bar.marks)
            label = std::max(label, canvas_.text_width(text, text_size, false));
        const double flat = std::max(
            {canvas_.text_width(bar.title, text_size, true), canvas_.text_width(bar.note, text_size, false),
             bar.other ? sample_width + gap + canvas_.text_width(bar.other->second, text_size, false) : 0.0});
        const double wide =
            std::max(bar_width, std::ceil(2 * padding + std::max(sample_width + gap + label, flat)));
        const double rest = (bar_rests.empty() ? 0 : scale_gap)
                            + row * (3 + (bar.note.empty() ? 0 : 1) + (bar.other ? 1 : 0));
        if (wide > widest || frame + bar_rest + rest + min_bar * double(bar_rests.size() + 1) > highest)
            break;
        bar_width = wide;
        bar_rest += rest;
        bar_rests.push_back(rest);
    }
    // A small window has room for the scales, or for the entries, or for neither.
    const bool bar = !bar_rests.empty();
    const double min_bars = min_bar * double(bar_rests.size());
    double w = bar ? bar_width : 0, h = frame;
    bool entries = !content.legend.empty();
    std::size_t shown = content.legend.size(); // beside a scale as many as there is room for
    if (entries) {
        const double wide = std::max(w, entries_width());
        const double high = frame + entries_height + (bar ? bar_rest + min_bars : 0);
        entries = wide <= widest && (bar || high <= 0.55 * height);
        if (entries && high > highest && bar) {
            shown = std::size_t(std::max(0.0, (highest - high + entries_height) / row));
            entries = shown > 0;
        }
        if (entries) {
            w = wide;
            h += row * double(shown);
        }
    }
    if (!bar && !entries) return;
    double bar_height = 0;
    if (bar) {
        const double count = double(bar_rests.size());
        bar_height = std::clamp((highest - h - bar_rest) / count, min_bar, largest_bar);
        h += bar_rest + count * bar_height;
    }
    const LayoutRect r{width - margin - w, margin, width - margin, margin + h};
    layout.legend = r;
    if (!draw) return;
    const Colors& colors = colors_of(content.palette);
    canvas_.rectangle(r.x0, r.y0, r.x1, r.y1, colors.panel_border, 0.9);
    canvas_.rectangle(r.x0 + 1, r.y0 + 1, r.x1 - 1, r.y1 - 1, colors.panel);
    double y = r.y0 + padding - 3;
    if (entries)
        for (std::size_t i = 0; i < shown; ++i) {
            draw_legend_entry(content.legend[i], r.x0 + padding, y + row / 2, colors);
            y += row;
        }
    for (std::size_t i = 0; i < bar_rests.size(); ++i) {
        const double below = y + bar_rests[i] + bar_height;
        draw_color_bar(content.color_bars[i],
                       {r.x0 + padding, y + (i > 0 ? scale_gap : 0), r.x1 - padding, below}, colors);
        y = below;
    }
}

void Overlay::draw_legend_entry(const LegendEntry& e, double x0, double y, const Colors& colors) {
    const double x1 = x0 + sample_width;
    const double half = std::max(1.0, 0.75 * e.width);
    switch (e.sample) {
    case LegendEntry::Sample::line:
        canvas_.rectangle(x0, y - half, x1, y + half, e.color);
        break;
    case LegendEntry::Sample::dashes:
        for (int i = 0; i < 3; ++i) // as on the part: 3/5 drawn, 2/5 left out
            canvas_.rectangle(x0 + 10.0 * i, y - half, x0 + 10.0 * i + 6.0, y + half, e.color);
        break;
    case LegendEntry::Sample::dot:
        for (int i = 0; i < 3; ++i)
            canvas_.disc(x0 + sample_width * (0.5 + i) / 3.0, y, 2.0, e.color);
        break;
    case LegendEntry::Sample::spot:
        canvas_.disc(x0 + sample_width / 2, y, 4.5, e.color);
        break;
    case LegendEntry::Sample::box:
        canvas_.rectangle(x0, y - 6, x1, y + 6, e.color);
        canvas_.rectangle(x0 + 1, y - 5, x1 - 1, y + 5, colors.panel);
        canvas_.rectangle(x0 + 1, y - 5, x1 - 1, y + 5, e.color, 0.2);
        break;
    case LegendEntry::Sample::surface:
        canvas_.rectangle(x0, y - 6, x1, y + 6, e.color);
        break;
    case LegendEntry::Sample::none: // goes on from the entry above
        break;
    }
    canvas_.write({x1 + gap, y, OverlayText::Align::left, e.label, text_size, false, colors.text});
}

void Overlay::draw_color_bar(const ColorBar& bar, const LayoutRect& in, const Colors& colors) {
    const double x0 = in.x0, x1 = x0 + sample_width, text_x = x1 + gap;
    double y = in.y0;
    const auto line = [&](const std::string& text, bool bold, const Rgb& color) {
        canvas_.write({x0, y + row / 2, OverlayText::Align::left, text, text_size, bold, color});
        y += row;
    };
    line(bar.title, true, colors.text);
    if (!bar.note.empty()) line(bar.note, false, colors.faint_text);
    // The ends' meanings stand beside the arrows, which say that there is more than the scale shows.
    double bottom = in.y1 - (bar.other ? row : 0);
    const auto end = [&](double tip, double base, bool arrow, const Rgb& color, const std::string& text) {
        if (arrow) canvas_.polygon({{x0, base}, {(x0 + x1) / 2, tip}, {x1, base}}, color, 1.0);
        canvas_.write({text_x, (2 * tip + base) / 3, OverlayText::Align::left, text, text_size, false,
                       colors.faint_text});
    };
    const double top = y + row;
    bottom -= row;
    end(y + 5, top - 1, bar.has_above, bar.above, bar.high_text);
    end(bottom + row - 5, bottom + 1, bar.has_below, bar.below, bar.low_text);
    const double high = bottom - top, step = high / double(bar.colors.size());
    for (std::size_t i = 0; i < bar.colors.size(); ++i)
        canvas_.rectangle(x0, bottom - step * double(i + 1), x1, bottom - step * double(i), bar.colors[i]);
    // Texts keep clear of each other and of those at the ends.
    double lowest = bottom + 1;
    for (const auto& [at, text] : bar.marks) {
        const double place = bottom - at * high;
        canvas_.rectangle(x1, place - 0.5, x1 + 4, place + 0.5, colors.text);
        const double text_y = std::clamp(place, top + text_size / 2 - 2, bottom - text_size / 2 + 2);
        if (text_y > lowest - text_size && lowest <= bottom) continue;
        canvas_.write({text_x, text_y, OverlayText::Align::left, text, text_size, false, colors.text});
        lowest = text_y;
    }
    if (bar.other) {
        const double other_y = in.y1 - row / 2;
        canvas_.rectangle(x0, other_y - 6, x1, other_y + 6, bar.other->first);
        canvas_.write(
            {text_x, other_y, OverlayText::Align::left, bar.other->second, text_size, false, colors.text});
    }
}

void Overlay::lay_out_axes(const OverlayContent& content, bool draw, OverlayLayout& layout) {
    if (!content.axes) return;
    const double width = canvas_.width(), height = canvas_.height() - content.covered_below;
    const double side = axes_side(width, height);
    if (side <= 0) return;
    layout.axes = {margin / 2, height - margin / 2 - side, margin / 2 + side, height - margin / 2};
    if (!draw) return;
    const Colors& colors = colors_of(content.palette);
    const double x = (layout.axes.x0 + layout.axes.x1) / 2, y = (layout.axes.y0 + layout.axes.y1) / 2;
    const char* names[3] = {"X", "Y", "Z"};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& d = content.axis_directions[k];
        const double flat = std::hypot(d.x(), d.y());
        if (flat < 0.2) continue; // points at the eye or away: the name would cover the arrow
        // Beyond the arrow's tip, never so near the middle that names meet.
        const double reach = side * (0.33 * flat + 0.09);
        canvas_.write({x + d.x() / flat * reach, y - d.y() / flat * reach, OverlayText::Align::center,
                       names[k], std::max(10.0, 0.14 * side), true, colors.axes[k]});
    }
}

void Overlay::lay_out_scale(const OverlayContent& content, bool draw, OverlayLayout& layout) {
    if (!content.scale || !(content.mm_per_pixel > 0) || !std::isfinite(content.mm_per_pixel)) return;
    const double width = canvas_.width(), height = canvas_.height() - content.covered_below;
    const double left = layout.axes.empty() ? margin : layout.axes.x1 + gap;
    const double longest = std::min({150.0, 0.35 * width, width - margin - left});
    if (width < 200 || height < 56) return;
    const double length_mm = round_length(longest * content.mm_per_pixel, content.unit);
    const double length = length_mm / content.mm_per_pixel;
    const std::string label =
        format_number(length_mm / mm_per(content.unit)) + " " + std::string(unit_name(content.unit));
    const double label_width = canvas_.text_width(label, text_size, false);
    if (std::max(length, label_width) > width - margin - left) return;
    const double x1 = width - margin, y1 = height - margin, x0 = x1 - length;
    // Room for the longest bar there can be: what is fitted around it must not depend on the zoom before.
    layout.scale = {x1 - longest, y1 - 8 - text_size - 4, x1, y1};
    if (!draw) return;
    const Colors& colors = colors_of(content.palette);
    canvas_.rectangle(x0, y1 - 2, x1, y1, colors.text);
    canvas_.rectangle(x0, y1 - 8, x0 + 2, y1, colors.text);
    canvas_.rectangle(x1 - 2, y1 - 8, x1, y1, colors.text);
    canvas_.write({std::min((x0 + x1) / 2, x1 - label_width / 2), y1 - 8 - text_size / 2,
                   OverlayText::Align::center, label, text_size, false, colors.text});
}

} // namespace facetmill
