// The stock in the window: its kinds in the form, the mesh that is chosen for it, and what it looks like.
#include "tests/screenshot/window_support.h"
#include "ui/layer_bar.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/viewport.h"

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

namespace {

/// Chooses a word of a list as a user does.
void choose(ui::MainWindow& window, const char* key, const char* word) {
    auto* combo = window.properties().form()->findChild<QComboBox*>(QLatin1String(key));
    combo->setCurrentIndex(combo->findText(QLatin1String(word)));
    emit combo->activated(combo->currentIndex());
}

QString shown(ui::MainWindow& window, const char* key) {
    const auto* combo = window.properties().form()->findChild<QComboBox*>(QLatin1String(key));
    return combo ? combo->currentText() : QString();
}

QString stock_in_tree(ui::MainWindow& window) {
    const auto* tree = window.tree().findChild<QTreeWidget*>();
    return tree->topLevelItem(1)->text(0);
}

} // namespace

class TestWindowStock : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() {
        QVERIFY(show_window());
        QVERIFY(open_part());
        w().layers().set_shown(ui::ViewLayer::stock, true);
        w().tree().select({TreeNode::Kind::stock, 0});
    }
    void cleanup() { close_window(); }

    void a_round_stock() {
        const auto& stock = w().document().project().stock;
        auto* form = w().properties().form();
        QVERIFY(form->findChild<QComboBox*>(QStringLiteral("kind")));
        QVERIFY(!form->findChild<QWidget*>(QStringLiteral("diameter"))); // a box has none
        const Box3 box = w().viewport().scene().bounds();
        const QImage as_box = view_picture(w());
        choose(w(), "kind", "cylinder");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stock.kind == StockSpec::Kind::cylinder);
        QCOMPARE(shown(w(), "kind"), QStringLiteral("cylinder"));
        QCOMPARE(shown(w(), "diameter"), QStringLiteral("auto"));
        QCOMPARE(stock_in_tree(w()), QStringLiteral("Stock: cylinder"));
        const Box3 round = w().viewport().scene().bounds();
        QVERIFY(round.size().x() > box.size().x() && round.size().y() > box.size().y());
        QVERIFY(changed_pixels(as_box, view_picture(w())) > 500);
        shot(w(), QStringLiteral("stock-cylinder"));
        enter(w(), "diameter", QStringLiteral("0"));
        QVERIFY(!error_under(w(), "diameter").isEmpty());
        enter(w(), "diameter", QStringLiteral("1.5"));
        QVERIFY(error_under(w(), "diameter").isEmpty());
        QVERIFY(std::abs(stock.diameter.number - 38.1) < 1e-9);
        choose(w(), "axis", "x");
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stock.axis == StockSpec::Axis::x);
        shot(w(), QStringLiteral("stock-cylinder-lying"));
        // The part does not fit into that: planning says so.
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        QVERIFY(w().message_bar().message().isEmpty() || w().last_failure().isEmpty());
        for (int n = 0; n < 4; ++n)
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stock.kind == StockSpec::Kind::box);
        QCOMPARE(stock_in_tree(w()), QStringLiteral("Stock: box"));
    }

    /// Its size is told where it is selected, and can be typed as a whole.
    void size_or_margins() {
        const auto& stock = w().document().project().stock;
        const auto& dimensions = [this]() -> const std::array<std::string, 3>& {
            return w().viewport().scene().stock().dimensions();
        };
        const Vec3 part = w().document().part()->box.size();
        const double x = (part.x() + 2 * stock.margin[0]) / mm_per_inch;
        QVERIFY2(dimensions()[0] == format_number(x, 5) + "\u00a0in", dimensions()[0].c_str());
        QVERIFY(field(w(), "size0"));
        enter(w(), "size0", QString::number(part.x() / mm_per_inch + 1, 'g', 12));
        QVERIFY2(std::abs(stock.margin[0] - 12.7) < 1e-9, qPrintable(error_under(w(), "size")));
        action(w(), "undo")->trigger();
        w().layers().set_shown(ui::ViewLayer::stock, false);
        QVERIFY(wait_until_settled(w()));
        const QImage with = view_picture(w());
        shot(w(), QStringLiteral("stock-size"));
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(dimensions() == (std::array<std::string, 3>()));
        QVERIFY(changed_pixels(with, view_picture(w())) > 500);
        w().tree().select({TreeNode::Kind::stock, 0});
        auto* form = w().properties().form();
        const std::array<double, 3> size{part.x() + 20, part.y() + 30, part.z() + 7};
        emit form->edited("size", size);
        QVERIFY(std::abs(stock.margin[0] - 10) < 1e-9 && std::abs(stock.margin[1] - 15) < 1e-9);
        QVERIFY(std::abs(stock.margin[2] - 7) < 1e-9);
        emit form->edited("size", std::array<double, 3>{part.x() - 1, part.y(), part.z()});
        QVERIFY(error_under(w(), "size").contains(QStringLiteral("larger along X")));
        QVERIFY(std::abs(stock.margin[0] - 10) < 1e-9);
        action(w(), "undo")->trigger();
        QVERIFY(std::abs(stock.margin[0] - 10) > 1e-3);
    }

    void a_mesh_for_a_stock() {
        const QString folder = scratch_folder(QStringLiteral("stock"));
        const QString raw = write_block(folder + QStringLiteral("/raw.stl"), w().document().part()->box);
        const auto& stock = w().document().project().stock;
        // Nothing chosen: nothing changes.
        bool asked = false;
        answer_file_dialog(asked);
        choose(w(), "kind", "mesh");
        QVERIFY(asked);
        QVERIFY(stock.kind == StockSpec::Kind::box);
        QCOMPARE(shown(w(), "kind"), QStringLiteral("box"));
        QVERIFY(!w().document().undo_stack().canUndo());

        asked = false;
        answer_file_dialog(asked, raw);
        choose(w(), "kind", "mesh");
        QVERIFY(asked);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stock.kind == StockSpec::Kind::mesh);
        QCOMPARE(QString::fromStdString(w().document().project().stock_path().string()), raw);
        QCOMPARE(stock_in_tree(w()), QStringLiteral("Stock: raw.stl"));
        QVERIFY(w().document().part_is_current());
        const Box3 part = w().document().part()->box, all = w().viewport().scene().bounds();
        QVERIFY((all.size() - part.size() - Vec3::Constant(50.8)).norm() < 1e-3);
        QVERIFY(w().message_bar().message().isEmpty());
        auto* button = w().properties().findChild<QPushButton*>(QStringLiteral("choose_stock"));
        QVERIFY(button->isVisible());
        shot(w(), QStringLiteral("stock-mesh"));
        // Another one, by the button.
        const QString other = folder + QStringLiteral("/other.stl");
        QVERIFY(QFile::copy(raw, other));
        asked = false;
        answer_file_dialog(asked, other);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(asked);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(stock_in_tree(w()), QStringLiteral("Stock: other.stl"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(stock_in_tree(w()), QStringLiteral("Stock: raw.stl"));

        // It stays the same file when the project is saved beside it.
        const QString saved = folder + QStringLiteral("/p.facetmill");
        QVERIFY(w().files().save_to(saved));
        QCOMPARE(stock.file, std::string("raw.stl"));
        QVERIFY(w().document().part_is_current());
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(stock.kind == StockSpec::Kind::box);
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(QString::fromStdString(w().document().project().stock_path().string()), raw);
        enter(w(), "file", QString());
        QVERIFY(!error_under(w(), "file").isEmpty());
        QCOMPARE(stock.file, std::string("raw.stl"));
    }

    /// Without its stock a part is shown, and not planned.
    void a_bad_mesh_for_a_stock() {
        const QString folder = scratch_folder(QStringLiteral("open-stock"));
        const QString path = folder + QStringLiteral("/raw.stl");
        write_block(path, w().document().part()->box, true);
        w().files().set_stock_file(path);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("not closed")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(w().document().part_is_current());
        QVERIFY(!w().viewport().scene().has(Layer::stock));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().state(0) != ui::OperationState::planned);
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("not closed")),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("stock-open-mesh"));
        // The file mended, the window reads it by itself, and it is planned.
        write_block(path, w().document().part()->box);
        QTRY_VERIFY_WITH_TIMEOUT(w().document().has_stock(), patience_ms);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        QVERIFY(w().viewport().scene().has(Layer::stock));
    }
};

FACETMILL_TEST(TestWindowStock)
#include "test_window_stock.moc"
