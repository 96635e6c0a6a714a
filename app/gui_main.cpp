// The workbench: `facetmill [FILE]`.
#include "core/base/error.h"
#include "core/mesh/mesh_format.h"
#include "facetmill_version.h"
#include "ui/autosave.h"
#include "ui/file_writing.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/settings_file.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QTimer>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <vtkObject.h>

namespace {

using namespace facetmill;

bool starting = true;

/// While the program starts, Qt ends it by a fatal message when there is no display; that becomes one line
/// that helps.
void message_handler(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtFatalMsg) {
        if (starting) {
            const char* display = std::getenv("DISPLAY");
            std::fprintf(
                stderr,
                "facetmill: no window can be opened on display '%s' (start it in a desktop session, or use "
                "facetmill-cli)\n",
                display ? display : "");
            std::_Exit(1);
        }
        std::fprintf(stderr, "facetmill: %s\n", qPrintable(message));
        return;
    }
    if (!starting && type != QtDebugMsg) std::fprintf(stderr, "facetmill: %s\n", qPrintable(message));
}

/// Options are read before there is an application, so that --help needs no display.
struct Options {
    QString file, screenshot, theme, language;
    std::optional<LengthUnit> unit;
    QSize size;
    QStringList programs;
    bool plan = false, verify = false;
    int exit_status = -1; ///< of --help, --version and mistakes
};

Options read_options(int argc, char** argv) {
    Options options;
    QStringList arguments;
    for (int i = 0; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Facetmill plans tool paths on triangle meshes. FILE is "
                                                    "a project (.facetmill) or a mesh (%1).")
                                         .arg(QString::fromStdString(mesh_format_names())));
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                  QStringLiteral("Show this and exit."));
    const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                     QStringLiteral("Show the version and exit."));
    const QCommandLineOption plan(QStringLiteral("plan"),
                                  QStringLiteral("Plan all operations after opening FILE."));
    const QCommandLineOption cl(
        QStringLiteral("cl"),
        QStringLiteral("Show this program in place of a plan; more than one run in order."),
        QStringLiteral("FILE.apt"));
    const QCommandLineOption verify(QStringLiteral("verify"),
                                    QStringLiteral("Verify what was planned, or the programs of --cl."));
    const QCommandLineOption units(
        QStringLiteral("units"), QStringLiteral("Unit of a mesh FILE, without asking: mm, cm, m, in or ft."),
        QStringLiteral("UNIT"));
    const QCommandLineOption screenshot(
        QStringLiteral("screenshot"),
        QStringLiteral("Save a picture of the window when everything is done, and exit."),
        QStringLiteral("FILE.png"));
    const QCommandLineOption size(
        QStringLiteral("size"), QStringLiteral("Size of the window, as in 1280x800."), QStringLiteral("WxH"));
    const QCommandLineOption theme(QStringLiteral("theme"),
                                   QStringLiteral("Colours for this start: system, light or dark."),
                                   QStringLiteral("NAME"));
    const QCommandLineOption language(QStringLiteral("language"),
                                      QStringLiteral("Language for this start: en, de or fr."),
                                      QStringLiteral("CODE"));
    parser.addOptions({help, version, plan, cl, verify, units, screenshot, size, theme, language});
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Project or mesh to open."),
                                 QStringLiteral("[FILE]"));
    const auto usage = [&](const QString& what) {
        std::fprintf(stderr, "facetmill: %s (facetmill --help lists the options)\n", qPrintable(what));
        options.exit_status = 2;
        return options;
    };
    if (!parser.parse(arguments)) return usage(parser.errorText());
    if (parser.isSet(help)) {
        // Without an application object Qt does not know what the program is called.
        std::fputs(qPrintable(parser.helpText().replace(QStringLiteral("<executable_name>"),
                                                        QStringLiteral("facetmill"))),
                   stdout);
        options.exit_status = 0;
        return options;
    }
    if (parser.isSet(version)) {
        std::printf("facetmill %s\n", FACETMILL_VERSION);
        options.exit_status = 0;
        return options;
    }
    if (parser.positionalArguments().size() > 1) return usage(QStringLiteral("more than one file was named"));
    if (!parser.positionalArguments().isEmpty()) options.file = parser.positionalArguments().front();
    options.plan = parser.isSet(plan);
    options.verify = parser.isSet(verify);
    options.programs = parser.values(cl);
    if (!options.programs.isEmpty() && (options.plan || options.file.isEmpty()))
        return usage(
            QStringLiteral("--cl shows a program on FILE, without planning: name a FILE, leave --plan "
                           "out"));
    options.screenshot = parser.value(screenshot);
    try {
        if (parser.isSet(units)) options.unit = parse_mesh_unit(parser.value(units).toStdString(), "--units");
    } catch (const Error& e) {
        return usage(ui::text(e.what()));
    }
    if (parser.isSet(size)) {
        const QStringList parts = parser.value(size).split(QChar('x'));
        const int w = parts.size() == 2 ? parts[0].toInt() : 0, h = parts.size() == 2 ? parts[1].toInt() : 0;
        if (w < 200 || h < 200 || w > 10000 || h > 10000)
            return usage(QStringLiteral("--size: write it as 1280x800, from 200x200 to 10000x10000"));
        options.size = QSize(w, h);
    }
    const MeshFormat* format = mesh_format_named(options.file.toStdString());
    const bool mesh =
        !options.file.isEmpty() && !options.file.endsWith(QStringLiteral(".facetmill"), Qt::CaseInsensitive);
    if (mesh && (!format || format->needs_unit()) && !options.unit
        && (options.plan || !options.programs.isEmpty() || !options.screenshot.isEmpty()))
        return usage(
            QStringLiteral("name the unit of the mesh by --units, as in --units mm: nobody is there to ask"));
    options.theme = parser.value(theme);
    if (parser.isSet(theme) && options.theme != QLatin1String("system")
        && ui::theme_from_name(options.theme) == ui::Theme::system)
        return usage(QStringLiteral("--theme: use system, light or dark"));
    options.language = parser.value(language);
    if (parser.isSet(language) && ui::language_for(options.language) != options.language)
        return usage(QStringLiteral("--language: use en, de or fr"));
    return options;
}

