#include "tests/screenshot/window_support.h"

#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "ui/language.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace facetmill::test {

bool wait_until_settled(ui::MainWindow& window) {
    QElapsedTimer timer;
    timer.start();
    // Ends of jobs start others: idle must hold for a few turns of the event loop.
    for (int idle = 0; idle < 3; idle = window.busy() ? 0 : idle + 1) {
        if (timer.elapsed() > patience_ms) return false;
        QTest::qWait(20);
    }
    return true;
}

QImage shot(QWidget& widget, const QString& name) {
    QTest::qWait(60);
    if (auto* view = widget.findChild<ui::Viewport*>())
        (void)QTest::qWaitFor([view] { return view->finished(); }, patience_ms);
    const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
    QDir().mkpath(QStringLiteral(FACETMILL_PICTURE_OUT));
    image.save(QStringLiteral(FACETMILL_PICTURE_OUT "/%1.png").arg(name), "PNG",
               80); // lightly packed: there are hundreds
    return image;
}

QImage view_picture(ui::MainWindow& window) {
    return window.viewport().full_picture();
}

bool shows_all(ui::Viewport& view) {
    const Box3 box = view.scene().bounds();
    Vec2 lo = Vec2::Constant(infinity), hi = -lo;
    for (int c = 0; c < 8; ++c) {
        const Vec3 corner(c & 1 ? box.hi.x() : box.lo.x(), c & 2 ? box.hi.y() : box.lo.y(),
                          c & 4 ? box.hi.z() : box.lo.z());
        const Vec2 at = view.scene().camera().display_of(corner) / view.devicePixelRatioF();
        lo = lo.cwiseMin(at);
        hi = hi.cwiseMax(at);
    }
    const Vec2 size(view.width(), view.height());
    return (lo.array() >= 0).all() && (hi.array() <= size.array()).all()
           && ((hi - lo).array() > 0.4 * size.array()).any();
}

int changed_pixels(const QImage& a, const QImage& b, int least) {
    if (a.size() != b.size()) return a.width() * a.height();
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            if (std::abs(qRed(p) - qRed(q)) > least || std::abs(qGreen(p) - qGreen(q)) > 24
                || std::abs(qBlue(p) - qBlue(q)) > least)
                ++count;
        }
    return count;
}

void type_over(QWidget* editor, const QString& text) {
    editor->setFocus();
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(editor, Qt::Key_Delete);
    QTest::keyClicks(editor, text);
}

bool activate(QWidget& window) {
    if (!QTest::qWaitForWindowExposed(&window)) return false;
    QApplication::setActiveWindow(&window);
    return window.isActiveWindow();
}

QString write_mesh(const QString& folder, const QString& name) {
    const auto mesh = make_sample("convex", 0.5, {});
    const QString path = folder + QChar('/') + name;
    save_stl(*mesh, path.toStdString(), LengthUnit::inch, {});
    return path;
}

QString write_block(const QString& path, const Box3& around, bool open) {
    Mesh m;
    for (int c = 0; c < 8; ++c) {
        Vec3 p;
        for (int k = 0; k < 3; ++k)
            p[k] = c >> k & 1 ? around.hi[k] + 25.4 : around.lo[k] - 25.4;
        m.vertices.push_back(p);
    }
    m.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (open) m.facets.pop_back();
    save_stl(m, path.toStdString(), LengthUnit::inch, {});
    return path;
}

QAction* action(ui::MainWindow& window, const char* name) {
    return window.findChild<QAction*>(QLatin1String(name));
}

QLineEdit* field(ui::MainWindow& window, const char* name) {
    auto* form = window.properties().form();
    if (auto* line = form->findChild<QLineEdit*>(QLatin1String(name))) return line;
    auto* combo = form->findChild<QComboBox*>(QLatin1String(name));
    return combo ? combo->lineEdit() : nullptr;
}

void enter(ui::MainWindow& window, const char* name, const QString& text) {
    type_over(field(window, name), text);
    QTest::keyClick(field(window, name), Qt::Key_Return);
}

QString error_under(ui::MainWindow& window, const char* key) {
    auto* label =
        window.properties().form()->findChild<QLabel*>(QStringLiteral("error_") + QLatin1String(key));
    return label && label->isVisible() ? label->text().replace(QChar::Nbsp, QChar(' ')) : QString();
}

