// The configuration-space room in the workbench: which contact point it stands at, its study in the
// background, and the panel that shows it. The window gives the panel its place, and shows the tool where the
// desk says.
#pragma once

#include "core/job/planner.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/five_axis/manual_posture.h"
#include "ui/background_job.h"
#include "ui/document.h"
#include "viz/cspace_room.h"
#include "viz/scene.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QToolButton;

namespace facetmill::ui {

class CSpaceView;
class ElidedLabel;

/// Heading, buttons, the room, its legend, and a line for what is under the pointer.
class CSpacePanel : public QWidget {
    Q_OBJECT
public:
    explicit CSpacePanel(QWidget* parent = nullptr);

    CSpaceView* view() { return view_; }
    ElidedLabel* heading() { return heading_; }
    QLabel* readout() { return readout_; }
    QToolButton* back() { return back_; }
    QToolButton* keep() { return keep_; }
    QToolButton* remove() { return remove_; }
    QToolButton* kept() { return kept_; }
    void set_busy(bool busy, double fraction = 0);
    /// Buttons for what is there: a point, its study.
    void set_ready(bool point, bool study);
    void show_legend();
    QSize sizeHint() const override { return {400, 460}; }

signals:
    void stepped(int points, int passes);
    void cancel_requested();
    void picture_requested();
    void table_requested();
    void back_requested(); ///< to the planned posture
    void keep_requested(); ///< of the tried posture for the point
    void remove_requested();

private:
    QToolButton* button(int which, const QString& tip, const char* name);
    CSpaceView* view_ = nullptr;
    ElidedLabel* heading_ = nullptr;
    QLabel* readout_ = nullptr;
    QWidget* legend_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QToolButton *cancel_ = nullptr, *back_ = nullptr, *picture_ = nullptr, *table_ = nullptr;
    QToolButton *keep_ = nullptr, *remove_ = nullptr, *kept_ = nullptr;
    std::vector<QToolButton*> steps_;
};

class CSpaceController : public QObject {
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

    bool save_picture(const QString& path);
    bool save_table(const QString& path);
    void set_palette(Palette palette);
    /// Studies what is wanted if the panel is seen.
    void look();
    bool busy() const;

signals:
    /// The tool belongs here: of an operation at a contact; no pose: the point is left to clean-up.
    void tool_wanted(int operation, const std::optional<facetmill::CutterLocation>& pose,
                     const facetmill::Marker& contact, const QString& readout);
    void failed(const QString& message);
    void told(const QString& message);
    void settled();

private:
    bool tell_written(const QString& path, const QString& wrong);
    void stand_at(std::size_t index);
    std::size_t nearest_point(const Vec3& place) const;
    std::vector<ManualPosture> all_kept() const;
    std::optional<std::size_t> kept_number() const;
    void change_kept(const QString& what, std::vector<ManualPosture> postures);
    void show_kept();
    void study();
    void show_point(std::shared_ptr<const FiveAxisStudy::Point> point);
    void clear_room(const QString& text);
    void show_hover(const std::optional<CSpaceRoom::Hit>& hit);
    QString reason_text(const PostureValue& posture, bool with_lift) const;
    void show_tool(const std::optional<PostureValue>& posture, const QString& what);
    CutterLocation pose(const PostureValue& posture) const;
    QString heading() const;

    Document& document_;
    CSpacePanel* panel_ = nullptr;
    int operation_ = -1;
    std::shared_ptr<const OperationResult> result_;
    std::shared_ptr<const FiveAxisRecord> record_;
    std::shared_ptr<const CutterProfile> cutter_;
    std::optional<std::size_t> at_;
    std::optional<PostureValue> tried_;
    std::shared_ptr<const FiveAxisStudy::Point> shown_;
    std::shared_ptr<const FiveAxisStudy> study_; ///< of `record_`
    /// Points of the lines studied last.
    std::map<std::size_t, std::shared_ptr<const FiveAxisStudy::Point>> known_;
    std::optional<std::size_t> wanted_; ///< first point of the line under study
    BackgroundJob job_;                 // last: it ends first
};

} // namespace facetmill::ui
