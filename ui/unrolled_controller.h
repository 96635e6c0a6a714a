// The unrolled view in the window: which operation it shows, and how its mark and the tool in the 3D view go
// together.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "viz/unrolled.h"

#include <optional>
#include <vector>

class QComboBox;

namespace facetmill::ui {

class UnrolledPanel;
class UnrolledView;

class UnrolledController : public Controller {
    Q_OBJECT
public:
    UnrolledController(Document& document, QWidget* window);
    ~UnrolledController() override;

    UnrolledPanel* panel() { return panel_; }
    UnrolledView* view() { return view_; }
    QComboBox* operation_box() { return operation_; }

    void project_changed() override;
    void paths_shown(const ShownPaths& paths) override;
    /// Another operation's path comes to be shown.
    void place_shown(std::size_t source, std::size_t motion, double share) override;
    void tool_removed() override;
    void panel_seen(bool seen) override;
    bool busy() const override { return job_.running(); }

    /// Written aside; what comes of it is told in the window.
    void save_picture(const QString& path);
    QString export_name() const;

signals:
    /// The tool is wanted at the end of this motion.
    void place_wanted(std::size_t source, std::size_t motion);
    void step_wanted(int by);

private:
    void list_paths();
    void update();
    void show_place();
    std::optional<std::size_t> source() const;

    Document& document_;
    UnrolledPanel* panel_ = nullptr;
    UnrolledView* view_ = nullptr;
    QComboBox* operation_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<std::size_t> sources_; ///< places of turning parts among the results: the entries of the box
    std::optional<std::pair<std::size_t, std::size_t>> place_;
    LengthUnit unit_ = LengthUnit::mm;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
