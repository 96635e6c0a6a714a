// Undo from every field there is: whatever is changed in a form is one step of the history, Ctrl+Z in that
// field takes it back to the byte, and Ctrl+Shift+Z brings it again.
#include "tests/screenshot/window_support.h"
#include "ui/boundary_list.h"
#include "ui/fixture_list.h"
#include "ui/help.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/settings_file.h"
#include "ui/setup_list.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSet>
#include <QTest>
#include <QTimer>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;
using ui::ParameterForm;
using ui::TreeNode;

namespace {

/// A field of a form that is built anew when something else shows: its parameter, and which of two or three.
struct FieldPlace {
    QString key;
    int part = 0;
};

bool takes_keys(const QWidget& w) {
    return (qobject_cast<const QCheckBox*>(&w) || qobject_cast<const QComboBox*>(&w)
            || (qobject_cast<const QLineEdit*>(&w) && !qobject_cast<const QComboBox*>(w.parentWidget())))
           && w.isVisibleTo(w.window()) && w.isEnabled();
}

QList<QWidget*> fields_in(const ui::ParameterEditor& editor) {
    QList<QWidget*> fields;
    for (QWidget* w : editor.findChildren<QWidget*>())
        if (takes_keys(*w)) fields << w;
    return fields;
}

ui::ParameterEditor* editor_of(const ParameterForm& form, const QString& key) {
    for (auto* editor : form.findChildren<ui::ParameterEditor*>())
        if (editor->property(ui::help_key_property).toString() == key) return editor;
    return nullptr;
}

QWidget* field_at(const ParameterForm& form, const FieldPlace& place) {
    const ui::ParameterEditor* editor = editor_of(form, place.key);
    return editor ? fields_in(*editor).value(place.part) : nullptr;
}

std::vector<FieldPlace> all_fields(const ParameterForm& form) {
    auto* fold = form.findChild<QToolButton*>(QStringLiteral("advanced"));
    if (fold && fold->isVisible() && !fold->isChecked()) fold->click();
    std::vector<FieldPlace> all;
    for (const auto* editor : form.findChildren<ui::ParameterEditor*>())
        for (int i = 0; i < fields_in(*editor).size(); ++i)
            all.push_back({editor->property(ui::help_key_property).toString(), i});
    return all;
}

/// Texts that one kind of line or another takes, tried until one is another value.
QStringList entries_other_than(const QString& now) {
    QStringList all{QStringLiteral("3"),    QStringLiteral("1"),  QStringLiteral("0.5"),
                    QStringLiteral("0.01"), QStringLiteral("40"), QStringLiteral("0"),
                    QStringLiteral("-1"),   QStringLiteral("2"),  QStringLiteral("G55"),
                    QStringLiteral("0.9"),  QStringLiteral("80"), QStringLiteral("Other"),
                    QStringLiteral("0, 2"), QStringLiteral("5-7")};
    all.removeAll(now);
    return all;
}

/// By mouse and keys, as a user does, until `changed` says so.
template <class Changed>
bool change(const ParameterForm& form, const FieldPlace& place, const Changed& changed,
            Qt::Key leave = Qt::Key_Return) {
    QWidget* field = field_at(form, place);
    if (qobject_cast<QCheckBox*>(field)) {
        QTest::mouseClick(field, Qt::LeftButton, {}, QPoint(8, field->height() / 2));
        return changed();
    }
    auto* box = qobject_cast<QComboBox*>(field);
    if (box && !box->isEditable()) {
        for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Up}) {
            field = field_at(form, place);
            field->setFocus();
            QTest::keyClick(field, key);
            if (changed()) return true;
        }
        return false;
    }
    const auto line = [&] {
        QWidget* now = field_at(form, place);
        auto* now_box = qobject_cast<QComboBox*>(now);
        return now_box ? now_box->lineEdit() : qobject_cast<QLineEdit*>(now);
    };
    const QString before = line()->text();
    for (const QString& entry : entries_other_than(before)) {
        type_over(line(), entry);
        QTest::keyClick(line(), leave);
        if (changed()) return true;
    }
    type_over(line(), before);
    QTest::keyClick(line(), leave);
    return false;
}

