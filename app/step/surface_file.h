// Faces of a STEP or IGES file, in millimetres, as OpenCASCADE reads them.
#pragma once

#include "app/step/step_progress.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <string>
#include <vector>

namespace facetmill::step {

enum class SurfaceFormat { step, iges };

/// A face of the file where it belongs in the whole.
struct PlacedFace {
    TopoDS_Face face;
    std::size_t number = 0; ///< in the order of the file; assemblies have a number for each copy
    std::size_t body = 0;   ///< faces of a closed shell or solid share it; loose faces have one together
};

struct SurfaceFile {
    TopoDS_Shape shape; ///< holds all of `faces`
    std::vector<PlacedFace> faces;
    std::size_t numbers = 0;     ///< of faces, those included that have vanished in sewing
    std::size_t bodies = 0;      ///< of the solids and closed shells; body `bodies` is what is loose
    std::size_t loose_faces = 0; ///< of no solid or closed shell
    bool sewn = false;           ///< faces that only lay beside each other were joined
    std::string unit;            ///< as the file names it
    double mm_per_unit = 1;
    std::vector<std::string> parts; ///< names of the products, each once
};

/// Faces whose edges are nearer than `chord` (mm) are joined where the file does not say that they hang
/// together. Throws Error(syntax, no_facets); `path` is not named in it.
SurfaceFile read_surface_file(const std::string& path, SurfaceFormat format, double chord,
                              StepProgress& progress);

} // namespace facetmill::step
