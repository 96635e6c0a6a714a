// The workbench's window: the view in the middle, project and parameters on the left, the report on the
// right, the log below. Long work runs in two background jobs: one that reads, plans and writes (with the
// Planner, so one at a time), and one that makes planned paths ready to be drawn.
#pragma once

#include "core/strategy/cleanup/cleanup.h"
#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/icons.h"
#include "ui/message_bar.h"
#include "ui/theme.h"
#include "viz/scene.h"

#include <QMainWindow>

#include <filesystem>
#include <optional>

class QAction;
class QComboBox;
class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace facetmill::ui {

class CSpaceController;
class ElidedLabel;
class InspectionController;
class LayerBar;
class LogView;
class ProjectTree;
class PropertiesPanel;
class RegionController;
class ReportView;
class RoughController;
class StartHint;
class StripController;
class ToolDialog;
class UnrolledController;
class VerificationController;
class Viewport;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a project or a mesh, after asking what to do with unsaved changes. `unit` answers the question
    /// in which unit a mesh is; without it the user is asked.
    void open_file(const QString& path, std::optional<LengthUnit> unit = std::nullopt);
    void new_from_sample(const std::string& name);
    /// Plans all operations, or one.
    void plan(std::optional<std::size_t> only = std::nullopt);
    /// Verifies the plan; what is not planned as it stands is planned first.
    void verify();
    void cancel();
    void select_last_operation();
    /// Makes a mesh the stock, as a step of the history; it is read in the background.
    void set_stock_file(const QString& path);
    /// Writes to `path`; false when that failed, with the reason in the window.
    bool save_to(const QString& path);
    /// Writes the program files and report.json into `folder`, in the background.
    void export_to(const QString& folder);
    /// Writes the setup sheet of the plan as it was verified, with the view as it is, in the background.
    void save_sheet(const QString& path);
    bool save_picture(const QString& path);
    void set_theme(Theme theme);
    void set_unit(LengthUnit unit);

    /// True while a job runs or a picture is due.
    bool busy() const;
    /// The last thing that failed, until something succeeds.
    const QString& last_failure() const { return last_failure_; }

    Document& document() { return document_; }
    Viewport& viewport() { return *viewport_; }
    ProjectTree& tree() { return *tree_; }
    PropertiesPanel& properties() { return *properties_; }
    LayerBar& layers() { return *layers_; }
    MessageBar& message_bar() { return *message_; }
    ReportView& report() { return *report_; }
    VerificationController& verification() { return *controller_; }
    CSpaceController& cspace() { return *cspace_; }
    InspectionController& inspection() { return *inspection_; }
    UnrolledController& unrolled() { return *unrolled_; }
    RoughController& roughing() { return *rough_; }
    RegionController& regions() { return *regions_; }
    StripController& strips() { return *strips_; }
    BackgroundJob& job() { return job_; }

signals:
    /// The window is through with what it was asked to do.
    void settled();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct LoadedPart {
        std::shared_ptr<const PreparedPart> part;
        PartDisplayPtr display;
        StockShapePtr stock;   ///< of a stock that is a mesh
        QString stock_failure; ///< why there is none though there should be
        std::string key;
    };
    struct PlanWork;

    // main_window.cpp
    void build_docks();
    void build_status_bar();
    void connect_parts();
    void update_title();
    void update_actions();
    void restore_window();
    void arrange_report();
    void tell(MessageBar::Kind kind, const QString& message, bool in_bar = true);
    void fail(const QString& message);
    void ended(const JobEnd& end);
    void check_settled();

    // main_window_actions.cpp
    void build_actions();
    void build_menus();
    QAction* add_action(std::optional<Icon> icon, const QString& text, const QKeySequence& key,
                        const char* name, const std::function<void()>& run);
    void show_shortcuts();
    void show_about();
    void fill_recent_menu();

    // main_window_files.cpp
    bool may_discard();
    void open_with_dialog();
    void choose_stock();
    void open_project(const std::filesystem::path& path);
    void open_mesh(const std::filesystem::path& path, std::optional<LengthUnit> unit);
    void read_mesh(const std::filesystem::path& path, LengthUnit unit, std::function<void(LoadedPart)> then);
    void ask_unit(const std::filesystem::path& path, LoadedPart loaded);
    void take_mesh(const std::filesystem::path& path, LengthUnit unit, LoadedPart loaded, const QString& name,
                   bool turned = false);
    void close_project();
    bool save();
    bool save_as();
    void export_with_dialog();
    bool may_export();
    void sheet_with_dialog();
    /// Says why not.
    bool may_write_sheet();
    void picture_with_dialog();

