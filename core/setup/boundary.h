// Where operations may cut: regions of the part's surface that the user paints, draws or names by slope, as
// the project says them. Millimetres, radians, coordinates of the setup.
#pragma once

#include "core/base/parameter.h"
#include "core/mesh/mesh.h"

#include <array>
#include <string>
#include <vector>

namespace facetmill {

/// A corner of a closed curve.
struct CurveCorner {
    std::array<double, 3> at{0, 0, 0};
    bool operator==(const CurveCorner&) const = default;
};

struct Boundary {
    enum class Kind {
        facets,     ///< those that were painted
        slope,      ///< facets whose normal makes such an angle with +Z
        curve,      ///< what lies in a closed curve, looked at along Z
        silhouette, ///< what lies in the part's outline, looked at along Z
        rest,       ///< what a tool leaves where it has been everywhere, looked at along Z
        faces,      ///< faces of a file that has surfaces
    };
    std::string name = "Boundary";
    Kind kind = Kind::facets;
    /// facets: numbers of facets of the part's file from 0, in order: "0-57, 60" (facet_ranges_text).
    std::string facets;
    long of_facets = 0; ///< facets: how many the part had when they were painted
    std::string faces;  ///< faces: their numbers in the part's file from 0, in order, as those of facets
    std::array<double, 2> slope{0, radians(30)};
    std::vector<CurveCorner> curve; ///< the last is joined to the first; z is only for showing it
    long tool = 0;                  ///< rest: its number
    double more_than = 0.1;         ///< rest: less than that, along the normal, counts as nothing
    double offset = 0;              ///< curve, silhouette, rest: outward, inward below 0
    bool invert = false;            ///< all but that
};

const ParameterTable<CurveCorner>& curve_corner_parameters();
inline constexpr RecordList<CurveCorner> curve_list{"curve", curve_corner_parameters};
const ParameterTable<Boundary>& boundary_parameters();
/// "facets", "slope", "curve", "silhouette", "rest", "faces".
const std::string& boundary_kind_name(Boundary::Kind kind);
/// Keys of the parameters that a kind has; the others say nothing of it.
const std::vector<std::string>& boundary_keys(Boundary::Kind kind);

/// Numbers of facets as text, "0-57, 60", and back. `numbers` are in ascending order, each once. Throws
/// Error(syntax) for what is no list of ascending ranges, Error(out_of_range) for a number not below `count`.
std::string facet_ranges_text(const std::vector<Index>& numbers);
std::vector<Index> facet_ranges(const std::string& text, std::size_t count);
/// The same of faces; the text that `facet_ranges_text` gives.
std::vector<Index> face_ranges(const std::string& text, std::size_t count);

/// Where the tool may be, beside the contact: an operation's boundary keeps this within.
enum class Containment : std::uint8_t {
    contact, ///< the place where the cutter touches the part
    tip,     ///< the tool's tip, looked at along Z
    tool,    ///< all of the cutter, looked at along Z
};

} // namespace facetmill
