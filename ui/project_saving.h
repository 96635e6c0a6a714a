// Writing the project to its file, aside from the window: a slow disk holds up nobody. It is saved when the
// window says so, and what was changed meanwhile stays unsaved.
#pragma once

#include "ui/document.h"

#include <QWidget>

#include <filesystem>
#include <memory>

namespace facetmill::ui {

class Messages;
class PropertiesPanel;

class ProjectSaving : public QObject {
    Q_OBJECT
public:
    /// `sample_folder`: whose meshes a project takes along.
    ProjectSaving(Document& document, Messages& messages, PropertiesPanel& properties,
                  std::filesystem::path sample_folder, QWidget* window);
    /// What was begun is written.
    ~ProjectSaving() override;

    /// Begins to write the project as it is now, to its own file, or to one that the user is asked for. What
    /// comes of it is told in the window. False: there is nothing to wait for, since the user gave up or a
    /// parameter is not valid.
    bool save();
    bool save_as();
    bool save_to(const QString& path);
    /// Waits until all is written that was begun, while the window is still drawn. False: the last of it
    /// could not be written.
    bool finish();
    /// Something is being written.
    bool busy() const { return begun_ > 0; }

signals:
    /// The project stands there, under this name.
    void saved(const QString& path);
    void settled();

private:
    struct Writing;
    void end(const Writing& written);
    void take(const Writing& written);

    Document& document_;
    Messages& messages_;
    PropertiesPanel& properties_;
    std::filesystem::path sample_folder_;
    QWidget* window_;
    int begun_ = 0;              ///< how many are under way
    int opened_ = 0;             ///< how many projects were shown before this one
    int changes_ = 0;            ///< how often the project has changed
    bool written_ = true;        ///< the last one was
    std::filesystem::path last_; ///< where the last one goes, while it is under way
};

/// Asks for the file of a project; empty where the user gives up.
QString ask_project_name(QWidget* window, const QString& title, const QString& start);

} // namespace facetmill::ui
