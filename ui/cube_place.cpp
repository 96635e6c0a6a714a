#include "ui/cube_place.h"

#include "ui/view_cube.h"
#include "ui/viewport.h"

#include <QChildEvent>
#include <QTimer>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr int cube_margin = 8, scale_bar = 52; // points
constexpr int min_width = 260, min_free = 140; // of a view with a cube, points

} // namespace

CubePlace::CubePlace(Viewport& viewport, ViewCube& cube)
    : QObject(&viewport), viewport_(viewport), cube_(cube) {
    viewport.installEventFilter(this);
}

void CubePlace::update() {
    // Lower right, above the scale bar: the legend stands above, the axes on the left.
    const auto others = viewport_.findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    const auto blocks = [&](const QWidget* other) {
        return other != &cube_ && !other->isHidden()
               && !other->testAttribute(Qt::WA_TransparentForMouseEvents)
               && other->geometry().intersects(cube_.geometry());
    };
    const int width = viewport_.width(), height = viewport_.height();
    int message = 0; // along the lower edge: axes and scale stand above it, too
    for (const QWidget* other : others)
        if (other != &cube_ && !other->isHidden() && !other->testAttribute(Qt::WA_TransparentForMouseEvents)
            && other->geometry().bottom() >= height - 1)
            message = std::max(message, height - other->y());
    if (viewport_.scene().set_covered_below(message)) {
        viewport_.keep_picture();
        viewport_.refresh();
    }
    cube_.move(width - cube_.width() - cube_margin, height - cube_.height() - scale_bar - message);
    const bool free = width > min_width && height > min_free + cube_.height() + message
                      && std::none_of(others.begin(), others.end(), blocks);
    cube_.setVisible(free);
    const QRectF covered = free ? QRectF(cube_.geometry()) : QRectF();
    viewport_.scene().set_covered({covered.left(), covered.top()}, {covered.right(), covered.bottom()});
}

bool CubePlace::eventFilter(QObject* object, QEvent* event) {
    const QEvent::Type type = event->type();
    if (object == &viewport_) {
        if (type == QEvent::ChildAdded) static_cast<QChildEvent*>(event)->child()->installEventFilter(this);
    } else if (object->parent() == &viewport_ && object != &cube_
               && (type == QEvent::Show || type == QEvent::Hide || type == QEvent::Resize
                   || type == QEvent::Move)) {
        QTimer::singleShot(0, this, &CubePlace::update);
    }
    return QObject::eventFilter(object, event);
}

} // namespace facetmill::ui
