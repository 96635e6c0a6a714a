// Forms made from parameter descriptions: what is typed, what is refused and what is handed over.
#include "tests/screenshot/window_support.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/text.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <QToolTip>

using namespace facetmill;
using namespace facetmill::test;
using ui::ParameterForm;

namespace {

enum class Pattern { zigzag, one_way };

struct Everything {
    double length = 5;
    double tilt = radians(10);
    long count = 3;
    bool flag = false;
    Pattern pattern = Pattern::zigzag;
    std::string label = "name";
    NumberOrWord step{0, "adaptive"};
    std::array<double, 2> limits{0, 10};
    std::array<double, 3> shift{0, 0, 0};
    double hidden_away = 1;
};

const ParameterTable<Everything>& everything() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<Everything> t;
        t.add(&Everything::length, {.key = "length",
                                    .label = "Length",
                                    .help = "A length.",
                                    .quantity = Quantity::length,
                                    .minimum = 0,
                                    .maximum = 100,
                                    .open_minimum = true});
        t.add(&Everything::tilt, {.key = "tilt",
                                  .label = "Tilt",
                                  .help = "An angle.",
                                  .quantity = Quantity::angle,
                                  .minimum = 0,
                                  .maximum = pi / 2});
        t.add(&Everything::count, {.key = "count",
                                   .label = "Count",
                                   .help = "A number.",
                                   .kind = K::integer,
                                   .quantity = Quantity::count,
                                   .minimum = 1,
                                   .maximum = 9});
        t.add(&Everything::flag, {.key = "flag", .label = "Flag", .help = "Yes or no.", .kind = K::boolean});
        t.add_choice(
            &Everything::pattern,
            {.key = "pattern", .label = "Pattern", .help = "A choice.", .words = {"zigzag", "one_way"}});
        t.add(&Everything::label, {.key = "label", .label = "Label", .help = "Text.", .kind = K::text});
        t.add(&Everything::step, {.key = "step",
                                  .label = "Step-over",
                                  .help = "A number or a word.",
                                  .kind = K::number_or_word,
                                  .quantity = Quantity::length,
                                  .minimum = 0,
                                  .maximum = 50,
                                  .open_minimum = true,
                                  .words = {"adaptive"}});
        t.add(&Everything::limits, {.key = "limits",
                                    .label = "Limits",
                                    .help = "Two numbers.",
                                    .kind = K::pair,
                                    .quantity = Quantity::length,
                                    .minimum = -20,
                                    .maximum = 20,
                                    .ordered = true});
        t.add(&Everything::shift, {.key = "shift",
                                   .label = "Shift",
                                   .help = "Three numbers.",
                                   .kind = K::triple,
                                   .quantity = Quantity::length});
        t.add(&Everything::hidden_away,
              {.key = "hidden_away", .label = "Rare", .help = "Rarely needed.", .advanced = true});
        return t;
    }();
    return table;
}

/// A form over a struct, wired as the window does it: values that are handed over are set, then shown.
struct Bench {
    Everything values;
    ParameterForm form;
    LengthUnit unit = LengthUnit::mm;
    int edits = 0;
    std::string last_key;

    explicit Bench(LengthUnit u = LengthUnit::mm) : unit(u) {
        form.set_parameters(view().parameters(), unit);
        form.set_values(view(), unit);
        QObject::connect(&form, &ParameterForm::edited, &form,
                         [this](const std::string& key, const ParameterValue& v) {
                             ++edits;
                             last_key = key;
                             auto now = view();
                             now.set(key, v);
                             form.set_values(now, unit);
                         });
        form.resize(320, 480);
        form.show();
    }
    ParameterView<Everything> view() { return {values, everything()}; }
    QLineEdit* line(const char* name) {
        if (auto* line = form.findChild<QLineEdit*>(QLatin1String(name))) return line;
        return form.findChild<QComboBox*>(QLatin1String(name))->lineEdit();
    }
    void enter(const char* name, const QString& text) {
        type_over(line(name), text);
        QTest::keyClick(line(name), Qt::Key_Return);
    }
    QLabel* error(const char* key) {
        return form.findChild<QLabel*>(QStringLiteral("error_") + QLatin1String(key));
    }
};

} // namespace

