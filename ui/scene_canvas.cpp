#include "ui/scene_canvas.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QResizeEvent>
#include <QWindow>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <utility>

namespace facetmill::ui {

namespace {

/// A window with two sets of framebuffers, for pictures of two sizes in turn: to make one larger or smaller
/// again and again costs 10 to 60 ms each time where the memory of the pictures is the processor's.
class TwoSizeWindow : public vtkGenericOpenGLRenderWindow {
public:
    static TwoSizeWindow* New();
    vtkTypeMacro(TwoSizeWindow, vtkGenericOpenGLRenderWindow);

    /// Draws in the other set from now on.
    void swap_framebuffers() {
        for (std::size_t i = 0; i < 3; ++i) {
            other_[i]->SetContext(this); // as OpenGLInit does with the first set
            std::swap(*own()[i], other_[i]);
        }
    }
    void ReleaseGraphicsResources(vtkWindow* window) override {
        for (auto* f : other_)
            f->ReleaseGraphicsResources(window);
        vtkGenericOpenGLRenderWindow::ReleaseGraphicsResources(window);
    }

private:
    using Framebuffer = vtkOpenGLFramebufferObject*;
    TwoSizeWindow() {
        for (Framebuffer& f : other_)
            f = vtkOpenGLFramebufferObject::New();
    }
    ~TwoSizeWindow() override {
        for (Framebuffer f : other_)
            f->Delete();
    }
    std::array<Framebuffer*, 3> own() {
        return {&RenderFramebuffer, &DisplayFramebuffer, &ResolveFramebuffer};
    }
    std::array<Framebuffer, 3> other_{};
};
vtkStandardNewMacro(TwoSizeWindow);

} // namespace

struct SceneCanvas::Window {
    vtkSmartPointer<TwoSizeWindow> vtk = vtkSmartPointer<TwoSizeWindow>::New();
};

namespace {

/// A full picture that takes longer is replaced by a coarse one until nothing changes any more.
constexpr double slow_frame_ms = 40.0;
/// Coarseness 1 is the scene's preview without smoothing; 2 has half the pixels a side besides, 3 a third.
constexpr int coarsest = 3;
constexpr double dear_frame_ms = 16.0, cheap_frame_ms = 5.0;
/// Lines are wider in a view that is higher: on a large screen that is not enlarged they would be hairs.
constexpr double ordinary_height = 1000, widest = 2;
constexpr int rest_after_ms = 250;
/// The same where what is shown is right but for trifles: until then more may be painted.
constexpr int kept_rest_ms = 1500;
/// Without a new picture before shaders of later ones are rehearsed: none while something moves. In an empty
/// window there is nothing that could.
constexpr int rehearsal_ms = 120, empty_rehearsal_ms = 20;

} // namespace

SceneCanvas::SceneCanvas(QWidget* parent) : GlCanvas(parent), window_(std::make_unique<Window>()) {
    const auto once = [this](QTimer& timer, int ms, auto&& what) {
        timer.setSingleShot(true);
        timer.setInterval(ms);
        connect(&timer, &QTimer::timeout, this, what);
    };
    once(rest_timer_, rest_after_ms, &SceneCanvas::rested);
    once(step_timer_, 0, &SceneCanvas::draw_step);
    once(pace_timer_, 0, [this] { update(); });
    once(rehearsal_timer_, rehearsal_ms, &SceneCanvas::rehearse);
}

SceneCanvas::~SceneCanvas() {
    if (!initialized() || !make_current()) return;
    scene_.detach();
    window_->vtk->Finalize();
    window_->vtk->SetReadyForRendering(false);
    done_current();
}

void SceneCanvas::initialize_gl() {
    auto* w = window_->vtk.Get();
    w->SetOwnContext(0);
    w->SetIsCurrent(true);
    w->SetReadyForRendering(true);
    // The canvas reads back what is drawn, where it is drawn: without a graphics card, copying it elsewhere
    // first would wait for it.
    w->SetFrameBlitModeToNoBlit();
    w->SetSwapBuffers(0);
    w->SetMultiSamples(0);
    w->OpenGLInit();
    scene_.attach(w);
    dirty_ = true;
    const auto* name = QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER);
    const QString renderer = name ? QString::fromUtf8(reinterpret_cast<const char*>(name)) : QString();
    without_card_ = false;
    for (const char* processor :
         {"llvmpipe", "softpipe", "swrast", "software", "swiftshader", "basic render"})
        without_card_ = without_card_ || renderer.contains(QLatin1String(processor), Qt::CaseInsensitive);
}

bool SceneCanvas::ready() const {
    return window_->vtk->GetReadyForRendering();
}

