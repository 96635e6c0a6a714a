// Lu's three benchmark surfaces: the poles of Appendix A as published, in inches.
#include "core/mesh/sample_surface.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/mesh/sample_parts.h"
#include "core/mesh/sample_tessellate.h"

#include <cmath>

namespace facetmill {

namespace {

struct SectionPoles {
    double x;
    std::vector<Vec2> poles; ///< (y, z)
};

std::vector<SectionPoles> concave_poles() {
    return {
        {0.0,
         {{-5.31285703876, 2.12375344346},
          {-4.78535414379, 1.9064611891},
          {-3.80191222906, 1.51159819394},
          {-2.0857796089, 1.19894959495},
          {-0.89487840783, 0.45060791096},
          {0.50415108187, 0.48375602458},
          {1.66808289465, 0.82895078376},
          {3.38334878251, 0.11726632576},
          {4.83002830859, 1.08557556228},
          {5.26003777973, 1.58919644164},
          {5.32325478899, 2.01809670345}}},
        {10.0,
         {{-4.62864577498, 1.08819913378},
          {-4.19939037727, 0.92959273666},
          {-3.27768154476, 0.61857372322},
          {-2.21778311551, -0.12902186244},
          {-0.52178263366, -0.08723116013},
          {0.81300482478, -0.3117214236},
          {2.40149245577, -0.29406723564},
          {3.35965360789, -0.134085048},
          {3.8472741381, -0.01058633345}}},
    };
}

std::vector<SectionPoles> convex_poles() {
    return {
        {0.0,
         {{-5.41253707665, 0.66931884577},
          {-4.66999839947, 0.85095927803},
          {-3.37812452597, 1.13458559497},
          {-2.05635851355, 1.40085249865},
          {-0.7113740875, 1.46125334161},
          {0.786193207, 1.44891527757},
          {2.53682697608, 1.16640726706},
          {4.22840002199, 0.77585007737},
          {5.20720866556, 0.51314611426}}},
        {10.0,
         {{-4.79796934492, 0.3894087029},
          {-4.26415509035, 0.55815957213},
          {-3.17383443511, 0.9112620964},
          {-1.79596436598, 1.44257759491},
          {0.14571281761, 2.0648327382},
          {1.845323037, 1.78653258887},
          {2.92687188765, 0.7476796591},
          {3.62911822007, 0.34843638503},
          {3.90244845487, 0.19199241571}}},
    };
}

std::vector<SectionPoles> complex_poles() {
    return {
        {0.0,
         {{-4.83452923734, 0.83117426975},
          {-4.23359412867, 1.22852571944},
          {-3.17572336319, 1.63254247132},
          {-0.9490510132, 1.46408074758},
          {-0.55878264161, 0.38887242279},
          {1.88282986778, 0.93340485851},
          {2.68592925279, 1.34201837238},
          {4.21725080203, 1.3288709321},
          {5.47757285099, 0.93515361287},
          {6.21390834899, 0.63441403312}}},
        {3.0,
         {{-4.90234051572, 1.92682808671},
          {-4.31868302157, 1.46328658447},
          {-3.29601199362, 0.94499320514},
          {-1.62130604026, 0.5674302786},
          {-0.06810139837, 1.59908032762},
          {1.53984681152, 0.37286896354},
          {3.88950280147, 0.07234185862},
          {5.38694414337, 0.84131249677},
          {6.25167971058, 1.70120947278}}},
        {6.0,
         {{-4.84125201982, 1.09443077247},
          {-4.4369631971, 1.3071328367},
          {-3.62745102168, 1.57886959732},
          {-2.31465871192, 1.82575599182},
          {-1.17487972906, 1.1483803841},
          {0.20455008416, 0.09112469148},
          {1.9681195181, 1.06366475449},
          {4.01891138412, 1.10082739513},
          {5.33380956787, 1.04158492551},
          {6.14637447872, 0.90265495062}}},
        {9.0,
         {{-4.9187204271, 1.66788109113},
          {-4.50806485641, 1.31978766736},
          {-3.69569968219, 0.83943936563},
          {-2.38801615698, 0.54689214573},
          {-1.16405179513, 0.67508618677},
          {-0.23741060782, 1.10763923085},
          {0.7747551645, 0.87802558212},
          {1.48534746713, 0.36426627421},
          {2.68554847294, 0.05610475524},
          {3.99087060784, 0.04910304933},
          {5.44371156916, 0.23208672233},
          {5.96379566955, 0.8609585026},
          {6.13659165562, 1.16023920978}}},
    };
}
LoftedSurface in_millimetres(const std::vector<SectionPoles>& inches) {
    std::vector<LoftedSurface::Section> sections;
    for (const SectionPoles& s : inches) {
        std::vector<Vec2> poles;
        for (const Vec2& p : s.poles)
            poles.push_back(p * mm_per_inch);
        sections.push_back({s.x * mm_per_inch, CubicBSpline(std::move(poles))});
    }
    return LoftedSurface(std::move(sections));
}

} // namespace

const LoftedSurface& lu_surface(std::string_view name) {
    static const LoftedSurface concave = in_millimetres(concave_poles());
    static const LoftedSurface convex = in_millimetres(convex_poles());
    static const LoftedSurface complex = in_millimetres(complex_poles());
    if (name == "concave") return concave;
    if (name == "convex") return convex;
    if (name == "complex") return complex;
    throw Error(ErrorCode::out_of_range, "sample surface", "unknown name '" + printable(name) + "'",
                "use concave, convex or complex");
}

/// Cells are about square, and several to a span of the section curves.
Mesh sample::lu(std::string_view name, double tolerance, const Progress& progress) {
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

} // namespace facetmill
