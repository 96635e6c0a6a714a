#include "ui/region_controller.h"

#include "core/strategy/global_local/rework_plan.h"
#include "ui/language.h"
#include "ui/parameter_form.h"
#include "ui/properties_panel.h"
#include "ui/region_dialog.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QScreen>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr int wait_ms = 150, commit_ms = 400;

std::array<double, 3> triple(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// The edits of an operation after one of its regions was edited. `found_edits`: those that the region was
/// found with.
std::vector<RegionEdit> with_region_edited(std::vector<RegionEdit> edits, const ReworkRegion& region,
                                           const std::vector<RegionEdit>& found_edits,
                                           const std::function<void(RegionEdit&)>& edit) {
    std::vector<RegionEdit> own;
    for (const Vec3& place : region.places) {
        RegionEdit e{triple(place), region.strip.enabled, region.grow};
        // Edited again before the regions were found anew.
        for (const RegionEdit& known : edits)
            if (known.place == e.place) e = known;
        edit(e);
        own.push_back(e);
    }
    std::erase_if(edits, [&](const RegionEdit& e) {
        const bool about = std::any_of(region.edits.begin(), region.edits.end(), [&](std::size_t k) {
            return k < found_edits.size() && found_edits[k] == e;
        });
        return about || std::any_of(own.begin(), own.end(), [&](const RegionEdit& mine) {
                   return mine.place == e.place;
               });
    });
    for (const RegionEdit& e : own)
        if (!e.enabled || e.grow != 0) edits.push_back(e);
    return edits;
}

void add_drag(Operation& operation, const BoundaryDrag& drag) {
    std::vector<BoundaryDrag> drags = boundary_drag_list.of(operation);
    drags.push_back(drag);
    boundary_drag_list.set(operation, drags);
}

/// Puts the dialog beside the middle of its window, so that the view stays in sight.
void place_beside_view(QWidget& dialog) {
    const QWidget* window = dialog.parentWidget();
    const QRect screen = window->screen()->availableGeometry(), frame = window->frameGeometry();
    dialog.resize(dialog.sizeHint().boundedTo(screen.size() - QSize(0, 40)));
    const int x = std::min(frame.right() + 1 - dialog.width(), screen.right() + 1 - dialog.width());
    const int y = std::min(frame.top() + 60, screen.bottom() + 1 - dialog.height());
    dialog.move(std::max(screen.left(), x), std::max(screen.top(), y));
}

/// What the dialog says of the regions that were found, above their list.
QString regions_text(const ReworkRegions& r, const OperationResult* planned) {
    const auto off = std::count_if(r.regions.begin(), r.regions.end(),
                                   [](const ReworkRegion& region) { return !region.strip.enabled; });
    QString status =
        RegionController::tr("%1 regions", nullptr, int(r.regions.size())).arg(count_text(r.regions.size()));
    if (off > 0) status += RegionController::tr(", %1 switched off").arg(off);
    const auto percent = [](const ReworkRegions& of) {
        return number_text(of.part_area > 0 ? 100 * of.area / of.part_area : 0, 2);
    };
    status +=
        RegionController::tr("; rework covers %1 of the surface").arg(percent(r) + QStringLiteral(" %"));
    if (r.uncut_area >= 0.98 * r.part_area)
        return RegionController::tr(
            "This lead limit leaves the whole part uncut: raise it, or take a smaller tool.");
    // What the main path leaves is known when it is planned, and is in the report.
    const auto* path = planned ? planned->path.as<GlobalLocalPath>() : nullptr;
    if (!path) return status;
    const ReworkRegions& p = path->rework->regions;
    if (p.regions.size() == r.regions.size() && percent(p) == percent(r)) return status;
    return RegionController::tr("Before planning: %1. As planned, where the paths were looked at: %2, %3 %")
        .arg(status)
        .arg(p.regions.size())
        .arg(percent(p));
}

} // namespace

/// What one look came to.
struct RegionController::Found {
    std::shared_ptr<RegionPreview::Result> result;
    StripDisplayPtr display;
    std::string where; ///< the parameter that is wrong
    QString wrong;     ///< empty: nothing is
};

