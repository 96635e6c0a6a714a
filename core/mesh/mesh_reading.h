// What a job says of a mesh file beside its place: the unit of its numbers, which of its objects are meant,
// how large the relief is that a picture is read as, and how closely facets follow the surfaces of a file
// that has such.
#pragma once

#include "core/base/units.h"
#include "core/base/vec.h"

#include <optional>
#include <string>

namespace facetmill {

/// A relief read from a picture, a heightmap: black is its ground, white its top. Lengths in mm.
struct Relief {
    std::optional<double> width; ///< along x, from the middles of the first column's pixels to the last one's
    std::optional<double> length; ///< along y; without it as long as square pixels make it
    std::optional<double> height; ///< from black to white
    double smoothing = 0;         ///< evened out, no height moved by more than this; 0: as the picture has it
    bool invert = false;          ///< black is the top
    bool operator==(const Relief&) const = default;
};

/// Taken where nothing is said, mm; the report warns then.
inline constexpr double usual_relief_width = 100, usual_relief_height = 5;
/// Where nothing is said of the surfaces of STEP and IGES files: how far facets may lie from them (mm), and
/// how much the normals of facets beside each other may differ on one surface.
inline constexpr double usual_chord = 0.01, usual_chord_angle = 10 * pi / 180;

struct MeshReading {
    MeshReading() = default;
    MeshReading(LengthUnit of_numbers) : unit(of_numbers) {} // NOLINT(google-explicit-constructor): often all

    /// That of the file's numbers, of a format that states none. Without it they are millimetres, and a file
    /// that states another one contradicts nobody.
    std::optional<LengthUnit> unit;
    /// Names or numbers of the objects of a 3MF file that are read, separated by commas; empty: all that the
    /// file has on its build plate.
    std::string objects;
    Relief relief;
    double chord = usual_chord, chord_angle = usual_chord_angle; ///< mm, radians; of surfaces
    bool operator==(const MeshReading&) const = default;
};

/// Another text for another mesh of the same file.
std::string reading_key(const MeshReading& reading);

} // namespace facetmill
