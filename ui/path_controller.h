// The planned paths in the view: drawn in the background, all of them, that of the chosen operation alone, or
// one layer of a roughing.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/shown_paths.h"

namespace facetmill::ui {

class LayerBar;
class RoughController;
class Viewport;

class PathController : public Controller {
    Q_OBJECT
public:
    PathController(Document& document, Viewport& viewport, LayerBar& layers, const ProjectTree& tree,
                   const RoughController& rough, QObject* window);

    const ShownPaths& paths() const { return paths_; }
    /// What is drawn of each path.
    std::vector<PathSource> sources() const;
    /// The first cutting motion that is drawn.
    std::optional<PathPick> start() const;
    /// Draws the layers that are chosen. `keep_tool`: it stays where it is, if that is drawn; else it goes to
    /// the start.
    void draw(bool keep_tool);
    /// Draws the paths of all operations where the path of another one than this is seen alone.
    void uncover(int operation);

    void project_opened() override { refresh(); }
    void project_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    void node_chosen(const std::optional<TreeNode>& node) override;
    void layers_toggled() override;
    bool busy() const override { return job_.running(); }

signals:
    /// The paths are about to be others: what stands on them goes.
    void replaced();
    /// Other paths are drawn, or none.
    void shown();
    /// Not all of the paths is drawn, or is again.
    void parts_shown(const std::vector<facetmill::PathSource>& sources);
    /// The same paths are drawn in other parts.
    void redrawn(const std::vector<facetmill::PathSource>& sources, bool keep_tool);

private:
    void refresh();
    void redraw_if_alone_changed();
    /// The operation whose path is seen alone: the chosen one, if it has a path and others are not wanted.
    std::optional<int> alone() const;

    Viewport& viewport_;
    LayerBar& layers_;
    const ProjectTree& tree_;
    const Document& document_;
    const RoughController& rough_;
    ShownPaths paths_;
    std::optional<int> drawn_alone_;                            ///< `alone` when the paths were drawn
    std::vector<std::shared_ptr<const OperationResult>> drawn_; ///< the programs in the view already
    BackgroundJob job_;                                         // last: it ends first
};

} // namespace facetmill::ui
