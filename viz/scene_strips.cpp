#include "viz/scene_strips.h"

#include "viz/poly_data.h"
#include "viz/scene_part.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace facetmill {

namespace {

constexpr double band_opacity = 0.45, off_opacity = 0.22;
/// Regions with a line of their own in the legend, and with a label.
constexpr std::size_t max_entries = 10, max_labels = 10;
/// Layout pixels: between two lines of a label, and around it.
constexpr double label_line = 16, label_gap = 6;

/// What of the window is free for labels.
class FreePlaces {
public:
    FreePlaces(const Vec2& window, std::initializer_list<LayoutRect> taken) : window_(window) {
        for (const LayoutRect& r : taken)
            if (!r.empty()) taken_.push_back(r);
    }

    void take(const LayoutRect& r) { taken_.push_back(r); }
    /// About a place, or beside what stands there, as long as the place is below or above it.
    std::optional<LayoutRect> find(const Vec2& at, double width, double height) const {
        std::vector<double> middles{at.x(), label_gap + width / 2, window_.x() - label_gap - width / 2};
        for (const LayoutRect& t : taken_) {
            middles.push_back(t.x0 - 1.01 * label_gap - width / 2);
            middles.push_back(t.x1 + 1.01 * label_gap + width / 2);
        }
        std::stable_sort(middles.begin(), middles.end(),
                         [&](double a, double b) { return std::abs(a - at.x()) < std::abs(b - at.x()); });
        for (const double x : middles) {
            if (std::abs(x - at.x()) > width / 2) break;
            const LayoutRect r{x - width / 2, at.y() - height / 2, x + width / 2, at.y() + height / 2};
            if (free(r)) return r;
        }
        return std::nullopt;
    }

private:
    bool free(const LayoutRect& r) const {
        return r.x0 >= label_gap && r.x1 <= window_.x() - label_gap && r.y0 >= 0 && r.y1 <= window_.y()
               && std::none_of(taken_.begin(), taken_.end(), [&](const LayoutRect& t) {
                      return r.x0 < t.x1 + label_gap && t.x0 < r.x1 + label_gap && r.y0 < t.y1 + label_gap
                             && t.y0 < r.y1 + label_gap;
                  });
    }

    Vec2 window_;
    std::vector<LayoutRect> taken_;
};

} // namespace

SceneStrips::SceneStrips(SceneStage& stage, const ScenePart& part) : SceneLayer(stage), part_(part) {}

template <class Look>
void SceneStrips::fit(SceneActors& actors, std::size_t count, const Look& look) {
    while (actors.size() > count) {
        stage_.renderer->RemoveActor(actors.back()->actor);
        actors.pop_back();
    }
    while (actors.size() < count) {
        actors.push_back(std::make_unique<SceneActor>());
        actors.back()->unlit();
        look(*actors.back());
        add_actor(*actors.back());
    }
}

void SceneStrips::set(StripDisplayPtr strips) {
    // The arrays stay until the actors have others.
    const StripDisplayPtr old = std::exchange(strips_, std::move(strips));
    static const StripDisplay none;
    const StripDisplay& s = strips_ ? *strips_ : none;
    const std::size_t n = s.strips.size();
    // A hair above the surface, and the lines a hair above the bands.
    fit(bands_, n,
        [](SceneActor& a) { a.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -34); });
    fit(lines_, n,
        [](SceneActor& a) { a.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -46); });
    fit(handles_, n, [](SceneActor& a) {
        a.mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-52);
        a.property()->SetRenderPointsAsSpheres(true);
    });
    for (std::size_t i = 0; i < n; ++i) {
        const StripDisplay::One& one = s.strips[i];
        handles_[i]->set_data(dot_data(one.handles), s.center);
        bands_[i]->set_data(triangle_data(one.points, {}, one.triangles), s.center);
        lines_[i]->set_data(segment_data(one.line_points, one.segments), s.center);
    }
    apply_palette(colors_of(stage_.palette));
    apply_line_widths();
}

void SceneStrips::choose(std::optional<std::size_t> strip) {
    chosen_ = strip;
    apply_palette(colors_of(stage_.palette));
    apply_line_widths();
}

void SceneStrips::set_handles(bool on) {
    handles_on_ = on;
}

