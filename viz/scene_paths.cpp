#include "viz/scene_paths.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"
#include "viz/scene_part.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill {

/// A point of a path near the pixel.
struct ScenePaths::Candidate {
    double pixels = 0, depth = 0; ///< distance on the screen; distance from the eye's plane, mm
    std::size_t source = 0;
    bool is_contact = false;
    std::size_t pass = 0, index = 0; ///< pass and CC, or motion
};

ScenePaths::ScenePaths(SceneStage& stage, const ScenePart& part) : SceneLayer(stage), part_(part) {
    on_.fill(true);
    const auto add = [&](SceneActor& a, double nearer) {
        add_actor(a);
        a.unlit();
        a.nearer(nearer);
    };
    add(contact_preview_, 40);
    add(contact_lines_, 40);
    add(contact_dots_, 48);
    add(left_dots_, 50);
    add(kept_dots_, 52);
    for (auto* lines : {&lines_, &preview_, &tint_lines_, &tint_preview_})
        for (auto& a : *lines)
            add(a, 44);
    for (SceneActor* dots : {&contact_dots_, &left_dots_, &kept_dots_})
        dots->property()->SetRenderPointsAsSpheres(true);
    // The previews look as what they stand for.
    contact_preview_.actor->SetProperty(contact_lines_.property());
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        preview_[k].actor->SetProperty(lines_[k].property());
        tint_preview_[k].actor->SetProperty(tint_lines_[k].property());
        tint_lines_[k].mapper->ScalarVisibilityOn();
        tint_preview_[k].mapper->ScalarVisibilityOn();
    }
}

void ScenePaths::set(PathDisplayPtr path) {
    set_tint(nullptr);
    const PathDisplayPtr old =
        std::exchange(path_, std::move(path)); // its arrays stay until there are others
    static const PathDisplay none;
    const PathDisplay& p = path_ ? *path_ : none;
    contact_lines_.set_data(polyline_data(p.contacts), p.center);
    contact_dots_.set_data(dot_data(p.contacts), p.center);
    contact_preview_.set_data(polyline_data(p.contacts_preview), p.center);
    left_dots_.set_data(dot_data(p.left_points), p.center);
    kept_dots_.set_data(dot_data(p.kept_points), p.center);
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        lines_[k].set_data(polyline_data(p.motions[k]), p.center);
        preview_[k].set_data(polyline_data(p.motions_preview[k]), p.center);
    }
}

void ScenePaths::set_tint(TintedPathPtr tint) {
    // The old arrays stay until the actors have the new ones.
    const TintedPathPtr old = std::exchange(tint_, std::move(tint));
    static const TintedPath none;
    const TintedPath& t = tint_ ? *tint_ : none;
    const auto set = [&](SceneActor& a, const TintedPath::Lines& lines) {
        if (lines.empty()) {
            a.clear();
            return;
        }
        const auto data = segment_data(lines.points, lines.segments);
        set_point_colors({data}, lines.rgba);
        a.set_data(data, t.center);
    };
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        set(tint_lines_[k], t.lines[k]);
        set(tint_preview_[k], t.preview[k]);
    }
}

void ScenePaths::set_visible(MotionKind kind, bool on) {
    on_[std::size_t(kind)] = on;
}

bool ScenePaths::visible(MotionKind kind) const {
    return on_[std::size_t(kind)];
}

std::optional<PathPick> ScenePaths::pick(double x, double y, double radius) const {
    if (!path_ || stage_.camera.pixel_size() <= 0) return std::nullopt;
    const std::vector<Candidate> near = candidates(x, y, radius);
    constexpr std::size_t tries = 8; // lines of sight cast: what else lies that near is hidden as well
    for (std::size_t i = 0; i < std::min(near.size(), tries); ++i) {
        const PathPick pick = pick_of(near[i]);
        if (!part_.covers() || !part_.hides(pick.position)) return pick;
    }
    return std::nullopt;
}

