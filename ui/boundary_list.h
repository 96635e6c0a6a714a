// The boundaries of the shown setup: changes of their list, each as one step of the history.
#pragma once

#include "ui/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace facetmill::ui {

/// Returns its place: the last. A closed curve begins round the part. Only where the part was read as the
/// project says.
std::size_t add_boundary(Document& document, Boundary::Kind kind);
/// Behind itself.
void duplicate_boundary(Document& document, std::size_t i);
/// Throws Error(missing_reference) where an operation names it.
void remove_boundary(Document& document, std::size_t i);
/// Operations that name it follow.
void rename_boundary(Document& document, std::size_t i, const std::string& name);
/// What it says of another kind stays, to come back to.
void set_boundary_kind(Document& document, std::size_t i, Boundary::Kind kind);
/// `faces`: numbers of faces of the part's file, as a project has them; `what` names the step.
void set_boundary_faces(Document& document, std::size_t i, const std::string& faces, const QString& what);
/// Facets of the part as it was read, one mark for each. Those of a file of surfaces would become others with
/// the finest tolerance: the step fixes the part's chord tolerance where it is "auto", and this is true then.
bool set_boundary_facets(Document& document, std::size_t i, const std::vector<char>& marks,
                         const QString& what);
void set_boundary_curve(Document& document, std::size_t i, const std::vector<CurveCorner>& curve,
                        const QString& what);

/// "1 234 of 5 000 facets", "7 corners"; empty for kinds that list nothing.
QString boundary_extent(const Boundary& boundary);
/// Why what is painted does not fit the part; empty: it does, or is not of facets, or there
/// is no part.
QString boundary_mismatch(const Boundary& boundary, const std::shared_ptr<const PreparedPart>& part);

} // namespace facetmill::ui
