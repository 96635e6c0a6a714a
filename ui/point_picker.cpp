#include "ui/point_picker.h"

#include "core/mesh/flat_face.h"
#include "ui/axis_dialog.h"
#include "ui/messages.h"
#include "ui/parameter_form.h"
#include "ui/properties_panel.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QKeyEvent>

namespace facetmill::ui {

namespace {

/// Pixels: a corner of the facet that is so near is what is meant.
constexpr double corner_pixels = 8;

} // namespace

Vec3 snapped_point(const Viewport& viewport, const Mesh& mesh, const PartPick& pick) {
    Vec3 point = pick.point;
    const SceneCamera& camera = viewport.scene().camera();
    const Vec2 at = camera.display_of(pick.point);
    double nearest = corner_pixels * viewport.devicePixelRatioF();
    for (int k = 0; k < 3; ++k) {
        const Vec3& corner = mesh.corner(pick.facet, k);
        const double away = (camera.display_of(corner) - at).norm();
        if (away > nearest) continue;
        nearest = away;
        point = corner;
    }
    return point;
}

namespace {

/// Upright on the face that was met, as it is seen.
Vec3 picked_axis(const PartPick& pick) {
    return rounded_axis(pick.back_side ? Vec3(-pick.normal) : pick.normal);
}

} // namespace

PointPicker::PointPicker(Document& document, Viewport& viewport, PropertiesPanel& properties,
                         Messages& messages, QObject* window)
    : Controller(window), document_(document), viewport_(viewport), properties_(properties),
      messages_(messages) {
    connect(&properties_, &PropertiesPanel::pick_requested, this, [this](const std::string& key, bool on) {
        if (on)
            begin(key);
        else
            end();
    });
    connect(&properties_, &PropertiesPanel::shown, this, &PointPicker::end);
    connect(&viewport_, &Viewport::point_picked, this, &PointPicker::take);
}

void PointPicker::begin(const std::string& key) {
    if (!document_.has_part() || !document_.part()) {
        messages_.information(tr("The part is not read yet: there is nothing to pick."));
        return end();
    }
    emit picking_begun();
    key_ = key;
    properties_.form()->set_picking(key);
    viewport_.set_picking(true);
    messages_.information(is_axis()
                              ? tr("Click a face of the part: the tool will stand upright on it. Ctrl+click "
                                   "takes the direction that "
                                   "you look along. Esc leaves it.")
                              : tr("Click a point of the part for “%1”; a corner nearby is taken exactly. "
                                   "Ctrl+click takes the middle of the flat face there. Esc leaves it.")
                                    .arg(properties_.form()->spoken_label(key)));
}

void PointPicker::take(const std::optional<PartPick>& pick, Qt::KeyboardModifiers modifiers) {
    if (key_.empty()) return;
    const bool control = modifiers & Qt::ControlModifier;
    if (is_axis() && control) return take_axis(rounded_axis(viewport_.scene().camera().toward_eye()));
    if (!pick) {
        messages_.information(tr("That is beside the part: click on it, or press Esc."));
        return;
    }
    const Mesh& mesh = *document_.part()->mesh;
    if (is_axis()) return take_axis(picked_axis(*pick));
    const Vec3 point = control ? middle_of(mesh, flat_face(mesh, Index(pick->facet)))
                               : snapped_point(viewport_, mesh, *pick);
    const std::string key = key_;
    end();
    viewport_.scene().marks().set_marker(Marker{point, pick->normal});
    viewport_.refresh();
    properties_.take_point(key, point);
}

void PointPicker::take_axis(const Vec3& axis) {
    const std::string key = key_;
    end();
    properties_.take_point(key, axis);
}

bool PointPicker::is_axis() const {
    return key_ == "tool_axis";
}

void PointPicker::end() {
    const bool picking = !key_.empty();
    key_.clear();
    properties_.form()->set_picking({});
    if (!picking) return;
    viewport_.set_picking(false);
    messages_.dismiss();
}

bool PointPicker::take_key(const QKeyEvent& event) {
    if (key_.empty() || event.key() != Qt::Key_Escape) return false;
    end();
    return true;
}

} // namespace facetmill::ui
