// A widget whose picture OpenGL draws off-screen; it is read back and painted as any other widget's.
//
// A QOpenGLWidget costs nothing to read back, but has OpenGL put the whole window together, forms and log
// too, whenever any widget in it changes. Where there is no graphics card that holds up the window for 10 to
// 30 ms at every tick of the progress bar. Reading back takes about 1 ms for a million pixels.
#pragma once

#include <QImage>
#include <QWidget>

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace facetmill::ui {

class GlCanvas : public QWidget {
public:
    explicit GlCanvas(QWidget* parent = nullptr);
    ~GlCanvas() override;

    /// What is shown, after what is due has been drawn. Null where there is no OpenGL. Device pixels.
    QImage picture();

protected:
    /// Once, before the first `paint_gl`, with the context current.
    virtual void initialize_gl() = 0;
    /// Before every painting of the widget, with the context current. Draws where something is due, into a
    /// framebuffer of its own, and ends with `take_picture` then.
    virtual void paint_gl() = 0;

    /// What the widget shows from now on: of the framebuffer that is bound for reading the lower left part of
    /// this size, enlarged where that is less than `frame_size`. Waits until it is drawn.
    void take_picture(const QSize& drawn);
    /// True from `initialize_gl` on: there is a context.
    bool initialized() const { return initialized_; }
    /// False where there is no OpenGL.
    bool make_current();
    void done_current();
    /// Of the widget, in device pixels.
    QSize frame_size() const;

    void paintEvent(QPaintEvent* event) override;

private:
    void draw();

    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_;
    QImage picture_, small_;
    bool initialized_ = false, failed_ = false;
};

} // namespace facetmill::ui
