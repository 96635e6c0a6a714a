// What painting facets takes on a part of a million: neighbours once, then the searches of a stroke.
// Processor time; asserts nothing.
//
//     bench_paint [FACETS]
#include "core/mesh/facet_paint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace facetmill;

namespace {

/// A wavy sheet, 200 mm square.
MeshPtr wavy_sheet(std::size_t facets) {
    auto mesh = std::make_shared<Mesh>();
    const auto n = Index(std::sqrt(double(facets) / 2)) + 1;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const double x = 200.0 * i / (n - 1), y = 200.0 * j / (n - 1);
            mesh->vertices.emplace_back(x, y, 12 * std::sin(x / 18) * std::cos(y / 23));
        }
    for (Index j = 0; j + 1 < n; ++j)
        for (Index i = 0; i + 1 < n; ++i) {
            const Index a = j * n + i;
            mesh->facets.push_back({a, a + 1, a + n + 1});
            mesh->facets.push_back({a, a + n + 1, a + n});
        }
    return mesh;
}

/// The least of five, ms.
template <class Work>
void row(const char* what, Work&& work) {
    double least = infinity;
    std::size_t found = 0;
    for (int n = 0; n < 5; ++n) {
        const std::clock_t start = std::clock();
        found = work();
        least = std::min(least, 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::printf("%-36s %9.2f ms  %8zu facets\n", what, least, found);
}

} // namespace

int main(int argc, char** argv) {
    const MeshPtr mesh = wavy_sheet(argc > 1 ? std::size_t(std::atoll(argv[1])) : 1'000'000);
    std::printf("%zu facets\n", mesh->facet_count());
    row("neighbours", [&] { return FacetPainter(mesh, {}).mesh()->facet_count(); });
    FacetPainter painter(mesh, {});
    const auto from = Index(mesh->facet_count() / 2);
    const Vec3 at = mesh->corner(from, 0);
    for (const double radius : {0.5, 2.0, 5.0, 20.0}) {
        char what[40];
        std::snprintf(what, sizeof what, "brush of %g mm", radius);
        row(what, [&] { return painter.brush(from, at, radius).size(); });
    }
    row("flood by 10 degrees", [&] { return painter.flood(from, radians(10)).size(); });
    std::vector<char> marks(mesh->facet_count(), 0);
    for (const Index f : painter.brush(from, at, 20))
        marks[f] = 1;
    row("one ring more", [&] { return ring_round(*mesh, marks, true, 0, {}).size(); });
    row("5 mm more", [&] { return ring_round(*mesh, marks, true, 5, {}).size(); });
    row("5 mm less", [&] { return ring_round(*mesh, marks, false, 5, {}).size(); });
    return 0;
}
