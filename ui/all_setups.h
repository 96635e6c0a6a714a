// All setups of a document in one job: planned in machining order, each on the stock that those before it
// leave, and judged as what they are together.
#pragma once

#include "core/job/setup_plan.h"
#include "ui/background_job.h"
#include "ui/document.h"

namespace facetmill::ui {

class Messages;
class PartController;
class PropertiesPanel;
class VerificationController;

class AllSetups : public QObject {
    Q_OBJECT
public:
    /// `planner`: of the shown setup; `planners`: of each, of which that is none.
    AllSetups(Document& document, std::shared_ptr<Planner> planner, std::shared_ptr<SetupPlanners> planners,
              BackgroundJob& job, Messages& messages, PartController& part, PropertiesPanel& properties,
              VerificationController& verification, QObject* window);

    /// Plans what is not planned as it stands.
    void plan() { start(false); }
    /// The same, and then verifies; setups that cut one stock as one job.
    void verify() { start(true); }
    /// There are several setups, and nothing runs.
    bool can_plan() const;

signals:
    /// Values that are being typed elsewhere are to be taken over now.
    void about_to_plan();

private:
    struct Work;
    void start(bool verify);
    /// Asks where the work would be more than usual (work_estimate.h).
    bool may_be_large(const Work& work);
    /// In the job's thread.
    static void run(Work& work, SetupPlanners& planners, const Progress& progress);
    void finish(Work& work, const JobEnd& end);

    Document& document_;
    std::shared_ptr<Planner> planner_;
    std::shared_ptr<SetupPlanners> planners_;
    BackgroundJob& job_;
    Messages& messages_;
    PartController& part_;
    PropertiesPanel& properties_;
    VerificationController& verification_;
};

} // namespace facetmill::ui
