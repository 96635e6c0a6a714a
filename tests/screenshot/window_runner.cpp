// Runs the window tests: a real application, with settings and caches in a folder of its own, and one font.
#include "tests/screenshot/window_support.h"

#include "ui/theme.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QDir>
#include <QFont>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <vector>

#include <vtkObject.h>

namespace facetmill::test {

namespace {

struct Entry {
    const char* name;
    std::function<std::unique_ptr<QObject>()> make;
};
std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
}

QString scratch;

} // namespace

bool register_test(const char* name, std::function<std::unique_ptr<QObject>()> make) {
    entries().push_back({name, std::move(make)});
    return true;
}

std::string data_path(const std::string& relative) {
    return std::string(FACETMILL_TEST_DATA) + "/" + relative;
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
    vtkObject::GlobalWarningDisplayOff();
    facetmill::ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    QApplication::setApplicationName(QStringLiteral("facetmill-test"));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication app(argc, argv);
    app.setFont(QFont(QStringLiteral("DejaVu Sans"), 9));
    app.setCursorFlashTime(0);
    facetmill::ui::apply_theme(app, facetmill::ui::Theme::light);

    using facetmill::test::entries;
    const char* only = nullptr;
    if (argc > 1 && argv[1][0] != '-') {
        for (const auto& e : entries())
            if (std::strcmp(e.name, argv[1]) == 0) only = e.name;
        if (only) {
            for (int i = 1; i + 1 < argc; ++i)
                argv[i] = argv[i + 1];
            --argc;
        }
    }
    int failed = 0, run = 0;
    for (const auto& e : entries()) {
        if (only && std::strcmp(e.name, only) != 0) continue;
        const auto object = e.make();
        failed += QTest::qExec(object.get(), argc, argv);
        ++run;
    }
    if (run == 0) {
        std::fprintf(stderr, "no test class was linked into this program\n");
        return 1;
    }
    return failed == 0 ? 0 : 1;
}
