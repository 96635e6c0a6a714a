#include "core/job/bounds.h"

#include "core/job/cache_key.h"
#include "core/mesh/grown.h"
#include "core/strategy/curves/plan_curve.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Fixtures that are named when they are in the way, at most.
constexpr std::size_t max_named = 3;
/// A mesh that is grown has 44 times as many.
constexpr std::size_t max_avoided_facets = 50'000;

/// All that makes the region on a part.
std::string text_of(const Project& project, const Boundary& boundary) {
    Key key;
    key.add_up_to(Stage::output, boundary, boundary_parameters());
    if (const auto c = project.cutter_of(boundary))
        key.add(std::array{c->d, c->r, c->e, c->f, c->alpha, c->beta, c->h});
    return key.text();
}

/// "'Clamp'", "'A', 'B', 'C' and 2 more"; empty for none.
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < max_named; ++i)
        text += (i > 0 ? ", '" : "'") + printable(names[i], 60) + "'";
    if (names.size() <= max_named) return text;
    return text + " and " + std::to_string(names.size() - max_named) + " more";
}

std::string fixtures_text(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    return names.size() == 1 ? "the fixture " + listed(names) : "the fixtures " + listed(names);
}

std::string tabs_text(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    return names.size() == 1 ? "the tab " + listed(names) : "the tabs " + listed(names);
}

/// Names and smallest clearance of a setup's fixtures.
KeptFixtures kept_fixtures(const PreparedPart& part, const ContactIndexPtr& grown) {
    KeptFixtures kept{grown, infinity, {}};
    if (!part.fixtures) return kept;
    std::vector<std::string> fixtures, tabs;
    bool table = false;
    for (const FixtureSolid& f : *part.fixtures) {
        kept.clearance = std::min(kept.clearance, f.clearance);
        table = table || f.table;
        if (!f.table) (f.tab ? tabs : fixtures).push_back(f.name);
    }
    for (const std::string& words : {fixtures_text(fixtures), tabs_text(tabs),
                                     table ? std::string("what holds the stock from below") : std::string()})
        if (!words.empty()) kept.names = kept.names.empty() ? words : kept.names + " or " + words;
    return kept;
}

} // namespace

std::string bounds_key(const Project& project, const Operation& operation) {
    const OperationCommon& common = operation.common();
    Key key;
    if (!common.boundary.empty())
        key.add("within").add(std::string_view(text_of(project, project.boundary_of(common.boundary))));
    if (!common.avoid.empty())
        key.add("avoid").add(std::string_view(text_of(project, project.boundary_of(common.avoid))));
    for (const std::string& name : operation.curve_names())
        key.add("follow").add(
            std::string_view(name.empty() ? name : text_of(project, project.boundary_of(name))));
    return key.text();
}

Boundary with_facets_of_faces(const Boundary& boundary, const PreparedPart& part) {
    if (boundary.kind != Boundary::Kind::faces) return boundary;
    const std::string place = boundary_place(boundary.name);
    if (!part.faces || !part.report.surfaces)
        throw Error(ErrorCode::missing_reference, place,
                    "it names faces, and the part's file has none: only STEP and IGES files do",
                    "paint the boundary, or take the part from such a file");
    std::vector<char> wanted(part.report.surfaces->faces, 0);
    try {
        for (const Index face : face_ranges(boundary.faces, wanted.size()))
            wanted[face] = 1;
    } catch (const Error& e) {
        throw e.within(place);
    }
    std::vector<Index> facets;
    for (std::size_t f = 0; f < part.faces->size(); ++f)
        if (wanted[(*part.faces)[f]]) facets.push_back(Index(f));
    Boundary made = boundary;
    made.kind = Boundary::Kind::facets;
    made.facets = facet_ranges_text(facets);
    made.of_facets = long(part.faces->size());
    return made;
}

