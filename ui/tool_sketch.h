// A tool drawn to scale: cutter, shank, holder, axis and dimensions; beside it the cutting part alone,
// enlarged.
#pragma once

#include "core/base/units.h"
#include "core/setup/tool.h"

#include <QPainterPath>
#include <QWidget>

namespace facetmill::ui {

class ToolSketch : public QWidget {
    Q_OBJECT
public:
    explicit ToolSketch(QWidget* parent = nullptr);

    /// Values that make no tool are not drawn: `why` stands in their place.
    void set_tool(const Tool& tool, LengthUnit unit);
    /// Without the enlarged cutting part, for narrow places.
    void set_compact(bool compact);
    /// Empty when the tool is drawn.
    const QString& why_not() const { return why_not_; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct View;
    void draw_assembly(QPainter& p, const QRectF& area) const;
    void draw_detail(QPainter& p, const QRectF& area) const;
    QPainterPath cutter_path(double scale) const;

    Tool tool_;
    LengthUnit unit_ = LengthUnit::mm;
    bool has_tool_ = false, compact_ = false;
    QString why_not_;
    std::vector<ProfilePiece> pieces_;
    double cutter_height_ = 0, cutter_radius_ = 0;
};

} // namespace facetmill::ui
