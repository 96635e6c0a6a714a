// The configuration space as a scene: a free point, a crowded one and an empty one, and what is under a
// pixel.
#include "tests/support/picture_compare.h"
#include "tests/support/test_runner.h"
#include "viz/cspace_labels.h"
#include "viz/offscreen.h"
#include "viz/overlay.h"
#include "viz/render_picture.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr std::array<int, 2> picture_size{900, 675};

/// Bottom and top in mm as functions of lead and yaw in degrees.
CSpaceContent content_of(const std::function<double(double, double)>& bottom,
                         const std::function<double(double, double)>& top,
                         const std::function<PostureBlock(double, double)>& cause) {
    CSpaceContent c;
    c.grid = PostureGrid::make(0, radians(45), radians(-45), radians(45), radians(3));
    for (const double lead : c.grid.lead)
        for (const double yaw : c.grid.yaw) {
            const double l = degrees(lead), o = degrees(yaw);
            c.bottom.push_back(bottom(l, o));
            c.top.push_back(top(l, o));
            const bool free = c.bottom.back() <= c.top.back();
            c.block.push_back(free                                                 ? PostureBlock::free
                              : c.top.back() < 0 && std::isfinite(c.bottom.back()) ? PostureBlock::lift
                                                                                   : cause(l, o));
            c.free_nodes += free;
        }
    return c;
}

/// Nothing in the way; the strip sets the top.
CSpaceContent free_point() {
    CSpaceContent c = content_of([](double, double) { return 0.0; },
                                 [](double l, double o) { return 0.5 - 0.008 * l - 0.0001 * o * o; },
                                 [](double, double) { return PostureBlock::local; });
    c.choices[0] = {true, {0, 0, 0}};
    c.choices[1] = {true, {radians(9), radians(12), 0.1}};
    c.choices[2] = c.choices[3] = {true, {radians(21), radians(-15), 0.2}};
    return c;
}

/// A wall on the left, a pillar ahead that the holder meets, and the machine's limit behind.
CSpaceContent crowded_point() {
    CSpaceContent c = content_of(
        [](double l, double o) {
            if (l > 40) return infinity; // the cutter cannot touch
            return std::max({0.0, 0.03 * (o - 6), 0.05 * (12 - l), l > 27 ? 0.2 * (l - 27) : 0.0});
        },
        [](double l, double) { return l > 40 ? -infinity : 0.6 - 0.01 * l; },
        [](double l, double o) {
            return l > 40      ? PostureBlock::shank
                   : l > 27    ? PostureBlock::holder
                   : o > 6 + 4 ? PostureBlock::global
                               : PostureBlock::local;
        });
    for (std::size_t il = 0; il < c.grid.lead.size(); ++il)
        for (std::size_t io = 0; io < c.grid.yaw.size(); ++io)
            if (const std::size_t n = c.grid.node(il, io);
                degrees(c.grid.yaw[io]) < -31 && c.block[n] == PostureBlock::free) {
                c.block[n] = PostureBlock::machine;
                --c.free_nodes;
            }
    c.choices[0] = {true, {radians(12), 0, 0.1}};
    c.choices[1] = c.choices[2] = c.choices[3] = {true, {radians(18), radians(-6), 0.05}};
    return c;
}

CSpaceContent empty_point() {
    return content_of([](double l, double o) { return 1.5 + 0.02 * l + 0.01 * std::abs(o); },
                      [](double l, double) { return 0.4 - 0.012 * l; },
                      [](double l, double) { return l < 20 ? PostureBlock::global : PostureBlock::holder; });
}

CSpaceRequest request_of(CSpaceContent content, const char* subtitle) {
    CSpaceRequest r;
    r.content = std::move(content);
    r.title = "Finish5 \u00b7 point 12";
    r.subtitle = subtitle;
    r.width = picture_size[0];
    r.height = picture_size[1];
    return r;
}

bool names(const std::vector<LegendEntry>& legend, const std::string& label) {
    return std::any_of(legend.begin(), legend.end(), [&](const LegendEntry& e) { return e.label == label; });
}

} // namespace