std::vector<ScenePaths::Candidate> ScenePaths::candidates(double x, double y, double radius) const {
    const Projection view = stage_.camera.projection();
    std::vector<Candidate> near;
    const auto consider = [&](const Vec3& p, Candidate c) {
        const double pixels = (view.pixel(p) - Vec2(x, y)).norm();
        if (!(pixels <= radius)) return;
        c.pixels = pixels;
        c.depth = view.depth(p);
        near.push_back(c);
    };
    for (std::size_t s = 0; s < path_->sources.size(); ++s) {
        const PathSource& source = path_->sources[s];
        if (stage_.on(Layer::cc) && source.contacts)
            for (std::size_t p = 0; p < source.contacts->passes.size(); ++p) {
                if (!source.shows(source.contacts->passes[p])) continue;
                const auto& cc = source.contacts->passes[p].cc;
                for (std::size_t i = 0; i < cc.size(); ++i)
                    consider(cc[i].point, {0, 0, s, true, p, i});
            }
        if (stage_.on(Layer::cl) && source.motions)
            for (std::size_t i = 0; i < source.motions->motions.size(); ++i)
                if (visible(source.motions->motions[i].kind) && source.shows_motion(i))
                    consider(source.motions->motions[i].to.tip, {0, 0, s, false, 0, i});
    }
    // Within two pixels counts as equally near; then the one before the others.
    std::sort(near.begin(), near.end(), [](const Candidate& a, const Candidate& b) {
        const double pa = std::floor(a.pixels / 2), pb = std::floor(b.pixels / 2);
        if (pa != pb) return pa < pb;
        if (a.depth != b.depth) return a.depth < b.depth;
        return a.pixels < b.pixels;
    });
    return near;
}

PathPick ScenePaths::pick_of(const Candidate& c) const {
    const PathSource& source = path_->sources[c.source];
    PathPick pick;
    pick.source = c.source;
    pick.is_contact = c.is_contact;
    if (c.is_contact) {
        const Pass& pass = source.contacts->passes[c.pass];
        pick.pass = Index(c.pass);
        pick.point = Index(c.index);
        pick.position = pass.cc[c.index].point;
        // A pass that was not lifted yet has contacts and no locations.
        pick.location =
            c.index < pass.cl.size() ? pass.cl[c.index] : CutterLocation{pick.position, Vec3(0, 0, 1)};
    } else {
        const Motion& motion = source.motions->motions[c.index];
        pick.motion = c.index;
        pick.pass = motion.pass;
        pick.point = motion.point;
        pick.position = motion.to.tip;
        pick.location = motion.to;
    }
    return pick;
}

bool ScenePaths::has(Layer layer) const {
    if (!path_) return false;
    if (layer == Layer::cc) return !path_->contacts.empty();
    return layer == Layer::cl
           && std::any_of(path_->motions.begin(), path_->motions.end(),
                          [](const Polylines& lines) { return !lines.empty(); });
}

void ScenePaths::apply_palette(const Colors& colors) {
    contact_lines_.color(colors.contacts);
    contact_dots_.color(colors.contacts);
    left_dots_.color(colors.left);
    kept_dots_.color(colors.kept);
    for (std::size_t k = 0; k < motion_kinds; ++k)
        lines_[k].color(colors.motions[k]);
}

void ScenePaths::apply_line_widths() {
    const double ratio = stage_.line_ratio();
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        lines_[k].set_line_width(motion_line_width(MotionKind(k)) * ratio);
        tint_lines_[k].set_line_width(2.2 * ratio); // colours that are to be told apart
    }
    left_dots_.set_point_size(6 * ratio);
    kept_dots_.set_point_size(9 * ratio);
}

