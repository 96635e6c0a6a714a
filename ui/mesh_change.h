// What is told of a mesh that was replaced or has changed on disk: how it differs, and what is out of date by
// that.
#pragma once

#include "core/job/planner.h"

#include <QString>

#include <filesystem>
#include <optional>
#include <string>

namespace facetmill::ui {

class Document;
class VerificationModel;

/// A mesh file as it was when it was read.
struct MeshFile {
    std::filesystem::path path;
    std::string stamp; ///< file_stamp
    bool operator==(const MeshFile&) const = default;
};
MeshFile mesh_file(const std::filesystem::path& path);

struct MeshFigures {
    std::size_t facets = 0;
    Box3 box; ///< in place, mm
    /// What its size suggests, and what it is read in; not told of stocks.
    std::optional<LengthUnit> guess, unit;
};
MeshFigures part_figures(const PreparedPart& part);
/// The part has a stock mesh.
MeshFigures stock_figures(const PreparedPart& part);

/// "“b.stl” in place of “a.stl”: 1 250 facets (1 234 before), 10 × 8 × 2 in as before."
QString mesh_change_text(const MeshFile& before, const MeshFigures& was, const MeshFile& after,
                         const MeshFigures& is, LengthUnit unit);
/// "Out of date: 2 plans, the verification." Empty where nothing is.
QString out_of_date_text(const Document& document, const VerificationModel& verification);
/// What the project has for places of its part that were picked on it. Empty where it has nothing.
QString kept_places_text(const Document& document);

} // namespace facetmill::ui