    // main_window_plan.cpp
    static LoadedPart load_part(Planner& planner, const Project& project, const Progress& progress);
    void reload_part();
    void show_part(const LoadedPart& loaded, bool new_view);
    void show_stock();
    void planned(const std::shared_ptr<PlanWork>& work, const JobEnd& end);
    void refresh_paths();
    std::vector<PathSource> path_sources() const;
    /// Of the operation whose path is seen alone: the chosen one, if it has a path and others are not wanted.
    std::optional<int> shown_alone() const;
    /// `keep_tool`: where it is, if that is seen; else it goes to the start of what is drawn.
    void draw_paths(bool keep_tool = false);
    void show_tool_at(const PathPick& pick);
    void show_start_of_path();
    void hide_tool();
    void step_tool(int by);
    void show_motion(std::size_t source, std::size_t motion);
    /// Place of a program among those shown; none where it is not.
    std::optional<std::size_t> source_of(const std::shared_ptr<const OperationResult>& program) const;
    /// The tool that a shown program is cut with. Throws Error(missing_reference).
    const Tool& tool_of(std::size_t source) const;
    /// Number of the motion; of a contact the one that cuts it.
    std::size_t motion_of(const PathPick& pick) const;
    void edit_tool(std::optional<std::size_t> index);

    // main_window_cspace.cpp
    void build_cspace();
    void show_cspace_tool(int operation, const std::optional<CutterLocation>& pose, const Marker& contact,
                          const QString& readout);
    void follow_cspace(const PathPick& pick);
    void export_cspace(bool table);
    void build_inspection();
    void export_chart(bool table);

    // main_window_unrolled.cpp
    void build_unrolled();
    void offer_unrolled();
    void export_unrolled();

    // main_window_strips.cpp
    void build_strips();
    void offer_strips();
    void show_touch(const Tool& tool, const CleanupRecord::Touch& touch);
    void hide_touch();
    /// The contact or place that was picked lies on a strip that the list has.
    bool pick_strip(const PathPick& pick);

    // main_window_pick.cpp
    void build_pick();
    void pick_point(const std::string& key);
    void take_picked(const std::optional<PartPick>& pick, Qt::KeyboardModifiers modifiers);
    void end_pick();

    Document document_;
    std::shared_ptr<Planner> planner_ = std::make_shared<Planner>();

    Viewport* viewport_ = nullptr;
    StartHint* hint_ = nullptr;
    ProjectTree* tree_ = nullptr;
    PropertiesPanel* properties_ = nullptr;
    ReportView* report_ = nullptr;
    LogView* log_ = nullptr;
    LayerBar* layers_ = nullptr;
    VerificationController* controller_ = nullptr;
    CSpaceController* cspace_ = nullptr;
    InspectionController* inspection_ = nullptr;
    UnrolledController* unrolled_ = nullptr;
    RoughController* rough_ = nullptr;
    RegionController* regions_ = nullptr;
    StripController* strips_ = nullptr;
    MessageBar* message_ = nullptr;
    QDockWidget *project_dock_ = nullptr, *properties_dock_ = nullptr, *report_dock_ = nullptr,
                *log_dock_ = nullptr, *verification_dock_ = nullptr, *cspace_dock_ = nullptr,
                *chart_dock_ = nullptr, *unrolled_dock_ = nullptr, *strips_dock_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* activity_ = nullptr;
    ElidedLabel* readout_ = nullptr;
    QToolButton* cancel_button_ = nullptr;
    QComboBox* unit_box_ = nullptr;
    QMenu *recent_menu_ = nullptr, *sample_menu_ = nullptr, *view_menu_ = nullptr;
    QAction *new_ = nullptr, *open_ = nullptr, *save_ = nullptr, *save_as_ = nullptr, *export_ = nullptr,
            *sheet_ = nullptr, *picture_ = nullptr, *undo_ = nullptr, *redo_ = nullptr, *plan_ = nullptr,
            *verify_ = nullptr, *cancel_ = nullptr, *fit_ = nullptr;
    std::vector<QAction*> theme_actions_, unit_actions_, view_actions_;

    QString last_failure_, sample_folder_, readout_text_;
    std::string picked_key_; ///< of the parameter whose point is being picked; empty: none
    /// Programs of the operations in the order of the scene's path sources, and their operations.
    std::vector<std::shared_ptr<const OperationResult>> shown_results_;
    std::vector<int> shown_ids_;
    std::optional<int> drawn_alone_; ///< shown_alone when the paths were drawn
    std::vector<std::shared_ptr<const OperationResult>> drawn_results_; ///< the ones in the view already
    std::optional<PathPick> tool_at_;
    StockShapePtr stock_mesh_;      ///< as read with the part
    bool cspace_offered_ = false;   ///< the room came to light once
    bool unrolled_offered_ = false; ///< the unrolled view came to light once
    bool strips_offered_ = false;   ///< the list of strips came to light once
    bool chart_sized_ = false;      ///< the charts' dock had its height given
    bool settling_ = false;
    bool verify_next_ = false;           ///< when the planning under way is through
    std::vector<QDockWidget*> made_way_; ///< put behind the parameters because the window is narrow
    // Last, so that they end first: their work uses the planner.
    BackgroundJob job_, display_job_;
};

} // namespace facetmill::ui
