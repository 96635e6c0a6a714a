// How the part lies: the faces that it can lie on, found in the background while the panel is seen and marked
// in the view; what is picked in the view for it; every change of the placement as one step of the history.
#pragma once

#include "ui/background_job.h"
#include "ui/camera_flight.h"
#include "ui/controller.h"
#include "ui/place_gizmo.h"
#include "ui/place_panel.h"
#include "ui/place_steps.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

class Messages;
class Viewport;

class PlaceController : public Controller {
    Q_OBJECT
public:
    PlaceController(Document& document, Viewport& viewport, Messages& messages, QWidget* window);
    ~PlaceController() override;

    PlacePanel* panel() { return panel_; }
    PlaceGizmo* gizmo() { return gizmo_; }
    /// Changes of the part that wait for the one before are not made: the user cancelled that one.
    void forget_waiting() { steps_->forget_waiting(); }
    /// Ends what is picked.
    void leave() { pick(PlacePick::none); }
    const std::vector<LyingFace>& faces() const { return faces_; }
    /// What was clicked, where the part is as the project says: it comes to lie on that face, or programs
    /// count from there.
    void lay_on(const PartPick& pick);
    void zero_at(const PartPick& pick);

    void project_opened() override;
    void project_changed() override;
    void part_changed() override;
    void panel_seen(bool seen) override;
    bool take_key(const QKeyEvent& event) override;
    bool busy() const override;

signals:
    /// A click in the view is for the placement now.
    void picking_begun();

private:
    void refresh();
    void show_zero();
    void change_zero(const std::function<void(ProgramSpec&)>& edit);
    void take_hole(const PartPick& pick);
    void find_faces();
    void show_chosen();
    void lay_chosen();
    void pick(PlacePick what);
    void take(const std::optional<PartPick>& pick);
    void take_point(const PartPick& pick);
    void take_edge(const PartPick& pick);
    const Mesh* mesh() const { return steps_->part() ? steps_->part()->mesh.get() : nullptr; }

    Document& document_;
    Viewport& viewport_;
    Messages& messages_;
    PlacePanel* panel_ = nullptr;
    CameraFlight* flight_ = nullptr;
    CameraVisit visit_; ///< to a chosen face, from below
    PlaceSteps* steps_ = nullptr;
    PlaceGizmo* gizmo_ = nullptr;
    bool seen_ = false;
    std::string listed_; ///< says what the list was, or is being, made from
    std::vector<LyingFace> faces_;
    PlacePick picking_ = PlacePick::none;
    std::vector<Vec3> points_; ///< picked so far
    QString square_said_;      ///< in the bar, of a part that lies so:
    Placement said_of_;
    Box3 box_;                     ///< of the part that the view was fitted to
    BackgroundJob job_, hole_job_; // last: they end first
};

} // namespace facetmill::ui
