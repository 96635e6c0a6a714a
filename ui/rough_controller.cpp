#include "ui/rough_controller.h"

#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "ui/elided_label.h"
#include "ui/rough_bar.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr int typing_ms = 150;
/// Frames stand out of the stock by this share of its size.
constexpr double outside = 0.01;

QString range_text(double least, double most, LengthUnit unit) {
    const QString high = shown_length(most, unit, 3), low = shown_length(least, unit, 3);
    return low == high ? high : RoughController::tr("%1 to %2").arg(low, high);
}

/// Smallest and largest distance between neighbours; none: 0.
std::pair<double, double> depths(const std::vector<double>& heights) {
    double least = infinity, most = 0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        least = std::min(least, heights[i - 1] - heights[i]);
        most = std::max(most, heights[i - 1] - heights[i]);
    }
    return {std::min(least, most), most};
}

} // namespace

RoughController::RoughController(Document& document, Viewport& viewport, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), bar_(new RoughBar(window)) {
    bar_->hide();
    timer_.setSingleShot(true);
    timer_.setInterval(typing_ms);
    connect(&timer_, &QTimer::timeout, this, [this] {
        if (const auto i = document_.index_of(id_)) start_preview(*i);
    });
    connect(bar_->slider(), &QSlider::valueChanged, this, [this](int value) {
        chosen_ = value - 1;
        show_levels();
        if (planned_) emit layer_changed();
    });
    connect(&job_, &BackgroundJob::ended, this, &RoughController::settled);
}

void RoughController::node_chosen(const std::optional<TreeNode>& node) {
    node_ = node;
    refresh();
}

int RoughController::layer_of(int operation_id) const {
    return planned_ && operation_id == id_ ? chosen_ : -1;
}

void RoughController::clear() {
    timer_.stop();
    job_.cancel();
    id_ = 0;
    fingerprint_.clear();
    const bool alone = planned_ && chosen_ >= 0;
    planned_ = false;
    heights_.clear();
    chosen_ = -1;
    bar_->hide();
    viewport_.scene().levels().set(std::nullopt);
    viewport_.refresh();
    if (alone) emit layer_changed();
}

void RoughController::refresh() {
    const bool on_operation = node_ && node_->kind == TreeNode::Kind::operation
                              && node_->index < document_.operation_count() && document_.part_is_current()
                              && document_.has_stock();
    if (!on_operation || !document_.operation(node_->index).has_layer_preview()) {
        if (id_ != 0) clear();
        return;
    }
    const std::size_t i = node_->index;
    if (document_.operation_id(i) != id_) {
        if (id_ != 0) clear();
        id_ = document_.operation_id(i);
    }
    const auto result = document_.result(i);
    const bool planned = result && document_.state(i) == OperationState::planned;
    // The results before it decide where the stock's top is.
    std::string fingerprint = planned ? "planned " : "preview ";
    for (std::size_t k = 0; k <= i; ++k)
        fingerprint += Document::fingerprint(document_.project(), k)
                       + (document_.state(k) == OperationState::planned ? "|planned|" : "|");
    fingerprint += unit_name(document_.unit());
    if (fingerprint == fingerprint_) return;
    fingerprint_ = std::move(fingerprint);
    const bool alone = planned_ && chosen_ >= 0;
    planned_ = planned;
    if (!planned) {
        if (alone) emit layer_changed();
        timer_.start();
        return;
    }
    timer_.stop();
    job_.cancel();
    const LengthUnit unit = document_.unit();
    const StrategyResult& path = result->path;
    const std::vector<double>& layers = path.as<RoughPath>()->layers;
    const auto [least, most] = depths(layers);
    QString all = tr("%1 layers", nullptr, int(layers.size())).arg(count_text(layers.size()));
    if (most > 0) all += tr(", %1 deep").arg(range_text(least, most, unit));
    all += tr("; at most %1 stays above the allowance").arg(shown_length(path.cusp_max, unit, 3));
    take(layers, document_.part()->box, all);
    if (alone) emit layer_changed();
}

void RoughController::start_preview(std::size_t i) {
    auto preview = std::make_shared<LayerPreview>();
    auto wrong = std::make_shared<QString>();
    std::vector<std::shared_ptr<const OperationResult>> before;
    for (std::size_t k = 0; k < i; ++k)
        if (document_.state(k) == OperationState::planned) before.push_back(document_.result(k));
    job_.start(
        tr("Choosing layers"),
        [=, project = std::make_shared<Project>(document_.project()),
         part = document_.part()](const Progress& progress) {
            try {
                *preview = project->operations.at(i)->preview_layers(
                    preview_context(*project, i, *part, before), progress);
            } catch (const Error& e) {
                *wrong = with_lengths_in(sentence(worded(e.message())), project->unit);
            }
        },
        [=, this, id = id_, fingerprint = fingerprint_](const JobEnd& end) {
            if (!end.done() || id != id_ || fingerprint != fingerprint_) return;
            const LengthUnit unit = document_.unit();
            QString all = *wrong;
            if (wrong->isEmpty()) {
                all = tr("Preview: %1 layers", nullptr, int(preview->heights.size()))
                          .arg(count_text(preview->heights.size()));
                all += tr(", %1 deep; at most %2 would stay above the allowance")
                           .arg(range_text(preview->depth_min, preview->depth_max, unit),
                                shown_length(preview->remaining, unit, 3));
            }
            take(preview->heights, document_.part()->box, all);
        });
}

void RoughController::take(std::vector<double> heights, const Box3& box, const QString& all) {
    const bool same_count = heights.size() == heights_.size();
    heights_ = std::move(heights);
    box_ = box;
    const StockSpec& stock = document_.project().stock;
    if (document_.has_stock()) box_.add(stock_solid(stock, *document_.part()).box);
    const Vec3 out = outside * box_.size();
    box_.lo -= out;
    box_.hi += out;
    all_ = all;
    if (!same_count) chosen_ = -1;
    {
        const QSignalBlocker quiet(bar_->slider());
        bar_->slider()->setRange(0, int(heights_.size()));
        bar_->slider()->setValue(chosen_ + 1);
        bar_->slider()->setEnabled(!heights_.empty());
    }
    bar_->show();
    show_levels();
}

void RoughController::show_levels() {
    // The path tells where its layers are.
    LevelMarks marks{box_, planned_ ? std::vector<double>() : heights_, std::nullopt};
    QString line = all_;
    if (chosen_ >= 0 && std::size_t(chosen_) < heights_.size()) {
        const auto k = std::size_t(chosen_);
        if (planned_) marks.heights.assign(1, heights_[k]);
        marks.chosen = planned_ ? 0 : k;
        line = tr("Layer %1 of %2, z %3")
                   .arg(k + 1)
                   .arg(heights_.size())
                   .arg(shown_length(heights_[k], document_.unit(), 5));
        if (k > 0)
            line += tr(", %1 deep").arg(shown_length(heights_[k - 1] - heights_[k], document_.unit(), 3));
        if (!planned_) line += tr(" (preview)");
    }
    bar_->readout()->set_text(line);
    viewport_.scene().levels().set(marks.heights.empty() ? std::nullopt : std::optional(marks));
    viewport_.refresh();
}

} // namespace facetmill::ui
