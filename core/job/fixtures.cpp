#include "core/job/fixtures.h"

#include "core/job/cache_key.h"
#include "core/job/placed_mesh.h"
#include "core/job/planner.h"
#include "core/mesh/grown.h"
#include "core/verify/winding_number.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// A mesh that is grown has 44 times as many.
constexpr std::size_t max_fixture_facets = 50'000;

FixtureSolid load_fixture(const Project& project, const Fixture& fixture, const Progress& progress) {
    const bool tab = fixture.kind == Fixture::Kind::tab;
    FixtureSolid solid{fixture.name, nullptr, nullptr, tab ? 0 : fixture.clearance, tab};
    if (fixture.kind != Fixture::Kind::mesh) {
        solid.mesh = std::make_shared<Mesh>(fixture_mesh(fixture));
        solid.grown = std::make_shared<Mesh>(fixture_mesh(fixture, solid.clearance));
        return solid;
    }
    solid.mesh =
        load_solid(project.fixture_path(fixture), MeshPlace::of(fixture), "fixture", progress.part(0, 0.8));
    if (solid.mesh->facet_count() > max_fixture_facets)
        throw Error(ErrorCode::limit_exceeded, "file",
                    "the mesh has " + std::to_string(solid.mesh->facet_count()) + " facets, more than "
                        + std::to_string(max_fixture_facets),
                    "use a coarser mesh, or boxes and cylinders");
    solid.grown = std::make_shared<Mesh>(grown_mesh(*solid.mesh, fixture.clearance, progress.part(0.8, 1)));
    return solid;
}

} // namespace

std::string fixtures_key(const Project& project) {
    Key key;
    for (const Fixture& fixture : project.fixtures) {
        key.add_up_to(Stage::output, fixture, fixture_parameters());
        if (fixture.kind == Fixture::Kind::mesh)
            key.add(std::string_view(file_stamp(project.fixture_path(fixture))));
    }
    return key.text();
}

std::vector<FixtureSolid> load_fixtures(const Project& project, const Progress& progress) {
    std::vector<FixtureSolid> solids;
    const auto n = double(project.fixtures.size());
    for (const Fixture& fixture : project.fixtures) {
        const auto i = double(solids.size());
        try {
            solids.push_back(load_fixture(project, fixture, progress.part(i / n, (i + 1) / n)));
            check_coordinates(solids.back().grown->box(), "fixture");
        } catch (const Error& e) {
            throw e.within("fixture '" + printable(fixture.name) + "'");
        }
    }
    return solids;
}

namespace {

/// Places all over a box or cylinder, off its sides by a share of its size: what touches the part has none in
/// it.
std::vector<Vec3> places_within(const Fixture& f) {
    const bool round = f.kind == Fixture::Kind::cylinder;
    const Mat3 turn = rotation_of(f.rotate);
    const Vec3 move(f.translate[0], f.translate[1], f.translate[2]),
        half = 0.5 * (round ? Vec3(f.diameter, f.diameter, f.height) : Vec3(f.size[0], f.size[1], f.size[2]));
    std::vector<Vec3> places;
    constexpr double off_sides = 0.98;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const double inward = round && x != 0 && y != 0 ? std::sqrt(0.5) : 1;
                const Vec3 p = off_sides * Vec3(inward * x, inward * y, z).cwiseProduct(half);
                places.push_back(turn * (p + Vec3(0, 0, half.z())) + move);
            }
    return places;
}

} // namespace

std::vector<std::string> fixture_warnings(const Project& project, const PreparedPart& part,
                                          const Progress& progress) {
    constexpr double inside = 0.75; // below a large sheet it is a half
    std::vector<std::string> warnings;
    for (const Fixture& f : project.fixtures) {
        if (f.kind == Fixture::Kind::mesh || f.kind == Fixture::Kind::tab)
            continue; // a tab begins in the part
        const std::vector<Vec3> places = places_within(f);
        const bool stands = std::any_of(places.begin(), places.end(), [&](const Vec3& p) {
            return (p.array() > part.box.lo.array()).all() && (p.array() < part.box.hi.array()).all()
                   && winding_number(*part.mesh, p, progress) > inside;
        });
        if (stands) warnings.push_back("The fixture '" + printable(f.name, 60) + "' stands in the part.");
    }
    return warnings;
}

MeshPtr grown_fixtures(const std::vector<FixtureSolid>& fixtures) {
    auto all = std::make_shared<Mesh>();
    for (const FixtureSolid& f : fixtures)
        append_mesh(*all, *f.grown);
    return all;
}

MeshPtr with_fixtures(const Mesh& part, const std::vector<FixtureSolid>& fixtures) {
    auto all = std::make_shared<Mesh>(part);
    append_mesh(*all, *grown_fixtures(fixtures));
    return all;
}

} // namespace facetmill
