// What leaves the workbench: programs with their report, the setup sheet, a picture of the view. Programs
// that were not verified leave only after a question.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"

#include <QWidget>

namespace facetmill::ui {

class MeshExport;
class Messages;
class PropertiesPanel;
class VerificationController;
class Viewport;

class ProgramExport : public QObject {
    Q_OBJECT
public:
    ProgramExport(const Document& document, BackgroundJob& job, Messages& messages,
                  PropertiesPanel& properties, Viewport& viewport, VerificationController& verification,
                  QWidget* window);

    void programs_with_dialog();
    /// The program of one operation alone.
    void program_with_dialog(std::size_t operation) { ask_folder(operation); }
    /// Writes the program files and report.json into `folder`, in the background; of one operation alone.
    void save_programs(const QString& folder, std::optional<std::size_t> only = std::nullopt);
    void sheet_with_dialog();
    /// Writes the setup sheet of the plan as it was verified, with the view as it is, in the background.
    void save_sheet(const QString& path);
    MeshExport& meshes() { return *meshes_; }
    void picture_with_dialog();
    /// Written aside; what comes of it is told in the window.
    void save_picture(const QString& path);

signals:
    /// The user would rather verify first.
    void verify_wanted();
    /// Program files lie where they were wanted.
    void programs_written();

private:
    void ask_folder(std::optional<std::size_t> only);
    bool may_export();
    /// Says why not.
    bool may_write_sheet();

    const Document& document_;
    BackgroundJob& job_;
    Messages& messages_;
    PropertiesPanel& properties_;
    Viewport& viewport_;
    VerificationController& verification_;
    QWidget* window_;
    MeshExport* meshes_;
};

} // namespace facetmill::ui