void ScenePaths::apply_visibility(ShownSurface) {
    const bool cc = stage_.on(Layer::cc), cl = stage_.on(Layer::cl);
    const bool coarse_contacts = stage_.moving && contact_preview_.filled;
    contact_lines_.show(cc && !coarse_contacts);
    contact_dots_.show(cc && !coarse_contacts);
    contact_preview_.show(cc && coarse_contacts);
    for (SceneActor* dots : {&left_dots_, &kept_dots_}) // what the path leaves is shown with it
        dots->show(cc || cl);
    for (std::size_t k = 0; k < motion_kinds; ++k) {
        const bool shown = cl && on_[k], tinted = tint_lines_[k].filled;
        const bool coarse = stage_.moving && (tinted ? tint_preview_[k] : preview_[k]).filled;
        lines_[k].show(shown && !tinted && !coarse);
        preview_[k].show(shown && !tinted && coarse);
        tint_lines_[k].show(shown && !coarse);
        tint_preview_[k].show(shown && coarse);
    }
}

void ScenePaths::prepare_frame() {
    // Dots and lines that would run into each other are thinner.
    const double mm = stage_.camera.pixel_size(), ratio = stage_.line_ratio();
    const double gap = path_ && path_->contact_spacing > 0 && mm > 0 ? path_->contact_spacing / mm : infinity;
    contact_dots_.set_point_size(std::clamp(0.4 * gap, 0.8 * ratio, 2.6 * ratio));
    contact_lines_.set_line_width(std::clamp(0.2 * gap, 0.4 * ratio, 0.8 * ratio));
}

bool ScenePaths::has_preview() const {
    bool any = contact_preview_.filled;
    for (const auto* previews : {&preview_, &tint_preview_})
        for (const SceneActor& a : *previews)
            any = any || a.filled;
    return any;
}

void ScenePaths::add_bounds(Box3& box) const {
    if (path_ && (stage_.on(Layer::cc) || stage_.on(Layer::cl))) box.add(path_->box);
}

void ScenePaths::add_heavy(HeavyActors& heavy) {
    heavy.lines.insert(heavy.lines.end(), {&contact_lines_, &contact_dots_});
    for (auto* lines : {&lines_, &tint_lines_})
        for (auto& a : *lines)
            heavy.lines.push_back(&a);
}

bool ScenePaths::moves(MotionKind kind) const {
    const auto k = std::size_t(kind);
    return stage_.on(Layer::cl) && on_[k] && lines_[k].filled && !tint_lines_[k].filled;
}

void ScenePaths::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    using Sample = LegendEntry::Sample;
    const Colors& colors = colors_of(stage_.palette);
    const bool cc = stage_.on(Layer::cc), cl = stage_.on(Layer::cl);
    if (cc && contact_dots_.filled) entries.push_back({Sample::dot, colors.contacts, 1, "Contact points"});
    const auto mark = [&](const SceneActor& dots, const Rgb& color, const char* label) {
        if (dots.filled && (cc || cl)) entries.push_back({Sample::spot, color, 1, label});
    };
    mark(left_dots_, colors.left, "Left to clean-up");
    mark(kept_dots_, colors.kept, "Posture kept by hand");
    const auto add = [&](MotionKind kind, const char* label) {
        if (moves(kind))
            entries.push_back({kind == MotionKind::rapid ? Sample::dashes : Sample::line,
                               colors.motions[std::size_t(kind)], motion_line_width(kind), label});
    };
    add(MotionKind::cut, "Cut");
    add(MotionKind::link, "Link");
    const bool approach = moves(MotionKind::approach), retract = moves(MotionKind::retract);
    if (approach && retract)
        add(MotionKind::approach, "Approach, retract");
    else if (approach)
        add(MotionKind::approach, "Approach");
    else
        add(MotionKind::retract, "Retract");
    add(MotionKind::rapid, "Rapid");
}

void ScenePaths::add_color_bars(std::vector<ColorBar>& bars, ShownSurface) const {
    for (std::size_t k = 0; k < motion_kinds; ++k)
        if (stage_.on(Layer::cl) && on_[k] && tint_lines_[k].filled) {
            bars.push_back(tint_->bar());
            return;
        }
}

} // namespace facetmill
