// glTF 2.0, binary (.glb) and text with its data in it (.gltf): the triangles of the scene, or of chosen
// objects. Its unit is the metre, and Y points up: the part is turned so that Z does. Materials, bones and
// shapes to morph into are passed over.
#include "core/mesh/gltf_file.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/object_choice.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/tolerances.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

/// Small files can name a node, or a mesh, many times: what comes of that is bounded.
constexpr std::uint64_t max_gltf_facets = 50'000'000, max_gltf_nodes = 200'000;
constexpr int max_node_depth = 64;
constexpr unsigned triangles = 4, triangle_strip = 5, triangle_fan = 6;

class GltfScene {
public:
    GltfScene(const MeshSource& source, const GltfFile& file, const Progress& progress)
        : source_(source), file_(file), progress_(progress), wanted_(source),
          limit_(tolerance::largest_coordinate / mm_per(LengthUnit::m)) {
        soup_.format = file.is_binary() ? "GLB" : "glTF";
        soup_.indexed = true;
        soup_.single_precision = true;
        soup_.unit = LengthUnit::m;
        soup_.warnings.insert("y_up_turned");
    }

    TriangleSoup run() {
        Eigen::Affine3d upright = Eigen::Affine3d::Identity(); // (x, y, z) to (x, -z, y)
        upright.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        for (const std::size_t node : roots())
            add_node(node, upright, wanted_.is_open(), 0);
        wanted_.rest([](const std::string&) { return false; }, [&] { return names(); });
        if (soup_.facets.empty())
            throw Error(ErrorCode::no_facets, source_.name, "the file holds no triangles",
                        "export the part as a mesh");
        std::size_t read = 0;
        for (const MeshObject& object : soup_.objects)
            if (object.read && ++read == 1) soup_.name = object.name;
        if (read > 1) soup_.name.clear();
        return std::move(soup_);
    }

private:
    /// Of the scene that is shown, or of all nodes where the file has no scene.
    std::vector<std::size_t> roots() const {
        std::vector<std::size_t> all;
        const Json& scenes = file_.list("scenes");
        if (!scenes.empty()) {
            const Json& scene = file_.element("scenes", file_.number(file_.json(), "scene", 0, ""));
            for (const std::size_t node : numbers_of(scene, "nodes", "scenes"))
                all.push_back(node);
            return all;
        }
        std::vector<bool> held(file_.list("nodes").size(), false);
        for (std::size_t i = 0; i < held.size(); ++i)
            for (const std::size_t child : numbers_of(file_.element("nodes", i), "children", "nodes"))
                if (child < held.size()) held[child] = true;
        for (std::size_t i = 0; i < held.size(); ++i)
            if (!held[i]) all.push_back(i);
        return all;
    }

    std::vector<std::size_t> numbers_of(const Json& object, const char* key, const std::string& place) const {
        std::vector<std::size_t> all;
        const auto found = object.find(key);
        if (found == object.end()) return all;
        if (!found->is_array()) file_.fail(ErrorCode::syntax, place + "." + key, "is no list");
        for (const Json& one : *found)
            all.push_back(file_.number(Json{{"n", one}}, "n", 0, place + "." + key));
        return all;
    }
    /// As many numbers as are asked for, or those given where there are none.
    std::vector<double> values_of(const Json& object, const char* key, std::vector<double> otherwise,
                                  const std::string& place) const {
        const auto found = object.find(key);
        if (found == object.end()) return otherwise;
        bool right = found->is_array() && found->size() == otherwise.size();
        for (std::size_t i = 0; right && i < otherwise.size(); ++i) {
            right = (*found)[i].is_number();
            if (right) otherwise[i] = (*found)[i].get<double>();
        }
        if (!right)
            file_.fail(ErrorCode::syntax, place + "." + key,
                       "is no list of " + std::to_string(otherwise.size()) + " numbers");
        return otherwise;
    }

