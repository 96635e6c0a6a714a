// The passes of the chosen operation in the view as they will about run, until they are planned. Made anew
// after every change, in the background; a change that comes meanwhile ends what is under way.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"

#include <memory>
#include <optional>
#include <string>

namespace facetmill {
class PassPreviewer; // core/job/preview_job.h
}

namespace facetmill::ui {

class LayerBar;
class Viewport;

class PreviewController : public Controller {
    Q_OBJECT
public:
    PreviewController(Document& document, Viewport& viewport, const LayerBar& layers, QWidget* window);
    ~PreviewController() override;

    void project_opened() override;
    void project_changed() override { refresh(); }
    void part_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    void layers_toggled() override { refresh(); }
    void node_chosen(const std::optional<TreeNode>& node) override;
    bool busy() const override { return job_.running(); }

private:
    /// The operation whose passes are to be previewed.
    std::optional<std::size_t> wanted() const;
    void refresh();
    void start(std::size_t operation);
    void clear();

    Document& document_;
    Viewport& viewport_;
    const LayerBar& layers_;
    std::optional<TreeNode> node_;
    std::shared_ptr<PassPreviewer> previewer_; ///< of the job's thread
    std::string fingerprint_;                  ///< says what the preview is of; empty: there is none
    BackgroundJob job_;                        // last: it ends first
};

} // namespace facetmill::ui
