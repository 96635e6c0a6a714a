// Strips of clean-up in the window: a list of what a planned operation found, each to be switched on and off;
// the strips in the view while the list is seen, one of them chosen in either place; and how the previous
// tool stood along it.
#pragma once

#include "core/strategy/cleanup/cleanup.h"
#include "ui/background_job.h"
#include "ui/controller.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QTreeWidgetItem;

namespace facetmill::ui {

class CameraFlight;
class StripPanel;
class Viewport;

class StripController : public Controller {
    Q_OBJECT
public:
    StripController(Document& document, Viewport& viewport, QWidget* window);
    ~StripController() override;

    StripPanel* panel() { return panel_; }

    void project_opened() override { refresh(); }
    void project_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    void paths_shown(const ShownPaths& paths) override;
    /// The strip that covers the place becomes the chosen one where the list is seen, and the previous tool
    /// stands there. On a path only while that tool is wanted.
    bool take_path_pick(const ShownPaths& paths, const PathPick& pick) override;
    bool take_part_pick(const PartPick& pick) override { return this->pick(pick.point); }
    void palette_changed(Palette palette) override;
    void panel_seen(bool seen) override;
    bool busy() const override;

    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Chooses a strip by its place in the operation's list.
    void choose(std::optional<std::size_t> strip, bool fly);
    /// Something else has the view's tool.
    void leave_tool();
    /// Puts the strips into the view again after others were there.
    void show_again();

signals:
    /// Strips of the list come into the view, or have gone: then it may show others.
    void strips_shown(bool on);
    /// The previous tool belongs here, touching the part at both points.
    void touch_wanted(const facetmill::Tool& tool, const facetmill::CleanupRecord::Touch& touch);
    /// The tool that was shown before belongs in the view again.
    void touch_gone();

private:
    std::optional<std::size_t> source() const;
    /// The chosen operation's result, and the strips that it does not cut; none where there is no such.
    const OperationResult* result() const;
    std::optional<std::string> switched_off() const;
    QString empty_reason() const;
    bool pick(const Vec3& place);
    void refresh();
    void show_states();
    void show_strips();
    void switch_strip(const QTreeWidgetItem& item);
    void show_place();
    void take_tool();
    void show_touch();

    Document& document_;
    Viewport& viewport_;
    StripPanel* panel_ = nullptr;
    CameraFlight* flight_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<int> ids_;
    std::vector<std::size_t> sources_; ///< places of the clean-ups among the results: the entries of the box
    std::optional<std::size_t> chosen_;
    const OperationResult* listed_ = nullptr; ///< whose strips the list has
    LengthUnit listed_unit_ = LengthUnit::mm;
    std::vector<std::string> listed_name_;
    StripDisplayPtr shown_;    ///< in the view; null: none
    std::string wanted_;       ///< what the view's strips are, or are being, made from
    bool touch_shown_ = false; ///< the view has the previous tool from here
    bool tool_left_ = false;   ///< something else has it, until a place is chosen again
    BackgroundJob job_;        // last: it ends first
};

} // namespace facetmill::ui