std::string tool_text(const Tool& tool) {
    Tool shown = tool;
    const ParameterView<Tool> view(shown, tool_parameters());
    std::string all;
    for (const ParameterInfo* info : view.parameters())
        all += info->value_text(view.get(info->key), LengthUnit::mm) + '\n';
    return all;
}

} // namespace

class TestWindowUndo : public QObject, private WindowFixture {
    Q_OBJECT

    QTimer no_files_; ///< choices that ask for one are given up

    std::string text_now() { return project_to_json(w().document().project()); }
    int steps() { return w().document().undo_stack().index(); }
    ParameterForm& form() { return *w().properties().form(); }

    void add_second_tool() {
        Tool second = w().document().project().tools.front();
        second.number = 2;
        w().document().change(QStringLiteral("tool"), [&](Project& p) { p.tools.push_back(second); });
    }

    /// Every field of what is shown, but for parameters that were `seen`. The number of fields; those that
    /// nothing changes go to `fixed`.
    int walk(const QString& name, QStringList& fixed, QStringList& wrong, const QSet<QString>& seen = {}) {
        std::vector<FieldPlace> fields = all_fields(form());
        std::erase_if(fields, [&](const FieldPlace& place) { return seen.contains(place.key); });
        for (const FieldPlace& place : fields) {
            const QString where = name + QChar(' ') + place.key + QChar(' ') + QString::number(place.part);
            const std::string before = text_now();
            const int step = steps();
            const auto press = [&](Qt::KeyboardModifiers keys) {
                QWidget* at = field_at(form(), place);
                auto* box = qobject_cast<QComboBox*>(at);
                if (box && box->isEditable()) at = box->lineEdit();
                if (!at) at = &w(); // the form has another shape now
                at->setFocus();
                QTest::keyClick(at, Qt::Key_Z, keys);
            };
            if (!change(form(), place, [&] { return text_now() != before; })) {
                fixed << where;
                if (text_now() != before || steps() != step)
                    wrong << where + QStringLiteral(": half changed");
                continue;
            }
            const std::string after = text_now();
            if (steps() != step + 1) wrong << where + QStringLiteral(": %1 steps").arg(steps() - step);
            press(Qt::ControlModifier);
            if (text_now() != before) wrong << where + QStringLiteral(": not undone");
            press(Qt::ControlModifier | Qt::ShiftModifier);
            if (text_now() != after) wrong << where + QStringLiteral(": not done again");
            press(Qt::ControlModifier);
            if (text_now() != before) wrong << where + QStringLiteral(": not undone a second time");
            while (steps() > step)
                w().document().undo_stack().undo();
        }
        return int(fields.size());
    }
    void compare(const QStringList& fixed, const QStringList& wrong, const QStringList& may_be_fixed) {
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QChar('\n'))));
        QStringList unexpected;
        for (const QString& one : fixed)
            if (!std::any_of(may_be_fixed.begin(), may_be_fixed.end(),
                             [&](const QString& end) { return one.endsWith(end); }))
                unexpected << one;
        QVERIFY2(unexpected.isEmpty(),
                 qPrintable(QStringLiteral("nothing changes\n") + unexpected.join(QChar('\n'))));
    }

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        QVERIFY(show_window() && open_part());
        QVERIFY(activate(w()));
        w().resize(1280, 1000);
        connect(&no_files_, &QTimer::timeout, this, [] {
            if (auto* asked = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) asked->reject();
        });
        no_files_.start(20);
    }
    void cleanup() {
        no_files_.stop();
        no_files_.disconnect();
        close_window();
        ui::SettingsFile::own().clear();
    }

    void every_field_of_every_operation() {
        add_second_tool();
        ui::add_boundary(w().document(), Boundary::Kind::slope);
        QStringList fixed, wrong;
        QSet<QString> seen; // what several kinds have is one description and one editor
        int fields = 0;
        for (const OperationKind& kind : operation_kinds()) {
            const std::size_t at = w().document().add_operation(kind.kind);
            w().tree().select({TreeNode::Kind::operation, at});
            fields += walk(ui::text(kind.kind), fixed, wrong, seen);
            for (const FieldPlace& place : all_fields(form()))
                seen.insert(place.key);
            w().document().undo_stack().undo();
        }
        QVERIFY2(seen.size() > 40 && fields > 50, qPrintable(QString::number(fields)));
        compare(fixed, wrong, {QStringLiteral("finish3 topology 0")}); // there is one so far
    }

    void every_field_of_the_job() {
        using NodeKind = TreeNode::Kind;
        add_second_tool();
        QStringList fixed, wrong;
        int fields = 0;
        for (const auto& [kind, name] : {std::pair(NodeKind::part, "part"),
                                         {NodeKind::stock, "stock"},
                                         {NodeKind::machine, "machine"},
                                         {NodeKind::limits, "limits"}}) {
            w().tree().select({kind, 0});
            const int walked = walk(QLatin1String(name), fixed, wrong);
            QVERIFY2(walked >= 1, name);
            fields += walked;
            QVERIFY(wait_until_settled(w()));
        }
        for (const StockSpec::Kind kind : {StockSpec::Kind::cylinder, StockSpec::Kind::mesh}) {
            w().document().change(QStringLiteral("stock"), [&](Project& p) { p.stock.kind = kind; });
            w().tree().select({NodeKind::part, 0});
            w().tree().select({NodeKind::stock, 0});
            fields += walk(QStringLiteral("stock %1").arg(int(kind)), fixed, wrong);
            w().document().undo_stack().undo();
            QVERIFY(wait_until_settled(w()));
        }
        for (QAction* made :
             w().tree().add_fixture_menu()->actions().mid(0, 5) + w().tree().add_boundary_menu()->actions()) {
            if (made->isSeparator() || !made->isEnabled()) continue;
            const int step = steps();
            made->trigger();
            QVERIFY(wait_until_settled(w()));
            if (steps() == step) continue; // it asks for a file
            fields += walk(made->text(), fixed, wrong);
            while (steps() > step)
                w().document().undo_stack().undo();
            QVERIFY(wait_until_settled(w()));
        }
        ui::add_setup(w().document(), ui::NewSetup::as_it_lies);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({NodeKind::setup, 1});
        fields += walk(QStringLiteral("setup"), fixed, wrong);
        QVERIFY2(fields > 60, qPrintable(QString::number(fields)));
        compare(fixed, wrong, {});
    }

    /// A tool's dialog hands over when it is closed, as one step, whatever was changed in it.
    void every_field_of_a_tool() {
        QStringList fixed, wrong;
        const std::string before = text_now();
        const int step = steps();
        const auto open = [&] {
            ui::ToolDialog* dialog = ui::ToolDialog::open_for(w().document(), 0, &w());
            return QTest::qWaitForWindowExposed(dialog) && activate(*dialog) ? dialog : nullptr;
        };
        const auto accept = [&](QPointer<ui::ToolDialog> dialog) {
            dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
            QTRY_VERIFY_WITH_TIMEOUT(!dialog, patience_ms);
        };
        std::vector<FieldPlace> fields;
        {
            auto* dialog = open();
            QVERIFY(dialog);
            fields = all_fields(*dialog->findChild<ParameterForm*>());
            dialog->reject();
        }
        QVERIFY2(fields.size() > 8, qPrintable(QString::number(fields.size())));
        for (const FieldPlace& place : fields) {
            auto* dialog = open();
            QVERIFY(dialog);
            auto& shown = *dialog->findChild<ParameterForm*>();
            (void)all_fields(shown); // unfolds
            const std::string was = tool_text(dialog->tool());
            auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            if (!change(
                    shown, place, [&] { return tool_text(dialog->tool()) != was && ok->isEnabled(); },
                    Qt::Key_Tab)) {
                fixed << place.key;
                dialog->reject();
                continue;
            }
            accept(dialog);
            const std::string after = text_now();
            if (steps() != step + 1 || after == before) wrong << place.key + QStringLiteral(": no step");
            action(w(), "undo")->trigger();
            if (text_now() != before) wrong << place.key + QStringLiteral(": not undone");
            action(w(), "redo")->trigger();
            if (text_now() != after) wrong << place.key + QStringLiteral(": not done again");
            w().document().undo_stack().setIndex(step);
        }
        compare(fixed, wrong, {});
    }
};

FACETMILL_TEST(TestWindowUndo)
#include "test_window_undo.moc"
