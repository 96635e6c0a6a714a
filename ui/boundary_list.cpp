#include "ui/boundary_list.h"

#include "core/base/usual_value.h"
#include "core/mesh/mesh_format.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

/// What boundaries of a kind are called at first.
std::string first_name(Boundary::Kind kind) {
    switch (kind) {
    case Boundary::Kind::facets:
        return utf8(Document::tr("Painted"));
    case Boundary::Kind::slope:
        return utf8(Document::tr("Slope"));
    case Boundary::Kind::curve:
        return utf8(Document::tr("Curve"));
    case Boundary::Kind::silhouette:
        return utf8(Document::tr("Silhouette"));
    case Boundary::Kind::rest:
        return utf8(Document::tr("Rest"));
    case Boundary::Kind::faces:
        break;
    }
    return utf8(Document::tr("Faces"));
}

std::string free_boundary_name(const Project& project, const std::string& wish) {
    return free_name(wish, [&](const std::string& name) {
        return std::any_of(project.boundaries.begin(), project.boundaries.end(),
                           [&](const Boundary& b) { return b.name == name; });
    });
}

/// Fills in what a boundary of its kind must have and nobody has said yet.
void complete(Boundary& boundary, const PreparedPart& part, const Project& project) {
    if (boundary.kind == Boundary::Kind::rest && !find_tool(project.tools, boundary.tool)) {
        const auto widest =
            std::max_element(project.tools.begin(), project.tools.end(),
                             [](const Tool& a, const Tool& b) { return a.diameter < b.diameter; });
        if (widest != project.tools.end()) boundary.tool = widest->number;
    }
    if (boundary.kind == Boundary::Kind::facets && boundary.facets.empty())
        boundary.of_facets = long(part.mesh->facet_count());
    if (boundary.kind == Boundary::Kind::curve && boundary.curve.size() < 3) {
        const Vec3 &lo = part.box.lo, &hi = part.box.hi;
        boundary.curve.clear();
        for (const auto& [x, y] : std::array<std::array<double, 2>, 4>{
                 {{lo.x(), lo.y()}, {hi.x(), lo.y()}, {hi.x(), hi.y()}, {lo.x(), hi.y()}}})
            boundary.curve.push_back({{x, y, hi.z()}});
    }
}

} // namespace

std::size_t add_boundary(Document& document, Boundary::Kind kind) {
    const std::size_t at = document.project().boundaries.size();
    if (!document.part_is_current()) return at;
    Boundary made;
    ParameterView<Boundary> view(made, boundary_parameters());
    take_usual_values(view, document.unit());
    made.kind = kind;
    made.name = free_boundary_name(document.project(), first_name(kind));
    complete(made, *document.part(), document.project());
    document.change(Document::tr("Add boundary"), [&](Project& p) { p.boundaries.push_back(made); });
    return at;
}

void duplicate_boundary(Document& document, std::size_t i) {
    Boundary copy = document.project().boundaries.at(i);
    copy.name = free_boundary_name(document.project(), copy.name);
    document.change(Document::tr("Duplicate boundary"), [&](Project& p) {
        p.boundaries.insert(p.boundaries.begin() + std::ptrdiff_t(i) + 1, copy);
    });
}

void remove_boundary(Document& document, std::size_t i) {
    const std::string name = document.project().boundaries.at(i).name;
    for (const auto& operation : document.project().operations) {
        const OperationCommon& common = operation->common();
        const std::vector<std::string> curves = operation->curve_names();
        const bool followed = std::find(curves.begin(), curves.end(), name) != curves.end();
        if (common.boundary == name || common.avoid == name || followed)
            throw Error(ErrorCode::missing_reference, "boundary '" + name + "'",
                        "operation '" + common.name
                            + (common.boundary == name ? "' cuts within it"
                               : common.avoid == name  ? "' keeps off it"
                                                       : "' follows it"),
                        "let the operation name another boundary, or none, first");
    }
    document.change(Document::tr("Remove boundary"),
                    [&](Project& p) { p.boundaries.erase(p.boundaries.begin() + std::ptrdiff_t(i)); });
}

void rename_boundary(Document& document, std::size_t i, const std::string& name) {
    const std::string before = document.project().boundaries.at(i).name;
    document.change(Document::tr("Rename boundary"), [&](Project& p) {
        p.boundaries.at(i).name = name;
        for (const auto& operation : p.operations)
            operation->rename_boundary(before, name);
    });
}

void set_boundary_kind(Document& document, std::size_t i, Boundary::Kind kind) {
    document.change(Document::tr("Change kind of boundary"), [&](Project& p) {
        p.boundaries.at(i).kind = kind;
        if (document.part()) complete(p.boundaries[i], *document.part(), p);
    });
}

/// Facets that follow surfaces become others when the finest tolerance does, and what is painted would be
/// lost: from now on they stay as they are.
static void keep_facets(Project& project) {
    const MeshFormat* format = mesh_format_named(project.part.file);
    if (!format || !format->has_surfaces || project.part.chord_tolerance.is_number()) return;
    project.part.chord_tolerance = {project.part_reading().chord, {}};
}

bool set_boundary_facets(Document& document, std::size_t i, const std::vector<char>& marks,
                         const QString& what) {
    std::vector<Index> numbers;
    for (std::size_t f = 0; f < marks.size(); ++f)
        if (marks[f]) numbers.push_back(Index(f));
    const bool kept = document.project().part.chord_tolerance.is_number();
    document.change(what, [&](Project& p) {
        p.boundaries.at(i).facets = facet_ranges_text(numbers);
        p.boundaries[i].of_facets = long(marks.size());
        keep_facets(p);
    });
    return document.project().part.chord_tolerance.is_number() && !kept;
}

void set_boundary_faces(Document& document, std::size_t i, const std::string& faces, const QString& what) {
    document.change(what, [&](Project& p) { p.boundaries.at(i).faces = faces; });
}

void set_boundary_curve(Document& document, std::size_t i, const std::vector<CurveCorner>& curve,
                        const QString& what) {
    document.change(what, [&](Project& p) { p.boundaries.at(i).curve = curve; });
}

QString boundary_extent(const Boundary& boundary) {
    if (boundary.kind == Boundary::Kind::curve)
        return Document::tr("%1 corners", nullptr, int(boundary.curve.size()))
            .arg(count_text(boundary.curve.size()));
    if (boundary.kind == Boundary::Kind::faces)
        return boundary.faces.empty() ? Document::tr("no faces yet")
                                      : Document::tr("faces %1").arg(text(boundary.faces));
    if (boundary.kind != Boundary::Kind::facets) return {};
    const auto all = std::size_t(boundary.of_facets);
    try {
        const std::size_t painted = facet_ranges(boundary.facets, all ? all : no_index).size();
        return Document::tr("%1 of %2 facets", nullptr, int(painted))
            .arg(count_text(painted), count_text(all));
    } catch (const Error& e) {
        return sentence(worded(e));
    }
}

QString boundary_mismatch(const Boundary& boundary, const std::shared_ptr<const PreparedPart>& part) {
    const auto all = std::size_t(boundary.of_facets);
    if (boundary.kind != Boundary::Kind::facets || all == 0 || !part || all == part->mesh->facet_count())
        return {};
    return Document::tr("It was painted on a part of %1 facets, and this one has %2: paint it anew.")
        .arg(count_text(all), count_text(part->mesh->facet_count()));
}

} // namespace facetmill::ui
