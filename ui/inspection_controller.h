// Looking at a planned path in numbers: the colours of the path in the view, and charts of it: the rotary
// axes over the path or the time, the step-over along the part. The chart's cursor and the tool in the view
// go together.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/path_chart.h"
#include "viz/path_tint.h"

#include <optional>
#include <vector>

namespace facetmill::ui {

class InspectionPanel;
class LayerBar;
class Viewport;

class InspectionController : public Controller {
    Q_OBJECT
public:
    InspectionController(Document& document, Viewport& viewport, LayerBar& layers, QWidget* window);
    ~InspectionController() override;

    InspectionPanel* panel() { return panel_; }

    void project_changed() override;
    void paths_shown(const ShownPaths& paths) override;
    /// The colours go to what is drawn.
    void path_parts_shown(const std::vector<PathSource>& sources) override;
    void place_shown(std::size_t source, std::size_t motion, double share) override;
    void tool_removed() override;
    void panel_seen(bool seen) override;
    bool busy() const override { return job_.running(); }

    Chart chart() const;
    /// Name for files: "Finish5-axes", "Finish5-stepover".
    QString export_name() const;
    /// Written aside; what comes of it is told in the window.
    void save_picture(const QString& path);
    void save_table(const QString& path);

signals:
    /// The tool is wanted at the end of this motion.
    void place_wanted(std::size_t source, std::size_t motion);
    /// Motions back or on.
    void step_wanted(int by);

private:
    PathQuantity quantity() const;
    void offer_quantities();
    void update();
    void show_tint();
    void show_chart();
    void show_place();
    void go_to(double x);
    void step(int by);
    std::size_t source() const;
    /// The tool's place on the path that is charted.
    std::optional<ChartPlace> place_here() const;

    Document& document_;
    Viewport& viewport_;
    LayerBar& layers_;
    InspectionPanel* panel_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<PathFiguresPtr> figures_; ///< one per result, or empty
    std::vector<PathSource> shown_;       ///< empty: all of them
    TintedPathPtr tint_;                  ///< shows the present quantity and unit
    LengthUnit tint_unit_ = LengthUnit::mm;
    PathChart chart_;
    std::optional<std::pair<std::size_t, ChartPlace>> place_; ///< where the tool is: which path, where on it
    BackgroundJob job_;                                       // last: it ends first
};

} // namespace facetmill::ui
