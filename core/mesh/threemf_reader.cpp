// 3MF: what lies on the build plate, or the chosen objects, as one mesh.
#include "core/mesh/mesh_format.h"
#include "core/mesh/object_choice.h"
#include "core/mesh/threemf_model.h"

#include "core/base/archive.h"
#include "core/base/error.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace facetmill::detail {

namespace {

/// Small files can name an object of objects of objects: what comes of that is worked out first.
constexpr std::uint64_t max_expanded_facets = 50'000'000, max_uses = 1'000'000;
constexpr int max_component_depth = 64;

/// What an object comes to with all that it is put together from.
struct Expanded {
    std::uint64_t facets = 0, uses = 1;
};

class Expansion3mf {
public:
    Expansion3mf(const MeshSource& source, const Model3mf& model, TriangleSoup& soup,
                 const Progress& progress)
        : source_(source), model_(model), soup_(soup), progress_(progress), wanted_(source),
          limit_(tolerance::largest_coordinate / mm_per(model.unit)) {}

    void run() {
        Expanded all;
        for (const Use3mf& item : model_.items)
            add(all, measure(item.object, 0));
        check(all);
        for (const Use3mf& item : model_.items)
            append(item, item.transform, wanted_.is_open());
        append_from_shelf();
        if (wanted_.is_open() && model_.items.empty())
            throw Error(ErrorCode::no_facets, source_.name, "nothing lies on the file's build plate",
                        model_.objects.empty() ? "export the part again"
                                               : "name its objects: " + object_names());
        if (soup_.facets.empty())
            throw Error(ErrorCode::no_facets, source_.name, "the file holds no mesh",
                        "export the part again");
        list_objects();
    }

private:
    [[noreturn]] void too_large() const {
        throw Error(ErrorCode::limit_exceeded, source_.name,
                    "its objects, put together, have more than 50 million facets or a million parts",
                    "choose some of its objects");
    }
    void check(const Expanded& all) const {
        if (all.facets > max_expanded_facets || all.uses > max_uses) too_large();
    }
    void add(Expanded& all, const Expanded& more) const {
        all.facets += more.facets;
        all.uses += more.uses;
        check(all);
    }
    static std::string called(const Id3mf& id) { return "object " + std::to_string(id.second); }

    const Object3mf& object_of(const Id3mf& id) const {
        const auto found = model_.objects.find(id);
        if (found == model_.objects.end())
            throw Error(ErrorCode::missing_reference, source_.name, "there is no " + called(id),
                        "the file is damaged: export it again");
        return found->second;
    }

    /// Also finds objects that hold themselves.
    Expanded measure(const Id3mf& id, int depth) {
        if (const auto known = measured_.find(id); known != measured_.end()) return known->second;
        if (depth > max_component_depth)
            throw Error(ErrorCode::limit_exceeded, source_.name,
                        "objects are put together too deeply, or hold themselves: " + called(id),
                        "the file is damaged: export it again");
        const Object3mf& object = object_of(id);
        // No mesh needs more than three vertices a facet: those of no facet count as well.
        Expanded all{std::max<std::uint64_t>(object.facets.size(), object.vertices.size() / 3), 1};
        for (const Use3mf& part : object.components)
            add(all, measure(part.object, depth + 1));
        measured_[id] = all;
        return all;
    }

    void append(const Use3mf& use, const Transform3mf& transform, bool taken) {
        progress_.check();
        const Object3mf& object = object_of(use.object);
        if (wanted_.takes({object.name, std::to_string(use.object.second), use.part_number})) taken = true;
        if (taken && !object.of_model) {
            soup_.warnings.insert("objects_left_out");
            return;
        }
        if (taken) append_mesh(use.object, object, transform);
        for (const Use3mf& part : object.components)
            append(part, part.transform.then(transform), taken);
    }

