// Looking at a planned path in numbers: the colours of the path in the view, and charts of it: the rotary
// axes over the path or the time, the step-over along the part. The chart's cursor and the tool in the view
// go together.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "viz/path_tint.h"

#include <optional>
#include <vector>

namespace facetmill::ui {

class InspectionPanel;
class LayerBar;
class Viewport;

enum class Chart { rotary_over_length, rotary_over_time, stepover };

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
    bool save_picture(const QString& path);
    bool save_table(const QString& path);

signals:
    /// The tool is wanted at the end of this motion.
    void place_wanted(std::size_t source, std::size_t motion);
    /// Motions back or on.
    void step_wanted(int by);

private:
    void export_chart(bool table);
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