const OperationCommon& first_operation(ui::MainWindow& window) {
    return window.document().operation(0).common();
}

void answer_next(QMessageBox::StandardButton button, bool& asked) {
    QTimer::singleShot(50, qApp, [button, &asked] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        asked = true;
        box->button(button)->click();
    });
}

QStringList found_at_rest(const std::function<QStringList()>& find) {
    QStringList found = find();
    for (int tries = 0; tries < 20 && !found.isEmpty(); ++tries) {
        QTest::qWait(25);
        found = find();
    }
    return found;
}

void answer_file_dialog(bool& asked, const QString& file) {
    auto* timer = new QTimer(qApp);
    const auto answered = std::make_shared<QPointer<QFileDialog>>();
    QObject::connect(timer, &QTimer::timeout, timer, [&asked, file, timer, answered] {
        QPointer<QFileDialog>& dialog = *answered;
        if (!timer->property("asked").toBool()) {
            dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            timer->setProperty("asked", true);
            asked = true;
            if (file.isEmpty()) return dialog->reject();
        }
        if (!dialog || !dialog->isVisible()) return timer->deleteLater(); // it has taken the answer
        // At once: letter by letter, what completes the name chooses folders on the way, too, and keeps them.
        // Nothing can be opened until the dialog has seen by itself what lies in the folder.
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        if (name && name->text() != file) name->setText(file);
        auto* buttons = dialog->findChild<QDialogButtonBox*>(QStringLiteral("buttonBox"));
        QPushButton* open = buttons ? buttons->button(QDialogButtonBox::Open) : nullptr;
        if (buttons && !open) open = buttons->button(QDialogButtonBox::Save);
        if (open && open->isEnabled()) QTest::mouseClick(open, Qt::LeftButton);
    });
    timer->start(50);
}

bool WindowFixture::show_window() {
    window_ = std::make_unique<ui::MainWindow>();
    window_->resize(1280, 800);
    show_previews(false);
    window_->show();
    return activate(*window_);
}

void WindowFixture::show_previews(bool on) {
    for (const ui::Workspace workspace : {ui::Workspace::plan, ui::Workspace::prepare}) {
        w().workspaces().enter(workspace);
        w().layers().set_shown(ui::ViewLayer::preview, on);
    }
}

void WindowFixture::leave_as_found() {
    if (window_) w().set_theme(ui::Theme::system);
    close_window();
    ui::speak(QStringLiteral("en"));
}

bool WindowFixture::open_part() {
    w().open_file(write_mesh(scratch_folder(QStringLiteral("part"))), LengthUnit::inch);
    return wait_until_settled(w()) && w().document().part_is_current();
}

bool WindowFixture::open_and_plan() {
    if (!open_part()) return false;
    // Twice as thick a tool as a new project has: the stock's lattice follows the smallest cutter's radius.
    w().document().change(QStringLiteral("Thicker"), [](Project& p) {
        Tool& tool = p.tools.front();
        tool.diameter *= 2;
        tool.corner_radius *= 2;
        tool.shank_diameter *= 2;
    });
    w().tree().select({ui::TreeNode::Kind::operation, 0});
    enter(w(), "tolerance", QStringLiteral("0.02"));
    QTest::keyClick(&w(), Qt::Key_F5);
    return wait_until_settled(w()) && w().document().state(0) == ui::OperationState::planned;
}

bool WindowFixture::plan_five_axes() {
    if (!open_part()) return false;
    w().document().add_operation("finish5");
    w().document().remove_operation(0);
    w().document().change(QStringLiteral("Coarse"), [](Project& p) {
        p.machine = "tarus-tpi-2000";
        p.operations[0]->common().tolerance = 0.03 * mm_per_inch;
        p.operations[0]->set("grid_degrees", ParameterValue(radians(9)));
        p.operations[0]->set("normal_limit", ParameterValue(radians(20)));
        p.operations[0]->set("posture", ParameterValue(std::string("cm2")));
    });
    w().plan();
    return wait_until_settled(w()) && w().document().state(0) == ui::OperationState::planned;
}

} // namespace facetmill::test
