#include "ui/inspection_controller.h"

#include "core/base/file.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "ui/elided_label.h"
#include "ui/export.h"
#include "ui/inspection_panel.h"
#include "ui/layer_bar.h"
#include "ui/plot_view.h"
#include "ui/shown_paths.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QComboBox>
#include <QImage>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace facetmill::ui {

namespace {

constexpr QSize picture_size(1600, 900);
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_in_seconds = 300; ///< beyond it the axis of time counts minutes

const char* kind_name(MotionKind kind) {
    constexpr const char* names[] = {"rapid", "approach", "cut", "link", "retract"};
    return names[std::size_t(kind)];
}

QString angle_text(double degrees, int digits = 1) {
    return QString::number(degrees, 'f', digits).replace(QChar('-'), QChar(0x2212)) + QChar(0x00B0);
}

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
    connect(panel_, &InspectionPanel::picture_requested, this, [this] { export_chart(false); });
    connect(panel_, &InspectionPanel::table_requested, this, [this] { export_chart(true); });
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
    if (chart_unit_ != document_.unit()) show_chart();
}

PathQuantity InspectionController::quantity() const {
    return layers_.quantity();
}

Chart InspectionController::chart() const {
    return Chart(std::max(0, panel_->chart_box()->currentIndex()));
}

