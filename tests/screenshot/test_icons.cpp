// Icons: every name that the code has is asked for and has a file, and every file shows something in both
// palettes.
#include "tests/support/test_runner.h"
#include "ui/icons.h"
#include "ui/theme.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QMetaEnum>
#include <QPalette>
#include <QRegularExpression>
#include <QSet>
#include <QSvgRenderer>
#include <QTest>

using namespace facetmill::ui;

namespace {

const QString root = QStringLiteral(FACETMILL_TEST_DATA "/..");

QString text_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QSet<QString> svg_names(const QString& folder) {
    QSet<QString> names;
    for (const QString& file : QDir(folder).entryList({QStringLiteral("*.svg")}))
        names.insert(file.chopped(4));
    return names;
}

/// The icons by those who know of them.
struct Lists {
    QSet<QString> names;    // in enum Icon
    QSet<QString> asked;    // by the code of ui
    QSet<QString> files;    // in resources/icons
    QSet<QString> compiled; // into this program
};

QStringList wrong_lists(const Lists& all) {
    QStringList wrong;
    const auto beyond = [&](const QSet<QString>& some, const QSet<QString>& others, const char* what) {
        for (const QString& name : some - others)
            wrong << QString("%1 %2").arg(name, what);
    };
    beyond(all.names, all.asked, "is a name that no code asks for");
    beyond(all.names, all.files, "has no file");
    beyond(all.files, all.names, "is a file that no name stands for");
    beyond(all.files, all.compiled, "is not in resources/icons.qrc");
    return wrong;
}

/// In an icon without a colour of its own.
const IconColors one_color = {QColor(1, 2, 3), QColor(1, 2, 3), QColor(1, 2, 3), QColor(1, 2, 3),
                              QColor(1, 2, 3), QColor(1, 2, 3), QColor(1, 2, 3)};

QStringList unknown_colors(const QString& svg) {
    static const QRegularExpression painted(QStringLiteral("(fill|stroke)(=\"|:\\s*)([^\";]*)"));
    QStringList unknown;
    for (auto it = painted.globalMatch(with_colors(svg, one_color)); it.hasNext();)
        if (const QString color = it.next().captured(3);
            color != "none" && color != "white" && color != "#010203")
            unknown << color;
    return unknown;
}

QImage image_of(const QIcon& icon, int side, QIcon::Mode mode = QIcon::Normal) {
    return icon.pixmap(QSize(side, side), 1.0, mode).toImage().convertToFormat(QImage::Format_ARGB32);
}

/// Pixels that are told from a window of the palette.
int seen_pixels(const QImage& image) {
    const QColor ground = QApplication::palette().color(QPalette::Window);
    int seen = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            const int differs =
                std::max({std::abs(c.red() - ground.red()), std::abs(c.green() - ground.green()),
                          std::abs(c.blue() - ground.blue())});
            seen += c.alpha() * differs > 40 * 255;
        }
    return seen;
}

/// All of its alpha.
int ink(const QImage& image) {
    int sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += image.pixelColor(x, y).alpha();
    return sum;
}

/// What is wrong with the text of a file.
QStringList wrong_drawing(const QString& svg) {
    QStringList wrong;
    const QSvgRenderer drawing(svg.toUtf8());
    if (!drawing.isValid() || drawing.viewBoxF() != QRectF(0, 0, 24, 24)) wrong << "not on 24 x 24";
    for (const QString& color : unknown_colors(svg))
        wrong << "a colour that no word stands for: " + color;
    const QPalette before = QApplication::palette();
    for (const QPalette& palette : {light_palette(), dark_palette()}) {
        QApplication::setPalette(palette);
        for (const int side : {16, 24, 48})
            if (seen_pixels(image_of(svg_icon(svg), side)) < side / 2)
                wrong
                    << QString("not seen at %1 in %2").arg(side).arg(palette.color(QPalette::Window).name());
    }
    QApplication::setPalette(before);
    return wrong;
}

QString drawn(const QString& inside) {
    return QString("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 24 24\">%1</svg>").arg(inside);
}

} // namespace

