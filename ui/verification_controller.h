// Verification and playback in the workbench: runs the one, drives the other, and shows both in the view. The
// window gives the widgets their places and passes on keys and clicks.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/playback_display.h"
#include "ui/verification_model.h"

namespace facetmill::ui {

class CameraFlight;
class LayerBar;
class PlaybackBar;
class VerificationPanel;
class Viewport;

class VerificationController : public Controller {
    Q_OBJECT
public:
    /// Panel and bar are made as children of `window`, which places them.
    VerificationController(Document& document, Viewport& viewport, LayerBar& layers, BackgroundJob& job,
                           QWidget* window);
    ~VerificationController() override;

    VerificationModel& model() { return model_; }
    PlaybackController& playback() { return playback_; }
    VerificationPanel* panel() { return panel_; }
    PlaybackBar* bar() { return bar_; }

    /// See can_judge.
    bool can_verify(std::optional<std::size_t> up_to = std::nullopt) const;
    /// Verifies the plan as it stands in the background job, or the operations up to one: they are judged by
    /// what they are to leave. Nothing where it cannot.
    /// `anyway`: also where it is known before that nothing can be verified.
    void verify(std::optional<std::size_t> up_to = std::nullopt, bool anyway = false);
    /// Takes over what a job has judged, and tells it.
    void take(const std::vector<std::shared_ptr<const VerificationOutcome>>& outcomes);
    /// Empty when what would be exported has passed; otherwise a sentence that says why it is not to be
    /// trusted.
    QString doubt() const;

    /// The user is playing back: keys and clicks on the path mean the playback.
    bool engaged() const { return engaged_; }
    /// The view was given another tool from elsewhere.
    void tool_taken() { display_.forget_tool(); }

    void project_changed() override { follow_plan(); }
    void part_changed() override { follow_plan(); }
    void plan_changed() override;
    /// Plays back to the end of an operation whose stock is chosen.
    void node_chosen(const std::optional<TreeNode>& node) override;
    /// While the user plays back, the playback goes there.
    void tool_placed(const ShownPaths& paths, const PathPick& pick) override;
    /// Space, comma, full stop; arrows while engaged.
    bool take_key(const QKeyEvent& event) override;
    void layers_toggled() override;
    bool busy() const override;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// A verification is wanted, planning first where it must.
    void verify_requested();
    /// The same of all setups.
    void verify_all_requested();
    void verified();
    /// It was left before anything was cut, as nothing could have been verified: why, in a message.
    void not_begun(const QString& message, std::optional<std::size_t> up_to);
    /// The user plays back: the stock should be seen.
    void played();
    /// A finding is by this operation: its path should be seen.
    void operation_meant(int id);
    /// Where the tool is, for the status line.
    void tool_moved(const QStringList& readout);

private:
    void follow_plan();
    void show_results();
    void show_playback();
    void show_stock_after(std::size_t operation);
    void use_scale(const DeviationScale& scale);
    void go_to_finding(std::size_t which);
    void tell(const VerificationOutcome& outcome, bool one_of_several);

    Document& document_;
    Viewport& viewport_;
    LayerBar& layers_;
    BackgroundJob& job_;
    VerificationModel model_;
    PlaybackController playback_;
    PlaybackDisplay display_;
    VerificationPanel* panel_ = nullptr;
    PlaybackBar* bar_ = nullptr;
    CameraFlight* flight_ = nullptr;

    std::vector<std::string> track_key_; ///< what the loaded playback was made from
    std::vector<std::shared_ptr<const OperationResult>> track_results_;
    bool engaged_ = false;
    bool from_finding_ = false;
    std::optional<std::size_t> wanted_finding_;          ///< once its setup is there
    std::optional<double> marked_at_;                    ///< position at which a finding's marker is shown
    std::optional<std::pair<double, double>> own_range_; ///< as the user set it
    const DeviationDisplay* shown_deviation_ = nullptr;
};

} // namespace facetmill::ui
