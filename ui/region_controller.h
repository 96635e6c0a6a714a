// Regions of the part's surface in the window: those of planned operations, and while the dialog "Settings of
// Rework Region" is open those that its values would bring, found anew in the background after every change.
// What is edited by hand (switched off, grown, shrunk, dragged in the view) goes to the document as steps of
// its history; a value that is still being typed, or a boundary point on its way, is only tried.
#pragma once

#include "core/job/region_preview.h"
#include "ui/background_job.h"
#include "ui/controller.h"
#include "viz/strip_display.h"

#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

class RegionDialog;
class Viewport;

class RegionController : public Controller {
    Q_OBJECT
public:
    RegionController(Document& document, Viewport& viewport, QWidget* window);
    ~RegionController() override;

    RegionDialog* dialog() { return dialog_; }
    /// Opens the dialog for an operation; nothing for one without rework regions.
    void open(std::size_t operation);
    void project_opened() override;
    void project_changed() override { refresh(); }
    void part_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    /// Where several operations have regions, only those of the selected one are shown.
    void node_chosen(const std::optional<TreeNode>& node) override;
    /// Chooses the region that is clicked, and leaves the click to others.
    bool take_part_pick(const PartPick& pick) override;
    /// Other strips are in the view (ui/strip_controller.h): those of planned operations are not drawn until
    /// they go.
    void give_way(bool on);
    /// Takes over what stands in the dialog's fields.
    void commit();
    /// What is drawn; null: nothing.
    const StripDisplayPtr& shown() const { return display_; }
    /// The regions as they would be, while the dialog is open: for the newest values that were looked at.
    const RegionPreview::Result* found() const { return found_.get(); }
    bool busy() const override;

signals:
    /// Regions are to be seen: their layer should be on.
    void wanted();
    /// The dialog is closed: its regions are not to be seen any more.
    void ended();

private:
    struct Found;
    void refresh();
    void look();
    void show_planned();
    void take(const Found& found);
    void show_display(StripDisplayPtr display);
    void try_value(const std::string& key, const ParameterValue& value);
    void close();
    /// The project with what is only tried.
    Project tried() const;
    std::string key_of(const Project& project, std::size_t i) const;
    std::optional<std::size_t> operation() const;
    void change(const QString& what, const std::function<void(Operation&)>& edit);
    void edit_region(const QString& what, std::size_t region, const std::function<void(RegionEdit&)>& edit);

    Document& document_;
    Viewport& viewport_;
    RegionDialog* dialog_ = nullptr;
    std::optional<TreeNode> node_;
    int id_ = 0;                                   ///< operation of the dialog; 0: it is closed
    std::map<std::string, ParameterValue> values_; ///< tried
    std::optional<BoundaryDrag> drag_;             ///< on its way
    std::string key_;                              ///< names what was looked at last
    std::shared_ptr<RegionPreview> preview_;
    std::shared_ptr<const RegionPreview::Result> found_;
    std::vector<RegionEdit> found_edits_;                         ///< that it was found with
    std::vector<std::shared_ptr<const OperationResult>> planned_; ///< whose strips are shown
    LengthUnit planned_unit_ = LengthUnit::mm;
    StripDisplayPtr display_;
    bool gives_way_ = false;
    QTimer wait_timer_;   ///< for the next key or the next place of the pointer
    QTimer commit_timer_; ///< for the end of a drag in the chart
    BackgroundJob job_;   // last: it ends first
};

} // namespace facetmill::ui