    void append_mesh(const Id3mf& id, const Object3mf& object, const Transform3mf& transform) {
        read_.insert(id);
        if (object.facets.empty()) return;
        if (object.has_slices) soup_.warnings.insert("slices_ignored");
        if (soup_.points.size() + object.vertices.size() >= no_index) too_large();
        const auto first = Index(soup_.points.size());
        const bool moved = transform != Transform3mf();
        for (const Vec3& v : object.vertices) {
            const Vec3 p = model_.factor * (moved ? transform.of(v) : v);
            if (!p.allFinite() || p.cwiseAbs().maxCoeff() > limit_)
                throw Error(ErrorCode::coordinate_range, source_.name + ", " + called(id),
                            "a vertex is further than " + format_number(limit_) + " from the origin",
                            "the file is damaged or in another unit");
            soup_.points.emplace_back(p.array() + 0.0); // no negative zeros
        }
        const bool mirrored = moved && transform.determinant() < 0;
        for (const Facet& f : object.facets)
            soup_.facets.push_back({first + f[0], first + f[mirrored ? 2 : 1], first + f[mirrored ? 1 : 2]});
        if (soup_.facets.size() > max_expanded_facets) too_large();
    }

    /// Objects that are asked for and lie in the file without being on its plate, as they are.
    void append_from_shelf() {
        const auto find = [&](const std::string& name) {
            bool found = false;
            for (const auto& [id, object] : model_.objects)
                if (object.name == name || std::to_string(id.second) == name) {
                    found = true;
                    check(measure(id, 0));
                    append({id, {}, {}}, {}, true);
                }
            return found;
        };
        wanted_.rest(find, [&] { return object_names(); });
    }

    std::string object_names() const {
        ObjectList names;
        for (const auto& [id, object] : model_.objects)
            names.add(std::to_string(id.second), object.name);
        return names.text();
    }

    void list_objects() {
        std::size_t with_mesh = 0;
        for (const auto& [id, object] : model_.objects) {
            if (soup_.objects.size() == max_listed_objects) break;
            const auto size = measured_.find(id);
            soup_.objects.push_back(
                {std::to_string(id.second), object.name,
                 size == measured_.end() ? object.facets.size() : std::size_t(size->second.facets),
                 read_.contains(id)});
            if (read_.contains(id) && !object.facets.empty() && ++with_mesh == 1) soup_.name = object.name;
        }
        if (with_mesh > 1) soup_.name.clear();
    }

    const MeshSource& source_;
    const Model3mf& model_;
    TriangleSoup& soup_;
    const Progress& progress_;
    ObjectChoice wanted_;
    double limit_;
    std::set<Id3mf> read_;
    std::map<Id3mf, Expanded> measured_;
};

TriangleSoup read_3mf(const MeshSource& source, const Progress& progress) {
    if (!is_archive(source.bytes)) {
        const std::string_view what = content_of(source.bytes, "3MF");
        throw Error(ErrorCode::syntax, source.name,
                    what.empty() ? "is not a 3MF file" : "is not a 3MF file but " + std::string(what),
                    "open the file itself, under a name that ends as its format does");
    }
    const Model3mf model = read_model_3mf(source, progress.part(0, 0.8));
    TriangleSoup soup;
    soup.format = "3MF";
    soup.indexed = true;
    soup.single_precision = true;
    soup.unit = model.unit;
    const Progress expanding = progress.part(0.8, 1);
    Expansion3mf(source, model, soup, expanding).run();
    return soup;
}

/// An archive whose list of files, at its end, has a model.
bool sniff_3mf(std::string_view bytes) {
    constexpr std::size_t tail = std::size_t(1) << 16;
    return is_archive(bytes)
           && bytes.substr(bytes.size() - std::min(bytes.size(), tail)).find(".model")
                  != std::string_view::npos;
}

} // namespace

MeshFormat threemf_format() {
    return {.name = "3MF",
            .label = "a 3MF file",
            .extensions = {".3mf"},
            .sniff = sniff_3mf,
            .read = read_3mf,
            .has_objects = true};
}

} // namespace facetmill::detail
