// A closed curve drawn on the part: clicks add corners, a corner of a closed one is dragged.
#pragma once

#include "core/base/vec.h"
#include "ui/view_tool.h"

#include <QObject>

#include <optional>
#include <vector>

namespace facetmill::ui {

class Viewport;

class CurveTool : public QObject, public ViewTool {
    Q_OBJECT
public:
    CurveTool(Viewport& viewport, QObject* parent);

    /// The curve that there is; a click beside its corners begins another one.
    void begin(std::vector<Vec3> corners);
    /// One is being drawn, and not closed yet.
    bool drawing() const { return drawing_; }
    const std::vector<Vec3>& corners() const { return corners_; }
    /// False: there are fewer than three corners.
    bool close();
    void take_back();

    bool press(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void drag(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void release(const QPointF& at, Qt::KeyboardModifiers keys) override;
    bool double_click(const QPointF& at) override;

signals:
    /// Other corners, while it is drawn or dragged.
    void changed();
    /// It was closed, or a corner was dragged to another place.
    void ended();
    /// It was to be closed, and cannot be.
    void refused();

private:
    std::optional<Vec3> place(const QPointF& at) const;
    std::optional<std::size_t> corner_at(const QPointF& at) const;

    Viewport& viewport_;
    std::vector<Vec3> corners_;
    bool drawing_ = false, moved_ = false;
    std::optional<std::size_t> held_;
    QPointF press_;
};

} // namespace facetmill::ui
