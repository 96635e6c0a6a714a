// The divide of a steep-and-shallow operation in the window: both sides have their colours on the part, and
// a handle moves it. The form and the handle change the same value.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace facetmill::ui {

class DivideBar;
class Viewport;

class DivideController : public Controller {
    Q_OBJECT
public:
    DivideController(Document& document, Viewport& viewport, QWidget* window);

    DivideBar* bar() { return bar_; }
    void project_opened() override;
    void project_changed() override { refresh(); }
    void part_changed() override { refresh(); }
    void node_chosen(const std::optional<TreeNode>& node) override;
    bool busy() const override { return commit_.isActive() || job_.running(); }

private:
    /// Slopes (radians) and areas of the facets that face up; of others infinite and 0.
    struct Slopes {
        std::vector<double> slope, area;
        double all = 0;
    };
    /// The operation that has a divide, where one is chosen and the part is as the project says.
    std::optional<std::size_t> chosen() const;
    void refresh();
    void find_slopes(std::size_t operation);
    void show(double divide);
    void tint(std::vector<char> steep, std::vector<char> shallow);
    void hide();
    void moved(int degrees);
    void commit();

    Document& document_;
    Viewport& viewport_;
    DivideBar* bar_ = nullptr;
    std::optional<TreeNode> node_;
    MeshPtr part_; ///< of the slopes
    Vec3 axis_ = Vec3::Zero();
    std::shared_ptr<const Slopes> slopes_;
    std::optional<double> shown_; ///< the divide in the view
    QTimer commit_;               ///< waits for the end of a movement
    BackgroundJob job_;           // last: it ends first
};

} // namespace facetmill::ui