class TestIcons : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY(!icon(Icon::add).pixmap(16).isNull()); // and what is compiled in can be listed
        const QMetaEnum names = QMetaEnum::fromType<Icon>();
        for (int i = 0; i < names.keyCount(); ++i)
            lists_.names.insert(QLatin1String(names.key(i)));
        static const QRegularExpression use(QStringLiteral("\\bIcon::(\\w+)"));
        for (const QString& file : QDir(root + "/ui").entryList({"*.cpp", "*.h"})) {
            const QString code = text_of(root + "/ui/" + file);
            for (auto it = use.globalMatch(code); it.hasNext();)
                lists_.asked.insert(it.next().captured(1));
        }
        lists_.files = svg_names(root + "/resources/icons");
        lists_.compiled = svg_names(QStringLiteral(":/icons"));
        QVERIFY(lists_.files.size() > 40);
    }

    void a_button_without_room_draws_nothing() {
        QTest::failOnWarning(QRegularExpression(QStringLiteral("QPainter")));
        for (const QSize size : {QSize(0, 16), QSize(16, 0), QSize(-2, 16)})
            QVERIFY(icon(Icon::add).pixmap(size).isNull());
    }

    void names_and_files_belong_together() {
        QVERIFY2(wrong_lists(lists_).isEmpty(), qPrintable(wrong_lists(lists_).join('\n')));
    }

    void what_does_not_belong_is_found() {
        const Lists good{{"a", "b"}, {"a", "b"}, {"a", "b"}, {"a", "b"}};
        QCOMPARE(wrong_lists(good), QStringList());
        for (QSet<QString> Lists::*lost : {&Lists::names, &Lists::asked, &Lists::files, &Lists::compiled}) {
            Lists bad = good;
            (bad.*lost).remove("b");
            QCOMPARE(wrong_lists(bad).size(), 1);
        }
    }

    void files_show_something() {
        for (const QString& name : lists_.files) {
            const QStringList wrong = wrong_drawing(text_of(root + "/resources/icons/" + name + ".svg"));
            QVERIFY2(wrong.isEmpty(), qPrintable(name + ": " + wrong.join(", ")));
        }
    }

    void what_shows_nothing_is_found() {
        const QString good = "<circle cx=\"12\" cy=\"12\" r=\"6\" fill=\"%1\"/>";
        for (const char* color : {"currentColor", "blue", "#0000ff", "green", "orange", "red", "gray"})
            QCOMPARE(wrong_drawing(drawn(good.arg(color))), QStringList());
        QVERIFY(!wrong_drawing({}).isEmpty());
        QVERIFY(!wrong_drawing(drawn({})).isEmpty());
        QVERIFY(!wrong_drawing(drawn(good.arg("none"))).isEmpty());
        QVERIFY(!wrong_drawing(drawn(good.arg("white"))).isEmpty());  // not seen on a light window
        QVERIFY(!wrong_drawing(drawn(good.arg("purple"))).isEmpty()); // no word of ours
        QVERIFY(!wrong_drawing(drawn("<circle cx=\"40\" cy=\"12\" r=\"6\" fill=\"red\"/>")).isEmpty());
        QVERIFY(!wrong_drawing(drawn(good.arg("red")).replace("24 24", "32 32")).isEmpty());
        QVERIFY(!wrong_drawing(drawn(good.arg("red")).chopped(4)).isEmpty());
    }

    void icons_follow_palette_and_state() {
        const QPalette before = QApplication::palette();
        const QMetaEnum names = QMetaEnum::fromType<Icon>();
        for (int i = 0; i < names.keyCount(); ++i) {
            const QIcon shown = icon(Icon(names.value(i)));
            QApplication::setPalette(light_palette());
            const QImage light = image_of(shown, 24);
            const int plain = ink(light), faint = ink(image_of(shown, 24, QIcon::Disabled));
            QApplication::setPalette(dark_palette());
            const QImage dark = image_of(shown, 24);
            QApplication::setPalette(before);
            QVERIFY2(light != dark, names.key(i));
            QVERIFY2(0 < faint && 2 * faint < plain, names.key(i));
            // As many pixels as the screen has, not small ones enlarged.
            const QPixmap twice = shown.pixmap(QSize(24, 24), 2.0);
            QCOMPARE(twice.size(), QSize(48, 48));
            QCOMPARE(twice.deviceIndependentSize(), QSizeF(24, 24));
        }
        for (const int side : {16, 256})
            QVERIFY(image_of(application_icon(), side).pixelColor(side / 2, side / 4).alpha() == 255);
    }

private:
    Lists lists_;
};

FACETMILL_TEST(TestIcons)
#include "test_icons.moc"
