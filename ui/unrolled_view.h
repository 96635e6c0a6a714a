// The unrolled path of an operation on a turning part: turning angle upward, length along the axis to the
// right, depth as colour, with axes and legend; dashed boxes are around what the cutter cannot come to. A
// click or left drag takes the tool to the nearest place; a mark shows where it is. The wheel zooms about the
// pointer, right, middle or Shift+left drag moves, a double click or Home shows all.
#pragma once

#include "viz/unrolled.h"

#include <QImage>
#include <QWidget>

namespace facetmill::ui {

class UnrolledView : public QWidget {
    Q_OBJECT
public:
    explicit UnrolledView(QWidget* parent = nullptr);

    void set_path(UnrolledPathPtr path);
    /// Without a path the text says why.
    void clear(const QString& why);
    const UnrolledPathPtr& path() const { return path_; }
    const QString& empty_text() const { return empty_text_; }
    /// Where the tool is: a motion of the operation, or none.
    void set_motion(std::optional<std::size_t> motion);
    std::optional<std::size_t> motion() const { return motion_; }

    const UnrolledWindow& window() const { return window_; }
    /// All of it.
    void reset_view();
    /// Pixel of the widget for a place; and the picture's frame in it.
    QPointF place_of(double along, double angle) const;
    QRectF frame() const;
    /// White ground, with the operation's name; no mark.
    QImage picture(const QSize& size) const;
    QSize sizeHint() const override { return {420, 420}; }
    /// Room for a small frame beside its titles and labels.
    QSize minimumSizeHint() const override;

signals:
    /// The tool is wanted at the end of this motion.
    void motion_wanted(std::size_t motion);
    void stepped(int by);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Drag { none, place, move };
    QRectF frame(const QSize& size, const QFontMetricsF& metrics, bool titled) const;
    void paint(QPainter& p, const QSize& size, const QImage& image, const UnrolledWindow& window,
               bool titled) const;
    QImage image_for(const QSize& pixels, const UnrolledWindow& window) const;
    void take(const QPointF& at);
    void zoom(const QPointF& about, double factor);
    /// Keeps the window within the whole, and redraws.
    void hold_window();

    UnrolledPathPtr path_;
    QString empty_text_;
    std::optional<std::size_t> motion_;
    UnrolledWindow window_;
    QImage image_; ///< what the frame shows, in device pixels; null: to be made
    Drag drag_ = Drag::none;
    QPointF last_;
};

} // namespace facetmill::ui
