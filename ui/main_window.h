// The workbench's window: the view in the middle, project and parameters on the left, the report and other
// panels on the right, the log below. It makes the parts and connects them; what is done stands in the parts
// (see ui/README.md).
#pragma once

#include "ui/background_job.h"
#include "ui/command.h"
#include "ui/document.h"
#include "ui/messages.h"
#include "ui/theme.h"
#include "viz/scene.h"

#include <QMainWindow>

#include <memory>
#include <optional>

namespace facetmill::ui {

class Controllers;
class CSpaceController;
class InspectionController;
class LayerBar;
class LogView;
class PlanRunner;
class ProgramExport;
class ProjectFiles;
class ProjectTree;
class PropertiesPanel;
class RegionController;
class ReportView;
class RoughController;
class StartHint;
class StatusLine;
class Templates;
class UnrolledController;
class ViewMenu;
class VerificationController;
class Viewport;
class WindowDocks;
class Workspaces;

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
    void set_theme(Theme theme);
    Theme theme() const { return theme_; }

    /// Brings what can be done, and how, up to date.
    void update_commands();
    void show_place(); ///< the panel that lays the part
    /// True while a job runs or a picture is due.
    bool busy() const;
    /// The last thing that failed, until something succeeds.
    const QString& last_failure() const;

    Document& document() { return document_; }
    BackgroundJob& job() { return job_; }
    ProjectFiles& files() { return *files_; }
    ProgramExport& exports() { return *exports_; }
    Templates& templates() { return *templates_; }
    PlanRunner& planning() { return *planning_; }
    Viewport& viewport() { return *viewport_; }
    ProjectTree& tree() { return *tree_; }
    PropertiesPanel& properties() { return *properties_; }
    LayerBar& layers() { return *layers_; }
    Workspaces& workspaces() { return *workspaces_; }
    MessageBar& message_bar() { return *message_bar_; }
    StartHint& start_page() { return *hint_; }
    Messages& messages() { return *messages_; }
    ReportView& report() { return *report_; }
    Controllers& controllers() { return *controllers_; }
    VerificationController& verification();
    CSpaceController& cspace();
    InspectionController& inspection();
    UnrolledController& unrolled();
    RoughController& roughing();
    RegionController& regions();

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
    void build_parts();
    void build_docks();
    void build_commands();
    void connect_document();
    void connect_panels();
    void connect_jobs();
    void restore_window();
    void update_title();
    void edit_tool(std::optional<std::size_t> index);
    void check_settled();

    Document document_;
    std::shared_ptr<Planner> planner_ = std::make_shared<Planner>();
    Theme theme_ = Theme::system;
    bool settling_ = false;

    Viewport* viewport_ = nullptr;
    StartHint* hint_ = nullptr;
    ViewMenu* view_menu_ = nullptr;
    MessageBar* message_bar_ = nullptr;
    LayerBar* layers_ = nullptr;
    Workspaces* workspaces_ = nullptr;
    LogView* log_ = nullptr;
    ProjectTree* tree_ = nullptr;
    PropertiesPanel* properties_ = nullptr;
    ReportView* report_ = nullptr;
    StatusLine* status_ = nullptr;
    WindowDocks* docks_ = nullptr;
    std::unique_ptr<Messages> messages_;
    std::unique_ptr<Commands> commands_;
    Controllers* controllers_ = nullptr;
    PlanRunner* planning_ = nullptr;
    std::unique_ptr<ProjectFiles> files_; // keeps what is not saved: goes before the document
    ProgramExport* exports_ = nullptr;
    Templates* templates_ = nullptr;
    BackgroundJob job_; // last, so that it ends first: its work uses the planner
};

} // namespace facetmill::ui
