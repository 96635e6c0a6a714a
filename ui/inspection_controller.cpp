#include "ui/inspection_controller.h"

#include "core/base/file.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "ui/elided_label.h"
#include "ui/export.h"
#include "ui/file_writing.h"
#include "ui/inspection_panel.h"
#include "ui/layer_bar.h"
#include "ui/plot_view.h"
#include "ui/shown_paths.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QComboBox>
#include <QImage>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace facetmill::ui {

namespace {

constexpr QSize inspection_picture_size(1600, 900);
} // namespace

InspectionController::InspectionController(Document& document, Viewport& viewport, LayerBar& layers,
                                           QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), layers_(layers),
      panel_(new InspectionPanel(window)) {
    connect(&layers_, &LayerBar::quantity_chosen, this, &InspectionController::update);
    connect(panel_->chart_box(), &QComboBox::currentIndexChanged, this, [this] {
        show_chart();
        update();
    });
    connect(panel_->operation_box(), &QComboBox::currentIndexChanged, this, [this] { show_chart(); });
    connect(panel_->plot(), &PlotView::cursor_moved, this, &InspectionController::go_to);
    connect(panel_->plot(), &PlotView::stepped, this, &InspectionController::step);
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    connect(panel_, &InspectionPanel::picture_requested, this, [this] {
        export_file(panel_, tr("Export the chart"), ExportFormat::picture, export_name(),
                    std::bind_front(&InspectionController::save_picture, this));
    });
    connect(panel_, &InspectionPanel::table_requested, this, [this] {
        export_file(panel_, tr("Export the chart's values"), ExportFormat::table, export_name(),
                    std::bind_front(&InspectionController::save_table, this));
    });
    offer_quantities();
    show_chart();
}

InspectionController::~InspectionController() = default;

/// The unit.
void InspectionController::project_changed() {
    if (tint_ && tint_unit_ != document_.unit()) {
        tint_ = nullptr;
        update();
    }
    if (chart_.unit() != document_.unit()) show_chart();
}

PathQuantity InspectionController::quantity() const {
    return layers_.quantity();
}

Chart InspectionController::chart() const {
    return Chart(std::max(0, panel_->chart_box()->currentIndex()));
}

void InspectionController::offer_quantities() {
    for (std::size_t q = 1; q < path_quantities; ++q) {
        std::string why = utf8(tr("No path is planned."));
        for (const auto& result : results_) {
            why = path_quantity_missing(PathQuantity(q), *result);
            if (why.empty()) break;
        }
        layers_.set_quantity_missing(PathQuantity(q), worded(why));
    }
}

void InspectionController::paths_shown(const ShownPaths& paths) {
    job_.cancel();
    results_ = paths.programs();
    figures_.clear();
    shown_.clear();
    tint_ = nullptr;
    layers_.show_scale(nullptr);
    place_.reset();
    offer_quantities();
    {
        const QSignalBlocker quiet(panel_->operation_box());
        QComboBox* box = panel_->operation_box();
        const QString was = box->currentText();
        box->clear();
        for (const auto& result : results_)
            box->addItem(elided(text(result->name), 40));
        box->setCurrentIndex(std::max(0, box->findText(was)));
        box->setVisible(results_.size() > 1);
    }
    show_chart();
    update();
}

void InspectionController::path_parts_shown(const std::vector<PathSource>& sources) {
    shown_ = sources;
    tint_ = nullptr;
    layers_.show_scale(nullptr);
    update();
}

void InspectionController::panel_seen(bool seen) {
    if (seen) update();
}

