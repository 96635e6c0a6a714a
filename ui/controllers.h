// All controllers of the window: made here, told in a loop what happens, and connected where one wants
// something of another.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"

#include <memory>
#include <vector>

class QWidget;

namespace facetmill {
class SetupPlanners; // core/job/setup_plan.h
}

namespace facetmill::ui {

class BoundaryController;
class CSpaceController;
class DivideController;
class InputsController;
class InspectionController;
class KeptPlans;
class LayerBar;
class MeasureController;
class Messages;
class PartController;
class PathController;
class PlaceController;
class PreviewController;
class PropertiesPanel;
class RegionController;
class RoughController;
class ScanController;
class StatusLine;
class StripController;
class StudyController;
class SuggestController;
class ToolController;
class UnrolledController;
class VerificationController;
class Viewport;

class Controllers : public QObject {
    Q_OBJECT
public:
    /// What the controllers work with; all of it lives longer than they do.
    struct Parts {
        Document& document;
        BackgroundJob& job;
        std::shared_ptr<Planner> planner;
        std::shared_ptr<SetupPlanners> planners;
        Viewport& viewport;
        LayerBar& layers;
        ProjectTree& tree;
        PropertiesPanel& properties;
        StatusLine& status;
        Messages& messages;
    };
    Controllers(const Parts& parts, QWidget* window);
    ~Controllers() override;

    VerificationController& verification() { return *verification_; }
    CSpaceController& cspace() { return *cspace_; }
    InspectionController& inspection() { return *inspection_; }
    UnrolledController& unrolled() { return *unrolled_; }
    RoughController& rough() { return *rough_; }
    DivideController& divide() { return *divide_; }
    RegionController& regions() { return *regions_; }
    StripController& strips() { return *strips_; }
    PartController& part() { return *part_; }
    InputsController& inputs() { return *inputs_; }
    PlaceController& place() { return *place_; }
    MeasureController& measure() { return *measure_; }
    KeptPlans& kept() { return *kept_; }
    ScanController& scan() { return *scan_; }
    StudyController& study() { return *study_; }
    SuggestController& suggest() { return *suggest_; }

    /// Calls a function of every controller.
    template <class Function, class... Arguments>
    void tell(Function function, const Arguments&... arguments) {
        for (Controller* controller : all_)
            (controller->*function)(arguments...);
    }
    bool take_key(const QKeyEvent& event);
    bool busy() const;
    /// Below the view, each while an operation of its kind is chosen.
    std::vector<QWidget*> operation_bars();

signals:
    void settled();
    /// The verification panel has something new to say.
    void verified();

private:
    void build(const Parts& parts, QWidget* window);
    void connect_document(const Document& document);
    void connect_messages(const Document& document, Messages& messages);
    void connect_tool();
    void connect_each_other(LayerBar& layers);
    void connect_view(Viewport& viewport);

    VerificationController* verification_ = nullptr;
    RoughController* rough_ = nullptr;
    DivideController* divide_ = nullptr;
    RegionController* regions_ = nullptr;
    InspectionController* inspection_ = nullptr;
    UnrolledController* unrolled_ = nullptr;
    CSpaceController* cspace_ = nullptr;
    StripController* strips_ = nullptr;
    ToolController* tool_ = nullptr;
    PathController* paths_ = nullptr;
    PartController* part_ = nullptr;
    InputsController* inputs_ = nullptr;
    PlaceController* place_ = nullptr;
    MeasureController* measure_ = nullptr;
    KeptPlans* kept_ = nullptr;
    ScanController* scan_ = nullptr;
    StudyController* study_ = nullptr;
    QString remark_;               ///< of the part that was opened last
    QString verdict_said_;         ///< in the bar
    QString tool_said_;            ///< in the bar, of a tool that came with an operation
    long added_tool_ = 0;          ///< its number
    std::vector<Controller*> all_; ///< in the order in which they are told
    PreviewController* preview_ = nullptr;
    SuggestController* suggest_ = nullptr;
};

} // namespace facetmill::ui
