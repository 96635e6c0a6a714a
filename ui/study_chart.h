// The pictures of a study (study_figures.h), painted here: the library for charts that Debian has brings no
// parallel coordinates with ranges to be dragged. A click, or the arrow keys, choose a candidate.
#pragma once

#include "ui/chart_view.h"
#include "ui/study_figures.h"

#include <QColor>
#include <QImage>
#include <QRectF>

#include <optional>
#include <vector>

class QPainter;

namespace facetmill::ui {

struct StudyChartLook {
    QColor ground, ink, quiet, grid, good, attention, bad, accent;
    QFont font;
};

class StudyChart : public ChartView {
    Q_OBJECT
public:
    explicit StudyChart(QWidget* parent);

    void show_figures(StudyFiguresPtr figures);
    const StudyFiguresPtr& figures() const { return figures_; }
    void choose(std::optional<std::size_t> candidate);
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Those that ranges leave, by number; the others are faint. Empty: all.
    void set_kept(std::vector<char> kept);
    /// White ground, without what is chosen.
    QImage picture(const QSize& size) const;
    /// Where a candidate is drawn; none where it is not.
    virtual std::optional<QPointF> place_of(std::size_t candidate) const = 0;

    void reset_view() override {}
    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {200, 120}; }

signals:
    /// By the user.
    void candidate_chosen(std::size_t candidate);

protected:
    bool filled() const override { return figures_ && !figures_->rows.empty(); }
    void point_at(const QPointF& at) override;
    void move_by(const QPointF& /*by*/) override {}
    void zoom_at(const QPointF& /*about*/, double /*factor*/, bool /*upright*/) override {}
    void zoom_by_key(double /*factor*/) override {}
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

    virtual void paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const = 0;
    /// The candidate at a place, if any.
    virtual std::optional<std::size_t> candidate_at(const QPointF& at) const = 0;
    /// Those that are drawn, in the order of the arrow keys.
    virtual std::vector<std::size_t> order() const = 0;
    virtual void figures_changed() {}

    bool is_kept(std::size_t candidate) const { return candidate >= kept_.size() || kept_[candidate]; }
    /// The mark of a candidate: its shape and colour say what became of it.
    void paint_mark(QPainter& p, const QPointF& at, std::size_t candidate, const StudyChartLook& look) const;
    void paint_chosen(QPainter& p, const QPointF& at, const StudyChartLook& look) const;
    /// "17: direction y, tool 2; machining time ..."
    QString tip_of(std::size_t candidate) const;
    StudyChartLook look() const;

private:
    StudyFiguresPtr figures_;
    std::optional<std::size_t> chosen_;
    std::vector<char> kept_;
};

/// Two measures against each other, usually time against the largest excess; a line along the front.
class StudyFrontChart : public StudyChart {
    Q_OBJECT
public:
    explicit StudyFrontChart(QWidget* parent = nullptr);
    void set_axes(Measure x, Measure y);
    std::optional<QPointF> place_of(std::size_t candidate) const override;
    void reset_view() override;

protected:
    void paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const override;
    std::optional<std::size_t> candidate_at(const QPointF& at) const override;
    std::vector<std::size_t> order() const override;
    void figures_changed() override;
    void move_by(const QPointF& by) override;
    void zoom_at(const QPointF& about, double factor, bool upright) override;
    void zoom_by_key(double factor) override;

private:
    std::optional<QPointF> values(std::size_t candidate) const;
    QRectF frame(const QSize& size, bool exported) const;
    QPointF place(const QPointF& values, const QRectF& frame) const;
    void paint_axes(QPainter& p, const QRectF& in, const StudyChartLook& look) const;
    void paint_points(QPainter& p, const QRectF& in, const StudyChartLook& look, bool exported) const;
    void paint_key(QPainter& p, const QRectF& in, const StudyChartLook& look) const;

    Measure x_ = Measure::machining_time, y_ = Measure::excess_max;
    QRectF view_{0, 0, 1, 1}; ///< what is seen of either axis; top is the low end
    bool own_view_ = false;   ///< the user has zoomed or moved
};

/// A strip of bars for each rung: one bar per candidate, as high as it takes time, in the same order in all
/// strips, in the colour of what came of it there.
class StudyStageChart : public StudyChart {
    Q_OBJECT
public:
    explicit StudyStageChart(QWidget* parent = nullptr);
    std::optional<QPointF> place_of(std::size_t candidate) const override;

protected:
    void paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const override;
    std::optional<std::size_t> candidate_at(const QPointF& at) const override;
    std::vector<std::size_t> order() const override { return order_; }
    void figures_changed() override;

private:
    QRectF strip(std::size_t rung, const QSize& size, bool exported) const;
    QRectF bar(std::size_t slot, const QRectF& in) const;
    QString strip_text(std::size_t rung) const;

    std::vector<std::size_t> order_;
    double longest_ = 1;
};

/// A line per candidate across upright axes: what varies, and measures. A drag along an axis keeps those in
/// that range, a click on it lets all be kept again, as Delete does of all axes.
class StudyParallelChart : public StudyChart {
    Q_OBJECT
public:
    explicit StudyParallelChart(QWidget* parent = nullptr);
    std::optional<QPointF> place_of(std::size_t candidate) const override;
    /// Whether all ranges hold a candidate, by number; empty: there is no range.
    std::vector<char> kept_by_ranges() const;
    std::size_t axis_count() const { return axes_.size(); }
    /// A place on an axis, 0 at its foot.
    QPointF axis_place(std::size_t axis, double share) const;
    void clear_ranges();

signals:
    void ranges_changed();

protected:
    void paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const override;
    std::optional<std::size_t> candidate_at(const QPointF& at) const override;
    std::vector<std::size_t> order() const override;
    void figures_changed() override;
    void reset_view() override { clear_ranges(); }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Axis {
        QString name;
        std::optional<std::size_t> variation; ///< else a measure
        Measure measure = Measure::machining_time;
        double low = 0, high = 1;
        std::optional<std::pair<double, double>> range; ///< shares of the axis
    };
    /// Where a candidate crosses an axis, 0 at its foot; none where that is not known.
    std::optional<double> share_of(std::size_t candidate, const Axis& axis) const;
    QRectF frame(const QSize& size) const;
    double axis_x(std::size_t axis, const QRectF& in) const;
    std::vector<QPointF> line_of(std::size_t candidate, const QRectF& in) const;
    std::optional<std::size_t> axis_at(const QPointF& at) const;
    void paint_at_axis(QPainter& p, const QRectF& in, std::size_t axis, const QString& words,
                       double top) const;
    void paint_axes(QPainter& p, const QRectF& in, const StudyChartLook& look) const;
    QString end_text(const Axis& axis, bool high) const;

    std::vector<Axis> axes_;
    std::optional<std::size_t> dragged_; ///< axis whose range is drawn
    double drag_from_ = 0;
};

} // namespace facetmill::ui
