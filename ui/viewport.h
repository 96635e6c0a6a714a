// The 3D view: a canvas around a vtkGenericOpenGLRenderWindow that shows a Scene. VTK is built against
// another Qt than ours on some systems, so its own widget is not used anywhere.
//
// It draws only when something changed (`refresh`); between changes it shows the picture it has. Where a
// full picture takes long, a coarse one is drawn at once, and when nothing has changed for a moment the full
// one follows in steps, between which the window answers. Mouse:
// left turns, or moves the boundary point under it where the scene shows handles; middle or Shift+left moves,
// right or the wheel zooms about the pointer, a click picks, a double click fits.
#pragma once

#include "ui/gl_canvas.h"
#include "viz/scene.h"

#include <QElapsedTimer>
#include <QTimer>

#include <optional>

template <class T>
class vtkSmartPointer;
class vtkGenericOpenGLRenderWindow;

namespace facetmill::ui {

class ViewCube;

class Viewport : public GlCanvas {
    Q_OBJECT
public:
    /// The surface format that VTK needs; set as the default before the application object is made.
    static void set_default_format();
    /// Why the display cannot show a viewport; empty when it can. Asked once before the first window.
    static QString why_unavailable();

    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    Scene& scene() { return scene_; }
    const Scene& scene() const { return scene_; }
    /// Draws soon. Many calls draw once.
    void refresh();
    /// The part or the paths are others: how long a picture takes is not known any more. Draws soon.
    void content_changed();
    /// False while a picture is due, or a coarse one stands for a full one that follows.
    bool finished() const;
    /// A full picture, drawn now however long it takes.
    QImage full_picture();
    void set_view(StandardView view);
    /// The scene's camera was moved from outside. Draws soon.
    void camera_moved();
    /// Fits the view without a change of direction.
    void fit();
    /// Direction of sight and upward direction of the screen, unit vectors.
    Vec3 sight() const;
    Vec3 up() const;
    ViewCube* view_cube() { return cube_; }
    /// While a point is picked every click asks the part alone, by point_picked; the pointer is a cross.
    void set_picking(bool on);

    /// A processor does the work of a graphics card; also while nothing was drawn yet.
    bool without_card() const { return without_card_; }

    /// Pixels drawn since the start, for tests and the log: frames and the time the last one took.
    int frames() const { return frames_; }
    double last_frame_ms() const { return last_frame_ms_; }

signals:
    /// The full picture is there.
    void drawn();
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

protected:
    void initialize_gl() override;
    void paint_gl() override;
    void frame_done() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Drag { none, turn, move, zoom, handle };
    void place_overlays();
    void turn(const QPointF& by);
    void move(const QPointF& by);
    void click(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void hover();
    std::optional<Vec3> handle_at(const QPointF& at) const;
    bool slow() const;
    void draw(int coarseness);
    void rehearse();
    void rested();
    void draw_step();
    void await_frame();
    void stop_steps();
    QPointF device(const QPointF& at) const { return at * devicePixelRatioF(); }

    Scene scene_;
    struct Window;
    std::unique_ptr<Window> window_;
    ViewCube* cube_ = nullptr;
    bool dirty_ = true;
    bool fitted_ =
        true; ///< nothing was moved or zoomed since the last fit: the picture keeps fitting the window
    Drag drag_ = Drag::none;
    bool dragged_ = false, picking_ = false;
    QPointF press_, last_;
    Vec3 pivot_ = Vec3::Zero();
    Vec3 handle_from_ = Vec3::Zero(), handle_to_ = Vec3::Zero();
    /// What OpenGL is drawing while the event loop goes on.
    enum class Drawing { nothing, first_picture, coarse_picture, full_picture, step, rehearsal };
    Drawing drawing_ = Drawing::nothing;
    QElapsedTimer drawing_since_;
    QTimer hover_timer_, rest_timer_, step_timer_, pace_timer_, rehearsal_timer_;
    bool coarse_ = false;       ///< what is shown is a coarse picture
    bool fresh_ = false;        ///< the content was not drawn yet
    bool whole_ = false;        ///< the next picture is a full one in any case
    int coarseness_ = 1;        ///< how coarse the next coarse picture is: what the last ones took decides
    double full_frame_ms_ = -1; ///< what the last picture in full detail took; below 0: not known
    std::optional<std::size_t> step_; ///< where the full picture that is being drawn has got to
    std::size_t steps_ = 0;
    double step_ms_ = 0;        ///< what the steps took until now
    std::size_t rehearsed_ = 0; ///< how many of the scene's rehearsals are done
    QPointF hover_at_;
    bool without_card_ = true;
    int frames_ = 0;
    double last_frame_ms_ = 0;
};

} // namespace facetmill::ui