std::optional<Vec3> SceneStrips::pick_handle(double x, double y, double radius) const {
    if (!handles_on_ || !shown()) return std::nullopt;
    std::optional<Vec3> nearest;
    double least = radius;
    for (const StripDisplay::One& one : strips_->strips)
        for (std::size_t i = 0; i + 2 < one.handles.size(); i += 3) {
            const Vec3 p =
                strips_->center
                + Vec3(double(one.handles[i]), double(one.handles[i + 1]), double(one.handles[i + 2]));
            const double away = (stage_.camera.display_of(p) - Vec2(x, y)).norm();
            // Behind the part it cannot be taken hold of.
            if (away > least || part_.hides(p)) continue;
            least = away;
            nearest = p;
        }
    return nearest;
}

bool SceneStrips::shown() const {
    return has(Layer::strips) && stage_.on(Layer::strips);
}

bool SceneStrips::has(Layer layer) const {
    return layer == Layer::strips && strips_ && !strips_->strips.empty();
}

void SceneStrips::apply_palette(const Colors&) {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        const StripDisplay::One& one = strips_->strips[i];
        const Rgb c = strip_color(one.color, one.enabled, stage_.palette);
        for (SceneActor* a : {bands_[i].get(), lines_[i].get(), handles_[i].get()})
            a->color(c);
        const double opacity = one.enabled ? band_opacity : off_opacity;
        bands_[i]->property()->SetOpacity(chosen_ == i ? opacity + 0.2 : opacity);
    }
}

void SceneStrips::apply_line_widths() {
    for (std::size_t i = 0; i < lines_.size(); ++i)
        lines_[i]->set_line_width((chosen_ == i ? 3.4 : 2.0) * stage_.line_ratio());
    for (auto& a : handles_)
        a->set_point_size(8 * stage_.line_ratio());
}

void SceneStrips::apply_visibility(ShownSurface) {
    const bool on = stage_.on(Layer::strips);
    for (auto* actors : {&bands_, &lines_})
        for (auto& a : *actors)
            a->show(on);
    for (auto& a : handles_)
        a->show(on && handles_on_);
}

void SceneStrips::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (!shown()) return;
    using Sample = LegendEntry::Sample;
    const std::size_t n = strips_->strips.size(), listed = n > max_entries ? max_entries - 1 : n;
    for (std::size_t i = 0; i < listed; ++i) {
        const StripDisplay::One& one = strips_->strips[i];
        entries.push_back({Sample::surface, strip_color(one.color, one.enabled, stage_.palette), 1,
                           one.enabled ? one.name : one.name + " (off)"});
    }
    if (listed < n)
        entries.push_back({Sample::surface, strip_color(listed, true, stage_.palette), 1,
                           std::to_string(n - listed) + " more regions"});
}

std::vector<OverlayNote> SceneStrips::notes(Overlay& overlay, const OverlayLayout& layout) const {
    std::vector<OverlayNote> notes;
    if (!shown()) return notes;
    const auto& all = strips_->strips;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    // The chosen one first, then the larger ones: they keep their labels where there is no room for all.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if ((chosen_ == a) != (chosen_ == b)) return chosen_ == a;
        return all[a].area > all[b].area;
    });
    FreePlaces places(stage_.camera.window_size().cast<double>() / stage_.ratio,
                      {layout.title, layout.legend, layout.scale, layout.axes, layout.covered});
    std::size_t labels = 0;
    for (const std::size_t i : order) {
        if (labels == max_labels) break;
        const StripDisplay::One& one = all[i];
        const Vec2 at = stage_.camera.display_of(one.label_at) / stage_.ratio;
        if (!at.allFinite()) continue;
        const double name = overlay.note_width(one.name, true),
                     wide = std::max(name, overlay.note_width(one.detail, false));
        // Where there is no room for both lines the name alone.
        bool both = true;
        std::optional<LayoutRect> r = places.find(at, wide, 2 * label_line);
        if (!r) {
            both = false;
            r = places.find(at, name, label_line);
        }
        if (!r) continue;
        ++labels;
        places.take(*r);
        const double x = 0.5 * (r->x0 + r->x1), y = both ? at.y() - 0.5 * label_line : at.y();
        notes.push_back({Vec2(x, y), 0, one.name, true, true});
        if (both) notes.push_back({Vec2(x, y + label_line), 0, one.detail, false, true});
    }
    return notes;
}

} // namespace facetmill