class TestParameterForm : public QObject {
    Q_OBJECT
private slots:
    /// The help of a parameter is made when it is asked for, and screen readers have it, too.
    void help_comes_where_the_pointer_rests() {
        Bench bench;
        QVERIFY(QTest::qWaitForWindowExposed(&bench.form));
        const auto rest_on = [&](QWidget* at) {
            QHelpEvent event(QEvent::ToolTip, QPoint(3, 3), at->mapToGlobal(QPoint(3, 3)));
            QApplication::sendEvent(at, &event);
            return QToolTip::text();
        };
        for (const auto& [name, help] : {std::pair("tilt", "An angle."), std::pair("length", "A length.")}) {
            QToolTip::hideText();
            QVERIFY(rest_on(bench.line(name)).contains(QLatin1String(help)));
            const auto* editor = qobject_cast<QWidget*>(bench.line(name)->parent());
            QCOMPARE(editor->accessibleDescription(), QLatin1String(help));
        }
        QToolTip::hideText();
    }

    void every_kind_has_an_editor() {
        Bench b;
        QVERIFY(QTest::qWaitForWindowExposed(&b.form));
        QCOMPARE(b.line("length")->text(), QStringLiteral("5"));
        QCOMPARE(b.line("tilt")->text(), QStringLiteral("10"));
        QCOMPARE(b.line("count")->text(), QStringLiteral("3"));
        QCOMPARE(b.line("label")->text(), QStringLiteral("name"));
        QCOMPARE(b.line("step")->text(), QStringLiteral("adaptive"));
        QCOMPARE(b.line("limits1")->text(), QStringLiteral("10"));
        QCOMPARE(b.line("shift2")->text(), QStringLiteral("0"));
        QVERIFY(!b.form.findChild<QCheckBox*>(QStringLiteral("flag"))->isChecked());
        QCOMPARE(b.form.findChild<QComboBox*>(QStringLiteral("pattern"))->count(), 2);
        shot(b.form, QStringLiteral("form"));
    }

    void good_values_arrive() {
        Bench b;
        b.enter("length", QStringLiteral("7.25"));
        QCOMPARE(b.values.length, 7.25);
        b.enter("tilt", QStringLiteral("45"));
        QCOMPARE(b.values.tilt, radians(45));
        b.enter("count", QStringLiteral("4"));
        QCOMPARE(b.values.count, 4L);
        b.enter("step", QStringLiteral("1.5"));
        QVERIFY(b.values.step.is_number() && b.values.step.number == 1.5);
        b.enter("step", QStringLiteral("adaptive"));
        QVERIFY(b.values.step.is("adaptive"));
        b.enter("limits0", QStringLiteral("-3"));
        QCOMPARE(b.values.limits, (std::array<double, 2>{-3, 10}));
        b.enter("shift1", QStringLiteral("2"));
        QCOMPARE(b.values.shift, (std::array<double, 3>{0, 2, 0}));
        b.enter("label", QStringLiteral("Zweiter Schnitt"));
        QCOMPARE(b.values.label, std::string("Zweiter Schnitt"));
        QTest::mouseClick(b.form.findChild<QCheckBox*>(QStringLiteral("flag")), Qt::LeftButton, {},
                          QPoint(8, 8));
        QVERIFY(b.values.flag);
        auto* pattern = b.form.findChild<QComboBox*>(QStringLiteral("pattern"));
        pattern->setFocus();
        QTest::keyClick(pattern, Qt::Key_Down);
        QVERIFY(b.values.pattern == Pattern::one_way);
        QVERIFY(b.form.valid());
    }

