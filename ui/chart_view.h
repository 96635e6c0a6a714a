// What charts have in common: their mouse and keys. Left click or drag points at a place, the wheel zooms
// about the pointer, right, middle or Shift+left drag moves, a double click or Home shows all, Plus and Minus
// zoom, the arrows step.
#pragma once

#include "ui/pointer.h"

#include <QWidget>

namespace facetmill::ui {

/// The number at a tick, with as many digits as tell neighbouring ones, `step` apart, from each other.
QString tick_text(double v, double step);

class ChartView : public QWidget {
    Q_OBJECT
public:
    explicit ChartView(QWidget* parent);
    virtual void reset_view() = 0;

signals:
    void stepped(int by);

protected:
    /// False while there is nothing to point at.
    virtual bool filled() const = 0;
    virtual void point_at(const QPointF& at) = 0;
    virtual void move_by(const QPointF& by) = 0;
    /// `upright`: along that axis alone, where the two are independent.
    virtual void zoom_at(const QPointF& about, double factor, bool upright) = 0;
    virtual void zoom_by_key(double factor) = 0;
    bool dragged() const { return bool(drag_); }

    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Drag { none, place, move };
    PointerDrag<Drag> drag_{0};
};

} // namespace facetmill::ui
