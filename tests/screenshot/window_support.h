// Whole windows under a virtual display: what the window tests share.
#pragma once

#include "tests/support/test_runner.h"
#include "ui/main_window.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/window_commands.h"

#include <QImage>
#include <QMessageBox>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <memory>

class QAction;
class QLineEdit;

namespace facetmill::test {

/// Waits until the window is through with its jobs and has drawn; false where that takes longer than
/// patience_ms.
bool wait_until_settled(ui::MainWindow& window);

/// Saves a picture of a widget among the test's outputs, to be looked at, and returns it.
QImage shot(QWidget& widget, const QString& name);

/// What the 3D view shows, drawn anew.
QImage view_picture(ui::MainWindow& window);

/// Part and stock are in the view whole, and fill it.
bool shows_all(ui::Viewport& view);

/// Number of pixels that differ by more than `least` of 255 in a colour; all of them when the sizes differ.
int changed_pixels(const QImage& a, const QImage& b, int least = 24);

/// Waits for a window to be shown and makes it the active one: there is no window manager to do so.
bool activate(QWidget& window);

/// What `find` finds when the page has come to rest: a background job may just have changed a text, whose
/// label grows with the next event.
QStringList found_at_rest(const std::function<QStringList()>& find);

/// Clears an editor and types into it, key by key, without leaving it.
void type_over(QWidget* editor, const QString& text);

/// A folder for a test's files that is empty and goes with the program.
QString scratch_folder(const QString& name);

/// A coarse sample as an STL file in inches: planned in a moment.
QString write_mesh(const QString& folder, const QString& name = QStringLiteral("surface.stl"));

/// A block 1 inch larger all round than the box, or what is left of it without a facet; in inches.
QString write_block(const QString& path, const Box3& around, bool open = false);

QAction* action(ui::MainWindow& window, const char* name);
/// The line of a parameter in the window's form, of a combo box too.
QLineEdit* field(ui::MainWindow& window, const char* name);
/// Types over a parameter and presses Enter.
void enter(ui::MainWindow& window, const char* name, const QString& text);
/// What the form says under a field; empty when it says nothing.
QString error_under(ui::MainWindow& window, const char* key);
const OperationCommon& first_operation(ui::MainWindow& window);
/// Answers the next message box by pressing one of its buttons; `asked` tells that there was one.
void answer_next(QMessageBox::StandardButton button, bool& asked);

/// Answers the next file dialog as soon as it is there: with a file, or by Cancel when `file` is empty.
void answer_file_dialog(bool& asked, const QString& file = {});

/// A window per test.
class WindowFixture {
public:
    /// Without previews of passes, which come into pictures of other things.
    bool show_window();
    /// Whether passes are shown before they are planned, in both workspaces that have them.
    void show_previews(bool on);
    void close_window() { window_.reset(); }
    /// Closes it, in the palette and the language that the next test begins with.
    void leave_as_found();
    ui::MainWindow& w() { return *window_; }
    /// A coarse part with the default operation, in inches.
    bool open_part();
    /// The same, planned by F5 at a tolerance of 0.02 in.
    bool open_and_plan();
    /// A coarse convex part with a coarse 5-axis operation in the place of the default one, planned.
    bool plan_five_axes();

protected:
    std::unique_ptr<ui::MainWindow> window_;
};

} // namespace facetmill::test