class TestCSpaceScene : public QObject {
    Q_OBJECT

    void check(const Picture& picture, const char* name) {
        const std::string wrong = check_picture(picture, name, FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }

    /// How many numbers there are.
    int whole_notes(const CSpaceScene& scene, double width, double height) {
        struct Box {
            double x0, y0, x1, y1;
            std::string text;
            bool name; ///< of an axis or a marker
        };
        std::vector<Box> boxes;
        int numbers = 0;
        for (const OverlayNote& n : scene.notes()) {
            const double w = 6.2 * double(n.text.size()); // about what its letters take
            const double x = n.at.x() - (n.end < 0 ? 0 : n.end > 0 ? w : w / 2);
            boxes.push_back({x, n.at.y() - 5, x + w, n.at.y() + 5, n.text, n.bold});
            const bool of_axis = n.bold && !n.framed && n.end == 0 && n.text != "No posture is free here";
            if (of_axis && width > 350 && !(boxes.back().x0 > 0 && boxes.back().x1 < width))
                QTest::qFail(("cut by the border: " + n.text).c_str(), __FILE__, __LINE__);
            if (n.bold) continue;
            ++numbers;
            const Box& b = boxes.back();
            if (!(b.x0 > 0 && b.x1 < width && b.y0 > 0 && b.y1 < height))
                QTest::qFail(("cut by the border: " + n.text).c_str(), __FILE__, __LINE__);
        }
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Box &a = boxes[i], &b = boxes[j];
                if (a.name && b.name) continue; // those of markers that lie together, without room
                if (a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1)
                    QTest::qFail((a.text + " lies on " + b.text).c_str(), __FILE__, __LINE__);
            }
        return numbers;
    }

private slots:
    void a_free_point() { check(render_cspace(request_of(free_point(), "all around free")), "cspace-free"); }

    void a_crowded_point() {
        check(render_cspace(request_of(crowded_point(), "between walls")), "cspace-crowded");
        CSpaceRequest inch = request_of(crowded_point(), "between walls, in inches");
        inch.unit = LengthUnit::inch;
        inch.palette = Palette::dark;
        inch.width = 420;
        inch.height = 360;
        check(render_cspace(inch), "cspace-crowded-small");
    }

    void an_empty_point() {
        QCOMPARE(empty_point().free_nodes, std::size_t(0));
        check(render_cspace(request_of(empty_point(), "nothing free")), "cspace-empty");
    }

