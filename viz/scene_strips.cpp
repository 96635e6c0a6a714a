// Regions of the surface in a scene: bands, boundary curves, labels.
#include "viz/poly_data.h"
#include "viz/scene_impl.h"

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
constexpr double label_line = 16, label_room = 6;

} // namespace

void Scene::set_strips(StripDisplayPtr strips) {
    // The arrays stay until the actors have others.
    const StripDisplayPtr old = std::exchange(impl_->strips, std::move(strips));
    static const StripDisplay none;
    const StripDisplay& s = impl_->strips ? *impl_->strips : none;
    const auto fit = [&](std::vector<std::unique_ptr<SceneActor>>& actors, auto&& look) {
        while (actors.size() > s.strips.size()) {
            impl_->renderer->RemoveActor(actors.back()->actor);
            actors.pop_back();
        }
        while (actors.size() < s.strips.size()) {
            actors.push_back(std::make_unique<SceneActor>());
            SceneActor& a = *actors.back();
            a.actor->GetProperty()->LightingOff();
            look(a);
            impl_->renderer->AddActor(a.actor);
        }
    };
    // A hair above the surface, and the lines a hair above the bands.
    fit(impl_->strip_bands,
        [](SceneActor& a) { a.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -34); });
    fit(impl_->strip_lines,
        [](SceneActor& a) { a.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -46); });
    fit(impl_->strip_handles, [](SceneActor& a) {
        a.mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-52);
        a.actor->GetProperty()->SetRenderPointsAsSpheres(true);
    });
    for (std::size_t i = 0; i < s.strips.size(); ++i) {
        const StripDisplay::One& one = s.strips[i];
        impl_->strip_handles[i]->set_data(dot_data(one.handles), s.center);
        impl_->strip_bands[i]->set_data(triangle_data(one.points, {}, one.triangles), s.center);
        impl_->strip_lines[i]->set_data(segment_data(one.line_points, one.segments), s.center);
    }
    impl_->color_strips();
    impl_->apply_line_widths();
    impl_->apply_visibility();
}

void Scene::set_strip_chosen(std::optional<std::size_t> strip) {
    impl_->chosen_strip = strip;
    impl_->color_strips();
    impl_->apply_line_widths();
}

void Scene::set_covered(const Vec2& from, const Vec2& to) {
    impl_->covered = {from.x(), from.y(), to.x(), to.y()};
}

void Scene::set_strip_handles(bool on) {
    impl_->handles_on = on;
    impl_->apply_visibility();
}

std::optional<Vec3> Scene::pick_strip_handle(double x, double y, double radius) const {
    if (!impl_->handles_on || !impl_->shows_strips()) return std::nullopt;
    std::optional<Vec3> nearest;
    double least = radius;
    const Vec3 toward = impl_->camera_frame().row(2).transpose();
    for (const StripDisplay::One& one : impl_->strips->strips)
        for (std::size_t i = 0; i + 2 < one.handles.size(); i += 3) {
            const Vec3 p =
                impl_->strips->center
                + Vec3(double(one.handles[i]), double(one.handles[i + 1]), double(one.handles[i + 2]));
            const double away = (display_of(p) - Vec2(x, y)).norm();
            if (away > least) continue;
            // Behind the part it cannot be taken hold of.
            if (impl_->part) {
                const double back = 2 * impl_->part->box.diagonal() + (impl_->part->box.center() - p).norm();
                const SightHit hit =
                    impl_->part->sights.first(*impl_->part->mesh, p + back * toward, -toward);
                if (hit.distance < back - 2 * impl_->pixel_size() - 1e-3 * impl_->part->box.diagonal())
                    continue;
            }
            least = away;
            nearest = p;
        }
    return nearest;
}

void Scene::Impl::color_strips() {
    for (std::size_t i = 0; i < strip_bands.size(); ++i) {
        const StripDisplay::One& one = strips->strips[i];
        const Rgb c = strip_color(one.color, one.enabled, palette);
        for (SceneActor* a : {strip_bands[i].get(), strip_lines[i].get(), strip_handles[i].get()})
            a->actor->GetProperty()->SetColor(c.r, c.g, c.b);
        const double opacity = one.enabled ? band_opacity : off_opacity;
        strip_bands[i]->actor->GetProperty()->SetOpacity(chosen_strip == i ? opacity + 0.2 : opacity);
    }
}

