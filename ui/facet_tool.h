// Facets painted in the view: by a brush, by flooding from the one that is clicked, by a box that is drawn.
#pragma once

#include "core/mesh/facet_paint.h"
#include "ui/background_job.h"
#include "ui/view_tool.h"

#include <QObject>
#include <QRectF>

#include <memory>
#include <optional>
#include <vector>

namespace facetmill::ui {

class Viewport;

struct PaintSettings {
    enum class Shape { brush, flood, box };
    Shape shape = Shape::brush;
    double radius = 2;    ///< of the brush, mm
    double angle = 0.3;   ///< flooding ends at edges where the surface turns by more, radians
    bool erase = false;   ///< takes facets out; Shift does the other of the two
    bool through = false; ///< the box takes facets too that are not seen
};

class FacetTool : public QObject, public ViewTool {
    Q_OBJECT
public:
    FacetTool(Viewport& viewport, QObject* parent);

    /// The part that is painted, and what is marked on it already.
    void begin(std::shared_ptr<FacetPainter> painter, std::vector<char> marks);
    /// Forgets a box whose facets are still looked for.
    void end() { search_.cancel(); }
    const std::vector<char>& marks() const { return marks_; }
    PaintSettings& settings() { return settings_; }

    bool press(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void drag(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void release(const QPointF& at, Qt::KeyboardModifiers keys) override;
    void paint(QPainter& painter, const QPointF& pointer) override;
    /// What lies in a box is being looked for; until then nothing else is painted.
    bool busy() const { return search_.running(); }

signals:
    /// These were taken in, or out, and were not so before.
    void painted(const std::vector<facetmill::Index>& facets, bool in);
    /// The button was let go after something was painted.
    void stroke_ended();
    void settled();

private:
    /// Paints under a place of the widget; false where the part is not.
    bool touch(const QPointF& at);
    double mm_per_point(const QPointF& at) const; ///< where the pointer is on the part
    void take(const std::vector<Index>& facets);
    void take_box(const QRectF& box);
    void end_stroke();

    Viewport& viewport_;
    std::shared_ptr<FacetPainter> painter_;
    std::vector<char> marks_;
    PaintSettings settings_;
    QPointF last_;                  ///< where the brush was
    std::optional<QPointF> corner_; ///< of a box, where it began
    bool in_ = true, changed_ = false;
    BackgroundJob search_; // last: it ends first
};

} // namespace facetmill::ui