RegionController::RegionController(Document& document, Viewport& viewport, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), dialog_(new RegionDialog(window)) {
    wait_timer_.setSingleShot(true);
    wait_timer_.setInterval(wait_ms);
    connect(&wait_timer_, &QTimer::timeout, this, &RegionController::look);
    commit_timer_.setSingleShot(true);
    commit_timer_.setInterval(commit_ms);
    connect(&commit_timer_, &QTimer::timeout, this, &RegionController::commit);

    connect(dialog_, &RegionDialog::edited, this, &RegionController::try_value);
    connect(dialog_, &RegionDialog::finished_editing, this, &RegionController::commit);
    connect(dialog_, &RegionDialog::lead_wanted, this, [this](double lead) {
        try_value("lead_limit", lead);
        commit_timer_.start();
    });
    connect(dialog_, &RegionDialog::lead_chosen, this, [this](double lead) {
        try_value("lead_limit", lead);
        commit();
    });
    connect(dialog_, &RegionDialog::region_switched, this, [this](std::size_t region, bool on) {
        edit_region(on ? tr("Switch region on") : tr("Switch region off"), region,
                    [on](RegionEdit& e) { e.enabled = on; });
    });
    connect(dialog_, &RegionDialog::region_grown, this, [this](std::size_t region, double grow) {
        edit_region(tr("Grow region"), region, [grow](RegionEdit& e) { e.grow = grow; });
    });
    connect(dialog_, &RegionDialog::region_chosen, this, [this](std::optional<std::size_t> region) {
        viewport_.scene().strips().choose(region);
        viewport_.refresh();
    });
    connect(dialog_, &RegionDialog::edits_dropped, this, [this] {
        change(tr("Drop region edits"), [](Operation& o) {
            region_edit_list.set(o, {});
            boundary_drag_list.set(o, {});
        });
    });
    connect(dialog_, &RegionDialog::closed, this, &RegionController::close);

    connect(&viewport_, &Viewport::handle_dragged, this, [this](const Vec3& from, const Vec3& to) {
        if (!operation()) return;
        drag_ = BoundaryDrag{triple(from), triple(to)};
        viewport_.scene().marks().set_marker(Marker{to, Vec3::Zero()});
        viewport_.refresh();
        wait_timer_.start();
    });
    connect(&viewport_, &Viewport::handle_dropped, this, [this](const Vec3& from, const Vec3& to) {
        drag_.reset();
        viewport_.scene().marks().set_marker(std::nullopt);
        viewport_.refresh();
        if (from != to)
            change(tr("Drag boundary point"), [&](Operation& o) { add_drag(o, {triple(from), triple(to)}); });
        refresh();
    });
    connect(&job_, &BackgroundJob::started, this, [this](const QString&) {
        if (id_ != 0) dialog_->set_busy(true);
    });
    connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, const QString& label) {
        if (id_ != 0) dialog_->set_busy(true, fraction, label);
    });
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (!job_.running()) dialog_->set_busy(false);
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
}

RegionController::~RegionController() {
    dialog_->disconnect(this);
    delete dialog_;
}

void RegionController::project_opened() {
    dialog_->hide();
    preview_.reset();
    refresh();
}

bool RegionController::take_part_pick(const PartPick& pick) {
    if (!found_ || !document_.part()) return false;
    std::vector<const Strip*> strips;
    for (const auto& region : found_->found.regions.regions)
        strips.push_back(&region.strip);
    if (const auto at = strip_at(pick.point, strips, document_.part()->box.diagonal())) dialog_->choose(at);
    return false;
}

bool RegionController::busy() const {
    return wait_timer_.isActive() || commit_timer_.isActive() || job_.running();
}

std::optional<std::size_t> RegionController::operation() const {
    if (id_ == 0) return std::nullopt;
    const auto i = document_.index_of(id_);
    return i && document_.operation(*i).rework() ? i : std::nullopt;
}

void RegionController::open(std::size_t i) {
    if (i >= document_.operation_count() || !document_.operation(i).rework()) return;
    commit();
    if (id_ != document_.operation_id(i)) {
        found_.reset();
        dialog_->clear_advice(tr("Comparing tools and limits…"));
    }
    id_ = document_.operation_id(i);
    key_.clear();
    if (!dialog_->isVisible()) place_beside_view(*dialog_);
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    emit wanted();
    refresh();
}

