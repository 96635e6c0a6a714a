// The unrolled path of an operation on a turning part: turning angle upward, length along the axis to the
// right, depth as colour, with axes and legend; dashed boxes are around what the cutter cannot come to. The
// tool goes to the place nearest to where the user points; a mark shows where it is.
#pragma once

#include "ui/chart_view.h"
#include "viz/unrolled.h"

#include <QImage>

namespace facetmill::ui {

class UnrolledView : public ChartView {
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
    void reset_view() override;
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

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool filled() const override { return path_ != nullptr; }
    void point_at(const QPointF& at) override;
    void move_by(const QPointF& by) override;
    void zoom_at(const QPointF& about, double factor, bool upright) override;
    void zoom_by_key(double factor) override;

private:
    QRectF frame(const QSize& size, const QFontMetricsF& metrics, bool titled) const;
    void paint(QPainter& p, const QSize& size, const QImage& image, const UnrolledWindow& window,
               bool titled) const;
    QImage image_for(const QSize& pixels, const UnrolledWindow& window) const;
    /// Keeps the window within the whole, and redraws.
    void hold_window();

    UnrolledPathPtr path_;
    QString empty_text_;
    std::optional<std::size_t> motion_;
    UnrolledWindow window_;
    QImage image_; ///< what the frame shows, in device pixels; null: to be made
};

} // namespace facetmill::ui
