#include "core/mesh/sample.h"

#include "core/mesh/sample_surface.h"
#include "core/mesh/sample_tessellate.h"

#include <cmath>

namespace facetmill {

namespace {

/// Cells are about square, and several to a span of the section curves.
Mesh lu_sample(std::string_view name, double tolerance, const Progress& progress) {
    const LoftedSurface& s = lu_surface(name);
    const int along = 24;
    const auto middle = [&s](double v) { return s.point(0.5, v); };
    PatchGrid grid;
    grid.b = even_stations(middle, 0.0, 1.0, along);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < grid.b.size(); ++i)
        length += (middle(grid.b[i + 1]) - middle(grid.b[i])).norm();
    const double extent = s.sections().back().x - s.sections().front().x;
    const int across = std::max(4, int(std::lround(along * extent / length)));
    for (int i = 0; i <= across; ++i)
        grid.a.push_back(double(i) / across);
    return tessellate_patch([&s](double u, double v) { return s.point(u, v); }, grid, tolerance,
                            std::string(name), progress);
}

} // namespace

const std::vector<SampleKind>& sample_kinds() {
    static const std::vector<SampleKind> kinds{
        {"concave", "Concave surface", "Lu's first benchmark: a ruled valley of 10 × 10 in.",
         LengthUnit::inch},
        {"convex", "Convex surface", "Lu's second benchmark: a ruled ridge of 10 × 10 in.", LengthUnit::inch},
        {"complex", "Complex surface", "Lu's third benchmark: convex, concave and saddle regions, 9 × 11 in.",
         LengthUnit::inch},
    };
    return kinds;
}

std::shared_ptr<const Mesh> make_sample(std::string_view name, double chord_tolerance_mm,
                                        const Progress& progress) {
    std::string names;
    bool known = false;
    for (const SampleKind& k : sample_kinds()) {
        names += (names.empty() ? "" : ", ") + k.name;
        known = known || k.name == name;
    }
    if (!known)
        throw Error(ErrorCode::out_of_range, "sample", "unknown name '" + printable(name) + "'",
                    "use one of: " + names);
    if (!(chord_tolerance_mm > 0.0) || !std::isfinite(chord_tolerance_mm))
        throw Error(ErrorCode::out_of_range, std::string(name), "the chord tolerance is not above 0",
                    "give a positive length");
    return std::make_shared<const Mesh>(lu_sample(name, chord_tolerance_mm, progress));
}

} // namespace facetmill
