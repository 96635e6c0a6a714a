// The configuration space in the workbench: which contact point is looked at, its study in the background,
// and the panel that shows it. The tool in the part view follows the posture that is chosen here.
#pragma once

#include "ui/controller.h"
#include "ui/cspace_studies.h"
#include "ui/kept_postures.h"
#include "viz/cspace_display.h"

#include <memory>
#include <optional>

namespace facetmill::ui {

class CSpacePanel;

class CSpaceController : public Controller {
    Q_OBJECT
public:
    CSpaceController(Document& document, QWidget* window);
    ~CSpaceController() override;

    CSpacePanel* panel() { return panel_; }

    /// Goes to the contact point of this operation that is nearest to a place. Nothing, and false, when the
    /// operation has no configuration spaces.
    bool go_near(int operation, const std::shared_ptr<const OperationResult>& result, const Vec3& place);
    /// Stands at no point any more.
    void leave();
    /// There is a point, and the panel is to be seen.
    bool active() const;
    /// Along the pass and over passes, as far as there are any.
    void step(int points, int passes);
    /// The program that the point belongs to; null: there is none.
    const std::shared_ptr<const OperationResult>& program() const { return result_; }
    /// Number of the contact point it stands at.
    std::optional<std::size_t> point() const { return at_; }
    std::size_t point_count() const;
    /// The study of the point it stands at, once it is there.
    const FiveAxisStudy::Point* shown() const { return shown_.get(); }
    /// The posture that is tried out in the part view.
    const std::optional<PostureValue>& tried() const { return tried_; }
    void try_posture(const PostureValue& posture);
    void show_choice(std::size_t choice);
    /// Keeps the tried posture for the point, as a step of the history; planning again uses it. Nothing where
    /// none is tried that is free.
    void keep();
    /// What was kept for the point is forgotten.
    void remove_kept();
    /// The posture kept for the point by the operation as it stands, planned with it or not.
    std::optional<ManualPosture> kept() const;

    /// Written aside; what comes of it is told in the window.
    void save_picture(const QString& path);
    void save_table(const QString& path);
    /// Arrow keys, while it is seen.
    bool take_key(const QKeyEvent& event) override;
    void project_changed() override;
    void tool_placed(const ShownPaths& paths, const PathPick& pick) override;
    void tool_removed() override { leave(); }
    void palette_changed(Palette palette) override;
    /// Studies what is wanted once it is seen.
    void panel_seen(bool seen) override;
    bool busy() const override;

signals:
    /// The tool of a program belongs here, at a contact; no pose: the point is left to clean-up.
    void tool_wanted(const std::shared_ptr<const facetmill::OperationResult>& program,
                     const std::optional<facetmill::CutterLocation>& pose, const facetmill::Marker& contact,
                     const QStringList& readout);

private:
    QString export_name() const;
    void stand_at(std::size_t index);
    void show_kept();
    void study();
    void show_point(std::shared_ptr<const FiveAxisStudy::Point> point);
    void clear_view(const QString& text);
    void show_hover(const std::optional<CSpaceDisplay::Hit>& hit);
    QString reason_text(const PostureValue& posture, bool with_lift = true) const;
    bool can_be_kept(const PostureValue& posture) const;
    void show_tool(const std::optional<PostureValue>& posture, const QString& what);
    CutterLocation pose(const PostureValue& posture) const;
    QString heading() const;

    Document& document_;
    KeptPostures kept_;
    CSpacePanel* panel_ = nullptr;
    std::shared_ptr<const OperationResult> result_;
    std::shared_ptr<const FiveAxisRecord> record_;
    std::shared_ptr<const CutterProfile> cutter_;
    std::optional<std::size_t> at_;
    std::optional<PostureValue> tried_;
    std::shared_ptr<const FiveAxisStudy::Point> shown_;
    CSpaceStudies* studies_ = nullptr;
};

} // namespace facetmill::ui