    void bad_values_are_refused_under_the_field_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("entry");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const char* field, const char* key, const char* entry,
                            const char* message) {
            QTest::newRow(name) << QString::fromLatin1(field) << QString::fromLatin1(key)
                                << QString::fromLatin1(entry) << QString::fromLatin1(message);
        };
        row("negative", "length", "length", "-1", "above 0 mm");
        row("zero", "length", "length", "0", "above 0 mm");
        row("too large", "length", "length", "101", "100 mm");
        row("word", "length", "length", "wide", "a number");
        row("empty", "length", "length", "", "enter a number");
        row("nan", "length", "length", "nan", "a number");
        row("infinite", "length", "length", "inf", "a number");
        row("overflow", "length", "length", "1e999", "a number");
        row("comma", "length", "length", "0,5", "0.5");
        row("angle", "tilt", "tilt", "91", "90");
        row("fraction", "count", "count", "2.5", "whole number");
        row("wrong word", "step", "step", "auto", "adaptive");
        row("reversed", "limits0", "limits", "11", "below");
        row("one of three", "shift1", "shift", "x", "three numbers");
    }
    void bad_values_are_refused_under_the_field() {
        QFETCH(QString, field);
        QFETCH(QString, key);
        QFETCH(QString, entry);
        QFETCH(QString, message);
        Bench b;
        const auto before = b.view().get(key.toStdString());
        b.enter(qPrintable(field), entry);
        QCOMPARE(b.edits, 0);
        QVERIFY(b.view().get(key.toStdString()) == before);
        QVERIFY(!b.form.valid());
        QVERIFY(b.error(qPrintable(key))->isVisible());
        QVERIFY2(b.error(qPrintable(key))->text().contains(ui::kept_together(message)),
                 qPrintable(b.error(qPrintable(key))->text()));
        QVERIFY(!b.form.commit());
        // Another value's change does not take the wrong entry away, and the wrong one still does not count.
        b.enter("label", QStringLiteral("other"));
        QCOMPARE(b.line(qPrintable(field))->text(), entry);
        QVERIFY(!b.form.valid());
        b.enter(qPrintable(field),
                key == QLatin1String("limits") ? QStringLiteral("1") : QStringLiteral("2"));
        QVERIFY(b.form.valid());
        QVERIFY(!b.error(qPrintable(key))->isVisible());
    }

    void an_open_entry_is_committed() {
        Bench b;
        type_over(b.line("length"), QStringLiteral("9"));
        QCOMPARE(b.values.length, 5.0);
        QVERIFY(b.form.commit());
        QCOMPARE(b.values.length, 9.0);
    }

    void untouched_values_keep_all_digits() {
        Bench b(LengthUnit::inch);
        b.values.length = 1.0 / 3;
        b.form.set_values(b.view(), b.unit);
        b.line("length")->setFocus();
        QTest::keyClick(b.line("length"), Qt::Key_Return);
        QVERIFY(b.form.commit());
        QCOMPARE(b.edits, 0);
        QCOMPARE(b.values.length, 1.0 / 3);
    }

    void units() {
        Bench b;
        b.values.length = 25.4;
        b.form.set_values(b.view(), LengthUnit::mm);
        QCOMPARE(b.line("length")->text(), QStringLiteral("25.4"));
        b.unit = LengthUnit::inch;
        b.form.set_values(b.view(), b.unit);
        QCOMPARE(b.line("length")->text(), QStringLiteral("1"));
        b.enter("length", QStringLiteral("2"));
        QCOMPARE(b.values.length, 50.8);
        b.enter("length", QStringLiteral("12.7 mm")); // the other unit, written out
        QCOMPARE(b.values.length, 12.7);
        QCOMPARE(b.line("length")->text(), QStringLiteral("0.5"));
        b.enter("length", QStringLiteral("4"));
        QVERIFY(!b.form.valid()); // 101.6 mm
        QVERIFY2(b.error("length")->text().contains(QStringLiteral("\u00a0in")),
                 qPrintable(b.error("length")->text()));
    }

    /// Whatever can be worked out is, when the entry is finished and not while it is typed.
    void numbers_are_worked_out() {
        Bench b;
        b.form.set_names({{"stock.x", 40}});
        b.enter("length", QStringLiteral("25.4/2"));
        QCOMPARE(b.values.length, 12.7);
        QCOMPARE(b.line("length")->text(), QStringLiteral("12.7"));
        b.enter("length", QStringLiteral("1/4 in"));
        QCOMPARE(b.values.length, 6.35);
        b.enter("length", QStringLiteral("= stock.x / 2 - 1"));
        QCOMPARE(b.values.length, 19.0);
        b.enter("tilt", QStringLiteral("90/4"));
        QCOMPARE(b.values.tilt, radians(22.5));
        b.enter("step", QStringLiteral("1/2"));
        QCOMPARE(b.line("step")->text(), QStringLiteral("0.5"));
        b.enter("step", QStringLiteral("adaptive"));
        QCOMPARE(b.line("step")->text(), QStringLiteral("adaptive"));
        b.enter("count", QStringLiteral("2*3"));
        QCOMPARE(b.line("count")->text(), QStringLiteral("6"));
        for (const char* wrong : {"25.4/", "stok.x", "3 4", "1/0"}) {
            b.enter("length", QString::fromLatin1(wrong));
            QVERIFY2(!b.form.valid() && !b.error("length")->text().isEmpty(), wrong);
        }
        shot(b.form, QStringLiteral("form-expression"));
        b.form.set_live(true);
        type_over(b.line("length"), QStringLiteral("8/2"));
        QCOMPARE(b.line("length")->text(), QStringLiteral("8/2"));
        QTest::keyClick(b.line("length"), Qt::Key_Return);
        QCOMPARE(b.values.length, 4.0);
    }

    void reset_and_advanced() {
        Bench b;
        auto* reset = b.form.findChild<QToolButton*>(QStringLiteral("reset_length"));
        QVERIFY(!reset->isVisible());
        b.enter("length", QStringLiteral("6"));
        QVERIFY(reset->isVisible());
        QTest::mouseClick(reset, Qt::LeftButton);
        QCOMPARE(b.values.length, 5.0);
        QVERIFY(!reset->isVisible());
        QVERIFY(!b.line("hidden_away")->isVisible());
        QTest::mouseClick(b.form.findChild<QToolButton*>(QStringLiteral("advanced")), Qt::LeftButton);
        QVERIFY(b.line("hidden_away")->isVisible());
    }

    void help_follows_the_focus() {
        Bench b;
        QVERIFY(activate(b.form));
        b.line("tilt")->setFocus();
        const QString help = b.form.findChild<QLabel*>(QStringLiteral("parameter_help"))->text();
        QVERIFY2(help.contains(QStringLiteral("An angle.")) && help.contains(QStringLiteral("0 to 90")),
                 qPrintable(help));
    }

    void live_forms_hand_over_while_typing() {
        Bench b;
        b.form.set_live(true);
        type_over(b.line("length"), QStringLiteral("8.5"));
        QCOMPARE(b.values.length, 8.5);
        QCOMPARE(b.line("length")->text(), QStringLiteral("8.5"));
        type_over(b.line("length"), QStringLiteral("0."));
        QCOMPARE(b.values.length, 8.5);
        QVERIFY(!b.form.valid());
        QCOMPARE(b.line("length")->text(), QStringLiteral("0."));
    }
};
FACETMILL_TEST(TestParameterForm)

