// The fixtures in the view: drawn, chosen by a click, dragged to another place as a step of the history.
#pragma once

#include "ui/controller.h"

namespace facetmill::ui {

class Viewport;

class FixtureController : public Controller {
    Q_OBJECT
public:
    FixtureController(Document& document, Viewport& viewport, ProjectTree& tree, QObject* window);

    void project_opened() override;
    void part_changed() override;
    void node_chosen(const std::optional<TreeNode>& node) override;

private:
    void shift(std::size_t i, const Vec3& by);
    void drop(std::size_t i, const Vec3& by);

    Document& document_;
    Viewport& viewport_;
    std::size_t count_ = 0; ///< of those in the view
};

} // namespace facetmill::ui
