// Planning, in the background: operation by operation, so that one that fails leaves the others planned; and
// planning that a verification follows.
#pragma once

#include "core/job/setup_plan.h"
#include "ui/background_job.h"
#include "ui/document.h"

namespace facetmill::ui {

class AllSetups;
class Messages;
class PartController;
class PropertiesPanel;
class VerificationController;

class PlanRunner : public QObject {
    Q_OBJECT
public:
    /// `planner`: of the shown setup; `planners`: of those whose stock it goes on with.
    PlanRunner(Document& document, std::shared_ptr<Planner> planner, std::shared_ptr<SetupPlanners> planners,
               BackgroundJob& job, Messages& messages, PartController& part, PropertiesPanel& properties,
               VerificationController& verification, QObject* window);

    /// Plans all operations, or one.
    void plan(std::optional<std::size_t> only = std::nullopt);
    /// Verifies the plan, or the operations up to one; what is not planned as it stands is planned first.
    void verify(std::optional<std::size_t> up_to = std::nullopt);
    AllSetups& all_setups() { return *all_setups_; }
    /// There is something to plan, and nothing runs.
    bool can_plan() const;

signals:
    /// Values that are being typed elsewhere are to be taken over now.
    void about_to_plan();
    /// Operations were planned, or failed; the first of them.
    void planned(std::size_t first);

private:
    struct Work;
    void start(const std::vector<std::size_t>& wanted);
    /// In the job's thread; `planned` is told of every operation as it is through.
    static void run(Work& work, Planner& planner, SetupPlanners& earlier, const Progress& progress,
                    const std::function<void(const OperationOutcome&)>& planned);
    /// Takes over what is planned while the others still are.
    void take(Work& work, const OperationOutcome& outcome);
    void finish(Work& work, const JobEnd& end);

    Document& document_;
    std::shared_ptr<Planner> planner_;
    std::shared_ptr<SetupPlanners> earlier_;
    AllSetups* all_setups_ = nullptr;
    BackgroundJob& job_;
    Messages& messages_;
    PartController& part_;
    PropertiesPanel& properties_;
    VerificationController& verification_;
    /// When the planning under way is through; the operation up to which, where that is not all.
    bool verify_next_ = false;
    std::optional<std::size_t> verify_to_;
};

} // namespace facetmill::ui
