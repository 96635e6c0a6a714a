// The scan room: the part's file surveyed in the background while the panel is seen, a recipe that is edited
// beside the project, tried in the background and seen before and after, and taken over as one step of the
// history.
#pragma once

#include "ui/background_job.h"
#include "ui/controller.h"
#include "ui/scan_panel.h"
#include "ui/scan_study.h"

#include <optional>
#include <string>
#include <vector>

class QAction;

namespace facetmill::ui {

class ScanView;
class Viewport;

class ScanController : public Controller {
    Q_OBJECT
public:
    /// `meshes`: what was read and repaired here is not done again where the part is read, and the other way
    /// round.
    ScanController(Document& document, std::shared_ptr<KnownMeshes> meshes, Viewport& viewport,
                   QWidget* window);
    ~ScanController() override;

    ScanPanel* panel() { return panel_; }
    /// Brings the panel to the front.
    void open();
    /// The same, for menus.
    QAction* open_action() { return open_action_; }
    /// The recipe as it is edited.
    const std::vector<RepairStep>& recipe() const { return draft_; }
    /// The file as it is; null until it was read.
    const ScannedMeshPtr& scan() const { return scan_; }
    /// What was tried last, to its end or to where it failed; null: nothing of this file.
    const ScanTrialPtr& trial() const { return trial_; }

    void project_opened() override;
    void project_changed() override { refresh(); }
    void part_changed() override { refresh(); }
    void panel_seen(bool seen) override;
    bool take_key(const QKeyEvent& event) override;
    bool busy() const override;

signals:
    /// It was brought to the front.
    void opened();

private:
    /// A side of the preview that the view shows.
    enum class Side { none, before, after };
    void connect_panel();
    void refresh();
    void follow_project();
    /// Reads and surveys the file, unless that was done.
    void survey();
    void list_survey();
    void preview();
    void end_preview(const std::shared_ptr<ScanTrial>& trial, const JobEnd& end);
    void apply();
    void suggest();
    void add(RepairStep::Kind kind);
    void edit(const std::string& key, const ParameterValue& value);
    void change(std::vector<RepairStep> recipe, std::optional<std::size_t> chosen);
    /// What a step came to, where it was tried as the recipe has it now.
    TriedStepPtr tried(std::size_t i) const;
    bool is_tried() const;

    void show_all();
    void show_steps();
    void show_step();
    void show_footer();
    QString summary() const;
    void show_in_view();

    Document& document_;
    std::shared_ptr<KnownMeshes> meshes_;
    ScanPanel* panel_ = nullptr;
    ScanView* view_ = nullptr;
    QAction* open_action_ = nullptr;
    bool seen_ = false;
    std::vector<RepairStep> applied_, draft_; ///< of the project; as it is edited
    std::optional<std::size_t> chosen_;
    std::string key_, place_key_; ///< of what was, or is being, surveyed; of where it was tried
    ScannedMeshPtr scan_;
    ScanTrialPtr trial_, known_; ///< known: whose steps need not be carried out again
    Side side_ = Side::none;
    LengthUnit shown_unit_ = LengthUnit::mm; ///< of the lengths in the survey
    QString failure_;                        ///< why there is no survey
    BackgroundJob job_, read_;               // last: they end first
};

} // namespace facetmill::ui