void RegionController::close() {
    commit();
    id_ = 0;
    values_.clear();
    drag_.reset();
    key_.clear();
    found_.reset();
    wait_timer_.stop();
    commit_timer_.stop();
    job_.cancel();
    viewport_.scene().strips().set_handles(false);
    viewport_.scene().strips().choose(std::nullopt);
    planned_.clear();
    show_display(nullptr);
    refresh();
    emit ended();
    emit settled();
}

void RegionController::node_chosen(const std::optional<TreeNode>& node) {
    node_ = node;
    refresh();
}

Project RegionController::tried() const {
    Project project = document_.project();
    const auto i = operation();
    if (!i) return project;
    Operation& operation = *project.operations[*i];
    for (const auto& [key, value] : values_)
        operation.set(key, value);
    if (drag_) add_drag(operation, *drag_);
    return project;
}

std::string RegionController::key_of(const Project& project, std::size_t i) const {
    return Document::fingerprint(project, i) + std::string(unit_name(project.unit));
}

void RegionController::try_value(const std::string& key, const ParameterValue& value) {
    if (!operation()) return;
    values_[key] = value;
    wait_timer_.start();
}

void RegionController::commit() {
    commit_timer_.stop();
    if (values_.empty()) return;
    const auto values = std::exchange(values_, {});
    const auto i = operation();
    if (!i) return;
    const Operation& now = document_.operation(*i);
    if (std::all_of(values.begin(), values.end(),
                    [&](const auto& v) { return now.get(v.first) == v.second; }))
        return refresh();
    const QString what =
        values.size() == 1
            ? tr("Edit %1").arg(in_a_sentence(worded(now.parameter(values.begin()->first).label)))
            : tr("Edit region settings");
    document_.change(what, [&](Project& p) {
        for (const auto& [key, value] : values)
            p.operations.at(*i)->set(key, value);
    });
}

void RegionController::change(const QString& what, const std::function<void(Operation&)>& edit) {
    commit();
    const auto i = operation();
    if (!i) return;
    try {
        document_.change(what, [&](Project& p) { edit(*p.operations.at(*i)); });
    } catch (const Error& e) {
        dialog_->show_problem({}, failure_text(e));
    }
}

void RegionController::edit_region(const QString& what, std::size_t region,
                                   const std::function<void(RegionEdit&)>& edit) {
    if (!found_ || region >= found_->found.regions.regions.size()) return;
    const auto found = found_; // stays while it is replaced
    const ReworkRegion& r = found->found.regions.regions[region];
    change(what, [&](Operation& o) {
        region_edit_list.set(o, with_region_edited(region_edit_list.of(o), r, found_edits_, edit));
    });
}

void RegionController::refresh() {
    const auto i = operation();
    if (id_ != 0 && !i) {
        dialog_->hide(); // the operation is gone; comes back here
        return;
    }
    if (!i) return show_planned();
    const Project project = tried();
    dialog_->show_settings(*project.operations[*i], project.unit, tool_choices(project, true));
    const GlobalLocalSettings& kept = *document_.operation(*i).rework();
    dialog_->set_edited(!kept.region_edits.empty() || !kept.boundary_drags.empty());
    if (!document_.part_is_current() || !document_.has_stock()) {
        dialog_->show_no_regions(tr("The part is being read…"));
        key_.clear();
        return;
    }
    if (key_of(project, *i) != key_) wait_timer_.start();
}

