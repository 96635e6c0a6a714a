#include "ui/part_controller.h"

#include "core/job/stock_solid.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/viewport.h"

namespace facetmill::ui {

LoadedPart load_part(Planner& planner, const Project& project, const Progress& progress) {
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

PartController::PartController(Document& document, Viewport& viewport, std::shared_ptr<Planner> planner,
                               BackgroundJob& job, Messages& messages, QObject* window)
    : Controller(window), document_(document), viewport_(viewport), planner_(std::move(planner)), job_(job),
      messages_(messages) {}

void PartController::reload() {
    if (!document_.has_part()) return;
    const bool first = !document_.part();
    auto loaded = std::make_shared<LoadedPart>();
    job_.start(
        tr("Reading %1").arg(elided(path_text(document_.project().part_path().filename()), 30)),
        [loaded, project = document_.project(), planner = planner_](const Progress& p) {
            *loaded = load_part(*planner, project, p);
        },
        [this, loaded, first](const JobEnd& end) {
            if (end.done()) show(*loaded, first);
        });
}

void PartController::show(const LoadedPart& loaded, bool new_view) {
    viewport_.scene().part().set(loaded.display);
    viewport_.content_changed();
    stock_mesh_ = loaded.stock;
    document_.set_part(loaded.part, loaded.key);
    show_stock();
    if (!loaded.stock_failure.isEmpty()) messages_.warning(sentence(loaded.stock_failure));
    if (new_view)
        viewport_.set_view(StandardView::iso);
    else
        viewport_.refresh();
}

void PartController::show_stock() {
    const auto& part = document_.part();
    const StockSpec& stock = document_.project().stock;
    StockShapePtr shape;
    if (part && stock.kind == StockSpec::Kind::mesh)
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
    viewport_.scene().part().set(PartDisplayPtr());
    viewport_.scene().stock().set_box(Box3());
    viewport_.scene().set_unit(document_.unit());
}

void PartController::project_changed() {
    viewport_.scene().set_unit(document_.unit());
    show_stock();
}

void PartController::part_changed() {
    if (document_.has_part() && document_.part() && !document_.part_is_current()) reload();
}

} // namespace facetmill::ui
