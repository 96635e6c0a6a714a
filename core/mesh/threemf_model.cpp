#include "core/mesh/threemf_model.h"

#include "core/base/archive.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/mesh/xml_stream.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr std::string_view core_space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
/// The draft of 2013, which has the same objects under another name.
constexpr std::string_view draft_space = "http://schemas.microsoft.com/3dmanufacturing/2013/01";
constexpr std::string_view production_path =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path";
constexpr std::string_view slice_stack =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07 slicestackid";
constexpr std::string_view slice_resolution =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07 meshresolution";
/// Extensions whose objects are still the meshes that the core specification has: a file may require them.
constexpr std::string_view known_extensions[] = {
    core_space,
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
};
constexpr std::string_view relationship =
    "http://schemas.openxmlformats.org/package/2006/relationships Relationship";
constexpr std::string_view model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

const std::string again = "the file is damaged: export it again";

/// The name of a file in the archive as others name it: from the root, in whichever case.
std::string plain_path(std::string_view path) {
    while (path.starts_with('/'))
        path.remove_prefix(1);
    return in_small_letters(std::string(path));
}

/// Finds the model among the relationships of the archive.
class RelationshipReader : public XmlHandler {
public:
    void start(std::string_view name, const char** attributes) override {
        if (name != relationship) return;
        const char* type = attribute(attributes, "Type");
        const char* target = attribute(attributes, "Target");
        if (!type || type != model_relationship) return;
        const char* mode = attribute(attributes, "TargetMode");
        external = external || (mode && std::string_view(mode) == "External");
        ++models;
        if (target) model = plain_path(target);
    }
    void end(std::string_view /*name*/) override {}

    std::string model;
    int models = 0;
    bool external = false;
};

/// Reads one file of the model.
class ModelReader : public XmlHandler {
public:
    ModelReader(Model3mf& model, std::string file, bool is_root)
        : model_(model), file_(std::move(file)), is_root_(is_root) {}

    void set_stream(const XmlStream& stream) { stream_ = &stream; }
    std::vector<std::string> files; ///< that it names

    void prefix(std::string_view prefix, std::string_view uri) override {
        spaces_[std::string(prefix)] = std::string(uri);
    }
    void start(std::string_view name, const char** attributes) override {
        if (!started_) return begin(name, attributes);
        if (!name.starts_with(space_) || name.size() < space_.size() + 2) return;
        const std::string_view local = name.substr(space_.size() + 1);
        if (local == "vertex")
            vertex(attributes);
        else if (local == "triangle")
            triangle(attributes);
        else if (local == "object")
            object(attributes);
        else if (local == "component")
            current().components.push_back(use(attributes));
        else if (local == "item" && is_root_)
            model_.items.push_back(use(attributes));
    }
    void end(std::string_view name) override {
        if (name.ends_with(" object") && name.starts_with(space_)) object_ = nullptr;
    }

private:
    [[noreturn]] void fail(ErrorCode code, const std::string& what, const std::string& remedy = again) const {
        throw Error(code, stream_->place(), what, remedy);
    }
    static std::string shown(const char* text) { return "'" + printable(text, 40) + "'"; }

    /// The root element, by which a file is a model.
    void begin(std::string_view name, const char** attributes) {
        if (name == std::string(draft_space) + " model")
            space_ = draft_space;
        else if (name != std::string(core_space) + " model")
            fail(ErrorCode::syntax, "the XML is no 3MF model: it begins with " + printable(name));
        started_ = true;
        if (const char* required = attribute(attributes, "requiredextensions")) check_extensions(required);
        const char* stated = attribute(attributes, "unit");
        const std::string_view unit = stated ? stated : "millimeter";
        struct Unit {
            std::string_view name;
            LengthUnit unit;
            double factor; ///< to numbers in that unit
        };
        static constexpr Unit units[] = {{"micron", LengthUnit::mm, 0.001},
                                         {"millimeter", LengthUnit::mm, 1},
                                         {"centimeter", LengthUnit::cm, 1},
                                         {"inch", LengthUnit::inch, 1},
                                         {"meter", LengthUnit::m, 1}};
        const auto* known =
            std::find_if(std::begin(units), std::end(units), [&](const Unit& u) { return u.name == unit; });
        if (known == std::end(units))
            fail(ErrorCode::unsupported_format, "the model's unit is '" + printable(unit, 40) + "'",
                 "export it in micron, millimeter, centimeter, inch or meter");
        if (!is_root_ && (model_.unit != known->unit || model_.factor != known->factor))
            fail(ErrorCode::unsupported_format, "the model's files have different units",
                 "export it in one unit");
        model_.unit = known->unit;
        model_.factor = known->factor;
    }

