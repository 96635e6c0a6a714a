#include "core/job/fixtures.h"

#include "core/job/cache_key.h"
#include "core/job/placed_mesh.h"
#include "core/mesh/grown.h"

namespace facetmill {

namespace {

/// A mesh that is grown has 44 times as many.
constexpr std::size_t max_fixture_facets = 50'000;
/// What stands less deep in a fixture touches it, mm.
constexpr double touching = 0.01;

void append(Mesh& mesh, const Mesh& more) {
    const auto first = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Facet& f : more.facets)
        mesh.facets.push_back({first + f[0], first + f[1], first + f[2]});
}

FixtureSolid load_fixture(const Project& project, const Fixture& fixture, const Progress& progress) {
    FixtureSolid solid{fixture.name, nullptr, nullptr, fixture.clearance};
    if (fixture.kind != Fixture::Kind::mesh) {
        solid.mesh = std::make_shared<Mesh>(fixture_mesh(fixture));
        solid.grown = std::make_shared<Mesh>(fixture_mesh(fixture, fixture.clearance));
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

std::vector<std::string> fixture_warnings(const Project& project, const Mesh& part) {
    std::vector<std::string> warnings;
    for (const Fixture& f : project.fixtures) {
        if (f.kind == Fixture::Kind::mesh) continue;
        const bool round = f.kind == Fixture::Kind::cylinder;
        const Mat3 back = rotation_of(f.rotate).transpose();
        const Vec3 move(f.translate[0], f.translate[1], f.translate[2]);
        double deepest = 0;
        for (const Vec3& vertex : part.vertices) {
            const Vec3 p = back * (vertex - move);
            const double height = round ? f.height : f.size[2];
            const double beside =
                round ? 0.5 * f.diameter - p.head<2>().norm()
                      : std::min(0.5 * f.size[0] - std::abs(p.x()), 0.5 * f.size[1] - std::abs(p.y()));
            deepest = std::max(deepest, std::min({beside, p.z(), height - p.z()}));
        }
        if (deepest > touching)
            warnings.push_back("The fixture '" + printable(f.name, 60)
                               + "' stands in the part, which reaches "
                               + length_text(deepest, project.unit, 3) + " into it.");
    }
    return warnings;
}

MeshPtr grown_fixtures(const std::vector<FixtureSolid>& fixtures) {
    auto all = std::make_shared<Mesh>();
    for (const FixtureSolid& f : fixtures)
        append(*all, *f.grown);
    return all;
}

MeshPtr with_fixtures(const Mesh& part, const std::vector<FixtureSolid>& fixtures) {
    auto all = std::make_shared<Mesh>(part);
    append(*all, *grown_fixtures(fixtures));
    return all;
}

} // namespace facetmill