void InspectionController::offer_quantities() {
    for (std::size_t q = 1; q < path_quantities; ++q) {
        std::string why = "No path is planned.";
        for (const auto& result : results_) {
            why = path_quantity_missing(PathQuantity(q), *result);
            if (why.empty()) break;
        }
        layers_.set_quantity_missing(PathQuantity(q), text(why));
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
    viewport_.scene().set_path_tint(tint_);
    layers_.show_scale(tint_);
    viewport_.content_changed();
    viewport_.refresh();
}

std::size_t InspectionController::source() const {
    return std::size_t(std::max(0, panel_->operation_box()->currentIndex()));
}

void InspectionController::show_chart() {
    PlotView* plot = panel_->plot();
    chart_unit_ = document_.unit();
    drives_.clear();
    const auto nothing = [&](const QString& why) {
        plot->clear(why);
        panel_->readout()->set_text({});
        panel_->set_ready(false);
    };
    if (source() >= results_.size()) return nothing(tr("Plan an operation to see it here"));
    const OperationResult& result = *results_[source()];
    const QString name = text(result.name);
    const LengthUnit unit = document_.unit();
    const double per = mm_per(unit);
    const QString length_unit = text(unit_name(unit));
    PlotContent content;
    if (chart() == Chart::stepover) {
        std::map<int, Drive> drives;
        for (const Pass& pass : result.path.passes)
            drives.try_emplace(pass.drive, Drive{pass.offset, 0, pass.drive});
        const auto& motions = result.program.motions.motions;
        for (std::size_t m = motions.size(); m-- > 0;)
            if (motions[m].kind == MotionKind::cut && motions[m].pass < result.path.passes.size())
                drives[result.path.passes[motions[m].pass].drive].motion = m;
        for (const auto& [drive, values] : drives)
            drives_.push_back(values);
        std::sort(drives_.begin(), drives_.end(),
                  [](const Drive& a, const Drive& b) { return a.offset < b.offset; });
        if (drives_.size() < 2) {
            drives_.clear();
            return nothing(tr("“%1” has one pass only: there is no step-over").arg(name));
        }
        content.title = tr("%1: step-over along the part").arg(name);
        content.x_label = tr("Place of the pass across the travel (%1)").arg(length_unit);
        content.y_label = tr("Step-over (%1)").arg(length_unit);
        // From each pass to the next.
        PlotSeries steps{{}, {}, {}, none, none};
        for (std::size_t i = 0; i + 1 < drives_.size(); ++i) {
            const double step = (drives_[i + 1].offset - drives_[i].offset) / per;
            for (const std::size_t end : {i, i + 1}) {
                content.x.push_back(drives_[end].offset / per);
                steps.y.push_back(step);
            }
        }
        content.series.push_back(std::move(steps));
    } else {
        if (!result.program.multi_axis)
            return nothing(tr("“%1” cuts with three axes: no rotary axis moves").arg(name));
        if (source() >= figures_.size()) return nothing(tr("Following the path on the machine…"));
        const PathFigures& figures = *figures_[source()];
        const auto& rotary = figures.machine.rotary;
        if (rotary.empty())
            return nothing(tr("The machine “%1” has no rotary axis").arg(text(figures.machine.label)));
        const bool over_time = chart() == Chart::rotary_over_time;
        const bool minutes = !figures.elapsed.empty() && figures.elapsed.back() > longest_in_seconds;
        content.title = tr("%1 on %2: rotary axes").arg(name, text(figures.machine.label));
        content.x_label = over_time ? tr("Time (%1)").arg(minutes ? tr("min") : tr("s"))
                                    : tr("Way of the tool tip (%1)").arg(length_unit);
        content.y_label = tr("Angle (°)");
        content.marks_label = tr("turns back");
        const auto& along = over_time ? figures.elapsed : figures.length;
        const double scale = over_time ? (minutes ? 60.0 : 1.0) : per;
        for (const double v : along)
            content.x.push_back(v / scale);
        for (std::size_t r = 0; r < std::min<std::size_t>(rotary.size(), 2); ++r) {
            PlotSeries series{text(rotary[r].name), {}, figures.reversals[r], none, none};
            for (const double v : figures.rotary[r])
                series.y.push_back(degrees(v));
            const Travel& travel = rotary[r].travel;
            if (travel.lo > -infinity) series.low_limit = degrees(travel.lo);
            if (travel.hi < infinity) series.high_limit = degrees(travel.hi);
            if (travel.limited())
                series.name += tr(" (%1 to %2)")
                                   .arg(travel.lo > -infinity ? angle_text(series.low_limit, 0) : tr("any"),
                                        travel.hi < infinity ? angle_text(series.high_limit, 0) : tr("any"));
            content.series.push_back(std::move(series));
        }
    }
    plot->set_content(std::move(content));
    panel_->set_ready(true);
    show_place();
}

double InspectionController::x_of(const Place& place) const {
    const PlotContent& content = panel_->plot()->content();
    if (chart() == Chart::stepover) {
        const OperationResult& result = *results_[place.source];
        const Index pass = result.program.motions.motions[place.motion].pass;
        if (pass >= result.path.passes.size()) return none;
        return result.path.passes[pass].offset / mm_per(document_.unit());
    }
    if (place.motion >= content.x.size()) return none;
    const double to = content.x[place.motion], from = place.motion > 0 ? content.x[place.motion - 1] : to;
    return from + place.share * (to - from);
}

void InspectionController::show_place() {
    PlotView* plot = panel_->plot();
    if (plot->empty()) return;
    const bool here = place_ && place_->source == source();
    const double x = here ? x_of(*place_) : none;
    if (!std::isfinite(x)) {
        plot->set_cursor(std::nullopt);
        panel_->readout()->set_text({});
        return;
    }
    plot->set_cursor(x);
    const LengthUnit unit = document_.unit();
    if (chart() == Chart::stepover) {
        const auto& passes = results_[place_->source]->path.passes;
        const int drive =
            passes[results_[place_->source]->program.motions.motions[place_->motion].pass].drive;
        const auto at =
            std::find_if(drives_.begin(), drives_.end(), [&](const Drive& d) { return d.drive == drive; });
        QString line = tr("Pass %1 of %2").arg(drive + 1).arg(drives_.size());
        if (at != drives_.begin() && at != drives_.end())
            line += tr("   %1 to the one before").arg(shown_length(at->offset - (at - 1)->offset, unit, 4));
        if (at != drives_.end() && at + 1 != drives_.end())
            line += tr("   %1 to the next").arg(shown_length((at + 1)->offset - at->offset, unit, 4));
        panel_->readout()->set_text(line);
        return;
    }
    const PathFigures& figures = *figures_[source()];
    const std::size_t m = place_->motion, before = m > 0 ? m - 1 : m;
    const auto between = [&](const std::vector<double>& v) {
        return v[before] + place_->share * (v[m] - v[before]);
    };
    QString line = tr("GOTO %1   %2   %3")
                       .arg(count_text(m + 1), shown_length(between(figures.length), unit, 5),
                            duration_text(between(figures.elapsed)));
    for (std::size_t r = 0; r < 2 && !figures.rotary[r].empty(); ++r)
        if (const double v = between(figures.rotary[r]); std::isfinite(v))
            line +=
                QStringLiteral("   %1 %2").arg(text(figures.machine.rotary[r].name), angle_text(degrees(v)));
    panel_->readout()->set_text(line);
}

void InspectionController::place_shown(std::size_t source, std::size_t motion, double share) {
    if (source >= results_.size() || motion >= results_[source]->program.motions.motions.size())
        return tool_removed();
    place_ = Place{source, motion, share};
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
    if (!place_ || place_->source != source() || drives_.empty()) return;
    const double v = x_of(*place_) * mm_per(document_.unit());
    const auto at = std::lower_bound(drives_.begin(), drives_.end(), v - 1e-9,
                                     [](const Drive& d, double value) { return d.offset < value; });
    const auto next =
        std::clamp<std::ptrdiff_t>(at - drives_.begin() + by, 0, std::ptrdiff_t(drives_.size()) - 1);
    emit place_wanted(source(), drives_[std::size_t(next)].motion);
}

void InspectionController::go_to(double x) {
    if (source() >= results_.size() || panel_->plot()->empty()) return;
    if (chart() == Chart::stepover) {
        const double v = x * mm_per(document_.unit());
        const auto nearest =
            std::min_element(drives_.begin(), drives_.end(), [&](const Drive& a, const Drive& b) {
                return std::abs(a.offset - v) < std::abs(b.offset - v);
            });
        if (nearest != drives_.end()) emit place_wanted(source(), nearest->motion);
        return;
    }
    const auto& along = panel_->plot()->content().x;
    const auto after = std::lower_bound(along.begin(), along.end(), x);
    auto motion = std::size_t(std::min(after, along.end() - 1) - along.begin());
    if (motion > 0 && x - along[motion - 1] < along[motion] - x) --motion;
    emit place_wanted(source(), motion);
}

QString InspectionController::export_name() const {
    if (source() >= results_.size()) return {};
    return text(results_[source()]->name)
           + (chart() == Chart::stepover ? QStringLiteral("-stepover") : QStringLiteral("-axes"));
}

std::string InspectionController::table() const {
    const std::string unit(unit_name(document_.unit()));
    const double per = mm_per(document_.unit());
    const auto number = [](double v) { return std::isfinite(v) ? format_number(v, 9) : std::string(); };
    std::string lines;
    if (chart() == Chart::stepover) {
        lines = "pass,place_" + unit + ",stepover_to_next_" + unit + "\n";
        for (std::size_t i = 0; i < drives_.size(); ++i)
            lines += std::to_string(drives_[i].drive + 1) + "," + number(drives_[i].offset / per) + ","
                     + (i + 1 < drives_.size() ? number((drives_[i + 1].offset - drives_[i].offset) / per)
                                               : std::string())
                     + "\n";
        return lines;
    }
    const PathFigures& figures = *figures_[source()];
    const auto& motions = figures.operation->program.motions.motions;
    const std::size_t axes = figures.rotary[1].empty() ? 1 : 2;
    lines = "goto,kind,way_" + unit + ",time_s";
    for (std::size_t r = 0; r < axes; ++r)
        lines +=
            "," + figures.machine.rotary[r].name + "_deg," + figures.machine.rotary[r].name + "_turns_back";
    lines += "\n";
    std::array<std::size_t, 2> next{};
    for (std::size_t m = 0; m < motions.size(); ++m) {
        lines += std::to_string(m + 1) + "," + kind_name(motions[m].kind) + ","
                 + number(figures.length[m] / per) + "," + number(figures.elapsed[m]);
        for (std::size_t r = 0; r < axes; ++r) {
            const auto& turns = figures.reversals[r];
            const bool here = next[r] < turns.size() && turns[next[r]] == m;
            next[r] += here;
            lines += "," + number(degrees(figures.rotary[r][m])) + (here ? ",1" : ",0");
        }
        lines += "\n";
    }
    return lines;
}

bool InspectionController::save_picture(const QString& path) {
    if (panel_->plot()->empty()) return false;
    return report_written(path, write_picture(path, panel_->plot()->picture(picture_size)));
}

bool InspectionController::save_table(const QString& path) {
    if (panel_->plot()->empty()) return false;
    return report_written(path, write_table(path, table()));
}

void InspectionController::export_chart(bool table) {
    const QString path =
        ask_export_file(panel_, table ? tr("Export the chart's values") : tr("Export the chart"),
                        table ? ExportFormat::table : ExportFormat::picture, export_name());
    if (path.isEmpty()) return;
    if (table)
        save_table(path);
    else
        save_picture(path);
}

} // namespace facetmill::ui