class TestText : public QObject {
    Q_OBJECT
private slots:
    void messages_speak_the_unit_of_the_project() {
        const QString message =
            QStringLiteral("the tip goes 25.4 mm below -12.7 mm at 100 mm/min in 5 mm² of T1.5 mm, 1e-03 mm");
        QCOMPARE(ui::with_lengths_in(message, LengthUnit::mm), message);
        QCOMPARE(ui::with_lengths_in(message, LengthUnit::inch),
                 QStringLiteral(
                     "the tip goes 1 in below -0.5 in at 100 mm/min in 5 mm² of T1.5 mm, 0.0000394 in"));
    }
    void figures_have_a_floor_in_every_unit() {
        QCOMPARE(ui::shown_length(2e-6, LengthUnit::mm), QStringLiteral("< 0.0001\u00a0mm"));
        QCOMPARE(ui::shown_length(2e-6, LengthUnit::inch), QStringLiteral("< 0.00001\u00a0in"));
        QCOMPARE(ui::with_lengths_in(QStringLiteral("up to < 0.0001 mm, < 5 mm"), LengthUnit::inch),
                 QStringLiteral("up to < 0.00001 in, < 0.1969 in"));
        QCOMPARE(ui::shown_area(0.0434, LengthUnit::inch), QStringLiteral("< 0.0001\u00a0in²"));
        QCOMPARE(ui::shown_area(64.516, LengthUnit::inch), QStringLiteral("0.1\u00a0in²"));
        QCOMPARE(ui::percent_text(3e-7), QStringLiteral("< 0.01 %"));
        QCOMPARE(ui::percent_text(0.125), QStringLiteral("12.5 %"));
    }
    /// "2" at the end of a line and "%" on the next is hard to read.
    void a_number_keeps_its_unit() {
        const QString gap(QChar(0x00A0));
        QCOMPARE(
            ui::kept_together(QStringLiteral("2 % of 0.5 mm² in 3 min 20 s at (1, 2) mm, 8000 U/min")),
            QStringLiteral("2~% of 0.5~mm² in 3~min 20~s at (1, 2)~mm, 8000~U/min").replace(QChar('~'), gap));
        for (const char* other : {"3 models", "2 inner ones", "G54 in", "width=\"100%\"", "5 hours", "1 2"})
            QCOMPARE(ui::kept_together(QLatin1String(other)), QLatin1String(other));
        QWidget view;
        ui::MessageBar bar(&view);
        bar.show_message(ui::MessageBar::Kind::warning, QStringLiteral("Material is left on 2 % of it"));
        QCOMPARE(bar.findChild<QLabel*>(QStringLiteral("message_text"))->text(),
                 QStringLiteral("Material is left on 2~% of it").replace(QChar('~'), gap));
        QCOMPARE(bar.message(), QStringLiteral("Material is left on 2 % of it"));
    }
    void names_are_listed_as_a_sentence_has_them() {
        QCOMPARE(ui::some_of({}), QString());
        QCOMPARE(ui::some_of({"a"}), QStringLiteral("a"));
        QCOMPARE(ui::some_of({"a", "b"}), QStringLiteral("a and b"));
        QCOMPARE(ui::some_of({"a", "%1", "c"}), QStringLiteral("a, %1 and c"));
        QCOMPARE(ui::some_of({"a", "b", "c", "d", "e"}), QStringLiteral("a, b, c and 2 more"));
        const QString name = ui::some_of({QString(100, QLatin1Char('x'))});
        QVERIFY(name.size() == 32 && name.contains(QChar(0x2026)));
    }

    void durations_and_counts() {
        QCOMPARE(ui::duration_text(0.44), QStringLiteral("0.4 s"));
        QCOMPARE(ui::duration_text(9.96), QStringLiteral("10 s"));
        QCOMPARE(ui::duration_text(59.4), QStringLiteral("59 s"));
        QCOMPARE(ui::duration_text(59.6), QStringLiteral("1 min 00 s"));
        QCOMPARE(ui::duration_text(3725), QStringLiteral("1 h 02 min"));
        QCOMPARE(ui::count_text(7), QStringLiteral("7"));
        QCOMPARE(ui::count_text(1234567).remove(QChar(0x202F)), QStringLiteral("1234567"));
        QCOMPARE(ui::count_text(1234567).size(), 9);
        QCOMPARE(ui::elided(QStringLiteral("abcdefghij"), 5), QStringLiteral("ab…ij"));
        QCOMPARE(ui::elided(QStringLiteral("abcde"), 5), QStringLiteral("abcde"));
    }
};
FACETMILL_TEST(TestText)

#include "test_window_forms.moc"
