// Layers of a roughing operation in the window: as its parameters would make them, while they are edited, and
// as they were planned; and the path of one layer alone.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <string>

namespace facetmill::ui {

class RoughBar;
class Viewport;

class RoughController : public Controller {
    Q_OBJECT
public:
    RoughController(Document& document, Viewport& viewport, QWidget* window);

    RoughBar* bar() { return bar_; }
    void project_opened() override { refresh(); }
    void project_changed() override { refresh(); }
    void part_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    /// Shows the layers of a roughing operation that is selected.
    void node_chosen(const std::optional<TreeNode>& node) override;
    /// The layer of an operation's path that is to be drawn alone, or -1.
    int layer_of(int operation_id) const;
    /// Heights of the tip, from the top down, that are shown; mm.
    const std::vector<double>& heights() const { return heights_; }
    bool busy() const override { return timer_.isActive() || job_.running(); }

signals:
    /// Another layer is to be drawn alone.
    void layer_changed();

private:
    void refresh();
    void start_preview(std::size_t i);
    void take(std::vector<double> heights, const Box3& box, const QString& all);
    void show_levels();
    void clear();

    Document& document_;
    Viewport& viewport_;
    RoughBar* bar_ = nullptr;
    std::optional<TreeNode> node_;
    int id_ = 0;              ///< operation shown; 0: none
    bool planned_ = false;    ///< the heights are those of its path
    std::string fingerprint_; ///< says what the heights were found from
    std::vector<double> heights_;
    Box3 box_;
    QString all_; ///< what the bar says of all layers
    int chosen_ = -1;
    QTimer timer_;      ///< waits for the next key
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
