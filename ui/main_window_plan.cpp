// Planning and showing what was planned.
#include "ui/main_window.h"

#include "core/job/stock_solid.h"
#include "ui/cspace_controller.h"
#include "ui/elided_label.h"
#include "ui/inspection_controller.h"
#include "ui/layer_bar.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/region_controller.h"
#include "ui/rough_controller.h"
#include "ui/strip_controller.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/unrolled_controller.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <algorithm>

namespace facetmill::ui {

/// One planning job: what it plans from, and what it came to.
struct MainWindow::PlanWork {
    Project project;
    std::vector<std::size_t> wanted; ///< places of the operations
    std::vector<int> ids;            ///< their ids in the document
    std::vector<OperationOutcome> outcomes;
    LoadedPart part; ///< only when the part had to be read again
    bool read_part = false;
};

MainWindow::LoadedPart MainWindow::load_part(Planner& planner, const Project& project,
                                             const Progress& progress) {
    LoadedPart loaded;
    loaded.key = Document::part_key(project); // before: a file that changes meanwhile is read again
    const Progress reading = progress.part(0, 0.7, "Reading the part");
    try {
        loaded.part = planner.prepare(project, reading);
    } catch (const Error& e) {
        // Without its stock a part can be seen, though not planned.
        if (project.stock.kind != StockSpec::Kind::mesh) throw;
        Project alone = project;
        alone.stock = StockSpec();
        loaded.part = planner.prepare(alone, reading);
        loaded.stock_failure = text(e.what());
    }
    loaded.display = prepare_part_display(loaded.part->mesh, progress.part(0.7, 0.9, "Preparing the view"));
    if (loaded.part->stock_mesh)
        loaded.stock = make_stock_shape(stock_solid(project.stock, *loaded.part), progress.part(0.9, 1));
    return loaded;
}

void MainWindow::reload_part() {
    if (!document_.has_part()) return;
    const bool first = !document_.part();
    auto loaded = std::make_shared<LoadedPart>();
    job_.start(
        tr("Reading %1").arg(elided(path_text(document_.project().part_path().filename()), 30)),
        [loaded, project = document_.project(), planner = planner_](const Progress& p) {
            *loaded = load_part(*planner, project, p);
        },
        [this, loaded, first](const JobEnd& end) {
            if (end.done()) show_part(*loaded, first);
        });
}

void MainWindow::show_part(const LoadedPart& loaded, bool new_view) {
    viewport_->scene().set_part(loaded.display);
    viewport_->content_changed();
    stock_mesh_ = loaded.stock;
    document_.set_part(loaded.part, loaded.key);
    show_stock();
    if (!loaded.stock_failure.isEmpty()) tell(MessageBar::Kind::warning, sentence(loaded.stock_failure));
    if (new_view)
        viewport_->set_view(StandardView::iso);
    else
        viewport_->refresh();
}

void MainWindow::show_stock() {
    const auto& part = document_.part();
    const StockSpec& stock = document_.project().stock;
    StockShapePtr shape;
    if (part && stock.kind == StockSpec::Kind::mesh)
        shape = stock_mesh_;
    else if (part)
        shape = make_stock_shape(stock_solid(stock, *part), {});
    viewport_->scene().set_stock_shape(shape);
}

void MainWindow::verify() {
    if (job_.running() || !document_.has_part()) return;
    if (properties_->commit() && controller_->can_verify()) {
        message_->dismiss();
        controller_->verify();
        return;
    }
    plan(); // or says why it cannot
    verify_next_ = job_.running();
}

void MainWindow::plan(std::optional<std::size_t> only) {
    if (job_.running() || !document_.has_part()) return;
    if (!properties_->commit()) {
        tell(MessageBar::Kind::warning, tr("A parameter is not valid: correct it, then plan."));
        return;
    }
    regions_->commit();
    if (document_.operation_count() == 0) {
        tell(MessageBar::Kind::warning, tr("There is no operation to plan: add one below the project tree."));
        return;
    }
    auto work = std::make_shared<PlanWork>();
    work->project = document_.project();
    for (std::size_t i = 0; i < document_.operation_count(); ++i)
        if (!only || *only == i) {
            work->wanted.push_back(i);
            work->ids.push_back(document_.operation_id(i));
        }
    work->read_part = !document_.part_is_current() || !document_.has_stock();
    message_->dismiss();
    document_.set_planning(work->ids);
    job_.start(
        tr("Planning"),
        [work, planner = planner_](const Progress& progress) {
            double from = 0;
            if (work->read_part) {
                work->part = load_part(*planner, work->project, progress.part(0, 0.2));
                from = 0.2;
            }
            check_project(work->project);
            const double share = (1 - from) / double(work->wanted.size());
            for (std::size_t k = 0; k < work->wanted.size(); ++k) {
                const std::size_t i = work->wanted[k];
                const std::string name = work->project.operations[i]->common().name;
                OperationOutcome outcome;
                outcome.id = work->ids[k];
                outcome.fingerprint = Document::fingerprint(work->project, i);
                try {
                    const auto result = planner->plan(
                        work->project, name,
                        progress.part(from + share * double(k), from + share * double(k + 1), name));
                    outcome.result = result->operations.at(0);
                } catch (const Error& e) {
                    // The other operations may still be planned. Names and places stay as they are.
                    const LengthUnit unit = work->project.unit;
                    const auto in_unit = [unit](const std::string& s) {
                        return utf8(with_lengths_in(text(s), unit));
                    };
                    outcome.failure =
                        text(Error(e.code(), e.where(), in_unit(e.message()), in_unit(e.remedy())).what());
                }
                work->outcomes.push_back(std::move(outcome));
            }
        },
        [this, work](const JobEnd& end) { planned(work, end); });
}

void MainWindow::planned(const std::shared_ptr<PlanWork>& work, const JobEnd& end) {
    document_.set_planning({});
    const bool verify_now = std::exchange(verify_next_, false);
    if (!end.done()) return; // nothing was taken over: the states are what they were
    if (work->read_part && Document::part_key(document_.project()) == work->part.key)
        show_part(work->part, false);
    // Operations that were removed in the meantime are forgotten.
    std::erase_if(work->outcomes, [this](const OperationOutcome& o) { return !document_.index_of(o.id); });
    document_.take(work->outcomes);
    QStringList failures;
    if (document_.part())
        for (const std::string& warning :
             stock_warnings(document_.project().stock, *document_.part(), document_.unit()))
            tell(MessageBar::Kind::warning, text(warning), false);
    for (const OperationOutcome& o : work->outcomes) {
        const QString name = text(document_.operation(*document_.index_of(o.id)).common().name);
        if (!o.result) {
            failures << (o.failure.contains(name) ? o.failure : name + QStringLiteral(": ") + o.failure);
            continue;
        }
        for (const auto& program : programs_of(o.result)) {
            const QString program_name = text(program->name);
            tell(MessageBar::Kind::information,
                 tr("Planned “%1” in %2: %3 passes, cut length %4, machining time %5.")
                     .arg(program_name, duration_text(program->seconds_planning),
                          count_text(std::size_t(program->path.drive_planes)),
                          shown_length(program->totals.cut_length, document_.unit(), 5),
                          duration_text(program->totals.time_seconds)),
                 false);
            for (const std::string& warning : program->warnings())
                tell(MessageBar::Kind::warning,
                     program_name + QStringLiteral(": ") + with_lengths_in(text(warning), document_.unit()),
                     false);
        }
    }
    if (failures.isEmpty())
        last_failure_.clear();
    else
        fail(failures.join(QChar('\n')));
    // The report of what was planned is what one wants to see now.
    const auto node = tree_->selected();
    const bool on_operation = node && node->kind == TreeNode::Kind::operation;
    if (!on_operation && !work->wanted.empty())
        tree_->select({TreeNode::Kind::operation, work->wanted.front()});
    if (verify_now) controller_->verify(); // unless an operation failed: then that is what was said
}

void MainWindow::select_last_operation() {
    if (const std::size_t n = document_.operation_count(); n > 0)
        tree_->select({TreeNode::Kind::operation, n - 1});
}

void MainWindow::refresh_paths() {
    std::vector<std::shared_ptr<const OperationResult>> results;
    std::vector<int> ids;
    for (std::size_t i = 0; i < document_.operation_count(); ++i)
        if (const auto result = document_.result(i))
            for (const auto& program : programs_of(result)) {
                results.push_back(program);
                ids.push_back(document_.operation_id(i));
            }
    layers_->box(ViewLayer::others)->setVisible(!ids.empty() && ids.front() != ids.back());
    if (results == shown_results_) {
        shown_ids_ = ids;
        return;
    }
    shown_results_ = results;
    shown_ids_ = ids;
    hide_tool();
    if (results.empty()) {
        display_job_.cancel();
        drawn_results_.clear();
        viewport_->scene().set_path(nullptr);
        inspection_->set_paths({});
        unrolled_->set_paths({});
        strips_->set_paths({}, {});
        viewport_->refresh();
        return;
    }
    draw_paths();
}

std::optional<int> MainWindow::shown_alone() const {
    const auto node = tree_->selected();
    if (layers_->shown(ViewLayer::others) || !node
        || (node->kind != TreeNode::Kind::operation && node->kind != TreeNode::Kind::stock_after)
        || node->index >= document_.operation_count())
        return std::nullopt;
    const int id = document_.operation_id(node->index);
    if (std::find(shown_ids_.begin(), shown_ids_.end(), id) == shown_ids_.end()) return std::nullopt;
    return id;
}

std::vector<PathSource> MainWindow::path_sources() const {
    std::vector<PathSource> sources;
    for (std::size_t i = 0; i < shown_results_.size(); ++i)
        sources.push_back(path_source(shown_results_[i], rough_->layer_of(shown_ids_[i])));
    const std::optional<int> alone = shown_alone();
    for (std::size_t i = 0; alone && i < sources.size(); ++i)
        sources[i].hidden = shown_ids_[i] != *alone;
    // Beside a layer alone nothing of the others.
    if (std::any_of(sources.begin(), sources.end(), [](const PathSource& s) { return s.layer >= 0; }))
        for (PathSource& s : sources)
            s.hidden = s.layer < 0;
    return sources;
}

/// Draws the paths, of the layers that are chosen, in the background; what lists and charts them follows.
void MainWindow::draw_paths(bool keep_tool) {
    drawn_alone_ = shown_alone();
    if (shown_results_.empty()) return;
    auto display = std::make_shared<PathDisplayPtr>();
    display_job_.start(
        tr("Drawing the path"),
        [display, sources = path_sources()](const Progress& p) {
            *display = prepare_path_display(sources, p);
        },
        [this, display, keep_tool, results = shown_results_](const JobEnd& end) {
            if (!end.done() || results != shown_results_) return;
            viewport_->scene().set_path(*display);
            viewport_->content_changed();
            const bool other_layers = results == drawn_results_;
            drawn_results_ = results;
            if (other_layers) {
                inspection_->set_shown((*display)->sources);
                if (!keep_tool
                    || (!controller_->engaged()
                        && !(tool_at_
                             && (*display)->sources[tool_at_->source].shows_motion(motion_of(*tool_at_)))))
                    show_start_of_path();
                return;
            }
            inspection_->set_paths(results);
            if (drawn_alone_) inspection_->set_shown((*display)->sources);
            unrolled_->set_paths(results);
            offer_unrolled();
            show_start_of_path();
            strips_->set_paths(results, shown_ids_);
            offer_strips();
        });
}

void MainWindow::show_start_of_path() {
    std::vector<PathSource> sources = path_sources();
    // That of a layer that is drawn alone goes before the others.
    std::size_t source = 0;
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (sources[i].layer >= 0) source = i;
    for (; source < shown_results_.size(); ++source) {
        const auto& motions = shown_results_[source]->program.motions.motions;
        auto first = motions.begin();
        while (first != motions.end()
               && !(first->kind == MotionKind::cut
                    && sources[source].shows_motion(std::size_t(first - motions.begin()))))
            ++first;
        if (first == motions.end()) continue;
        PathPick pick;
        pick.source = source;
        pick.motion = std::size_t(first - motions.begin());
        pick.pass = first->pass;
        pick.point = first->point;
        pick.position = first->to.tip;
        pick.location = first->to;
        show_tool_at(pick);
        return;
    }
}

void MainWindow::show_tool_at(const PathPick& pick) {
    if (pick.source >= shown_ids_.size()) return;
    const auto index = document_.index_of(shown_ids_[pick.source]);
    if (!index) return;
    const Operation& operation = document_.operation(*index);
    Scene& scene = viewport_->scene();
    hide_touch();
    try {
        scene.set_tool(tool_of(pick.source));
        scene.set_tool_pose(pick.location);
    } catch (const Error&) {
        hide_tool(); // the operation's tool was changed into none since it was planned
        return;
    }
    tool_at_ = pick;
    const StrategyResult& path = shown_results_[pick.source]->path;
    const bool has_contact = pick.pass < path.passes.size() && pick.point < path.passes[pick.pass].cc.size();
    const double mm = mm_per(document_.unit());
    const auto place = [&](const Vec3& v) {
        const int digits = document_.unit() == LengthUnit::inch ? 4 : 3;
        return QStringLiteral("%1, %2, %3")
            .arg(QString::number(v.x() / mm, 'f', digits), QString::number(v.y() / mm, 'f', digits),
                 QString::number(v.z() / mm, 'f', digits));
    };
    QString readout = text(operation.common().name);
    if (shown_results_[pick.source] != document_.result(*index))
        readout = text(shown_results_[pick.source]->name); // a further program of it
    if (has_contact) {
        const CutterContact& cc = path.passes[pick.pass].cc[pick.point];
        scene.set_marker(Marker{cc.point, cc.normal});
        readout += tr("   pass %1, point %2   CC %3   CL %4 %5")
                       .arg(pick.pass + 1)
                       .arg(pick.point + 1)
                       .arg(place(cc.point), place(pick.location.tip), text(unit_name(document_.unit())));
    } else {
        scene.set_marker(std::nullopt);
        readout += tr("   CL %1 %2").arg(place(pick.location.tip), text(unit_name(document_.unit())));
    }
    readout_text_ = readout;
    readout_->set_text(readout);
    viewport_->refresh();
    controller_->tool_put(shown_results_[pick.source], pick.motion);
    inspection_->set_place(pick.source, motion_of(pick));
    unrolled_->set_place(pick.source, motion_of(pick));
    follow_cspace(pick);
}

void MainWindow::hide_tool() {
    tool_at_.reset();
    hide_touch();
    cspace_->leave();
    inspection_->clear_place();
    unrolled_->clear_place();
    readout_text_.clear();
    readout_->set_text({});
    viewport_->scene().set_tool(std::nullopt);
    viewport_->scene().set_tool_pose(std::nullopt);
    viewport_->scene().set_marker(std::nullopt);
}

void MainWindow::step_tool(int by) {
    if (!tool_at_ || tool_at_->source >= shown_results_.size()) return;
    const auto& motions = shown_results_[tool_at_->source]->program.motions.motions;
    if (motions.empty()) return;
    const auto last = std::ptrdiff_t(motions.size()) - 1;
    const auto at = std::ptrdiff_t(motion_of(*tool_at_));
    show_motion(tool_at_->source, std::size_t(std::clamp<std::ptrdiff_t>(at + by, 0, last)));
}

std::optional<std::size_t>
MainWindow::source_of(const std::shared_ptr<const OperationResult>& program) const {
    const auto at = std::find(shown_results_.begin(), shown_results_.end(), program);
    if (at == shown_results_.end()) return std::nullopt;
    return std::size_t(at - shown_results_.begin());
}

const Tool& MainWindow::tool_of(std::size_t source) const {
    const auto index = document_.index_of(shown_ids_.at(source));
    const auto& program = shown_results_[source];
    const Project& project = document_.project();
    // The operation's own tool may have been renumbered since; a further one is known by its number.
    if (index && document_.result(*index) == program) return project.tool_of(document_.operation(*index));
    for (const Tool& t : project.tools)
        if (t.number == program->program.tool_number) return t;
    throw Error(ErrorCode::missing_reference, program->name, "its tool is not in the project any more",
                "plan it again");
}

std::size_t MainWindow::motion_of(const PathPick& pick) const {
    const auto& motions = shown_results_[pick.source]->program.motions.motions;
    if (pick.motion < motions.size()) return pick.motion;
    // A contact was picked: its motion is the one that cuts it.
    const auto it = std::find_if(motions.begin(), motions.end(), [&](const Motion& m) {
        return m.pass == pick.pass && m.point == pick.point;
    });
    return it == motions.end() ? 0 : std::size_t(it - motions.begin());
}

void MainWindow::show_motion(std::size_t source, std::size_t motion) {
    if (source >= shown_results_.size()) return;
    const auto& motions = shown_results_[source]->program.motions.motions;
    if (motion >= motions.size()) return;
    PathPick pick;
    pick.source = source;
    pick.motion = motion;
    pick.pass = motions[motion].pass;
    pick.point = motions[motion].point;
    pick.position = motions[motion].to.tip;
    pick.location = motions[motion].to;
    show_tool_at(pick);
}

void MainWindow::edit_tool(std::optional<std::size_t> index) {
    if (!document_.has_part()) return;
    const auto& tools = document_.project().tools;
    Tool tool;
    std::vector<long> taken;
    for (std::size_t i = 0; i < tools.size(); ++i)
        if (!index || i != *index) taken.push_back(tools[i].number);
    if (index) {
        if (*index >= tools.size()) return;
        tool = tools[*index];
    } else {
        if (!tools.empty()) tool = tools.back();
        tool.number = document_.free_tool_number();
        tool.name = tr("Tool %1").arg(tool.number).toStdString();
    }
    auto* dialog = new ToolDialog(tool, document_.unit(), taken, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // A part that was still being read can bring another project: its tools are not the one on the screen.
    connect(&document_, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog, index] {
        if (index && *index < document_.project().tools.size())
            document_.set_tool(*index, dialog->tool());
        else
            document_.add_tool(dialog->tool());
        const std::size_t at = index ? *index : document_.project().tools.size() - 1;
        tree_->select({TreeNode::Kind::tool, at});
    });
    dialog->open();
}

} // namespace facetmill::ui
