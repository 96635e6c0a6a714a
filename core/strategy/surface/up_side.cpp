#include "core/strategy/surface/up_side.h"

#include "core/base/tolerances.h"

namespace facetmill {

UpSide::UpSide(const Mesh& mesh, const Progress& progress) {
    constexpr std::size_t check_every = 8192;
    // The area vectors of a closed surface whose windings agree sum up to nothing; its volume tells which
    // side is out.
    Vec3 sum = Vec3::Zero();
    double total = 0, volume = 0;
    const Vec3 origin = mesh.facets.empty() ? Vec3(Vec3::Zero()) : mesh.corner(0, 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % check_every == 0) progress.check();
        const Vec3 cross = mesh.facet_cross(f);
        sum += cross;
        total += cross.norm();
        volume += cross.dot(mesh.corner(f, 0) - origin);
    }
    if (sum.norm() <= tolerance::closed_sum * total) out_ = volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

} // namespace facetmill
