#include "ui/part_controller.h"

#include "core/job/project_inputs.h"
#include "core/job/stock_solid.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/verification_model.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <utility>

namespace facetmill::ui {

LoadedPart load_part(Planner& planner, const Project& project, const Progress& progress) {
    LoadedPart loaded;
    // Before: a file that changes meanwhile is read again.
    loaded.key = Document::part_key(project);
    loaded.part_file = mesh_file(project.part_path());
    loaded.stock_file = mesh_file(project.stock_path());
    const Progress reading = progress.part(0, 0.7, "Reading the part");
    try {
        loaded.part = planner.prepare(project, reading);
    } catch (const Error& e) {
        // Without its stock and fixtures a part can be seen, though not planned.
        const bool rest = project.stock.kind == StockSpec::Kind::rest; // known when the setup is planned
        const bool of_fixture = e.where().starts_with("fixture '");
        if (project.stock.kind != StockSpec::Kind::mesh && !rest && !of_fixture) throw;
        Project alone = project;
        std::erase_if(alone.fixtures, [](const Fixture& f) { return f.kind == Fixture::Kind::mesh; });
        if (!of_fixture || rest) alone.stock = StockSpec();
        loaded.part = planner.prepare(alone, reading);
        if (!rest || of_fixture) loaded.stock_failure = worded(e);
    }
    loaded.display = prepare_part_display(loaded.part->mesh, progress.part(0.7, 0.9, "Preparing the view"));
    if (loaded.part->stock_mesh)
        loaded.stock = make_stock_shape(stock_solid(project.stock, *loaded.part), progress.part(0.9, 1));
    return loaded;
}

PartController::PartController(Document& document, Viewport& viewport, std::shared_ptr<Planner> planner,
                               std::shared_ptr<SetupPlanners> planners, BackgroundJob& job,
                               Messages& messages, const VerificationModel& verification, QObject* window)
    : Controller(window), document_(document), viewport_(viewport), planner_(std::move(planner)),
      planners_(std::move(planners)), job_(job), messages_(messages), verification_(verification) {
    connect(&job_, &BackgroundJob::started, this, &PartController::forget_former);
    viewport_.scene().set_empty_text({});
}

void PartController::reload() {
    if (!document_.has_part()) return;
    tried_ = Document::part_key(document_.project());
    wanted_ = true;
    if (is_missing(document_.project().part_path())) {
        job_.cancel(); // what it may be reading is the part of another time
        say_instead(tr("The file of the part is missing"));
        emit settled();
        return;
    }
    const bool first = !document_.part();
    auto loaded = std::make_shared<LoadedPart>();
    const QString reading =
        tr("Reading %1").arg(elided(path_text(document_.project().part_path().filename()), 30));
    say_instead(reading + QChar(0x2026));
    job_.start(
        reading,
        [loaded, project = document_.project(), planner = planner_, planners = planners_](const Progress& p) {
            if (auto rest = planners->known_rest(project)) planner->carry(std::move(rest));
            *loaded = load_part(*planner, project, p);
        },
        [this, loaded, first, key = tried_, reading_now = ++readings_](const JobEnd& end) {
            if (end.how == JobEnd::How::cancelled && tried_ == key) tried_.clear();
            // One that gave way to another says nothing of that.
            if (!end.done() && reading_now == readings_) say_instead(tr("The part was not read"));
            if (!end.done()) return;
            show(*loaded, first);
            // Beside that, what is wrong with the stock would not be seen.
            if (const QString change = taken_change(); !change.isEmpty())
                messages_.information(change, loaded->stock_failure.isEmpty());
        });
}

void PartController::show_with_step(const LoadedPart& loaded, const QString& what,
                                    const std::function<void(Project&)>& edit) {
    tried_ = loaded.key; // it is read already
    const bool first = !document_.part();
    document_.change(what, edit);
    show(loaded, first);
}

void PartController::note_change(const LoadedPart& loaded) {
    const LengthUnit unit = document_.unit();
    const auto& before = document_.part();
    const auto add = [&](const MeshFile& old_file, const MeshFile& new_file, const MeshFigures& was,
                         const MeshFigures& is) {
        if (old_file.path.empty() || new_file.path.empty() || old_file == new_file) return false;
        changes_ << mesh_change_text(old_file, was, new_file, is, unit);
        return true;
    };
    if (before && add(part_file_, loaded.part_file, part_figures(*before), part_figures(*loaded.part))) {
        part_replaced_ = true;
        const Mesh &was = *before->mesh, &is = *loaded.part->mesh;
        if (was.vertices != is.vertices || was.facets != is.facets) viewport_.scene().former().set(display_);
    }
    if (before && before->stock_mesh && loaded.part->stock_mesh)
        add(stock_file_, loaded.stock_file, stock_figures(*before), stock_figures(*loaded.part));
    part_file_ = loaded.part_file;
    stock_file_ = loaded.stock_file;
}

void PartController::forget_former() {
    if (!viewport_.scene().former().any()) return;
    viewport_.scene().former().set(nullptr);
    viewport_.refresh();
}

QString PartController::taken_change() {
    if (changes_.isEmpty()) return {};
    QStringList all = std::exchange(changes_, {});
    all << out_of_date_text(document_, verification_);
    if (std::exchange(part_replaced_, false)) all << kept_places_text(document_);
    all.removeAll(QString());
    return all.join(QChar(' '));
}

void PartController::say_instead(const QString& words) {
    viewport_.scene().set_empty_text(utf8(words));
    viewport_.refresh();
}

void PartController::show(const LoadedPart& loaded, bool new_view) {
    say_instead(tr("All of it is switched off below the view"));
    note_change(loaded);
    if (display_ != loaded.display)
        viewport_.scene().marks().set_marker(std::nullopt); // on the part that was
    display_ = loaded.display;
    viewport_.scene().part().set(display_);
    viewport_.content_changed();
    stock_mesh_ = loaded.stock;
    document_.set_part(loaded.part, loaded.key);
    show_stock();
    // One that is missing is told as such.
    if (!loaded.stock_failure.isEmpty() && missing_inputs(document_.project()).empty())
        messages_.warning(sentence(loaded.stock_failure));
    if (new_view)
        viewport_.set_view(StandardView::iso);
    else
        viewport_.refresh();
    if (!loaded.remark.isEmpty()) emit remarked(loaded.remark);
}

void PartController::show_stock() {
    const auto& part = document_.part();
    const StockSpec& stock = document_.project().stock;
    StockShapePtr shape;
    if (part && (stock.kind == StockSpec::Kind::mesh || stock.kind == StockSpec::Kind::rest))
        shape = stock_mesh_;
    else if (part)
        shape = make_stock_shape(stock_solid(stock, *part), {});
    viewport_.scene().stock().set(shape);
    show_dimensions();
}

void PartController::show_dimensions() {
    std::array<std::string, 3> texts;
    const auto& part = document_.part();
    if (part && node_ && node_->kind == TreeNode::Kind::stock) {
        const StockSolid solid = stock_solid(document_.project().stock, *part);
        for (int k = 0; k < 3 && !solid.box.empty(); ++k) {
            const bool round = solid.kind == StockSolid::Kind::cylinder && k != solid.axis;
            texts[std::size_t(k)] = utf8((round ? QStringLiteral("Ø ") : QString())
                                         + shown_length(solid.box.size()[k], document_.unit(), 5));
        }
    }
    if (texts == viewport_.scene().stock().dimensions()) return;
    viewport_.scene().stock().set_dimensions(texts);
    viewport_.refresh();
}

void PartController::node_chosen(const std::optional<TreeNode>& node) {
    node_ = node;
    show_dimensions();
}

void PartController::project_opened() {
    ++readings_; // what is read now is the part of another project
    tried_.clear();
    wanted_ = false;
    part_file_ = stock_file_ = {};
    changes_.clear();
    part_replaced_ = false;
    display_ = nullptr;
    viewport_.scene().former().set(nullptr);
    viewport_.scene().part().set(PartDisplayPtr());
    viewport_.scene().stock().set_box(Box3());
    viewport_.scene().set_unit(document_.unit());
    say_instead({}); // the start page stands there
}

void PartController::project_changed() {
    forget_former();
    if (document_.part_is_current()) {
        // Saving may have given them other names.
        tried_.clear();
        part_file_ = mesh_file(document_.project().part_path());
        stock_file_ = mesh_file(document_.project().stock_path());
    }
    viewport_.scene().set_unit(document_.unit());
    show_stock();
}

void PartController::end_opening() {
    if (--openings_ == 0) part_changed();
}

void PartController::part_changed() {
    if (openings_ > 0 || !document_.has_part() || document_.part_is_current()) return;
    // Not before it was read for the first time, and what could not be read, not again.
    if (!document_.part() && !wanted_) return;
    if (tried_ != Document::part_key(document_.project())) reload();
}

} // namespace facetmill::ui
