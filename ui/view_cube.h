// A small cube in the corner of the view that turns with it; a click on a face looks from there, the house
// looks from the corner, the arrows roll the picture by a quarter of a turn.
#pragma once

#include "viz/scene.h"

#include <QPolygonF>
#include <QWidget>

#include <array>
#include <optional>

namespace facetmill::ui {

class ViewCube : public QWidget {
    Q_OBJECT
public:
    explicit ViewCube(QWidget* parent = nullptr);

    void set_orientation(const Vec3& sight, const Vec3& up);
    /// The face under a point of the widget; `iso` for the house in the corner.
    std::optional<StandardView> face_at(const QPointF& at) const;
    /// Quarters of a turn that the arrow under a point rolls the picture clockwise: 1, -1; 0: none is there.
    int roll_at(const QPointF& at) const;
    /// Middle of the arrow that rolls the picture so.
    QPointF roll_center(int quarters) const;
    /// Middle of a face on the screen, if it can be seen.
    std::optional<QPointF> face_center(StandardView view) const;

signals:
    void chosen(facetmill::StandardView view);
    void rolled(int quarters);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    QPointF project(const Vec3& p) const;
    bool seen(const Vec3& outward) const { return outward.dot(sight_) < -0.02; }

    Vec3 sight_ = Vec3(0, 1, 0), up_ = Vec3(0, 0, 1);
    void draw_arrow(QPainter& p, int quarters, const QColor& ground, const QColor& ink) const;

    std::optional<StandardView> hover_, pressed_;
    int roll_hover_ = 0, roll_pressed_ = 0;
};

} // namespace facetmill::ui
