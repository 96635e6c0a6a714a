// The project and the meshes on disk: new, opened, saved, with the questions that belong to it.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"
#include "ui/part_controller.h"

#include <QWidget>

#include <filesystem>

namespace facetmill::ui {

class Autosave;
class Messages;
class ProjectSaving;
class PropertiesPanel;

class ProjectFiles : public QObject {
    Q_OBJECT
public:
    ProjectFiles(Document& document, std::shared_ptr<Planner> planner, BackgroundJob& job, Messages& messages,
                 PartController& part, PropertiesPanel& properties, ProjectTree& tree, QWidget* window);

    ~ProjectFiles() override;

    /// Asks what to do with unsaved changes. False: the user would rather stay.
    bool may_discard();
    /// The same as the window closes: what is not saved by then is not wanted.
    bool may_close();
    Autosave& autosave() { return *autosave_; }
    void close_project();
    void open_with_dialog();
    /// Opens a project or a mesh, after asking what to do with unsaved changes. `unit` answers the question
    /// in which unit a mesh is; without it the user is asked.
    void open(const QString& path, std::optional<LengthUnit> unit = std::nullopt);
    /// Opens what was dropped, or says why not.
    void open_dropped(const QStringList& paths);
    /// Shows a project as one that is not saved; `name` calls it while it has no path.
    void restore(Project project, const QString& name);
    void new_from_sample(const std::string& name);
    void open_program_with_dialog();
    /// Shows CL files, which run one after the other, in place of the plan.
    void open_program(const QStringList& files);
    /// Saves aside from the window.
    ProjectSaving& saving() { return *saving_; }
    /// The same, and waits for it. False when that failed, with the reason in the window.
    bool save();
    bool save_to(const QString& path);
    bool busy() const;
    void save_packed_with_dialog();
    /// Packs a copy of the project in the background; the project itself stays where it is.
    void save_packed_to(const QString& path);

    void choose_stock();
    /// The same for a fixture, by its place; behind the last one: a new one.
    void choose_fixture(std::size_t index);
    /// Makes a mesh the stock, as a step of the history; it is read in the background.
    void set_stock_file(const QString& path);

signals:
    /// The project has another name on disk.
    void renamed();
    void settled();

private:
    void open_project(const std::filesystem::path& path);
    /// Asks for a folder, unpacks there and opens what was unpacked.
    void open_packed(const std::filesystem::path& path);
    void unpack(const std::filesystem::path& path, const std::filesystem::path& folder);
    void show_project(Project project, const QString& name, bool unsaved);
    void open_mesh(const std::filesystem::path& path, std::optional<LengthUnit> unit);
    void read_mesh(const std::filesystem::path& path, LengthUnit unit, std::function<void(LoadedPart)> then);
    void ask_unit(const std::filesystem::path& path, const LoadedPart& loaded);
    void take_mesh(const std::filesystem::path& path, LengthUnit unit, LoadedPart loaded, const QString& name,
                   bool turned = false);
    QString chosen_file(const QString& title, const QString& filter) const;

    Document& document_;
    std::shared_ptr<Planner> planner_;
    BackgroundJob& job_;
    Messages& messages_;
    PartController& part_;
    PropertiesPanel& properties_;
    ProjectTree& tree_;
    QWidget* window_;
    QString sample_folder_;
    std::unique_ptr<Autosave> autosave_;
    ProjectSaving* saving_;
};

} // namespace facetmill::ui
