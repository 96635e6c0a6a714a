// What comes off a stock, and when: blocks that are cut through in known places.
#include "core/verify/loose_pieces.h"
#include "core/verify/playback.h"
#include "core/verify/verify.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// 60 x 40 x 10 mm, on z = 0, about the origin.
StockSolid plate() {
    StockSolid stock;
    stock.box = Box3();
    stock.box.add(Vec3(-30, -20, 0));
    stock.box.add(Vec3(30, 20, 10));
    return stock;
}

Tool flat(double diameter) {
    Tool tool;
    tool.diameter = tool.shank_diameter = diameter;
    tool.corner_radius = 0;
    tool.flute_length = 30;
    return tool;
}

/// At feed from place to place, from above the first.
VerifyProgram route(const std::vector<Vec3>& places, double diameter = 4) {
    auto motions = std::make_shared<ToolMotions>();
    const auto to = [&](MotionKind kind, const Vec3& tip) {
        motions->motions.push_back({kind, {tip, Vec3::UnitZ()}, no_index, no_index});
    };
    to(MotionKind::rapid, Vec3(places[0].x(), places[0].y(), 40));
    for (const Vec3& p : places)
        to(MotionKind::cut, p);
    return {"Round", VerifyTool(flat(diameter)), motions, std::nullopt};
}

/// The part: 20 x 12 x 8 mm in the middle of the plate.
Mesh part() {
    return box(Vec3(-10, -6, 0), Vec3(10, 6, 8));
}

std::optional<LoosePieces> loose(const std::vector<VerifyProgram>& programs, double resolution = 0.2) {
    VerifySettings settings;
    settings.resolution = resolution;
    return loose_pieces(part(), *stock_after(plate(), programs, settings, Progress()), programs, Progress());
}

} // namespace

class TestLoosePieces : public QObject {
    Q_OBJECT

private slots:
    /// A groove all round, down to the table: the last of its four sides sets the part free.
    void a_groove_all_round_sets_the_part_free() {
        const std::vector<Vec3> corners{
            {-14, -10, -1}, {14, -10, -1}, {14, 10, -1}, {-14, 10, -1}, {-14, -10, -1}};
        const auto found = loose({route(corners)});
        QVERIFY(found);
        // By rays of its own where the stock's are few, or a great many: the same.
        for (const double resolution : {3.0, 0.1}) {
            const auto other = loose({route(corners)}, resolution);
            QVERIFY(other && other->part_is_free && other->at.motion == found->at.motion);
        }
        QVERIFY(found->part_is_free);
        QCOMPARE(found->count, std::size_t(1));
        QCOMPARE(found->at.program, std::size_t(0));
        // The rapid above, down to the first corner, then four sides.
        QCOMPARE(found->at.motion, std::size_t(5));
        // The frame: all of the plate but what lies within the groove's outer side, whose corners are round.
        const double frame = (60 * 40 - 32 * 24 + (4 - pi) * 4) * 10;
        QVERIFY2(std::abs(found->largest.volume - frame) < 0.02 * frame,
                 qPrintable(QString::number(found->largest.volume)));
        // Of two programs the second.
        const auto second =
            loose({route({corners[0], corners[1], corners[2]}), route({corners[2], corners[3], corners[0]})});
        QVERIFY(second && second->at.program == 1 && second->at.motion == 3);
    }

    /// Whatever thin is left holds: a film of the bottom, a wall across the groove, a bridge in its bottom.
    void a_little_holds() {
        const std::vector<Vec3> film{
            {-14, -10, 0.05}, {14, -10, 0.05}, {14, 10, 0.05}, {-14, 10, 0.05}, {-14, -10, 0.05}};
        QVERIFY(!loose({route(film)}));
        const std::vector<Vec3> wall{
            {-14, -10, -1}, {14, -10, -1}, {14, 10, -1}, {-14, 10, -1}, {-14, -5.9, -1}};
        QVERIFY(!loose(
            {route(wall)})); // 0.1 mm of the last side, at x = -14 between the two rounds of the cutter
        const std::vector<Vec3> bridge{{-14, -10, -1}, {14, -10, -1}, {14, 10, -1},
                                       {-14, 10, -1},  {-14, 5, -1},  {-14, 5, 3},
                                       {-14, -3, 3},   {-14, -3, -1}, {-14, -10, -1}};
        QVERIFY(!loose({route(bridge)}));
    }

    void chips_are_no_frame() {
        // A corner of 4 x 4 mm comes off.
        const auto found = loose({route({{-24, -25, -1}, {-24, -14, -1}, {-35, -14, -1}})});
        QVERIFY(found && !found->part_is_free);
        QCOMPARE(found->at.motion, std::size_t(3));
        QVERIFY2(std::abs(found->largest.volume - 160) < 16,
                 qPrintable(QString::number(found->largest.volume)));
    }

    void a_block_that_is_only_carved_is_one() {
        QVERIFY(!loose({route({{-14, -10, 8}, {14, -10, 8}, {14, 10, 8}})}));
    }

    /// Pieces by rays against squares that are filled one by one from a picture of the plate.
    void pieces_are_those_of_a_picture() {
        std::vector<VerifyProgram> programs{route({{-35, -7, -1}, {35, -7, -1}}),
                                            route({{-7, -25, -1}, {-7, 25, -1}}),
                                            route({{9, -25, -1}, {9, 1, -1}})};
        StockPlayback playback(plate(), programs, 0.5, Progress());
        playback.go_to(double(playback.motion_count()), Progress());
        const StockPieces pieces(playback.stock(), Progress());
        // The cross makes four; the short slot divides the lower right one: five.
        QCOMPARE(pieces.pieces().size(), std::size_t(5));
        const double volumes[] = {35. * 25 * 10, 21. * 25 * 10, 21. * 11 * 10, 19. * 11 * 10, 12. * 11 * 10};
        for (std::size_t i = 0; i < 5; ++i)
            QVERIFY2(
                std::abs(pieces.pieces()[i].volume - volumes[i]) < 0.06 * volumes[i],
                qPrintable(QString("%1: %2 of %3").arg(i).arg(pieces.pieces()[i].volume).arg(volumes[i])));
        QVERIFY(pieces.at(Vec3(10, 10, 5)) == std::size_t(0));
        QVERIFY(pieces.at(Vec3(-20, 10, 5)) == std::size_t(1));
        QVERIFY(!pieces.at(Vec3(-7, 10, 5)) && !pieces.at(Vec3(100, 0, 5)));
    }

    /// It stands among the remarks of the verdict, which it does not change.
    void the_verdict_tells_it() {
        const std::vector<Vec3> corners{
            {-14, -10, -1}, {14, -10, -1}, {14, 10, -1}, {-14, 10, -1}, {-14, -10, -1}};
        VerifySettings settings;
        settings.resolution = settings.sample_spacing = 0.5;
        settings.gouge_limit = 0.01;
        settings.look_for_pieces = true;
        const VerifyProgram programs[] = {route(corners)};
        const Verification v = verify(part(), plate(), programs, settings, Progress());
        QVERIFY(v.loose && v.collisions.empty());
        QVERIFY(std::any_of(v.remarks.begin(), v.remarks.end(), [](const std::string& r) {
            return r.starts_with("The part is cut free at GOTO 6 of 'Round'");
        }));
    }
};

FACETMILL_TEST(TestLoosePieces)
#include "test_loose_pieces.moc"
