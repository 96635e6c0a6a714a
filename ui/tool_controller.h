// The tool in the 3D view: at a place of a path, at a posture of the configuration space, along the playback,
// or the previous tool where a strip was found; and what the status line says of it.
#pragma once

#include "core/strategy/cleanup/cleanup.h"
#include "ui/controller.h"
#include "ui/shown_paths.h"

namespace facetmill::ui {

class PathController;
class StatusLine;
class VerificationController;
class Viewport;

class ToolController : public Controller {
    Q_OBJECT
public:
    ToolController(Document& document, Viewport& viewport, const PathController& paths,
                   VerificationController& verification, StatusLine& status, QObject* window);

    /// At a place of a path, with the contact that is cut there.
    void show_at(const PathPick& pick);
    /// At the end of a motion; nothing where there is no such motion.
    void show_motion(std::size_t source, std::size_t motion);
    /// Goes motions on or back along the path.
    void step(int by);
    /// The tool of a program at any pose over a contact; no pose: the contact alone.
    void show_pose(const std::shared_ptr<const OperationResult>& program,
                   const std::optional<CutterLocation>& pose, const Marker& contact,
                   const QStringList& readout);
    /// The tool that cut before, where it touches the part at two places; then the one shown before it again.
    void show_touch(const Tool& tool, const CleanupRecord::Touch& touch);
    void end_touch();
    void hide();
    /// The same paths are drawn in other parts: the tool goes to their start unless it is to stay and can.
    void paths_redrawn(const std::vector<PathSource>& sources, bool keep_tool);

    void project_opened() override { hide(); }
    void paths_shown(const ShownPaths& paths) override;
    bool take_key(const QKeyEvent& event) override;

signals:
    void placed(const facetmill::PathPick& pick);
    void at_place(std::size_t source, std::size_t motion, double share);
    void removed();
    /// Something else than a touch is shown from now on.
    void touch_left();

private:
    void leave_touch();
    void follow_playback();
    void show_start();
    /// In parts, as the status line has them.
    QStringList readout_of(const PathPick& pick) const;
    const ShownPaths& shown() const;

    Document& document_;
    Viewport& viewport_;
    const PathController& paths_;
    VerificationController& verification_;
    StatusLine& status_;
    std::optional<PathPick> at_;
};

} // namespace facetmill::ui