bool Scene::Impl::shows_strips() const {
    return strips && !strips->strips.empty() && layer_on[std::size_t(Layer::strips)];
}

void Scene::Impl::add_strip_legend(std::vector<LegendEntry>& entries) const {
    if (!shows_strips()) return;
    using Sample = LegendEntry::Sample;
    const std::size_t n = strips->strips.size(), shown = n > max_entries ? max_entries - 1 : n;
    for (std::size_t i = 0; i < shown; ++i) {
        const StripDisplay::One& one = strips->strips[i];
        entries.push_back({Sample::surface, strip_color(one.color, one.enabled, palette), 1,
                           one.enabled ? one.name : one.name + " (off)"});
    }
    if (shown < n)
        entries.push_back({Sample::surface, strip_color(shown, true, palette), 1,
                           std::to_string(n - shown) + " more regions"});
}

std::vector<OverlayNote> Scene::Impl::strip_notes(const OverlayLayout& layout) const {
    std::vector<OverlayNote> notes;
    if (!shows_strips()) return notes;
    const auto& all = strips->strips;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    // The chosen one first, then the larger ones: they keep their labels where there is no room for all.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if ((chosen_strip == a) != (chosen_strip == b)) return chosen_strip == a;
        return all[a].area > all[b].area;
    });
    const Vec2 picture = window_size().cast<double>() / ratio;
    std::vector<LayoutRect> taken;
    for (const LayoutRect& r : {layout.title, layout.legend, layout.scale, layout.axes, covered})
        if (!r.empty()) taken.push_back(r);
    const auto free = [&](const LayoutRect& r) {
        return r.x0 >= label_room && r.x1 <= picture.x() - label_room && r.y0 >= 0 && r.y1 <= picture.y()
               && std::none_of(taken.begin(), taken.end(), [&](const LayoutRect& t) {
                      return r.x0 < t.x1 + label_room && t.x0 < r.x1 + label_room && r.y0 < t.y1 + label_room
                             && t.y0 < r.y1 + label_room;
                  });
    };
    /// About a place, or beside what stands there, as long as the place is below or above it.
    const auto room_at = [&](const Vec2& at, double width, double height) -> std::optional<LayoutRect> {
        std::vector<double> middles{at.x(), label_room + width / 2, picture.x() - label_room - width / 2};
        for (const LayoutRect& t : taken) {
            middles.push_back(t.x0 - 1.01 * label_room - width / 2);
            middles.push_back(t.x1 + 1.01 * label_room + width / 2);
        }
        std::stable_sort(middles.begin(), middles.end(),
                         [&](double a, double b) { return std::abs(a - at.x()) < std::abs(b - at.x()); });
        for (const double x : middles) {
            if (std::abs(x - at.x()) > width / 2) break;
            const LayoutRect r{x - width / 2, at.y() - height / 2, x + width / 2, at.y() + height / 2};
            if (free(r)) return r;
        }
        return std::nullopt;
    };
    std::size_t labels = 0;
    for (const std::size_t i : order) {
        if (labels == max_labels) break;
        const StripDisplay::One& one = all[i];
        const Vec2 at = display_of(one.label_at) / ratio;
        if (!at.allFinite()) continue;
        const double name = overlay->note_width(one.name, true),
                     wide = std::max(name, overlay->note_width(one.detail, false));
        // Where there is no room for both lines the name alone.
        bool both = true;
        std::optional<LayoutRect> r = room_at(at, wide, 2 * label_line);
        if (!r) {
            both = false;
            r = room_at(at, name, label_line);
        }
        if (!r) continue;
        ++labels;
        taken.push_back(*r);
        const double x = 0.5 * (r->x0 + r->x1), y = both ? at.y() - 0.5 * label_line : at.y();
        notes.push_back({Vec2(x, y), 0, one.name, true, true});
        if (both) notes.push_back({Vec2(x, y + label_line), 0, one.detail, false, true});
    }
    return notes;
}

} // namespace facetmill
