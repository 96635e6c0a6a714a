// Studies in the window: made from the project or opened, worked on in the background by processes of
// facetmill-cli or by a cluster, looked at, and adopted as one step of the history. A study goes on while
// the project is worked on; its folder lies beside the project.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/study_dialog.h"
#include "ui/study_runner.h"

#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace facetmill::ui {

class VerificationModel;

class StudyController : public Controller {
    Q_OBJECT
public:
    /// `verification`: how long a verdict took, for the estimate.
    StudyController(Document& document, const VerificationModel& verification, QWidget* window);
    ~StudyController() override;

    /// Made when it is first asked for: it has a view of its own.
    StudyDialog* dialog();
    /// The page, with a new study of the project where none is open.
    void open();
    /// A study's file, or the folder of one.
    void open_study(const QString& path);
    /// Plans and verifies what is not known yet.
    void start();
    void stop();
    void adopt(std::size_t candidate);
    /// What is known of the study; null: there is none.
    const StudyLookPtr& look() const { return look_; }
    bool running() const { return running_; }

    void project_opened() override;
    void project_changed() override { refresh(); }
    void plan_changed() override { refresh(); }
    void palette_changed(Palette palette) override;
    bool busy() const override;

signals:
    /// A study works on the project as it is saved: whoever has the files is to save it now.
    void save_wanted();

private:
    /// Where a study is read from.
    struct Source {
        std::filesystem::path file;   ///< of the study; empty: its folder alone is known
        std::filesystem::path folder; ///< empty: there is none yet
    };
    void connect_dialog();
    void new_study();
    void ask_for_study();
    bool write_file();
    void run(bool make, const StudyPlace& place);
    void run_on_slurm(bool make, const StudyPlace& place);
    void end(StudyLookPtr look, const JobEnd& end);
    void watch_slurm();
    void take_news();
    void take(StudyLookPtr look);
    void refresh();
    void tell_outcome();
    void export_table();
    void export_picture();

    Document& document_;
    const VerificationModel& verification_;
    QWidget* window_;
    StudyDialog* dialog_ = nullptr; ///< null until it was asked for
    Palette palette_ = Palette::light;
    Source source_;
    std::shared_ptr<const StudyFolder> folder_;
    StudyLookPtr look_;
    std::shared_ptr<StudyNews> news_;
    std::string drafted_; ///< the project that the form was made from
    QString problem_;     ///< why the last thing did not work
    QString handed_;      ///< what Slurm was given; empty: nothing is under way there
    bool running_ = false;
    QTimer poll_, slurm_;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