bool SceneCanvas::slow() const {
    return full_frame_ms_ < 0 ? scene_.has_preview() : full_frame_ms_ > slow_frame_ms;
}

void SceneCanvas::paint_gl() {
    auto* w = window_->vtk.Get();
    if (!ready()) return;
    const double ratio = devicePixelRatioF();
    const QSize size = frame_size();
    const bool resized = w->GetSize()[0] != size.width() || w->GetSize()[1] != size.height();
    if (resized) stop_steps();
    if (awaiting()) return;
    // All around it was laid out and is painted in this round of the event loop, which is enough for one.
    if (resized && frames_ > 0 && pace_timer_.isActive() && testAttribute(Qt::WA_WState_InPaintEvent)) return;
    if (!dirty_ && !resized) return draw_painted();
    dirty_ = false;
    w->SetSize(size.width(), size.height());
    scene_.set_pixel_ratio(ratio);
    scene_.set_line_scale(std::clamp(height() / ordinary_height, 1.0, widest));
    // What is shown in another workspace may have a larger legend.
    if (fitted_ && (resized || (!holds_view() && scene_.legend_came_over()))) scene_.fit();
    coarse_ = !std::exchange(whole_, false) && slow();
    // New content goes to the graphics card in its first picture, which says nothing about the later ones. It
    // does so by steps, as long as nobody turns it; until then the old picture stands.
    const bool fresh = std::exchange(fresh_, false);
    if (coarse_ && fresh && hand() == Hand::free) {
        rested();
        return;
    }
    const bool kept = std::exchange(keep_, false) && stands_ && !step_ && !resized;
    if (coarse_ && kept && hand() != Hand::drags_view) {
        rest_timer_.start(kept_rest_ms);
        return draw_painted();
    }
    painted_ = false;
    const bool first = full_frame_ms_ < 0;
    drawing_ = !coarse_ ? Drawing::full_picture : first ? Drawing::first_picture : Drawing::coarse_picture;
    draw(!coarse_ ? 0 : first ? 2 : coarseness_);
}

void SceneCanvas::frame_done() {
    const Drawing drawn = std::exchange(drawing_, Drawing::nothing);
    const double ms = double(drawing_since_.nsecsElapsed()) * 1e-6;
    switch (drawn) {
    case Drawing::nothing: // something changed meanwhile
    case Drawing::rehearsal:
        stands_ = false;
        break;
    case Drawing::painted:
        ++frames_;
        last_frame_ms_ = ms;
        break;
    case Drawing::step:
        step_ms_ += ms;
        if (*step_ < steps_) {
            step_timer_.start();
            return;
        }
        stop_steps();
        full_frame_ms_ = last_frame_ms_ = step_ms_;
        coarse_ = false;
        stands_ = true;
        ++frames_;
        break;
    case Drawing::first_picture:
    case Drawing::coarse_picture:
        ++frames_;
        last_frame_ms_ = ms;
        if (drawn == Drawing::first_picture)
            coarseness_ = 1;
        else if (ms > dear_frame_ms)
            coarseness_ = std::min(coarseness_ + 1, coarsest);
        else if (ms < cheap_frame_ms)
            coarseness_ = std::max(coarseness_ - 1, 1);
        stands_ = false;
        rest_timer_.start(rest_after_ms);
        break;
    case Drawing::full_picture:
        ++frames_;
        last_frame_ms_ = ms;
        stands_ = true;
        // The first picture of all compiles shaders and says nothing about the later ones.
        if (frames_ > 1 && !fresh_) full_frame_ms_ = ms;
        break;
    }
    if (!shaders_made()) rehearsal_timer_.start(scene_.has(Layer::scale) ? rehearsal_ms : empty_rehearsal_ms);
    update();
    if (drawn == Drawing::step || drawn == Drawing::full_picture || drawn == Drawing::painted)
        emit this->drawn();
}

void SceneCanvas::draw(int coarseness) {
    auto* w = window_->vtk.Get();
    const int width_px = w->GetSize()[0], height_px = w->GetSize()[1], part = std::max(1, coarseness);
    const double ratio = devicePixelRatioF();
    drawing_since_.start();
    scene_.set_moving(coarseness > 0);
    scene_.set_antialiasing(coarseness == 0);
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    if (part == 1) {
        w->Render();
        await_frame();
    } else {
        // Fewer pixels, shown larger. Afterwards the window has its size again: picking counts in its pixels.
        w->swap_framebuffers();
        w->SetSize(std::max(1, width_px / part), std::max(1, height_px / part));
        scene_.set_pixel_ratio(ratio / part);
        w->Render();
        await_frame();
        w->swap_framebuffers();
        w->SetSize(width_px, height_px);
        scene_.set_pixel_ratio(ratio);
    }
    state->Pop();
}

