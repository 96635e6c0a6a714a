#include "core/setup/fixture.h"

#include "core/mesh/mesh_format.h"

#include <cmath>

namespace facetmill {

namespace {

/// Sides of a cylinder: the corners stand out by a thousandth of its radius.
constexpr int cylinder_sides = 72;

ParameterInfo fixture_length(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::number,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = 1e5,
            .open_minimum = true,
            .stage = Stage::contact};
}

/// The upright prism over a polygon counted counter-clockwise.
Mesh prism_over(const std::vector<Vec2>& polygon, double bottom, double top) {
    Mesh mesh;
    const auto n = Index(polygon.size());
    for (const Vec2& p : polygon) {
        mesh.vertices.emplace_back(p.x(), p.y(), bottom);
        mesh.vertices.emplace_back(p.x(), p.y(), top);
    }
    for (Index i = 0; i < n; ++i) {
        const Index a = 2 * i, b = 2 * ((i + 1) % n);
        mesh.facets.push_back({a, b, b + 1});
        mesh.facets.push_back({a, b + 1, a + 1});
        if (i > 0 && i + 1 < n) {
            mesh.facets.push_back({0, b, a});
            mesh.facets.push_back({1, a + 1, b + 1});
        }
    }
    return mesh;
}

std::vector<Vec2> fixture_outline(const Fixture& fixture, double by) {
    std::vector<Vec2> polygon;
    if (fixture.kind == Fixture::Kind::cylinder) {
        const double r = (0.5 * fixture.diameter + by) / std::cos(pi / cylinder_sides);
        for (int k = 0; k < cylinder_sides; ++k) {
            const double angle = 2 * pi * k / cylinder_sides;
            polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        return polygon;
    }
    const double x = 0.5 * fixture.size[0] + by, y = 0.5 * fixture.size[1] + by;
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// Along x, with its upper edge above the middle. Grown, its flanks are that much farther out.
Mesh triangular_tab(const Fixture& fixture, double by) {
    const double half = 0.5 * fixture.size[1], height = fixture.size[2];
    const double slant = std::hypot(half, height);
    const double rise = by * slant / half;                    // of the edge, for flanks that move out by `by`
    const double wide = half * (height + rise + by) / height; // where they meet the lower bottom
    Mesh mesh = prism_over({{-wide, -by}, {wide, -by}, {0, height + rise}}, -0.5 * fixture.size[0] - by,
                           0.5 * fixture.size[0] + by);
    for (Vec3& p : mesh.vertices)
        p = Vec3(p.z(), p.x(), p.y()); // even: it stays wound outward
    return mesh;
}

} // namespace

const ParameterTable<Fixture>& fixture_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        ParameterTable<Fixture> t;
        t.add(&Fixture::name, {.key = "name",
                               .label = "Name",
                               .help = "Stands in the report, the verdict and the setup sheet.",
                               .kind = K::text,
                               .stage = Stage::contact});
        t.add_choice(&Fixture::kind, {.key = "kind",
                                      .label = "Kind",
                                      .help = "Shape of what holds the part: a vice's jaw or a clamp is a "
                                              "box, a bolt or a chuck a cylinder. A tab is a piece of the "
                                              "stock that is left between part and rest.",
                                      .words = {"box", "cylinder", "mesh", "tab"},
                                      .stage = Stage::contact});
        t.add(&Fixture::size, {.key = "size",
                               .label = "Size",
                               .help = "Of the box along X, Y and Z, before it is turned; of a tab its "
                                       "length from the part outward, its width and its height.",
                               .kind = K::triple,
                               .quantity = Quantity::length,
                               .minimum = 0,
                               .maximum = 1e5,
                               .open_minimum = true,
                               .stage = Stage::contact});
        t.add_choice(&Fixture::shape, {.key = "shape",
                                       .label = "Shape",
                                       .help = "Of a tab as it is seen along its length. A triangular one is "
                                               "cut in ramps and breaks off more easily.",
                                       .words = {"rectangular", "triangular"},
                                       .stage = Stage::contact});
        t.add(&Fixture::diameter, fixture_length("diameter", "Diameter", "Of the cylinder."));
        t.add(&Fixture::height,
              fixture_length("height", "Height", "Of the cylinder, along Z before it is turned."));
        t.add(&Fixture::file, {.key = "file",
                               .label = "File",
                               .help = "The fixture's mesh (" + solid_format_names()
                                       + "), closed; a relative path starts at the project file.",
                               .kind = K::text,
                               .stage = Stage::mesh});
        t.add_choice(&Fixture::unit, mesh_unit_parameter());
        t.add(&Fixture::scale, scale_parameter("fixture's mesh"));
        t.add_choice(&Fixture::mirror, mirror_parameter("fixture's mesh"));
        t.add(&Fixture::rotate,
              rotate_parameter("Turns the fixture about X, then Y, then Z (fixed axes), about the middle of "
                               "its bottom; a mesh about its file's origin."));
        t.add(&Fixture::translate,
              translate_parameter("Where the middle of its bottom is; how far a mesh is moved. The part's "
                                  "placement does not move it."));
        t.add(&Fixture::clearance,
              fixture_length("clearance", "Clearance",
                             "What cutter, shank and holder keep from it, in cuts and in rapids."));
        return t;
    }();
    return table;
}

const std::string& fixture_kind_name(Fixture::Kind kind) {
    return fixture_parameters().find("kind")->info.words.at(std::size_t(kind));
}

const std::vector<std::string>& fixture_keys(Fixture::Kind kind) {
    static const std::array<std::vector<std::string>, 4> keys{
        {{"name", "kind", "size", "rotate", "translate", "clearance"},
         {"name", "kind", "diameter", "height", "rotate", "translate", "clearance"},
         {"name", "kind", "file", "units", "scale", "mirror", "rotate", "translate", "clearance"},
         {"name", "kind", "size", "shape", "rotate", "translate"}}};
    return keys.at(std::size_t(kind));
}

Mesh fixture_mesh(const Fixture& fixture, double by) {
    if (fixture.kind == Fixture::Kind::mesh)
        throw Error(ErrorCode::internal, "fixtures", "a mesh has no described shape", "report this");
    const double height = fixture.kind == Fixture::Kind::cylinder ? fixture.height : fixture.size[2];
    Mesh mesh = fixture.kind == Fixture::Kind::tab && fixture.shape == Fixture::TabShape::triangular
                    ? triangular_tab(fixture, by)
                    : prism_over(fixture_outline(fixture, by), -by, height + by);
    const Mat3 turn = rotation_of(fixture.rotate);
    const Vec3 move(fixture.translate[0], fixture.translate[1], fixture.translate[2]);
    for (Vec3& p : mesh.vertices)
        p = turn * p + move;
    return mesh;
}

} // namespace facetmill
