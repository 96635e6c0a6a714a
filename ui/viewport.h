// The 3D view of a Scene, with the mouse: buttons turn, move and zoom as the style of navigation says, the
// wheel zooms about the pointer; left moves the boundary point under it where the scene shows handles, or the
// chosen fixture; a click picks, a double click fits.
#pragma once

#include "ui/navigation.h"
#include "ui/pointer.h"
#include "ui/scene_canvas.h"
#include "ui/view_tool.h"

namespace facetmill::ui {

class CubePlace;
class ViewCube;

class Viewport : public SceneCanvas {
    Q_OBJECT
public:
    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    void content_changed() override;
    void set_view(StandardView view);
    /// The scene's camera was moved from outside. Draws soon.
    void camera_moved();
    /// The picture by quarters of a turn, clockwise.
    void roll(int quarters);
    /// Fits the view without a change of direction.
    void fit();
    /// Direction of sight and upward direction of the screen, unit vectors.
    Vec3 sight() const;
    Vec3 up() const;
    ViewCube* view_cube() { return cube_; }
    /// What is nearer is larger, or not.
    void set_perspective(bool on);
    void set_navigation(const Navigation& navigation) { navigation_ = navigation; }
    /// While a point is picked every click asks the part alone, by point_picked; the pointer is a cross.
    void set_picking(bool on);
    /// The left button is the tool's, which lives until another one is set; null: it turns the view again.
    void set_tool(ViewTool* tool);
    const ViewTool* tool() const { return tool_; }
    /// Handles over the picture, as long as no tool is set and no point is picked: a press that they do not
    /// take is for the view. Null: none.
    void set_gizmo(ViewTool* gizmo);

signals:
    void camera_changed();
    /// A click that met a CC or CL, the part, nothing.
    void path_picked(const facetmill::PathPick& pick);
    void part_picked(const facetmill::PartPick& pick);
    void nothing_picked();
    /// A click while a point is picked (set_picking): a point of the part, or none where it was missed.
    void point_picked(const std::optional<facetmill::PartPick>& pick, Qt::KeyboardModifiers modifiers);
    /// The point of the part under the resting pointer, or none.
    void hovered(const std::optional<facetmill::PartPick>& pick);
    void menu_requested(const QPoint& global);
    /// A handle of a region's boundary was taken at `from` and is over `to` of the part; then it was let go
    /// there.
    void handle_dragged(const facetmill::Vec3& from, const facetmill::Vec3& to);
    void handle_dropped(const facetmill::Vec3& from, const facetmill::Vec3& to);
    /// A click that met a fixture, by its place among them. The chosen one can be dragged: level, with Ctrl
    /// up and down; then it was let go so far from its place.
    void fixture_picked(std::size_t index);
    void fixture_dragged(std::size_t index, const facetmill::Vec3& by);
    void fixture_dropped(std::size_t index, const facetmill::Vec3& by);

protected:
    Hand hand() const override;
    bool holds_view() const override { return tool_ != nullptr; } ///< nobody paints what slips away
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// hold: a press that does nothing but click.
    enum class Drag { none, hold, turn, move, zoom, handle, fixture, tool, gizmo };
    Drag drag_of(const QMouseEvent& press) const;
    /// Begins with what a press of the left button takes hold of; false: nothing is there.
    bool take_hold(const QPointF& at);
    /// A drag of the view begins here.
    void choose_pivot(const QPointF& at);
    void turn(const QPointF& by);
    void move(const QPointF& by);
    void click(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void zoom_at(const QPointF& at, double factor);
    void hover(const QPointF& at);
    std::optional<Vec3> handle_at(const QPointF& at) const;
    void focus_under(const QPointF& at);
    std::optional<SceneFixtures::Pick> fixture_at(const QPointF& at) const;
    QPointF device(const QPointF& at) const { return at * devicePixelRatioF(); }

    ViewCube* cube_ = nullptr;
    CubePlace* cube_place_ = nullptr;
    Navigation navigation_;
    PointerDrag<Drag> drag_{click_slack};
    PointerRest rest_{[this](const QPointF& at) { hover(at); }};
    bool picking_ = false;
    ViewTool *tool_ = nullptr, *gizmo_ = nullptr;
    std::optional<QPointF> pointer_; ///< where it is, for the tool
    bool has_gizmo() const { return gizmo_ && !tool_ && !picking_; }
    Vec3 pivot_ = Vec3::Zero();
    Vec3 handle_from_ = Vec3::Zero(), handle_to_ = Vec3::Zero();
    SceneFixtures::Pick held_; ///< the fixture that is dragged, where it was taken
    Vec3 held_by_ = Vec3::Zero();
};

} // namespace facetmill::ui
