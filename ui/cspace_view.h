// The view of a configuration space: a canvas around a CSpaceScene. Left drag turns, the wheel or
// right drag zooms, a double click fits, a click in it tries that posture, a drag of a marker carries
// it along.
#pragma once

#include "ui/gl_canvas.h"
#include "ui/pointer.h"
#include "viz/cspace_scene.h"

#include <optional>

namespace facetmill::ui {

class CSpaceView : public GlCanvas {
    Q_OBJECT
public:
    explicit CSpaceView(QWidget* parent = nullptr);
    ~CSpaceView() override;

    CSpaceScene& scene() { return scene_; }
    /// Draws soon.
    void refresh();
    /// False while a picture is due.
    bool finished() const;
    /// The configuration space in this size with its legend, drawn now.
    QImage export_picture(const QSize& size);
    QSize sizeHint() const override { return {420, 150}; } ///< and all that is left

signals:
    /// What is under the resting pointer.
    void hovered(const std::optional<facetmill::CSpaceDisplay::Hit>& hit);
    /// A posture to be tried; of a dragged marker with its lift.
    void tried(const facetmill::PostureValue& posture);
    /// A click on a marker: a choice's number.
    void choice_clicked(std::size_t choice);
    /// Arrow keys: points along the pass, passes.
    void stepped(int points, int passes);

protected:
    void initialize_gl() override;
    void paint_gl() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Draws, and calls `read` while the picture is bound for reading.
    template <class Read>
    void render(const Read& read);
    enum class Drag { none, turn, zoom, marker };
    QPointF device(const QPointF& at) const { return at * devicePixelRatioF(); }
    std::optional<CSpaceDisplay::Hit> hit(const QPointF& at) const;

    CSpaceScene scene_;
    struct Window;
    std::unique_ptr<Window> window_;
    bool dirty_ = true;
    PointerDrag<Drag> drag_{click_slack};
    std::optional<std::size_t> marker_; ///< under the press
    PointerRest rest_{[this](const QPointF& at) { emit hovered(hit(at)); }};
};

} // namespace facetmill::ui