/// Finds the regions of what stands in the dialog.
void RegionController::look() {
    const auto i = operation();
    if (!i || !document_.part_is_current()) return;
    auto project = std::make_shared<Project>(tried());
    const std::string key = key_of(*project, *i);
    if (key == key_) return;
    key_ = key;
    if (!preview_) preview_ = std::make_shared<RegionPreview>();
    auto found = std::make_shared<Found>();
    job_.start(
        tr("Finding rework regions"),
        [=, place = *i, part = document_.part(), preview = preview_](const Progress& progress) {
            try {
                found->result = std::make_shared<RegionPreview::Result>(
                    preview->find(*project, place, *part, progress.part(0, 0.95)));
                std::vector<Strip> strips;
                for (const ReworkRegion& r : found->result->found.regions.regions)
                    strips.push_back(r.strip);
                found->display = prepare_strip_display(strips, project->unit, progress.part(0.95, 1));
            } catch (const Error& e) {
                found->where = e.where();
                found->wrong = with_lengths_in(failure_text(e), project->unit);
            }
        },
        [=, this, place = *i](const JobEnd& end) {
            if (key != key_ || id_ == 0) return;
            if (!end.done()) {
                key_.clear();
                if (end.how == JobEnd::How::failed) dialog_->show_problem({}, sentence(end.message));
                return;
            }
            found_edits_ = project->operations[place]->rework()->region_edits;
            take(*found);
        });
}

void RegionController::take(const Found& found) {
    const auto i = operation();
    if (!i) return;
    found_ = found.result;
    dialog_->show_problem(found.where, found.wrong);
    show_display(found.display);
    viewport_.scene().strips().set_handles(true);
    if (!found_) {
        dialog_->show_no_regions(tr("There are no regions while a value is not right."));
        dialog_->clear_advice(tr("Nothing can be compared while a value is not right."));
        return;
    }
    const ReworkRegions& r = found_->found.regions;
    const Project project = tried();
    const GlobalLocalSettings& settings = *project.operations[*i]->rework();
    if (r.regions.empty()) {
        dialog_->show_no_regions(
            tr("No place needs a lead above %1°: the main path cuts all of the part, there "
               "is nothing to rework.")
                .arg(number_text(degrees(settings.lead_limit), 3)));
    } else {
        const bool as_planned = values_.empty() && !drag_ && document_.state(*i) == OperationState::planned;
        dialog_->show_regions(r.regions, regions_text(r, as_planned ? document_.result(*i).get() : nullptr));
    }
    double diameter = 0;
    try {
        diameter = project.tool_of(*project.operations[*i]).diameter;
    } catch (const Error&) {
    }
    dialog_->show_advice(found_->advice, diameter, settings.lead_limit);
    viewport_.scene().strips().choose(dialog_->chosen());
    viewport_.refresh();
}

void RegionController::give_way(bool on) {
    if (std::exchange(gives_way_, on) == on || on) return;
    viewport_.scene().strips().set(display_);
    viewport_.refresh();
}

void RegionController::show_display(StripDisplayPtr display) {
    if (display == display_) return;
    const bool first = !display_ || display_->strips.empty();
    display_ = std::move(display);
    if (gives_way_ && id_ == 0) return;
    viewport_.scene().strips().set(display_);
    if (first && display_)
        viewport_.content_changed();
    else
        viewport_.refresh();
}

/// The regions of the selected operation, where it has any; otherwise of all.
void RegionController::show_planned() {
    std::vector<std::shared_ptr<const OperationResult>> results;
    for (std::size_t i = 0; i < document_.operation_count(); ++i) {
        const auto result = document_.result(i);
        if (!result || result->path.strips.empty()) continue;
        if (node_ && node_->kind == TreeNode::Kind::operation && node_->index == i) {
            results.assign(1, result);
            break;
        }
        results.push_back(result);
    }
    const LengthUnit unit = document_.unit();
    if (results == planned_ && (results.empty() || unit == planned_unit_)) return;
    planned_ = results;
    planned_unit_ = unit;
    if (results.empty()) {
        job_.cancel();
        show_display(nullptr);
        return;
    }
    auto display = std::make_shared<StripDisplayPtr>();
    job_.start(
        tr("Drawing regions"),
        [=](const Progress& progress) {
            std::vector<Strip> strips;
            for (const auto& result : results)
                strips.insert(strips.end(), result->path.strips.begin(), result->path.strips.end());
            *display = prepare_strip_display(strips, unit, progress);
        },
        [=, this](const JobEnd& end) {
            if (end.done() && id_ == 0 && results == planned_) show_display(*display);
        });
}

} // namespace facetmill::ui
