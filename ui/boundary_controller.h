// Boundaries in the view: the chosen one's facets and curve, or those that the chosen operation names;
// painted and drawn there, each stroke a step of the history.
#pragma once

#include "ui/background_job.h"
#include "ui/boundary_box.h"
#include "ui/controller.h"
#include "ui/curve_tool.h"
#include "ui/facet_tool.h"

#include <array>
#include <memory>
#include <optional>

namespace facetmill::ui {

class Messages;
class Viewport;

class BoundaryController : public Controller {
    Q_OBJECT
public:
    BoundaryController(Document& document, Viewport& viewport, BoundaryBox& box, Messages& messages,
                       QObject* window);
    ~BoundaryController() override;

    /// Painting ends: a click in the view is for somebody else.
    void leave();

    void project_opened() override;
    void project_changed() override;
    void part_changed() override;
    void node_chosen(const std::optional<TreeNode>& node) override;
    /// Esc ends painting, Enter closes a curve, Backspace takes its last corner back.
    bool take_key(const QKeyEvent& event) override;
    bool busy() const override { return job_.running() || facets_.busy(); }

signals:
    /// A click in the view is for a boundary now.
    void painting_begun();

private:
    /// What the view shows, and on what.
    struct Shown {
        std::optional<Boundary> boundary;
        PartDisplayPtr part;
        std::optional<AptCutter> cutter; ///< that leaves it
    };
    /// The chosen boundary, where one is and the part is as the project says.
    const Boundary* chosen() const;
    void begin();
    void end();
    void show();
    void show_role(BoundaryRole role, const Boundary* boundary);
    void show_curve(BoundaryRole role, const Boundary* boundary);
    void start_job();
    void change(BoundaryBox::Change change);
    void store_stroke();
    void tell_kept(bool kept);
    void store_curve();
    void curve_changed();

    Document& document_;
    Viewport& viewport_;
    BoundaryBox& box_;
    Messages& messages_;
    FacetTool facets_;
    CurveTool curve_;
    std::shared_ptr<FacetPainter> painter_;
    std::optional<TreeNode> node_;
    std::array<Shown, 2> shown_;
    std::array<bool, 2> wanted_{}; ///< to be made in the background
    bool sized_ = false;           ///< the brush suits the part
    bool inverted_ = false;        ///< what is painted is what the boundary leaves out
    bool storing_ = false;         ///< a stroke becomes a step of the history
    BackgroundJob job_;            // last: it ends first
};

} // namespace facetmill::ui
