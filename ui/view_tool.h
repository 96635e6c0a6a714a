// What the left button does in the view in place of turning it.
#pragma once

#include <QPointF>
#include <Qt>

class QPainter;

namespace facetmill::ui {

/// Places are those of the widget. Ctrl + left drag turns the view whatever the tool.
class ViewTool {
public:
    virtual ~ViewTool() = default;
    /// False: the press is not for the tool, and the view takes it.
    virtual bool press(const QPointF& at, Qt::KeyboardModifiers keys) = 0;
    /// While the button is held.
    virtual void drag(const QPointF& at, Qt::KeyboardModifiers keys) = 0;
    virtual void release(const QPointF& at, Qt::KeyboardModifiers keys) = 0;
    /// False: it is a press like any other.
    virtual bool double_click(const QPointF& /*at*/) { return false; }
    /// It would take a press there: the pointer tells.
    virtual bool takes(const QPointF& /*at*/) const { return true; }
    /// What is drawn over the picture while the pointer is at a place.
    virtual void paint(QPainter& /*painter*/, const QPointF& /*pointer*/) {}
};

} // namespace facetmill::ui
