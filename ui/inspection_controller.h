// Looking at a planned path in numbers: the colours of the path in the view, and charts of it: the rotary
// axes over the way or the time, the step-over along the part. The chart's cursor and the tool in the view go
// together; the window carries the one to the other.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"
#include "viz/path_tint.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QToolButton;

namespace facetmill::ui {

class ElidedLabel;
class LayerBar;
class PlotView;
class Viewport;

enum class Chart { rotary_over_length, rotary_over_time, stepover };

/// Which chart, of which operation, what stands at the cursor, and the chart.
class InspectionPanel : public QWidget {
    Q_OBJECT
public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    PlotView* plot() { return plot_; }
    QComboBox* chart_box() { return chart_; }
    QComboBox* operation_box() { return operation_; }
    ElidedLabel* readout() { return readout_; }
    void set_ready(bool ready);

signals:
    void picture_requested();
    void table_requested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    PlotView* plot_ = nullptr;
    QComboBox *chart_ = nullptr, *operation_ = nullptr;
    ElidedLabel* readout_ = nullptr;
    std::vector<QToolButton*> buttons_;
};

class InspectionController : public QObject {
    Q_OBJECT
public:
    InspectionController(Document& document, Viewport& viewport, LayerBar& layers, QWidget* window);
    ~InspectionController() override;

    InspectionPanel* panel() { return panel_; }

    /// The paths that the scene shows from now on, in its order.
    void set_paths(std::vector<std::shared_ptr<const OperationResult>> results);
    /// Which motions of the paths are drawn; in colours, too. As many as paths.
    void set_shown(std::vector<PathSource> shown);
    /// Where the tool is: of path `source`, `share` of the way through a motion.
    void set_place(std::size_t source, std::size_t motion, double share = 1);
    void clear_place();
    /// The panel came to be seen.
    void look();
    Chart chart() const;
    /// Name for files: "Finish5-axes", "Finish5-stepover".
    QString export_name() const;
    bool save_picture(const QString& path);
    bool save_table(const QString& path);
    bool busy() const { return job_.running(); }

signals:
    /// The tool is wanted at the end of this motion.
    void place_wanted(std::size_t source, std::size_t motion);
    /// Motions back or on.
    void step_wanted(int by);
    void failed(const QString& message);
    void told(const QString& message);
    void settled();

private:
    bool tell_written(const QString& path, const QString& wrong);
    struct Place {
        std::size_t source = 0, motion = 0;
        double share = 1;
    };
    PathQuantity quantity() const;
    void offer_quantities();
    void update();
    void show_tint();
    void show_chart();
    void show_place();
    void go_to(double x);
    void step(int by);
    std::size_t source() const;
    double x_of(const Place& place) const;
    std::string table() const;

    Document& document_;
    Viewport& viewport_;
    LayerBar& layers_;
    InspectionPanel* panel_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<PathFiguresPtr> figures_; ///< of `results_`, or empty
    std::vector<PathSource> shown_;       ///< empty: all of them
    TintedPathPtr tint_;                  ///< of the quantity and unit that are shown
    LengthUnit tint_unit_ = LengthUnit::mm, chart_unit_ = LengthUnit::mm;
    std::optional<Place> place_;
    /// Of the step-over chart: drive planes in the order of their places, with the first motion that cuts in
    /// each.
    struct Drive {
        double offset = 0; ///< mm
        std::size_t motion = 0;
        int drive = 0;
    };
    std::vector<Drive> drives_;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
