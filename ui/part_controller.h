// The part and its stock in the view: read in the background, also again when their files change.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "viz/part_display.h"
#include "viz/stock_shape.h"

namespace facetmill::ui {

class Messages;
class Viewport;

/// A part as it was read, ready to be drawn.
struct LoadedPart {
    std::shared_ptr<const PreparedPart> part;
    PartDisplayPtr display;
    StockShapePtr stock;   ///< where the stock is a mesh
    QString stock_failure; ///< why there is none though there should be
    std::string key;       ///< Document::part_key of what was read
};

/// Reads the part and, where it is a mesh, the stock of a project. Throws Error.
LoadedPart load_part(Planner& planner, const Project& project, const Progress& progress);

class PartController : public Controller {
    Q_OBJECT
public:
    PartController(Document& document, Viewport& viewport, std::shared_ptr<Planner> planner,
                   BackgroundJob& job, Messages& messages, QObject* window);

    /// Reads the document's part in the background, if it has one.
    void reload();
    /// Takes over what was read; `new_view` turns the view to it.
    void show(const LoadedPart& loaded, bool new_view);

    void project_opened() override;
    void project_changed() override;
    void part_changed() override;
    /// Draws the stock's dimensions while it is selected.
    void node_chosen(const std::optional<TreeNode>& node) override;

private:
    void show_stock();
    void show_dimensions();

    Document& document_;
    Viewport& viewport_;
    std::shared_ptr<Planner> planner_;
    BackgroundJob& job_;
    Messages& messages_;
    std::optional<TreeNode> node_;
    StockShapePtr stock_mesh_; ///< as read with the part
};

} // namespace facetmill::ui
