#include "core/mesh/sample.h"

#include "core/mesh/sample_parts.h"

#include <cmath>

namespace facetmill {

const std::vector<SampleKind>& sample_kinds() {
    using enum LengthUnit;
    static const std::vector<SampleKind> kinds{
        {"concave", "Concave surface", "Lu's first benchmark: a ruled valley, 10 × 10 in.", inch},
        {"convex", "Convex surface", "Lu's second benchmark: a ruled ridge, 10 × 10 in.", inch},
        {"complex", "Complex surface", "Lu's third benchmark: convex, concave and saddle regions, 9 × 11 in.",
         inch},
        {"pillar", "Pillar", "A long curved strip with concave blends, like a car's A-pillar, 20 × 6 in.",
         inch},
        {"gap", "Surface with a gap", "A domed surface with a winding gap between two walls, 6 × 5 in.",
         inch},
        {"shell", "Body shell", "A car body with four steep concave scoops, 12 × 6 in.", inch},
        {"mould", "Mould cavity",
         "A pocket with walls at 3° of draft, sharp inner corners and a boss on its floor, 100 × 80 mm.", mm},
        {"square-prism", "Square prism", "Jasra's turned prism: side 50 mm, 40 mm long, about the X axis.",
         mm, true},
        {"cylinder", "Cylinder", "Jasra's turned cylinder: Ø40 mm, 25 mm long, about the X axis.", mm, true},
        {"twisted-prism", "Twisted prism",
         "A square prism of side 45 mm, 60 mm long, that makes a quarter turn about the X axis.", mm, true},
        {"extruded-pattern", "Extruded pattern",
         "Raised pads on a cylinder Ø40 mm, 54 mm long, about the X axis.", mm, true},
        {"swept-pattern", "Swept pattern",
         "Ribs swept around a cylinder Ø40 mm, 54 mm long, about the X axis.", mm, true},
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
        throw Error(ErrorCode::out_of_range, std::string(name), "the chord tolerance is not a length above 0",
                    "give a positive length");
    const auto make = [&]() -> Mesh {
        if (name == "pillar") return sample::pillar(chord_tolerance_mm, progress);
        if (name == "gap") return sample::gap(chord_tolerance_mm, progress);
        if (name == "shell") return sample::shell(chord_tolerance_mm, progress);
        if (name == "mould") return sample::mould(chord_tolerance_mm);
        if (name == "square-prism") return sample::square_prism();
        if (name == "cylinder") return sample::cylinder(chord_tolerance_mm);
        if (name == "extruded-pattern") return sample::extruded_pattern(chord_tolerance_mm, progress);
        if (name == "swept-pattern") return sample::swept_pattern(chord_tolerance_mm, progress);
        if (name == "twisted-prism") return sample::twisted_prism(chord_tolerance_mm, progress);
        return sample::lu(name, chord_tolerance_mm, progress);
    };
    return std::make_shared<const Mesh>(make());
}

} // namespace facetmill