    void the_box_is_as_high_as_what_is_free() {
        for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
            const CSpaceDisplay display(free_point(), unit);
            QVERIFY(display.delta_max > 0.5 && display.delta_max < 1.1);
            QCOMPARE(display.delta_ticks.front(), 0.0);
            QVERIFY(std::abs(display.delta_ticks.back() - display.delta_max) < 1e-9);
            QVERIFY(display.delta_ticks.size() >= 3 && display.delta_ticks.size() <= 9);
            QVERIFY(std::abs(display.size.x() - 0.5) < 1e-12 && std::abs(display.size.y() - 1) < 1e-12);
        }
        QVERIFY(CSpaceDisplay(empty_point(), LengthUnit::mm).delta_max >= 0.4);
    }

    void surfaces_stay_in_the_box() {
        for (const CSpaceContent& c : {free_point(), crowded_point(), empty_point()}) {
            const CSpaceDisplay display(c, LengthUnit::mm);
            for (const CSpaceTriangles* t : {&display.bottom, &display.volume})
                for (std::size_t i = 0; i < t->points.size(); ++i) {
                    const double v = double(t->points[i]);
                    QVERIFY(std::isfinite(v));
                    if (i % 3 == 2) QVERIFY(v >= -1e-6 && v <= CSpaceDisplay::height + 1e-6);
                }
        }
    }

    void the_free_volume_is_where_it_is_free() {
        // The sides and the lid of the volume, seen from above, cover what is free and nothing else.
        const CSpaceContent c = crowded_point();
        const CSpaceDisplay display(c, LengthUnit::mm);
        double lid = 0;
        for (std::size_t t = 0; t < display.volume.size(); ++t) {
            if (display.volume.colors[4 * t + 3] < 60) continue; // the top where it is not free
            const float* p = &display.volume.points[9 * t];
            lid += std::abs(double((p[3] - p[0]) * (p[7] - p[1]) - (p[6] - p[0]) * (p[4] - p[1]))) / 2;
        }
        // Of cells: all four corners free at least, one of them at most.
        double least = 0, most = 0;
        const std::size_t nl = c.grid.lead.size(), no = c.grid.yaw.size();
        const double cell = display.size.x() / double(nl - 1) * display.size.y() / double(no - 1);
        for (std::size_t i = 0; i + 1 < nl; ++i)
            for (std::size_t j = 0; j + 1 < no; ++j) {
                int free = 0;
                for (const std::size_t n : {c.grid.node(i, j), c.grid.node(i + 1, j), c.grid.node(i, j + 1),
                                            c.grid.node(i + 1, j + 1)})
                    free += c.block[n] == PostureBlock::free;
                least += free == 4 ? cell : 0;
                most += free > 0 ? cell : 0;
            }
        QVERIFY(least > 0.05);
        QVERIFY2(lid >= least - 1e-6 && lid <= most + 1e-6,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(least).arg(lid).arg(most)));
    }

    void places_and_values_are_inverse() {
        const CSpaceDisplay display(crowded_point(), LengthUnit::mm);
        for (const double l : {0.0, 13.0, 45.0})
            for (const double o : {-45.0, 2.5, 45.0}) {
                const PostureValue p{radians(l), radians(o), 0.3 * display.delta_max};
                const PostureValue q = display.value(display.place(p));
                QVERIFY(std::abs(p.lead - q.lead) < 1e-12 && std::abs(p.yaw - q.yaw) < 1e-12
                        && std::abs(p.delta - q.delta) < 1e-12);
            }
    }

    void what_is_under_a_pixel() {
        CSpaceScene scene;
        OffscreenWindow window;
        scene.set_content(std::make_shared<const CSpaceContent>(crowded_point()));
        window.show(scene, picture_size[0], picture_size[1]);
        scene.reset_view();
        window.render();
        // A marker is where its posture is drawn.
        const PostureValue cm2 = scene.content()->choices[0].posture;
        const Vec2 at = scene.display_of(cm2);
        QVERIFY(at.x() > 0 && at.x() < 2 * picture_size[0] && at.y() > 0 && at.y() < 2 * picture_size[1]);
        const auto marker = scene.marker_at(at.x() + 2, at.y() - 2, 12);
        QVERIFY(marker && *marker == 0);
        QVERIFY(!scene.marker_at(5, 5, 12));
        QVERIFY(!scene.hit(3, 2.0 * picture_size[1] - 3));
        // A hit lies on the line of sight.
        int hits = 0;
        for (double y = 20; y < 2 * picture_size[1]; y += 97)
            for (double x = 20; x < 2 * picture_size[0]; x += 83)
                if (const auto hit = scene.hit(x, y); hit && hit->on != CSpaceDisplay::Hit::On::map) {
                    QVERIFY((scene.display_of(hit->posture) - Vec2(x, y)).norm() < 1e-3);
                    ++hits;
                }
        QVERIFY(hits > 10);
    }

    /// Numbers of the axes are read whole: they lie in the picture, and no name of a marker covers one.
    void no_number_of_an_axis_is_cut() {
        OffscreenWindow window;
        CSpaceScene scene;
        int numbers = 0;
        for (const CSpaceContent& content : {free_point(), crowded_point(), empty_point()}) {
            scene.set_content(std::make_shared<const CSpaceContent>(content));
            for (const auto& [width, height] : {std::pair(300, 140), {200, 150}, {372, 540}, {620, 300}}) {
                window.show(scene, width, height);
                scene.reset_view();
                for (int turn = 0; turn < 8; ++turn) {
                    window.render();
                    scene.turn(pi / 4, turn % 2 ? 0.1 : -0.1);
                    scene.fit();
                    window.render();
                    numbers += whole_notes(scene, width, height);
                    if (QTest::currentTestFailed()) return;
                }
            }
        }
        QVERIFY(numbers > 500);
    }

    /// In a low picture they would hide the axes: the legend has them, merged as the markers are.
    void a_low_picture_leaves_names_to_the_legend() {
        OffscreenWindow window;
        CSpaceScene scene;
        scene.set_content(std::make_shared<const CSpaceContent>(crowded_point()));
        const auto framed = [&] {
            const auto notes = scene.notes();
            return std::count_if(notes.begin(), notes.end(), [](const OverlayNote& n) { return n.framed; });
        };
        const auto legend = scene.legend();
        const auto chosen = std::count_if(legend.begin(), legend.end(), [](const LegendEntry& e) {
            return e.sample == LegendEntry::Sample::spot && e.label.rfind("Chosen: ", 0) == 0;
        });
        QVERIFY(chosen > 1);
        for (const int height : {300, 150}) {
            window.show(scene, 300, height);
            scene.reset_view();
            window.render();
            QCOMPARE(framed(), height < CSpaceScene::min_height_of_names ? 0 : chosen);
        }
    }

    void names_of_markers_keep_off_numbers() {
        OverlayContent content;
        content.width = 300;
        content.height = 140;
        content.notes = {{{120, 50}, 0, "-15", false, false}, {{120, 90}, 0, "-30", false, false}};
        const auto width = [](const std::string& name) { return 8.0 * double(name.size()); };
        add_markers(content, {{{100, 50}, Rgb(), "local"}}, width);
        QCOMPARE(content.notes.size(), std::size_t(3)); // beside it, below it or above it
        // Where there is room nowhere else a number goes.
        content.notes = {{{20, 50}, 0, "-15", false, false}, {{20, 90}, 0, "-30", false, false}};
        content.spots.clear();
        content.width = 60;
        add_markers(content, {{{16, 50}, Rgb(), "loc"}}, width);
        QCOMPARE(content.notes.size(), std::size_t(3));
        leave_out_covered(content, width);
        QCOMPARE(content.notes.size(), std::size_t(2));
        QCOMPARE(content.notes.front().text, std::string("-30"));
    }

    void the_legend_names_what_is_there() {
        CSpaceScene scene;
        QVERIFY(scene.legend().empty());
        scene.set_content(std::make_shared<const CSpaceContent>(crowded_point()));
        const auto legend = scene.legend();
        for (const PostureBlock b : {PostureBlock::free, PostureBlock::local, PostureBlock::global,
                                     PostureBlock::shank, PostureBlock::holder, PostureBlock::machine})
            QVERIFY2(names(legend, posture_block_label(b)), posture_block_label(b));
        scene.set_content(std::make_shared<const CSpaceContent>(empty_point()));
        QVERIFY(!names(scene.legend(), posture_block_label(PostureBlock::free)));
        QVERIFY(!names(scene.legend(), "Free volume"));
        scene.set_content(nullptr);
        QVERIFY(scene.legend().empty());
    }

    void grids_of_one_node() {
        CSpaceContent c;
        c.grid = PostureGrid::make(radians(10), radians(10), 0, 0, radians(3));
        c.bottom = {0};
        c.top = {infinity};
        c.block = {PostureBlock::free};
        c.free_nodes = 1;
        const CSpaceDisplay display(c, LengthUnit::mm);
        QVERIFY(display.bottom.size() > 0 && display.volume.size() > 0);
        QVERIFY(display.place({radians(10), 0, 0}).allFinite());
        c.top = {-infinity};
        c.bottom = {infinity};
        c.block = {PostureBlock::shank};
        c.free_nodes = 0;
        const CSpaceDisplay nothing(c, LengthUnit::inch);
        QCOMPARE(nothing.bottom.size(), std::size_t(0));
        QVERIFY(nothing.map.size() > 0);
    }
};

FACETMILL_TEST(TestCSpaceScene)
#include "test_cspace_scene.moc"