    Eigen::Affine3d place_of(const Json& node, const std::string& place) const {
        Eigen::Affine3d own;
        if (node.contains("matrix")) {
            const std::vector<double> m = values_of(node, "matrix", std::vector<double>(16, 0.0), place);
            own.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data()); // by columns, as Eigen has it
            if (own.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
                file_.fail(ErrorCode::syntax, place + ".matrix", "is no place in space");
        } else {
            const auto t = values_of(node, "translation", {0, 0, 0}, place),
                       s = values_of(node, "scale", {1, 1, 1}, place),
                       r = values_of(node, "rotation", {0, 0, 0, 1}, place);
            const Eigen::Quaterniond turn(r[3], r[0], r[1], r[2]);
            if (turn.norm() == 0) file_.fail(ErrorCode::syntax, place + ".rotation", "is no rotation");
            own =
                Eigen::Translation3d(t[0], t[1], t[2]) * turn.normalized() * Eigen::Scaling(s[0], s[1], s[2]);
        }
        const double det = own.linear().determinant();
        if (det == 0 || !std::isfinite(det))
            file_.fail(ErrorCode::out_of_range, place, "the node's place leaves nothing of an object");
        return own;
    }

    static std::string name_of(const Json& object) {
        const auto found = object.find("name");
        return found != object.end() && found->is_string() ? printable(found->get<std::string>(), 200)
                                                           : std::string();
    }

    void add_node(std::size_t number, const Eigen::Affine3d& outer, bool taken, int depth) {
        progress_.check();
        if (depth > max_node_depth || ++nodes_ > max_gltf_nodes)
            file_.fail(ErrorCode::limit_exceeded, "nodes", "nodes hold each other too deeply, or themselves");
        const Json& node = file_.element("nodes", number);
        const std::string place = "nodes[" + std::to_string(number) + "]";
        const Eigen::Affine3d placed = outer * place_of(node, place);
        std::string name = name_of(node);
        const bool has_mesh = node.contains("mesh");
        const std::size_t mesh = file_.number(node, "mesh", 0, place);
        if (name.empty() && has_mesh) name = name_of(file_.element("meshes", mesh));
        if (wanted_.takes({name, std::to_string(number)})) taken = true;
        if (has_mesh) {
            const std::size_t before = soup_.facets.size();
            if (node.contains("skin")) soup_.warnings.insert("shapes_at_rest");
            const std::size_t facets = add_mesh(mesh, placed, taken);
            if (soup_.objects.size() < max_listed_objects)
                soup_.objects.push_back({std::to_string(number), name, facets, soup_.facets.size() > before});
        }
        for (const std::size_t child : numbers_of(node, "children", place))
            add_node(child, placed, taken, depth + 1);
    }

    /// How many facets the mesh has, which are added where it is `taken`.
    std::size_t add_mesh(std::size_t number, const Eigen::Affine3d& placed, bool taken) {
        const Json& mesh = file_.element("meshes", number);
        const std::string place = "meshes[" + std::to_string(number) + "]";
        const auto primitives = mesh.find("primitives");
        if (primitives == mesh.end() || !primitives->is_array())
            file_.fail(ErrorCode::syntax, place, "has no list of primitives");
        std::size_t facets = 0;
        for (const Json& primitive : *primitives) {
            const std::size_t mode = file_.number(primitive, "mode", triangles, place);
            if (mode < triangles || mode > triangle_fan) {
                soup_.warnings.insert("lines_ignored");
                continue;
            }
            const auto attributes = primitive.find("attributes");
            if (attributes == primitive.end() || !attributes->is_object()
                || !attributes->contains("POSITION"))
                file_.fail(ErrorCode::syntax, place, "a primitive has no positions");
            if (primitive.contains("targets")) soup_.warnings.insert("shapes_at_rest");
            const std::size_t positions = file_.number(*attributes, "POSITION", 0, place);
            const bool indexed = primitive.contains("indices");
            const std::size_t corners =
                file_.count_of(indexed ? file_.number(primitive, "indices", 0, place) : positions);
            facets += mode == triangles ? corners / 3 : std::max<std::size_t>(corners, 2) - 2;
            if (!taken) continue;
            add_primitive(
                file_.positions(positions, progress_.part(0, 1)),
                indexed ? file_.indices(file_.number(primitive, "indices", 0, place), progress_.part(0, 1))
                        : counted(corners),
                unsigned(mode), placed, place);
        }
        return facets;
    }
    static std::vector<Index> counted(std::size_t count) {
        std::vector<Index> all(count);
        for (std::size_t i = 0; i < count; ++i)
            all[i] = Index(i);
        return all;
    }

