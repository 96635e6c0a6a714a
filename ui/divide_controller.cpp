#include "ui/divide_controller.h"

#include "core/base/units.h"
#include "core/job/axis_view.h"
#include "core/strategy/surface/slope_facets.h"
#include "ui/divide_bar.h"
#include "ui/elided_label.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace facetmill::ui {

namespace {

constexpr const char* divide_key = "divide";
/// One movement is one step of the history.
constexpr int divide_commit_ms = 400;

double degrees_of(double angle) {
    return angle * 180 / pi;
}

} // namespace

DivideController::DivideController(Document& document, Viewport& viewport, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), bar_(new DivideBar(window)) {
    bar_->hide();
    commit_.setSingleShot(true);
    commit_.setInterval(divide_commit_ms);
    connect(&commit_, &QTimer::timeout, this, &DivideController::commit);
    connect(bar_->slider(), &QSlider::valueChanged, this, &DivideController::moved);
    connect(bar_->slider(), &QSlider::sliderReleased, this, &DivideController::commit);
    connect(&job_, &BackgroundJob::ended, this, &DivideController::settled);
}

void DivideController::project_opened() {
    node_.reset();
    refresh();
}

void DivideController::node_chosen(const std::optional<TreeNode>& node) {
    if (node != node_ && commit_.isActive()) commit();
    node_ = node;
    refresh();
}

std::optional<std::size_t> DivideController::chosen() const {
    const auto display = viewport_.scene().part().display();
    const bool fits = node_ && node_->kind == TreeNode::Kind::operation
                      && node_->index < document_.operation_count() && document_.part_is_current() && display
                      && display->mesh == document_.part()->mesh
                      && document_.operation(node_->index).has(divide_key);
    return fits ? std::optional(node_->index) : std::nullopt;
}

void DivideController::refresh() {
    const auto operation = chosen();
    if (!operation) return hide();
    const Operation& o = document_.operation(*operation);
    const double divide = std::get<double>(o.get(divide_key));
    bar_->show();
    if (!commit_.isActive() && !bar_->slider()->isSliderDown()) {
        const QSignalBlocker quiet(bar_->slider());
        bar_->slider()->setValue(int(std::lround(degrees_of(divide))));
    }
    if (part_ != document_.part()->mesh || axis_ != o.tool_axis()) return find_slopes(*operation);
    if (slopes_ && !commit_.isActive()) show(divide);
}

void DivideController::find_slopes(std::size_t operation) {
    part_ = document_.part()->mesh;
    axis_ = document_.operation(operation).tool_axis();
    slopes_ = nullptr;
    shown_.reset();
    auto found = std::make_shared<Slopes>();
    job_.start(
        tr("Measuring slopes"),
        [found, part = part_, axis = axis_](const Progress& progress) {
            found->slope = facet_slopes(*part, false, turn_upright(axis), progress);
            found->area.resize(found->slope.size(), 0);
            for (std::size_t f = 0; f < found->slope.size(); ++f) {
                if (f % 8192 == 0) progress.check();
                if (!(found->slope[f] <= 0.5 * pi)) {
                    found->slope[f] = -infinity; // faces down: on neither side
                    continue;
                }
                found->area[f] = 0.5 * part->facet_cross(f).norm();
                found->all += found->area[f];
            }
        },
        [this, found, part = part_, axis = axis_](const JobEnd& end) {
            if (!end.done() || part != part_ || axis != axis_) return;
            slopes_ = found;
            refresh();
        });
}

void DivideController::show(double divide) {
    if (shown_ == divide) return;
    shown_ = divide;
    double steep = 0;
    std::vector<char> steeper(slopes_->slope.size()), others(slopes_->slope.size());
    for (std::size_t f = 0; f < steeper.size(); ++f) {
        steeper[f] = slopes_->slope[f] > divide;
        others[f] = slopes_->slope[f] >= 0 && !steeper[f];
        if (steeper[f]) steep += slopes_->area[f];
    }
    const double share = slopes_->all > 0 ? steep / slopes_->all : 0;
    bar_->readout()->set_text(
        tr("%1°: %2 % is steep").arg(degrees_of(divide), 0, 'f', 0).arg(100 * share, 0, 'f', 0));
    tint(std::move(steeper), std::move(others));
}

void DivideController::tint(std::vector<char> steep, std::vector<char> shallow) {
    viewport_.scene().boundaries().set(BoundaryRole::steep, std::move(steep));
    viewport_.scene().boundaries().set(BoundaryRole::shallow, std::move(shallow));
    viewport_.refresh();
}

void DivideController::hide() {
    commit_.stop();
    bar_->hide();
    if (shown_) tint({}, {});
    shown_.reset();
}

void DivideController::moved(int degrees) {
    if (!chosen() || !slopes_) return;
    show(radians(degrees));
    commit_.start();
}

void DivideController::commit() {
    commit_.stop();
    const auto operation = chosen();
    if (!operation || bar_->slider()->isSliderDown()) return; // once it is let go
    const double divide = radians(bar_->slider()->value());
    const double known = std::get<double>(document_.operation(*operation).get(divide_key));
    if (std::lround(degrees_of(known)) == bar_->slider()->value()) return refresh();
    document_.change(tr("Divide by slope"),
                     [&](Project& p) { p.operations.at(*operation)->set(divide_key, divide); });
}

} // namespace facetmill::ui
