// Nothing is cut off: on no page, in neither palette, in a small window and in the usual one.
#include "tests/screenshot/window_tour.h"
#include "ui/elided_label.h"
#include "ui/properties_panel.h"
#include "ui/viewport.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;

namespace {

QString named(const QWidget& w, const QString& text) {
    return QStringLiteral("%1 '%2' in %3")
        .arg(w.objectName(), text.left(60), w.parentWidget() ? w.parentWidget()->objectName() : QString());
}

/// What a label's words need; nothing for those that shorten themselves.
std::optional<QSize> needed(const QLabel& label) {
    if (label.text().isEmpty() || !label.pixmap().isNull()) return std::nullopt;
    if (qobject_cast<const ui::ElidedLabel*>(&label)) return std::nullopt;
    if (label.wordWrap()) return QSize(0, label.heightForWidth(label.width()));
    return label.sizeHint();
}

/// Why the words of a widget cannot be read; empty where they can.
QString cut(const QWidget& w) {
    QString text;
    QSize need;
    if (const auto* label = qobject_cast<const QLabel*>(&w)) {
        text = label->text();
        if (const auto* elided = qobject_cast<const ui::ElidedLabel*>(label);
            elided && elided->fontMetrics().horizontalAdvance(text) > elided->width()
            && !elided->toolTip().contains(text))
            return QStringLiteral("shortened without a tool tip: ") + named(w, text);
        const auto size = needed(*label);
        if (!size) return {};
        need = *size;
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&w)) {
        text = button->text();
        const auto* tool = qobject_cast<const QToolButton*>(button);
        if (text.isEmpty() || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)) return {};
        // Frames may be narrower than a style would like; words may not.
        const int icon = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
        need = QSize(button->fontMetrics().size(Qt::TextShowMnemonic, text).width() + icon, 0);
        if (!qobject_cast<const QPushButton*>(button) && !tool) need.setWidth(button->sizeHint().width());
    } else
        return {};
    if (need.width() > w.width() + 1 || need.height() > w.height() + 1)
        return QStringLiteral("%1 needs %2 x %3, has %4 x %5")
            .arg(named(w, text))
            .arg(need.width())
            .arg(need.height())
            .arg(w.width())
            .arg(w.height());
    // Not beyond the edge of what it stands in, to the right or left: there is nothing to scroll to.
    const QRect seen = w.visibleRegion().boundingRect();
    if (need.width() > 0 && !seen.isEmpty() && seen.width() < std::min(need.width(), w.width()) - 1)
        return QStringLiteral("%1 is seen for %2 of %3").arg(named(w, text)).arg(seen.width()).arg(w.width());
    return {};
}

QStringList cut_words(QWidget& top, const QString& page) {
    QStringList found;
    for (const QWidget* w : top.findChildren<QWidget*>())
        if (w->isVisible() && w->window() == &top && !w->visibleRegion().isEmpty())
            if (const QString why = cut(*w); !why.isEmpty()) found << page + QStringLiteral(": ") + why;
    return found;
}

} // namespace

class TestWindowLayout : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() {
        QSettings().clear();
        QVERIFY(show_window());
    }
    void cleanup() {
        w().set_theme(ui::Theme::system);
        close_window();
    }
    void cleanupTestCase() { QSettings().clear(); }

    void nothing_is_cut_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark");
        QTest::newRow("800x600") << QSize(800, 600) << false;
        QTest::newRow("800x600-dark") << QSize(800, 600) << true;
        QTest::newRow("1280x800") << QSize(1280, 800) << false;
    }
    void nothing_is_cut() {
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        w().resize(size);
        w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
        action(w(), "first_steps")->trigger();
        QTest::qWait(30);
        QStringList found = found_at_rest([&] { return cut_words(w(), QStringLiteral("start")); });
        const QString tag = QString::fromLatin1(QTest::currentDataTag());
        shot(w(), QStringLiteral("layout-%1-start").arg(tag));
        QVERIFY(open_and_plan());
        const int form = w().properties().width();
        int pages = 0;
        const auto look = [&](QWidget& top, const QString& page) {
            ++pages;
            found << found_at_rest([&] { return cut_words(top, page); });
            if (!qEnvironmentVariableIsEmpty("FACETMILL_LAYOUT_PICTURES"))
                shot(top,
                     QStringLiteral("layout-%1-%2").arg(tag, QString(page).replace(QChar('/'), QChar('-'))));
        };
        tour_window(w(), look);
        tour_dialogs(w(), look);
        QVERIFY2(pages > 40, qPrintable(QString::number(pages)));
        found.removeDuplicates();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
        // The form keeps its width, and the view is still one.
        QVERIFY2(std::abs(w().properties().width() - form) <= 2,
                 qPrintable(QStringLiteral("%1 %2").arg(form).arg(w().properties().width())));
        QVERIFY(form >= 270);
        QVERIFY(w().viewport().width() >= 200 && w().viewport().height() >= 200);
        QCOMPARE(w().size(), size);
    }

    /// A cut word is seen: the test itself.
    void a_cut_word_is_found() {
        QWidget top;
        top.setObjectName(QStringLiteral("top"));
        top.resize(200, 100);
        auto* label = new QLabel(QStringLiteral("Words that need more room than they have"), &top);
        label->setGeometry(0, 0, 60, 20);
        auto* button = new QPushButton(QStringLiteral("Quite a long button"), &top);
        button->setGeometry(0, 30, 50, 24);
        auto* edge = new QCheckBox(QStringLiteral("Beyond the edge"), &top);
        edge->setGeometry(150, 60, edge->sizeHint().width(), 24);
        auto* good = new QLabel(QStringLiteral("Short"), &top);
        good->setGeometry(0, 60, 80, 20);
        top.show();
        QVERIFY(QTest::qWaitForWindowExposed(&top));
        QCOMPARE(cut_words(top, QString()).size(), 3);
    }
};

FACETMILL_TEST(TestWindowLayout)
#include "test_window_layout.moc"
