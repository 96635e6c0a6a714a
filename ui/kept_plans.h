// What was planned and verified, kept beside the project (core/job/kept_folder.h) as soon as it is there, and
// taken up again when the project is opened: then it is as it was left, without planning.
#pragma once

#include "core/job/setup_plan.h"
#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/kept_writing.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace facetmill::ui {

class VerificationController;
struct KeptReading;

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
    std::optional<KeptFolder> folder() const;
    void keep_soon();
    void keep();
    /// What the document has now; null: nothing new.
    std::shared_ptr<KeptWriting> collect();
    /// The same of the setups' operations and of the verdict; what is looked at goes into `now`.
    void collect_plans(KeptWriting& writing, std::vector<std::size_t>& now) const;
    void collect_verdict(KeptWriting& writing, std::vector<std::size_t>& now) const;
    void end_writing(const KeptWriting& written);
    void take_up();
    void taken(KeptReading& reading, const JobEnd& end);
    void remember(const KeptAs& kept_as);
    /// The file in which this is kept; empty: not known.
    std::string file_of(const std::shared_ptr<const void>& what) const;

    Document& document_;
    std::shared_ptr<Planner> planner_;
    std::shared_ptr<SetupPlanners> planners_;
    BackgroundJob& job_;
    VerificationController& verification_;
    std::optional<HashKey> key_; ///< none: what is kept could not be told from what others wrote
    std::shared_ptr<FileContents> contents_;
    QTimer timer_;
    std::thread thread_;
    std::vector<std::pair<std::weak_ptr<const void>, std::string>> kept_as_; ///< plans and verifications
    std::vector<std::size_t> last_; ///< what was there when it was written last
    std::string last_path_;         ///< and where to
    bool due_ = false, writing_ = false;
    bool wanted_ = false;   ///< what is kept of the opened project is not taken up yet
    bool starting_ = false; ///< and will be at once
};

} // namespace facetmill::ui
