// Roughing in the window: layers that follow the form, the path of one layer, the stock afterwards.
#include "core/job/planner.h"
#include "tests/screenshot/window_support.h"
#include "ui/elided_label.h"
#include "ui/layer_bar.h"
#include "ui/project_tree.h"
#include "ui/rough_bar.h"
#include "ui/rough_controller.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QSlider>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowRough : public QObject, public WindowFixture {
    Q_OBJECT

    RoughController& controller() { return w().roughing(); }
    QSlider* slider() { return controller().bar()->slider(); }
    QString readout() { return controller().bar()->readout()->text(); }
    /// The default operation, and roughing, which stands before it, selected.
    bool add_rough() {
        if (!w().document().has_part() && !open_part()) return false;
        w().document().add_operation("rough");
        w().tree().select({TreeNode::Kind::operation, 0});
        return wait_until_settled(w());
    }
    bool plan_all() {
        w().document().change(QStringLiteral("coarse"), [](Project& p) {
            p.operations[1]->common().tolerance = 0.5; // mm
        });
        w().plan();
        if (!wait_until_settled(w())) return false;
        w().tree().select({TreeNode::Kind::operation, 0});
        return wait_until_settled(w()) && w().last_failure().isEmpty();
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void layers_follow_the_form() {
        QVERIFY(open_part());
        QVERIFY(!controller().bar()->isVisible());
        QVERIFY(add_rough());
        QVERIFY(controller().bar()->isVisible());
        QVERIFY2(readout().startsWith(QStringLiteral("Preview")), qPrintable(readout()));
        const std::size_t before = controller().heights().size();
        QVERIFY(before > 0);
        const QImage many = view_picture(w());
        enter(w(), "depth", QStringLiteral("0.4")); // twice what it began with
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(controller().heights().size() < before, qPrintable(readout()));
        QVERIFY(changed_pixels(many, view_picture(w())) > 300);
        // Every layer is at most that deep, and a layer can be looked for before there is a path.
        for (std::size_t i = 1; i < controller().heights().size(); ++i)
            QVERIFY(controller().heights()[i - 1] - controller().heights()[i] <= 0.4 * 25.4 + 1e-9);
        slider()->setValue(2);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(readout().contains(QStringLiteral("Layer 2 of")) && readout().contains("preview"),
                 qPrintable(readout()));
        shot(w(), QStringLiteral("rough-preview"));
        // What cannot be is said where the layers would be.
        enter(w(), "depth", QStringLiteral("9"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(readout().contains(QStringLiteral("flutes")), qPrintable(readout()));
        QVERIFY(controller().heights().empty() && !slider()->isEnabled());
        enter(w(), "depth", QStringLiteral("0.1"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!controller().heights().empty());
        w().tree().select({TreeNode::Kind::operation, 1});
        QVERIFY(!controller().bar()->isVisible());
    }

    void one_layer_alone() {
        QVERIFY(add_rough());
        enter(w(), "depth", QStringLiteral("0.1"));
        QVERIFY2(plan_all(), qPrintable(w().last_failure()));
        const auto& path = w().document().result(0)->path;
        QCOMPARE(controller().heights(), path.as<RoughPath>()->layers);
        QCOMPARE(slider()->maximum(), int(path.as<RoughPath>()->layers.size()));
        QVERIFY(path.as<RoughPath>()->layers.size() > 2);
        QVERIFY2(!readout().contains(QStringLiteral("Preview")), qPrintable(readout()));
        w().layers().set_shown(ViewLayer::part, false);
        emit w().layers().toggled();
        w().layers().set_shown(ViewLayer::others, true);
        QVERIFY(wait_until_settled(w()));
        const QImage all = view_picture(w());
        slider()->setValue(1);
        QVERIFY(wait_until_settled(w()));
        const QImage first = view_picture(w());
        QVERIFY(changed_pixels(all, first) > 1000);
        slider()->setValue(slider()->maximum());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(first, view_picture(w())) > 500);
        shot(w(), QStringLiteral("rough-layer"));
        QVERIFY(std::abs(w().viewport().scene().tool().pose()->tip.z() - path.as<RoughPath>()->layers.back())
                < 1e-9);
        slider()->setValue(0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(all, view_picture(w())) < 200);
        // Beside a layer alone nothing of the other operation is seen or picked.
        slider()->setValue(1);
        QVERIFY(wait_until_settled(w()));
        w().viewport().fit();
        const QImage alone = view_picture(w());
        const auto picked = [&] {
            int sources = 0;
            Scene& scene = w().viewport().scene();
            for (const Motion& m : w().document().result(1)->program.motions.motions) {
                const Vec2 at = scene.camera().display_of(m.to.tip);
                if (const auto pick = scene.paths().pick(at.x(), at.y(), 1)) sources |= 1 << pick->source;
            }
            return sources;
        };
        QVERIFY(!(picked() & 2));
        slider()->setValue(0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(picked() & 2);
        // Nor beside the chosen operation, unless others are wanted.
        w().layers().set_shown(ViewLayer::others, false);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(picked(), 1);
        w().tree().select({TreeNode::Kind::operation, 1});
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(picked(), 2);
        const auto& motions = w().document().result(1)->program.motions.motions;
        const auto cut = std::find_if(motions.begin(), motions.end(),
                                      [](const Motion& m) { return m.kind == MotionKind::cut; });
        QCOMPARE(w().viewport().scene().tool().pose()->tip, cut->to.tip);
        w().tree().select({TreeNode::Kind::part, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(picked() & 2);
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        w().document().remove_operation(1);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        slider()->setValue(1);
        QVERIFY(wait_until_settled(w()));
        w().viewport().fit();
        QTRY_VERIFY_WITH_TIMEOUT(changed_pixels(alone, view_picture(w())) < 20, patience_ms);
        // Elsewhere the whole path is there again.
        slider()->setValue(1);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::part, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(first, view_picture(w())) > 500);
        QCOMPARE(controller().layer_of(w().document().operation_id(0)), -1);
    }

    void who_asks_for_the_stock_waits_for_those_before() {
        Project p;
        for (const char* kind : {"rough", "finish5", "finish3"})
            p.operations.push_back(make_operation(kind));
        const std::string all = Document::fingerprint(p, 2);
        p.operations[0]->common().allowance = 1;
        QVERIFY(Document::fingerprint(p, 2) != all); // shank and holder keep out of what stands
        p.operations[2]->set("rest_only", true);
        const std::string rest = Document::fingerprint(p, 2);
        p.operations[1]->common().tolerance = 0.5;
        QCOMPARE(Document::fingerprint(p, 2), rest); // nobody counts on what 5-axis finishing takes
        p.operations[0]->common().allowance = 2;
        QVERIFY(Document::fingerprint(p, 2) != rest);
    }

    void the_stock_after_it() {
        QVERIFY(add_rough());
        enter(w(), "depth", QStringLiteral("0.1"));
        QVERIFY(!w().tree().item({TreeNode::Kind::stock_after, 0}));
        QVERIFY2(plan_all(), qPrintable(w().last_failure()));
        auto* after = w().tree().item({TreeNode::Kind::stock_after, 0});
        QVERIFY(after);
        QCOMPARE(after->parent(), w().tree().item({TreeNode::Kind::operation, 0}));
        w().tree().select({TreeNode::Kind::stock_after, 0});
        QVERIFY(wait_until_settled(w()));
        PlaybackController& playback = w().verification().playback();
        const std::size_t motions = w().document().result(0)->program.motions.motions.size();
        QCOMPARE(playback.position(), double(motions));
        QVERIFY(!playback.stock().empty());
        QVERIFY(w().layers().shown(ViewLayer::stock));
        const QImage rough = view_picture(w());
        shot(w(), QStringLiteral("rough-stock-after"));
        w().tree().select({TreeNode::Kind::stock_after, 1});
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(playback.position(), double(playback.track().motion_count()));
        QVERIFY(changed_pixels(rough, view_picture(w())) > 1000);
        // Gone with the plan.
        w().document().change(QStringLiteral("depth"),
                              [](Project& p) { p.operations[0]->common().allowance = 1; });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().tree().item({TreeNode::Kind::stock_after, 0}));
    }
};

FACETMILL_TEST(TestWindowRough)
#include "test_window_rough.moc"
