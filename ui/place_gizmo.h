// Rings and arrows about the part that turn and move it by the mouse. With Shift in round steps.
#pragma once

#include "core/base/vec.h"
#include "ui/place_value.h"
#include "ui/view_tool.h"

#include <QObject>
#include <QPointF>
#include <QPolygonF>

#include <array>
#include <optional>

namespace facetmill::ui {

class Viewport;

class PlaceGizmo : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit PlaceGizmo(Viewport& viewport, QObject* parent = nullptr);

    /// The part's box, about whose middle it stands; empty: there is none, and nothing to take.
    void set_box(const Box3& box, LengthUnit unit);
    bool dragging() const { return held_.has_value(); }
    /// Puts it back as it was before the drag.
    void cancel();

    bool press(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void drag(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void release(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void paint(QPainter& painter, const QPointF& pointer) override;
    bool takes(const QPointF& at) const override { return handle_at(at).has_value(); }

    /// A place on a ring (PlaceChange::turn), or the tip of an arrow (move), in the view, for tests; the
    /// ring's where the line at `share` of a turn is.
    QPointF place_of(PlaceChange what, int axis, double share = 0) const;

signals:
    /// While it is dragged: radians about the middle of the box, or mm.
    void dragged(facetmill::ui::PlaceChange what, int axis, double value);
    /// Let go there; 0: it was put back.
    void dropped(facetmill::ui::PlaceChange what, int axis, double value);

private:
    struct Handle {
        PlaceChange what = PlaceChange::turn;
        int axis = 0;
        bool operator==(const Handle&) const = default;
    };
    double radius() const;
    Vec3 toward_eye() const; ///< from the middle
    Vec3 ring_place(int axis, double angle) const;
    QPointF pixel(const Vec3& p) const;
    /// What is seen of a ring in front or behind; an arrow, which is in front.
    QPolygonF line_of(const Handle& handle, bool behind) const;
    /// The arrow would be a dot, seen from its end.
    bool seen(const Handle& handle) const;
    std::optional<Handle> handle_at(const QPointF& at) const;
    /// The value that the pointer stands for, against that where it was pressed.
    double value_at(const QPointF& at) const;
    QString value_text() const;

    Viewport& viewport_;
    Box3 box_;
    LengthUnit unit_ = LengthUnit::mm;
    std::optional<Handle> held_;
    QPointF press_;
    double last_angle_ = 0, value_ = 0; ///< as the pointer has it; as it is shown
    double turned_ = 0;                 ///< so far, over more than half a turn
};

} // namespace facetmill::ui