PlanCurve curve_seen(const Boundary& boundary, const Mat3& turn) {
    PlanCurve curve{{}, true};
    for (const CurveCorner& corner : boundary.curve)
        curve.points.emplace_back((turn * Vec3(corner.at[0], corner.at[1], corner.at[2])).head<2>());
    return curve;
}

NamedCurves BoundsCache::curves(const Project& project, const std::string& name, const Progress& progress) {
    NamedCurves curves{name, {}};
    if (name.empty()) return curves;
    const Boundary& boundary = project.boundary_of(name);
    if (boundary.kind != Boundary::Kind::curve) {
        curves.all = joined_loops(region(project, boundary, progress)->border());
        return curves;
    }
    curves.all.push_back(curve_seen(boundary, turn_));
    return curves;
}

std::shared_ptr<const BoundaryRegion> BoundsCache::region(const Project& project, const Boundary& boundary,
                                                          const Progress& progress) {
    auto& kept = regions_[text_of(project, boundary)];
    if (kept) return kept;
    Boundary turned = with_facets_of_faces(boundary, *prepared_);
    for (CurveCorner& corner : turned.curve) {
        const Vec3 at = turn_ * Vec3(corner.at[0], corner.at[1], corner.at[2]);
        corner.at = {at.x(), at.y(), at.z()};
    }
    kept = std::make_shared<BoundaryRegion>(turned, part_, progress, project.cutter_of(boundary));
    return kept;
}

void BoundsCache::avoid(const Project& project, const Boundary& boundary, double distance,
                        OperationBounds& bounds, const Progress& progress) {
    const std::string place = boundary_place(boundary.name);
    const std::string key = Key().add(std::string_view(text_of(project, boundary))).add(distance).text();
    if (!avoided_.contains(key)) {
        const auto region = this->region(project, boundary, progress.part(0, 0.2));
        const std::size_t facets = region->piece()->facet_count();
        if (facets > max_avoided_facets)
            throw Error(ErrorCode::limit_exceeded, place,
                        std::to_string(facets) + " facets are to be avoided, more than "
                            + std::to_string(max_avoided_facets),
                        "avoid fewer facets, or cut within a boundary that leaves them out");
        auto grown = std::make_shared<Mesh>(grown_mesh(*region->piece(), distance, progress.part(0.2, 0.4)));
        if (held_.fixtures) append_mesh(*grown, held_.fixtures->mesh());
        auto all = std::make_shared<Mesh>(*part_);
        append_mesh(*all, *grown);
        avoided_[key] = {std::make_shared<ContactIndex>(all, progress.part(0.4, 0.8)),
                         std::make_shared<ContactIndex>(grown, progress.part(0.8, 1))};
    }
    const Held& made = avoided_[key];
    bounds.contact = made.all;
    bounds.off.grown = made.fixtures;
    bounds.off.clearance = std::min(bounds.off.clearance, distance);
    bounds.off.names =
        bounds.off.names.empty() ? place + " to avoid" : bounds.off.names + " and " + place + " to avoid";
}

OperationBounds BoundsCache::of(const Project& project, const Operation& operation, const PreparedPart& part,
                                const Held& held, const Progress& progress) {
    if (part_ != part.mesh || held_.all != held.all) {
        regions_.clear();
        avoided_.clear();
        part_ = part.mesh;
        held_ = held;
    }
    prepared_ = &part;
    OperationBounds bounds{held.all, kept_fixtures(part, held.fixtures), nullptr, {}};
    for (const std::string& name : operation.curve_names())
        bounds.curves.push_back(curves(project, name, progress.part(0, 0)));
    const OperationCommon& common = operation.common();
    if (!common.avoid.empty())
        avoid(project, project.boundary_of(common.avoid), common.avoid_distance, bounds,
              progress.part(0, 0.5));
    if (!common.boundary.empty())
        bounds.within = std::make_shared<KeptWithin>(
            KeptWithin{region(project, project.boundary_of(common.boundary), progress.part(0.5, 1)),
                       common.contain, CutterProfile(project.tool_of(operation).cutter()).max_radius()});
    return bounds;
}

} // namespace facetmill
