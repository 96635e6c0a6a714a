// The part and its stock in the view: read in the background, also again when their files change.
#pragma once

#include "core/job/setup_plan.h"
#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/mesh_change.h"
#include "viz/part_display.h"
#include "viz/stock_shape.h"

namespace facetmill::ui {

class Messages;
class VerificationModel;
class Viewport;

/// A part as it was read, ready to be drawn.
struct LoadedPart {
    std::shared_ptr<const PreparedPart> part;
    PartDisplayPtr display;
    StockShapePtr stock;   ///< where the stock is a mesh
    QString stock_failure; ///< why it, or fixtures, are not there though they should be
    std::string key;       ///< Document::part_key of what was read
    MeshFile part_file, stock_file;
    QString remark; ///< of a mesh that was just opened: what may be mended
};

/// Reads the part and, where it is a mesh, the stock of a project. Throws Error.
LoadedPart load_part(Planner& planner, const Project& project, const Progress& progress);

class PartController : public Controller {
    Q_OBJECT
public:
    /// `planner`: of the shown setup; `planners`: know the stocks that others begin with.
    PartController(Document& document, Viewport& viewport, std::shared_ptr<Planner> planner,
                   std::shared_ptr<SetupPlanners> planners, BackgroundJob& job, Messages& messages,
                   const VerificationModel& verification, QObject* window);

    /// Reads the document's part in the background, if it has one and that is not missing.
    void reload();
    /// From here until as many `end_opening` another file is being opened by the same job: the part that is
    /// shown is not read anew, which would cancel that.
    void begin_opening() { ++openings_; }
    /// What changed meanwhile is read now, where that part is still the one that is shown.
    void end_opening();
    /// Takes over what was read; `new_view` turns the view to it.
    void show(const LoadedPart& loaded, bool new_view);
    /// The same of what a step of the history names, which is made here.
    void show_with_step(const LoadedPart& loaded, const QString& what,
                        const std::function<void(Project&)>& edit);
    /// What has become of part and stock since it was asked last, where their files are others than before or
    /// were written anew, and what is out of date by that. Empty: nothing.
    QString taken_change();
    /// The part before a replaced one is seen no more: it is until something else is done.
    void forget_former();

    void project_opened() override;
    void project_changed() override;
    void part_changed() override;
    /// Draws the stock's dimensions while it is selected.
    void node_chosen(const std::optional<TreeNode>& node) override;

signals:
    /// What is shown now has flaws that the scan room mends.
    void remarked(const QString& remark);

private:
    void note_change(const LoadedPart& loaded);
    /// What the view says where nothing is to be seen.
    void say_instead(const QString& words);
    void show_stock();
    void show_dimensions();

    Document& document_;
    Viewport& viewport_;
    std::shared_ptr<Planner> planner_;
    std::shared_ptr<SetupPlanners> planners_;
    BackgroundJob& job_;
    Messages& messages_;
    const VerificationModel& verification_;
    std::optional<TreeNode> node_;
    PartDisplayPtr display_;          ///< as shown
    StockShapePtr stock_mesh_;        ///< as read with the part
    MeshFile part_file_, stock_file_; ///< as shown
    int readings_ = 0;                ///< so many were begun
    int openings_ = 0;                ///< so many are under way
    QStringList changes_;
    bool part_replaced_ = false; ///< some of them are the part's
    bool wanted_ = false;        ///< the document's part was to be read since it was opened
    std::string tried_;          ///< Document::part_key of what was read last, or could not be
};

} // namespace facetmill::ui
