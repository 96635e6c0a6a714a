// Points for parameters, picked by a click on the part.
#include "ui/main_window.h"

#include "core/job/planner.h"
#include "core/mesh/flat_face.h"
#include "ui/parameter_form.h"
#include "ui/properties_panel.h"
#include "ui/text.h"
#include "ui/viewport.h"

namespace facetmill::ui {

namespace {

/// Pixels: a corner of the facet that is so near is what is meant.
constexpr double corner_pixels = 8;

} // namespace

void MainWindow::build_pick() {
    connect(properties_, &PropertiesPanel::pick_requested, this, [this](const std::string& key, bool on) {
        if (on)
            pick_point(key);
        else
            end_pick();
    });
    connect(properties_, &PropertiesPanel::shown, this, &MainWindow::end_pick);
    connect(viewport_, &Viewport::point_picked, this, &MainWindow::take_picked);
}

void MainWindow::pick_point(const std::string& key) {
    if (!document_.has_part() || !document_.part()) {
        tell(MessageBar::Kind::information, tr("The part is not read yet: there is nothing to pick."));
        return end_pick();
    }
    picked_key_ = key;
    properties_->form()->set_picking(key);
    viewport_->set_picking(true);
    tell(MessageBar::Kind::information, tr("Click a point of the part for “%1”; a corner nearby is taken "
                                           "exactly. Ctrl+click takes the middle "
                                           "of the flat face there. Esc leaves it.")
                                            .arg(text(key).replace(QChar('_'), QChar(' '))));
}

void MainWindow::take_picked(const std::optional<PartPick>& pick, Qt::KeyboardModifiers modifiers) {
    if (picked_key_.empty()) return;
    if (!pick) {
        tell(MessageBar::Kind::information, tr("That is beside the part: click on it, or press Esc."));
        return;
    }
    const Mesh& mesh = *document_.part()->mesh;
    Vec3 point = pick->point;
    if (modifiers & Qt::ControlModifier) {
        point = middle_of(mesh, flat_face(mesh, Index(pick->facet)));
    } else {
        const Scene& scene = viewport_->scene();
        const Vec2 at = scene.display_of(pick->point);
        double nearest = corner_pixels * viewport_->devicePixelRatioF();
        for (int k = 0; k < 3; ++k) {
            const Vec3& corner = mesh.corner(pick->facet, k);
            const double away = (scene.display_of(corner) - at).norm();
            if (away > nearest) continue;
            nearest = away;
            point = corner;
        }
    }
    const std::string key = picked_key_;
    end_pick();
    viewport_->scene().set_marker(Marker{point, pick->normal});
    viewport_->refresh();
    properties_->take_point(key, point);
}

void MainWindow::end_pick() {
    if (picked_key_.empty()) return properties_->form()->set_picking({});
    picked_key_.clear();
    properties_->form()->set_picking({});
    viewport_->set_picking(false);
    message_->dismiss();
}

} // namespace facetmill::ui
