// The pictures of a Scene: a canvas around a vtkGenericOpenGLRenderWindow. VTK is built against another Qt
// than ours on some systems, so its own widget is not used anywhere.
//
// It draws only when something changed (`refresh`); between changes it shows the picture it has. Where a
// full picture takes long, a coarse one is drawn at once, and when nothing has changed for a moment the full
// one follows in steps, between which the window answers.
#pragma once

#include "ui/gl_canvas.h"
#include "viz/scene.h"

#include <QElapsedTimer>
#include <QTimer>

#include <optional>

namespace facetmill::ui {

class SceneCanvas : public GlCanvas {
    Q_OBJECT
public:
    explicit SceneCanvas(QWidget* parent = nullptr);
    ~SceneCanvas() override;

    Scene& scene() { return scene_; }
    const Scene& scene() const { return scene_; }
    /// Draws soon. Many calls draw once.
    void refresh();
    /// Facets of a boundary were painted, and nothing else has changed. Draws them soon: where a whole
    /// picture takes long, over the one that stands.
    void refresh_painted();
    /// The next picture is one of what is shown already, but for trifles: it comes in its time, and no coarse
    /// one before it.
    void keep_picture() { keep_ = true; }
    /// The part or the paths are others: how long a picture takes is not known any more. Draws soon.
    virtual void content_changed();
    /// False while a picture is due, or a coarse one stands for a full one that follows.
    bool finished() const;
    /// A full picture, drawn now however long it takes.
    QImage full_picture();
    /// Draws once in every way that pictures are drawn in, which makes the shaders, before the window is
    /// shown: without a graphics card one takes up to 100 ms, in which a window would not answer. OpenGL
    /// keeps them on disk; from the second start on all of them together take a tenth of that.
    void make_shaders();
    bool shaders_made() const { return rehearsed_ == Scene::rehearsals; }

    /// A processor does the work of a graphics card; also while nothing was drawn yet.
    bool without_card() const { return without_card_; }

    /// Pixels drawn since the start, for tests and the log: frames and the time the last one took.
    int frames() const { return frames_; }
    double last_frame_ms() const { return last_frame_ms_; }

signals:
    /// The full picture is there.
    void drawn();

protected:
    /// What the user holds: a view that is dragged stays coarse, also while it is held still.
    enum class Hand { free, drags_in_view, paints, drags_view };
    virtual Hand hand() const { return Hand::free; }
    /// What is fitted stays where it is, whatever comes over it, until the window's size changes.
    virtual bool holds_view() const { return false; }
    /// Nothing was moved or zoomed since the last fit: the picture keeps fitting the window.
    void set_fitted(bool fitted) { fitted_ = fitted; }
    bool is_fitted() const { return fitted_; }
    /// OpenGL is there to draw and to pick with.
    bool ready() const;

    void initialize_gl() override;
    void paint_gl() override;
    void frame_done() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    bool slow() const;
    void draw(int coarseness);
    void rehearse();
    bool rehearse_next(); ///< false where there is no OpenGL
    void rested();
    void draw_step();
    void draw_painted();
    void await_frame();
    void stop_steps();

    Scene scene_;
    struct Window;
    std::unique_ptr<Window> window_;
    bool dirty_ = true, fitted_ = true;
    /// What OpenGL is drawing while the event loop goes on.
    enum class Drawing { nothing, first_picture, coarse_picture, full_picture, step, painted, rehearsal };
    Drawing drawing_ = Drawing::nothing;
    QElapsedTimer drawing_since_;
    QTimer rest_timer_, step_timer_, pace_timer_, rehearsal_timer_;
    bool coarse_ = false;       ///< what is shown is a coarse picture
    bool fresh_ = false;        ///< the content was not drawn yet
    bool painted_ = false;      ///< facets were painted that no picture shows yet
    bool keep_ = false;         ///< see keep_picture
    bool stands_ = false;       ///< what was drawn last is a full picture
    bool whole_ = false;        ///< the next picture is a full one in any case
    int coarseness_ = 1;        ///< how coarse the next coarse picture is: what the last ones took decides
    double full_frame_ms_ = -1; ///< what the last picture in full detail took; below 0: not known
    std::optional<std::size_t> step_; ///< where the full picture that is being drawn has got to
    std::size_t steps_ = 0;
    double step_ms_ = 0;        ///< what the steps took until now
    std::size_t rehearsed_ = 0; ///< how many of the scene's rehearsals are done
    bool without_card_ = true;
    int frames_ = 0;
    double last_frame_ms_ = 0;
};

} // namespace facetmill::ui
