// The files that the project names beside itself: tells which are missing, asks for others in their place,
// and puts another part in the place of the project's.
#pragma once

#include "core/job/project_inputs.h"
#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/part_controller.h"

namespace facetmill::ui {

class InputsController : public Controller {
    Q_OBJECT
public:
    InputsController(Document& document, std::shared_ptr<Planner> planner, BackgroundJob& job,
                     Messages& messages, PartController& part, QWidget* window);

    /// As they were looked for last.
    const std::vector<ProjectInput>& missing() const { return missing_; }
    /// Asks for the first missing file.
    void locate_with_dialog();
    /// Names `file` in its place, and others that lie beside it, as one step of the history once it was read.
    void locate(const QString& file);
    void replace_part_with_dialog();
    /// Makes a mesh the part, as one step of the history once it was read.
    void replace_part(const QString& file);

    void project_opened() override;
    void project_changed() override { look(); }
    void plan_changed() override { look(); }

private:
    void look();
    void tell(const QString& before = {}, bool warn = false);
    MessageAction locate_action();
    /// A button beside the message in the bar, where a job has failed for a missing file.
    void offer_for_message();
    QString missing_text() const;
    /// Reads the meshes of a project that names other files, makes that a step of the history, and tells what
    /// was `found` and what has become of the part. `for_stock`: nothing of that where the stock cannot be
    /// read.
    void take(const Project& candidate, const QString& step, const QString& found, bool for_stock = false);
    /// `asked`: the file that the user was asked for.
    void take_located(const Project& candidate, const ProjectInput& asked, const QString& found);
    QString chosen_file(const QString& title, const std::filesystem::path& before,
                        const QString& filter) const;

    Document& document_;
    std::shared_ptr<Planner> planner_;
    BackgroundJob& job_;
    Messages& messages_;
    PartController& part_;
    QWidget* window_;
    std::vector<ProjectInput> missing_;
    QString told_; ///< the last message about missing files
};

} // namespace facetmill::ui