/// What the options ask for after the window is there, one thing after the other.
class Script : public QObject {
public:
    Script(ui::MainWindow& window, const Options& options) : window_(window), options_(options) {
        connect(&window_, &ui::MainWindow::settled, this, &Script::next);
        QTimer::singleShot(0, this, &Script::next);
    }

private:
    void next() {
        if (window_.busy()) return;
        switch (step_++) {
        case 0:
            // A picture is taken without anybody there to ask.
            if (options_.screenshot.isEmpty() && window_.files().autosave().offer(options_.file)) break;
            if (!options_.file.isEmpty()) window_.open_file(options_.file, options_.unit);
            break;
        case 1:
            if (!window_.document().has_part() || !window_.last_failure().isEmpty()) break;
            if (options_.plan) window_.plan();
            if (!options_.programs.isEmpty()) window_.files().open_program(options_.programs);
            break;
        case 2:
            // What comes of all operations is what one wants to see.
            if (const std::size_t n = window_.document().operation_count(); options_.plan && n > 0)
                window_.tree().select({ui::TreeNode::Kind::operation, n - 1});
            break;
        case 3:
            if (options_.verify && window_.document().has_part() && window_.last_failure().isEmpty())
                window_.verify();
            break;
        case 4:
            // Layout and drawing take a few turns of the event loop.
            if (!options_.screenshot.isEmpty()) QTimer::singleShot(400, this, &Script::take_picture);
            return;
        default:
            return;
        }
        if (!window_.busy()) QTimer::singleShot(0, this, &Script::next); // nothing to wait for
    }
    void take_picture() {
        ui::write_file(
            window_, window_.document(), options_.screenshot,
            [picture = window_.grab().toImage()] { return ui::png_bytes(picture); },
            [this](const QString& wrong) { end(wrong); });
    }
    /// `wrong`: why there is no picture.
    void end(const QString& wrong) {
        bool good = wrong.isEmpty();
        if (!good) std::fprintf(stderr, "facetmill: %s\n", qPrintable(wrong));
        if (!window_.last_failure().isEmpty()) {
            std::fprintf(stderr, "facetmill: %s\n", qPrintable(window_.last_failure()));
            good = false;
        }
        QApplication::exit(good ? 0 : 1);
    }

    ui::MainWindow& window_;
    const Options& options_;
    int step_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    if (options.exit_status >= 0) return options.exit_status;
    qInstallMessageHandler(message_handler);
    vtkObject::GlobalWarningDisplayOff();
    ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("Facetmill"));
    QApplication::setApplicationName(QStringLiteral("facetmill"));
    QApplication::setApplicationDisplayName(QString()); // titles carry the name themselves
    QApplication::setApplicationVersion(QStringLiteral(FACETMILL_VERSION));
    QApplication app(argc, argv);
    starting = false;
    QObject::connect(&app, &QGuiApplication::applicationStateChanged, &app, [](Qt::ApplicationState state) {
        // Another window may have changed them meanwhile.
        if (state == Qt::ApplicationActive) ui::SettingsFile::own().read_again();
    });
    ui::speak(options.language.isEmpty() ? ui::settings::language() : options.language);
    if (const QString why = ui::Viewport::why_unavailable(); !why.isEmpty()) {
        std::fprintf(stderr, "facetmill: %s (install a graphics driver, or use facetmill-cli)\n",
                     qPrintable(why));
        if (options.screenshot.isEmpty() && QGuiApplication::platformName() != QLatin1String("offscreen"))
            QMessageBox::critical(
                nullptr, QStringLiteral("Facetmill"),
                QObject::tr(
                    "The 3D view cannot be shown: %1.\n\nInstall a graphics driver, or use facetmill-cli.")
                    .arg(why));
        return 1;
    }
    ui::MainWindow window;
    if (!options.theme.isEmpty()) window.set_theme(ui::theme_from_name(options.theme));
    if (options.size.isValid()) window.resize(options.size);
    window.viewport().make_shaders();
    window.show();
    // Pictures are of the window as it is used.
    if (options.screenshot.isEmpty() && ui::settings::take_first_start())
        if (auto* steps = window.findChild<QAction*>(QStringLiteral("first_steps"))) steps->trigger();
    Script script(window, options);
    return QApplication::exec();
}
