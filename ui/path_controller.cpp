#include "ui/path_controller.h"

#include "ui/layer_bar.h"
#include "ui/rough_controller.h"
#include "ui/viewport.h"

#include <QCheckBox>

#include <algorithm>

namespace facetmill::ui {

PathController::PathController(Document& document, Viewport& viewport, LayerBar& layers,
                               const ProjectTree& tree, const RoughController& rough, QObject* window)
    : Controller(window), viewport_(viewport), layers_(layers), tree_(tree), document_(document),
      rough_(rough), paths_(document) {
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    connect(&rough_, &RoughController::layer_changed, this, [this] { draw(false); });
}

void PathController::refresh() {
    const bool others = paths_.update();
    layers_.box(ViewLayer::others)->setVisible(paths_.of_several_operations());
    if (!others) return;
    emit replaced();
    if (!paths_.empty()) return draw(false);
    job_.cancel();
    drawn_.clear();
    viewport_.scene().paths().set(nullptr);
    emit shown();
    viewport_.refresh();
}

std::optional<int> PathController::alone() const {
    const auto node = tree_.selected();
    if (layers_.shown(ViewLayer::others) || !node
        || (node->kind != TreeNode::Kind::operation && node->kind != TreeNode::Kind::stock_after)
        || node->index >= document_.operation_count())
        return std::nullopt;
    const int id = document_.operation_id(node->index);
    const auto& ids = paths_.ids();
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) return std::nullopt;
    return id;
}

std::vector<PathSource> PathController::sources() const {
    std::vector<PathSource> sources;
    for (std::size_t i = 0; i < paths_.size(); ++i)
        sources.push_back(path_source(paths_.programs()[i], rough_.layer_of(paths_.ids()[i])));
    const std::optional<int> id = alone();
    for (std::size_t i = 0; id && i < sources.size(); ++i)
        sources[i].hidden = paths_.ids()[i] != *id;
    // Beside a layer alone nothing of the others.
    if (std::any_of(sources.begin(), sources.end(), [](const PathSource& s) { return s.layer >= 0; }))
        for (PathSource& s : sources)
            s.hidden = s.layer < 0;
    return sources;
}

void PathController::draw(bool keep_tool) {
    drawn_alone_ = alone();
    if (paths_.empty()) return;
    auto display = std::make_shared<PathDisplayPtr>();
    job_.start(
        tr("Drawing the path"),
        [display, sources = sources()](const Progress& p) { *display = prepare_path_display(sources, p); },
        [this, display, keep_tool, programs = paths_.programs()](const JobEnd& end) {
            if (!end.done() || programs != paths_.programs()) return;
            viewport_.scene().paths().set(*display);
            viewport_.content_changed();
            const bool same_paths = programs == drawn_;
            drawn_ = programs;
            if (!same_paths) emit shown();
            if (same_paths || drawn_alone_) emit parts_shown((*display)->sources);
            if (same_paths) emit redrawn((*display)->sources, keep_tool);
        });
}

std::optional<PathPick> PathController::start() const {
    const std::vector<PathSource> drawn = sources();
    // A layer that is drawn alone goes before the other paths.
    std::size_t source = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (drawn[i].layer >= 0) source = i;
    for (; source < paths_.size(); ++source) {
        const auto& motions = paths_.programs()[source]->program.motions.motions;
        for (std::size_t m = 0; m < motions.size(); ++m)
            if (motions[m].kind == MotionKind::cut && drawn[source].shows_motion(m))
                return paths_.pick_at(source, m);
    }
    return std::nullopt;
}

void PathController::uncover(int operation) {
    if (drawn_alone_ && operation != *drawn_alone_) layers_.set_shown(ViewLayer::others, true);
}

void PathController::redraw_if_alone_changed() {
    if (alone() != drawn_alone_) draw(true);
}

void PathController::node_chosen(const std::optional<TreeNode>&) {
    redraw_if_alone_changed();
}

void PathController::layers_toggled() {
    redraw_if_alone_changed();
}

} // namespace facetmill::ui
