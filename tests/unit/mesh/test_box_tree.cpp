// The tree of boxes against all of the boxes.
#include "core/mesh/box_tree.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 random_place(Random& rng) {
    return Vec3(uniform(rng, 0, 10), uniform(rng, 0, 10), uniform(rng, 0, 10));
}

/// Some of them the same, some without a size.
std::vector<Box3> random_boxes(Random& rng, std::size_t count) {
    std::vector<Box3> boxes;
    while (boxes.size() < count) {
        Box3 box;
        box.add(random_place(rng));
        if (boxes.size() % 3 > 0) box.add(box.lo + 0.1 * random_place(rng));
        boxes.push_back(boxes.size() % 7 == 6 ? boxes[boxes.size() / 2] : box);
    }
    return boxes;
}

bool meet(const Box3& a, const Box3& b) {
    return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

} // namespace

class TestBoxTree : public QObject {
    Q_OBJECT
private slots:

    void finds_what_all_boxes_say() {
        Random rng(1);
        for (const std::size_t count : {1, 2, 7, 8, 9, 16, 17, 100, 1000}) {
            const std::vector<Box3> boxes = random_boxes(rng, count);
            const BoxTree tree(boxes, Progress());
            for (int trial = 0; trial < trials(60, 5); ++trial) {
                const Box3 asked = random_boxes(rng, 2)[1];
                const auto enter = [&](const Box3& box) { return meet(box, asked); };
                std::vector<std::size_t> found, wanted;
                tree.each(enter, [&](std::size_t item) { found.push_back(item); });
                for (std::size_t i = 0; i < count; ++i)
                    if (meet(boxes[i], asked)) wanted.push_back(i);
                std::size_t visits = 0;
                const bool all = tree.each_until(enter, [&](std::size_t) { return ++visits < 3; });
                QCOMPARE(all, wanted.size() < 3);
                QCOMPARE(visits, std::min<std::size_t>(wanted.size(), 3));
                std::sort(found.begin(), found.end());
                QCOMPARE(found, wanted);

                const Vec3 p = random_place(rng);
                double near2 = infinity, least = infinity;
                std::size_t asked_for = 0;
                tree.nearest(p, near2, [&](std::size_t item) {
                    ++asked_for;
                    near2 = std::min(near2, squared_distance(boxes[item], p));
                });
                for (const Box3& box : boxes)
                    least = std::min(least, squared_distance(box, p));
                QCOMPARE(near2, least);
                QVERIFY(asked_for <= std::max<std::size_t>(8, count / 10));
            }
        }
        QVERIFY(BoxTree(std::vector<Box3>(), Progress()).empty());
    }
};

FACETMILL_TEST(TestBoxTree)
#include "test_box_tree.moc"
