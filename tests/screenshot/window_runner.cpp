// Runs the window tests: a real application, with settings and caches in a folder of its own, and one font.
#include "tests/screenshot/window_support.h"

#include "ui/language.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QDir>
#include <QFont>
#include <QTemporaryDir>

#include <vtkObject.h>

namespace facetmill::test {

namespace {
QString scratch;
}

QString scratch_folder(const QString& name) {
    const QString folder = scratch + QChar('/') + name;
    QDir(folder).removeRecursively();
    QDir().mkpath(folder);
    return folder;
}

} // namespace facetmill::test

int main(int argc, char** argv) {
    QTemporaryDir home;
    facetmill::test::scratch = home.path();
    qputenv("XDG_CONFIG_HOME", (home.path() + QStringLiteral("/config")).toUtf8());
    qputenv("XDG_CACHE_HOME", (home.path() + QStringLiteral("/cache")).toUtf8());
    qputenv("XDG_DATA_HOME", (home.path() + QStringLiteral("/data")).toUtf8());
    vtkObject::GlobalWarningDisplayOff();
    facetmill::ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    QApplication::setApplicationName(QStringLiteral("facetmill-test"));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication app(argc, argv);
    app.setFont(QFont(QStringLiteral("DejaVu Sans"), 9));
    app.setCursorFlashTime(0);
    facetmill::ui::speak(QStringLiteral("en")); // whatever the machine speaks
    facetmill::ui::apply_theme(app, facetmill::ui::Theme::light);

    return facetmill::test::run_tests(argc, argv);
}
