// What was planned and verified, kept beside the project (core/job/kept_folder.h) as soon as it is there, and
// taken up again when the project is opened: then it is as it was left, without planning.
#pragma once

#include "core/job/kept_folder.h"
#include "core/job/setup_plan.h"
#include "ui/background_job.h"
#include "ui/controller.h"

#include <QTimer>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace facetmill::ui {

class VerificationController;
struct VerificationOutcome;

/// The content of files, as text, each looked at once as it is on disk.
class FileContents {
public:
    explicit FileContents(const HashKey& key) : key_(key) {}
    /// Throws what InputFile does.
    std::string text(const std::filesystem::path& path, const Progress& progress);
    /// For document_keys.h; only as long as this and the progress live.
    FileText texts(const Progress& progress) {
        return [this, &progress](const std::filesystem::path& path) { return text(path, progress); };
    }

private:
    HashKey key_;
    std::mutex mutex_;
    std::map<std::string, std::string> known_; ///< by stamp
};

class KeptPlans : public Controller {
    Q_OBJECT
public:
    /// `planner`: of the shown setup; `planners`: of those whose stock it goes on with.
    KeptPlans(Document& document, std::shared_ptr<Planner> planner, std::shared_ptr<SetupPlanners> planners,
              BackgroundJob& job, VerificationController& verification, QObject* window);
    /// What is not written yet is written.
    ~KeptPlans() override;

    void project_opened() override;
    void project_changed() override { keep_soon(); }
    void part_changed() override;
    void plan_changed() override { keep_soon(); }
    bool busy() const override { return due_ || writing_ || starting_; }

signals:
    /// Operations are planned as they were.
    void taken_up();

private:
    struct Entry;
    struct Writing;
    struct Reading;

    std::optional<KeptFolder> folder() const;
    void keep_soon();
    void keep();
    /// What the document has now; null: nothing new.
    std::shared_ptr<Writing> collect();
    void end_writing(const Writing& written);
    void take_up();
    void taken(Reading& reading, const JobEnd& end);

    Document& document_;
    std::shared_ptr<Planner> planner_;
    std::shared_ptr<SetupPlanners> planners_;
    BackgroundJob& job_;
    VerificationController& verification_;
    std::optional<HashKey> key_; ///< none: what is kept could not be told from what others wrote
    std::shared_ptr<FileContents> contents_;
    QTimer timer_;
    std::thread thread_;
    std::vector<std::size_t> last_; ///< what was there when it was written last
    std::string last_path_;         ///< and where to
    bool due_ = false, writing_ = false;
    bool wanted_ = false;   ///< what is kept of the opened project is not taken up yet
    bool starting_ = false; ///< and will be at once
};

} // namespace facetmill::ui