    void check_extensions(std::string_view required) const {
        TextCursor cursor{required};
        for (std::string_view prefix = cursor.token(); !prefix.empty(); prefix = cursor.token()) {
            const auto space = spaces_.find(std::string(prefix));
            const std::string uri = space == spaces_.end() ? std::string() : space->second;
            if (std::find(std::begin(known_extensions), std::end(known_extensions), uri)
                == std::end(known_extensions))
                fail(ErrorCode::unsupported_format,
                     "the model cannot be read without the extension '"
                         + printable(uri.empty() ? prefix : uri, 120) + "'",
                     "export it as a plain mesh");
        }
    }

    Object3mf& current() const {
        if (!object_) fail(ErrorCode::syntax, "a part of an object stands outside of any");
        return *object_;
    }

    void object(const char** attributes) {
        if (object_) fail(ErrorCode::syntax, "an object stands in another one");
        const Id3mf id{file_, number(attributes, "id")};
        const auto [place, is_new] = model_.objects.try_emplace(id);
        if (!is_new) fail(ErrorCode::syntax, "the object " + std::to_string(id.second) + " occurs twice");
        object_ = &place->second;
        if (const char* name = attribute(attributes, "name")) object_->name = printable(name, 200);
        const char* type = attribute(attributes, "type");
        const std::string_view kind = type ? type : "model";
        object_->of_model = kind == "model" || kind == "surface";
        object_->has_slices = attribute(attributes, slice_stack) != nullptr;
        const char* resolution = attribute(attributes, slice_resolution);
        if (resolution && std::string_view(resolution) == "lowres")
            fail(ErrorCode::unsupported_format, "the object's mesh is a coarse stand-in for its slices",
                 "export it as a plain mesh");
    }

    void vertex(const char** attributes) const {
        std::vector<Vec3>& vertices = current().vertices;
        if (vertices.size() >= no_index - 1) fail(ErrorCode::too_large, "an object has too many vertices");
        vertices.emplace_back(coordinate(attributes, "x"), coordinate(attributes, "y"),
                              coordinate(attributes, "z"));
    }
    double coordinate(const char** attributes, std::string_view name) const {
        const char* text = attribute(attributes, name);
        if (!text) fail(ErrorCode::syntax, "a vertex has no " + std::string(name));
        double v = 0;
        switch (read_number(trimmed(text), v)) {
        case NumberForm::number:
            break;
        case NumberForm::non_finite:
            fail(ErrorCode::non_finite, shown(text) + " is not a finite number");
        case NumberForm::overflow:
            fail(ErrorCode::coordinate_range, "the coordinate " + shown(text) + " is too large");
        default:
            fail(ErrorCode::syntax, shown(text) + " is no number");
        }
        return v;
    }

    void triangle(const char** attributes) const {
        Object3mf& object = current();
        Facet facet{};
        static constexpr std::string_view names[] = {"v1", "v2", "v3"};
        for (std::size_t k = 0; k < 3; ++k) {
            facet[k] = number(attributes, names[k]);
            if (facet[k] >= object.vertices.size())
                fail(ErrorCode::syntax, "a triangle names the vertex " + std::to_string(facet[k]) + " of "
                                            + std::to_string(object.vertices.size()));
        }
        object.facets.push_back(facet);
    }

    std::uint32_t number(const char** attributes, std::string_view name) const {
        const char* text = attribute(attributes, name);
        if (!text) fail(ErrorCode::syntax, "the attribute " + std::string(name) + " is missing");
        std::uint32_t v = 0;
        const std::string_view digits = trimmed(text);
        const auto r = std::from_chars(digits.data(), digits.data() + digits.size(), v);
        if (r.ec != std::errc() || r.ptr != digits.data() + digits.size())
            fail(ErrorCode::syntax, std::string(name) + " is " + shown(text) + ", not a whole number");
        return v;
    }

