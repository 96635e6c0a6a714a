// The interface between the window and the subjects of the workbench. A controller looks after one subject
// (verification, charts, the configuration space, ...): it owns the subject's panel and its background job,
// and listens to what the window tells all of them in a loop. What it wants from the others it says by
// signals; the window carries them.
#pragma once

#include "ui/document.h"
#include "ui/message_bar.h"
#include "ui/project_tree.h"
#include "viz/scene.h"

class QKeyEvent;

namespace facetmill::ui {

class ShownPaths;

class Controller : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    // The document's signals, in the same words.
    virtual void project_opened() {}
    virtual void project_changed() {}
    virtual void part_changed() {}
    virtual void plan_changed() {}
    /// Another line of the project tree is selected.
    virtual void node_chosen(const std::optional<TreeNode>& /*node*/) {}

    /// Other paths are in the view, or none.
    virtual void paths_shown(const ShownPaths& /*paths*/) {}
    /// The same paths are drawn in other parts: `sources` says which motions of each.
    virtual void path_parts_shown(const std::vector<PathSource>& /*sources*/) {}
    /// The user put the tool somewhere on a path.
    virtual void tool_placed(const ShownPaths& /*paths*/, const PathPick& /*pick*/) {}
    /// The tool is `share` of the way through a motion of a path, put there or played back to it.
    virtual void place_shown(std::size_t /*source*/, std::size_t /*motion*/, double /*share*/) {}
    /// The view has no tool any more.
    virtual void tool_removed() {}

    /// A click in the view met a path or the part. True: it was meant for this controller, and is used up.
    virtual bool take_path_pick(const ShownPaths& /*paths*/, const PathPick& /*pick*/) { return false; }
    virtual bool take_part_pick(const PartPick& /*pick*/) { return false; }
    /// True when the key is used up.
    virtual bool take_key(const QKeyEvent& /*event*/) { return false; }
    /// Check marks of the layers changed.
    virtual void layers_toggled() {}
    virtual void palette_changed(Palette /*palette*/) {}
    /// Its panel came to be seen, or is hidden.
    virtual void panel_seen(bool /*seen*/) {}

    /// A job runs, or something that was asked for is not shown yet.
    virtual bool busy() const { return false; }

signals:
    /// For the log and, with `in_bar`, for the bar above the view.
    void said(facetmill::ui::MessageBar::Kind kind, const QString& message, bool in_bar);
    void failed(const QString& message);
    /// A file was written.
    void wrote(const QString& path);
    /// There is something to see in its panel for the first time.
    void offered();
    /// A job ended.
    void settled();

protected:
    void tell(const QString& message);
    /// Reports a file: `wrong` is empty when it was written. True in that case.
    bool report_written(const QString& path, const QString& wrong);
    /// Emits `offered`, once.
    void offer();

private:
    bool offered_ = false;
};

} // namespace facetmill::ui