    void add_primitive(const std::vector<Vec3>& points, const std::vector<Index>& corners, unsigned mode,
                       const Eigen::Affine3d& placed, const std::string& place) {
        if (soup_.points.size() + points.size() > 3 * max_gltf_facets
            || soup_.facets.size() + corners.size() > max_gltf_facets)
            file_.fail(ErrorCode::limit_exceeded, place,
                       "its objects, put together, have more than 50 million facets",
                       "choose some of its objects");
        const auto first = Index(soup_.points.size());
        for (const Vec3& p : points) {
            const Vec3 q = placed * p;
            if (!q.allFinite() || q.cwiseAbs().maxCoeff() > limit_)
                throw Error(ErrorCode::coordinate_range, source_.name + ": " + place,
                            "a vertex is further than " + format_number(limit_) + " from the origin",
                            "the file is damaged or in another unit");
            soup_.points.emplace_back(q.array() + 0.0); // no negative zeros
        }
        for (const Index corner : corners)
            if (corner >= points.size())
                file_.fail(ErrorCode::syntax, place,
                           "a triangle names the vertex " + std::to_string(corner) + " of "
                               + std::to_string(points.size()));
        const bool mirrored = placed.linear().determinant() < 0;
        const auto add = [&](Index a, Index b, Index c) {
            if (mirrored) std::swap(b, c);
            soup_.facets.push_back({first + a, first + b, first + c});
        };
        if (mode == triangles) {
            if (corners.size() % 3 != 0)
                file_.fail(ErrorCode::syntax, place, "the last triangle has no three corners");
            for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
                add(corners[i], corners[i + 1], corners[i + 2]);
        } else if (mode == triangle_strip) {
            for (std::size_t i = 0; i + 2 < corners.size(); ++i)
                add(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
        } else {
            for (std::size_t i = 1; i + 1 < corners.size(); ++i)
                add(corners[i], corners[i + 1], corners[0]);
        }
    }

    std::string names() const {
        ObjectList all;
        for (const MeshObject& object : soup_.objects)
            all.add(object.number, object.name);
        return all.text();
    }

    const MeshSource& source_;
    const GltfFile& file_;
    const Progress& progress_;
    ObjectChoice wanted_;
    double limit_;
    std::uint64_t nodes_ = 0;
    TriangleSoup soup_;
};

/// A text that begins as an object.
bool is_json(std::string_view bytes) {
    return trimmed(bytes.substr(byte_order_mark(bytes))).starts_with('{');
}

TriangleSoup read_gltf(const MeshSource& source, const Progress& progress) {
    const std::string_view what =
        is_glb(source.bytes) ? std::string_view() : content_of(source.bytes, "glTF");
    if (!what.empty() || (!is_glb(source.bytes) && !is_json(source.bytes)))
        throw Error(ErrorCode::syntax, source.name,
                    what.empty() ? "is not a glTF file" : "is not a glTF file but " + std::string(what),
                    "open the file itself, under a name that ends as its format does");
    const GltfFile file(source);
    return GltfScene(source, file, progress).run();
}

/// Binary, or JSON that has an asset near its beginning or end.
bool sniff_gltf(std::string_view bytes) {
    if (is_glb(bytes)) return true;
    if (!is_json(bytes)) return false;
    constexpr std::size_t near = 4096;
    return bytes.substr(0, near).find("\"asset\"") != std::string_view::npos
           || bytes.substr(bytes.size() - std::min(bytes.size(), near)).find("\"asset\"")
                  != std::string_view::npos;
}

} // namespace

MeshFormat gltf_format() {
    return {.name = "glTF",
            .label = "a glTF file",
            .extensions = {".glb", ".gltf"},
            .sniff = sniff_gltf,
            .read = read_gltf,
            .has_objects = true};
}

} // namespace facetmill::detail
