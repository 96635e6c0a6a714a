// A widget whose picture OpenGL draws off-screen; it is read back and painted as any other widget's.
//
// A QOpenGLWidget costs nothing to read back, but has OpenGL put the whole window together, forms and log
// too, whenever any widget in it changes. Where there is no graphics card that holds up the window for 10 to
// 30 ms at every tick of the progress bar. Reading back takes about 1 ms for a million pixels, once they are
// drawn: a canvas that must not hold up the window until then asks for them by `await_picture`.
#pragma once

#include <QImage>
#include <QString>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <utility>

class QOffscreenSurface;
class QOpenGLContext;

namespace facetmill::ui {

class GlCanvas : public QWidget {
public:
    /// The surface format that VTK needs; set as the default before the application object is made.
    static void set_default_format();
    /// Why the display cannot show a canvas; empty when it can. Asked once before the first window.
    static QString why_unavailable();

    explicit GlCanvas(QWidget* parent = nullptr);
    ~GlCanvas() override;

    /// What is shown, after what is due has been drawn. Null where there is no OpenGL. Device pixels.
    QImage picture();

protected:
    /// Once, before the first `paint_gl`, with the context current.
    virtual void initialize_gl() = 0;
    /// Before every painting of the widget, with the context current. Draws where something is due, into a
    /// framebuffer of its own, and ends with `take_picture` or `await_picture` then.
    virtual void paint_gl() = 0;
    /// What `await_picture` or `await_drawn` waited for is there. The context need not be current.
    virtual void frame_done() {}

    /// What the widget shows from now on: of the framebuffer that is bound for reading the lower left part of
    /// this size, enlarged where that is less than `frame_size`. Waits until it is drawn.
    void take_picture(const QSize& drawn);
    /// The same, but returns at once: OpenGL draws while the event loop goes on, the widget keeps its old
    /// picture until the new one is there, then `frame_done` is called. The framebuffer must stay as it is
    /// until then.
    void await_picture(const QSize& drawn);
    /// As `await_picture`, of something that is not to be shown.
    void await_drawn();
    /// OpenGL is still drawing what was asked for last.
    bool awaiting() const { return fence_ != nullptr; }
    /// True from `initialize_gl` on: there is a context.
    bool initialized() const { return initialized_; }
    /// False where there is no OpenGL.
    bool make_current();
    void done_current();
    /// Size of the widget in device pixels.
    QSize frame_size() const;

    void paintEvent(QPaintEvent* event) override;

private:
    void draw();
    void read(unsigned framebuffer, const QSize& drawn);
    void start_waiting();
    void look_for_frame(bool wait);

    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_;
    QImage picture_, small_;
    void* fence_ = nullptr;                             ///< a GLsync, after what is awaited
    std::optional<std::pair<unsigned, QSize>> to_read_; ///< framebuffer and size of the awaited picture
    QTimer look_timer_;
    bool initialized_ = false, failed_ = false;
};

} // namespace facetmill::ui