void SceneCanvas::await_frame() {
    const bool seen = drawing_ == Drawing::step ? *step_ == steps_ : drawing_ != Drawing::rehearsal;
    if (!seen) return await_drawn();
    auto* w = window_->vtk.Get();
    w->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    w->GetRenderFramebuffer()->ActivateReadBuffer(0);
    await_picture({w->GetSize()[0], w->GetSize()[1]});
}

void SceneCanvas::rehearse() {
    // A shader takes some 50 ms: only while nothing else goes on. The next picture starts the timer again.
    if (dirty_ || awaiting() || coarse_ || step_ || hand() != Hand::free || shaders_made() || !ready())
        return;
    rehearse_next();
}

bool SceneCanvas::rehearse_next() {
    if (!make_current()) return false;
    scene_.rehearse(rehearsed_++);
    drawing_ = Drawing::rehearsal;
    draw(1);
    scene_.end_rehearsal();
    scene_.set_moving(false);
    scene_.set_antialiasing(true);
    done_current();
    return true;
}

void SceneCanvas::make_shaders() {
    // In a window that was never shown there is not yet room for axes and scale, whose shaders would be left.
    constexpr QSize roomy(640, 480);
    const QSize had = size();
    resize(had.expandedTo(roomy));
    (void)picture(); // its own shaders first, and what is still being drawn
    while (!shaders_made() && rehearse_next())
        (void)picture(); // waits for it; nothing of it is to be seen
    resize(had);
}

void SceneCanvas::rested() {
    if (hand() == Hand::drags_view || (hand() == Hand::paints && stands_)) {
        rest_timer_.start(); // held still, but not let go
        return;
    }
    if (!coarse_ || dirty_ || awaiting() || !ready()) return;
    scene_.set_moving(false);
    scene_.set_antialiasing(true);
    painted_ = false;
    stands_ = false;
    steps_ = scene_.begin_steps();
    step_ = 0;
    step_ms_ = 0;
    step_timer_.start();
}

void SceneCanvas::draw_step() {
    if (!step_ || awaiting() || !make_current()) return;
    drawing_since_.start();
    auto* w = window_->vtk.Get();
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    scene_.set_step(*step_);
    w->Render();
    ++*step_;
    drawing_ = Drawing::step;
    await_frame();
    state->Pop();
    done_current();
}

void SceneCanvas::refresh_painted() {
    const bool stands = stands_ || coarse_ || step_ || awaiting(); // or will
    if (!slow() || !stands) return refresh();
    painted_ = true;
    if (!awaiting()) update();
}

void SceneCanvas::draw_painted() {
    // A picture that is still to come shows them anyway.
    if (!painted_ || !stands_ || step_) return;
    painted_ = false;
    if (!scene_.begin_added()) return;
    drawing_ = Drawing::painted;
    drawing_since_.start();
    auto* w = window_->vtk.Get();
    auto* state = w->GetState();
    state->Reset();
    state->Push();
    w->Render();
    await_frame();
    state->Pop();
    scene_.end_added();
}

void SceneCanvas::stop_steps() {
    if (!step_) return;
    step_.reset();
    step_timer_.stop();
    if (drawing_ == Drawing::step) drawing_ = Drawing::nothing;
    scene_.end_steps();
}

bool SceneCanvas::finished() const {
    const QWindow* shown = isVisible() ? window()->windowHandle() : nullptr;
    // A rehearsal is no picture that anybody waits for, and nobody is told of its end.
    const bool due = awaiting() && drawing_ != Drawing::rehearsal;
    return !coarse_ && !step_ && !painted_ && !due && !(dirty_ && shown && shown->isExposed());
}

void SceneCanvas::content_changed() {
    full_frame_ms_ = -1;
    fresh_ = true;
    refresh();
}

void SceneCanvas::refresh() {
    stop_steps();
    dirty_ = true;
    if (awaiting()) return; // the next one follows it
    // Pictures that take a while come by way of a timer, so that other timers and events get their turn in
    // between.
    if (!slow())
        update();
    else if (!pace_timer_.isActive())
        pace_timer_.start();
}

QImage SceneCanvas::full_picture() {
    refresh();
    whole_ = true;
    return picture();
}

void SceneCanvas::resizeEvent(QResizeEvent* event) {
    GlCanvas::resizeEvent(event);
    refresh();
    pace_timer_.start();
}

} // namespace facetmill::ui