    Use3mf use(const char** attributes) {
        Use3mf use;
        const char* path = attribute(attributes, production_path);
        use.object = {path ? plain_path(path) : file_, number(attributes, "objectid")};
        if (path) files.push_back(use.object.first);
        if (const char* part = attribute(attributes, "partnumber")) use.part_number = printable(part, 200);
        const char* text = attribute(attributes, "transform");
        if (!text) return use;
        TextCursor cursor{text};
        for (double& v : use.transform.m)
            if (read_number(cursor.token(), v) != NumberForm::number) fail_transform(text);
        if (!cursor.token().empty()) fail_transform(text);
        const double det = use.transform.determinant();
        if (det == 0 || !std::isfinite(det))
            fail(ErrorCode::out_of_range, "the transform " + shown(text) + " leaves nothing of an object");
        return use;
    }
    [[noreturn]] void fail_transform(const char* text) const {
        fail(ErrorCode::syntax, "the transform " + shown(text) + " is not twelve numbers");
    }

    Model3mf& model_;
    std::string file_;
    bool is_root_, started_ = false;
    std::string_view space_ = core_space; ///< of the elements that are read
    const XmlStream* stream_ = nullptr;
    std::map<std::string, std::string> spaces_; ///< by prefix
    Object3mf* object_ = nullptr;
};

/// An archive in which files are found by the names that others call them by.
class Package {
public:
    Package(const MeshSource& source, const Progress& progress)
        : name_(source.name), progress_(progress), archive_(source.bytes, source.name, {.files = 10000}) {
        for (std::size_t i = 0; i < archive_.count(); ++i) {
            places_.try_emplace(in_small_letters(archive_.entry_name(i)), i);
            bytes_ += double(archive_.size(i));
        }
    }
    bool has(const std::string& file) const { return places_.contains(file); }
    std::string where(const std::string& file) const { return name_ + ": " + printable(file, 200); }

    /// Hands the file to the handler, which `begin` may tell of the stream.
    template <class Begin>
    void read(const std::string& file, XmlHandler& handler, const Begin& begin) {
        const std::size_t i = places_.at(file);
        XmlStream stream(archive_.where(i), handler);
        begin(stream);
        archive_.read(i, [&](std::string_view piece) {
            stream.read(piece);
            done_ += double(piece.size());
            progress_.set(std::min(1.0, done_ / bytes_));
        });
        stream.finish();
    }

private:
    std::string name_;
    const Progress& progress_;
    ArchiveReader archive_;
    std::map<std::string, std::size_t> places_;
    double bytes_ = 1, done_ = 0;
};

std::string model_file(Package& package, const MeshSource& source) {
    const std::string relationships = "_rels/.rels";
    if (!package.has(relationships))
        throw Error(ErrorCode::syntax, source.name, "is an archive, but no 3MF: it has no relationships",
                    "export the part again");
    RelationshipReader reader;
    package.read(relationships, reader, [](const XmlStream&) {});
    if (reader.models != 1 || reader.external || reader.model.empty())
        throw Error(ErrorCode::syntax, package.where(relationships),
                    reader.models == 0  ? "names no 3D model"
                    : reader.models > 1 ? "names more than one 3D model"
                    : reader.external   ? "the 3D model is not in the file"
                                        : "the 3D model has no name",
                    "export the part again");
    return reader.model;
}

} // namespace

Transform3mf Transform3mf::then(const Transform3mf& outer) const {
    if (outer == Transform3mf()) return *this;
    Transform3mf all;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t k = 0; k < 3; ++k)
            all.m[3 * row + k] = m[3 * row] * outer.m[k] + m[3 * row + 1] * outer.m[3 + k]
                                 + m[3 * row + 2] * outer.m[6 + k] + (row == 3 ? outer.m[9 + k] : 0);
    return all;
}

Model3mf read_model_3mf(const MeshSource& source, const Progress& progress) {
    Package package(source, progress);
    Model3mf model;
    std::vector<std::string> files{model_file(package, source)};
    model.root = files.front();
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!package.has(files[i]))
            throw Error(ErrorCode::missing_reference, source.name,
                        "the model '" + printable(files[i], 200) + "' is not in the file", again);
        ModelReader reader(model, files[i], i == 0);
        package.read(files[i], reader, [&](const XmlStream& stream) { reader.set_stream(stream); });
        for (const std::string& named : reader.files)
            if (std::find(files.begin(), files.end(), named) == files.end()) files.push_back(named);
    }
    return model;
}

} // namespace facetmill::detail