/// Starts what is missing for what is wanted.
void InspectionController::update() {
    const PathQuantity wanted = quantity();
    if (tint_ && tint_->quantity != wanted) {
        tint_ = nullptr;
        show_tint();
    }
    const bool for_chart = panel_->isVisible() && chart() != Chart::stepover;
    const bool figures = figures_.empty() && (for_chart || wanted != PathQuantity::kind);
    const bool tint = wanted != PathQuantity::kind && !tint_;
    if (results_.empty() || (!figures && !tint)) {
        job_.cancel();
        return;
    }
    struct Outcome {
        std::vector<PathFiguresPtr> figures;
        TintedPathPtr tint;
    };
    auto outcome = std::make_shared<Outcome>();
    outcome->figures = figures_;
    const LengthUnit unit = document_.unit();
    job_.start(
        tr("Looking at the path"),
        [outcome, results = results_, shown = shown_, project = document_.project(), wanted,
         unit](const Progress& p) {
            if (outcome->figures.empty())
                for (std::size_t i = 0; i < results.size(); ++i) {
                    // A path of several axes belongs to the machine it was planned for.
                    const auto record = results[i]->path.five_axis();
                    const Machine machine = record ? record->context.machine : project_machine(project);
                    const double n = double(results.size());
                    outcome->figures.push_back(path_figures(
                        results[i], machine, p.part(0.4 * double(i) / n, 0.4 * double(i + 1) / n)));
                }
            outcome->tint = prepare_tinted_path(outcome->figures, wanted, unit, p.part(0.4, 1), shown);
        },
        [this, outcome, results = results_, wanted, unit](const JobEnd& end) {
            if (!end.done() || results != results_) return;
            const bool new_figures = figures_.empty();
            figures_ = outcome->figures;
            if (wanted == quantity() && unit == document_.unit()) {
                tint_ = outcome->tint;
                tint_unit_ = unit;
                show_tint();
            }
            if (new_figures) show_chart();
        });
}

void InspectionController::show_tint() {
    viewport_.scene().paths().set_tint(tint_);
    layers_.show_scale(tint_);
    viewport_.content_changed();
    viewport_.refresh();
}

std::size_t InspectionController::source() const {
    return std::size_t(std::max(0, panel_->operation_box()->currentIndex()));
}

void InspectionController::show_chart() {
    PlotView* plot = panel_->plot();
    const bool any = source() < results_.size();
    if (any)
        chart_ = PathChart(chart(), results_[source()],
                           source() < figures_.size() ? figures_[source()] : nullptr, document_.unit());
    if (!any || !chart_.missing().isEmpty()) {
        plot->clear(any ? chart_.missing() : tr("Plan an operation to see it here"));
        panel_->readout()->set_text({});
        panel_->set_ready(false);
        return;
    }
    plot->set_content(chart_.content());
    panel_->set_ready(true);
    show_place();
}

std::optional<ChartPlace> InspectionController::place_here() const {
    if (!place_ || place_->first != source() || panel_->plot()->empty()) return std::nullopt;
    return place_->second;
}

void InspectionController::show_place() {
    PlotView* plot = panel_->plot();
    if (plot->empty()) return;
    const auto here = place_here();
    const double x = here ? chart_.x_of(*here) : std::numeric_limits<double>::quiet_NaN();
    plot->set_cursor(std::isfinite(x) ? std::optional(x) : std::nullopt);
    const QStringList said = std::isfinite(x) ? chart_.readout(*here) : QStringList();
    panel_->readout()->set_text(said.value(0), said.mid(1));
}

void InspectionController::place_shown(std::size_t source, std::size_t motion, double share) {
    if (source >= results_.size() || motion >= results_[source]->program.motions.motions.size())
        return tool_removed();
    place_ = {source, {motion, share}};
    if (source != this->source())
        panel_->operation_box()->setCurrentIndex(int(source)); // shows chart and place
    else
        show_place();
}

void InspectionController::tool_removed() {
    place_.reset();
    show_place();
}

void InspectionController::step(int by) {
    if (chart() != Chart::stepover) return emit step_wanted(by);
    const auto here = place_here();
    if (const auto motion = here ? chart_.pass_from(*here, by) : std::nullopt)
        emit place_wanted(source(), *motion);
}

void InspectionController::go_to(double x) {
    if (source() >= results_.size() || panel_->plot()->empty()) return;
    if (const auto motion = chart_.motion_at(x)) emit place_wanted(source(), *motion);
}

QString InspectionController::export_name() const {
    if (source() >= results_.size()) return {};
    return text(results_[source()]->name)
           + (chart() == Chart::stepover ? QStringLiteral("-stepover") : QStringLiteral("-axes"));
}

void InspectionController::save_picture(const QString& path) {
    if (panel_->plot()->empty()) return;
    write_file(
        *this, document_, path,
        [picture = panel_->plot()->picture(inspection_picture_size)] { return png_bytes(picture); },
        [this, path](const QString& wrong) { report_written(path, wrong); });
}

void InspectionController::save_table(const QString& path) {
    if (panel_->plot()->empty()) return;
    write_file(
        *this, document_, path, [chart = chart_] { return chart.table(); },
        [this, path](const QString& wrong) { report_written(path, wrong); });
}

} // namespace facetmill::ui
