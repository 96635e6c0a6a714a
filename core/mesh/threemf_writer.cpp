// 3MF: one object of one mesh on the build plate. Core specification 1.3; the colours of vertices stand in a
// colour group of the materials extension, which readers that do not know it leave out.
#include "core/base/archive.h"
#include "core/base/error.h"
#include "core/mesh/mesh_writer.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace facetmill::detail {

namespace {

constexpr std::size_t lines_per_check = 16384;

/// Feet are written as inches: not every reader takes them.
LengthUnit written_unit(LengthUnit unit) {
    return unit == LengthUnit::ft ? LengthUnit::inch : unit;
}

std::string_view unit_word(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::inch:
    case LengthUnit::ft:
        return "inch";
    case LengthUnit::cm:
        return "centimeter";
    case LengthUnit::m:
        return "meter";
    case LengthUnit::mm:
        break;
    }
    return "millimeter";
}

/// Text of an attribute.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text)
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    return out;
}

/// The colours that occur, each once, in the order in which they do.
struct ColorGroup {
    std::vector<VertexColor> colors;
    std::vector<Index> of_vertex;

    explicit ColorGroup(std::span<const VertexColor> given) {
        std::map<VertexColor, Index> known;
        of_vertex.reserve(given.size());
        for (const VertexColor& color : given) {
            const auto [at, fresh] = known.emplace(color, Index(colors.size()));
            if (fresh) colors.push_back(color);
            of_vertex.push_back(at->second);
        }
    }
};

class ModelText {
public:
    ModelText(const Mesh& mesh, const MeshWriting& writing, const OutputFile& file, const Progress& progress)
        : mesh_(mesh), writing_(writing), file_(file), progress_(progress), group_(writing.colors) {}

    std::string text() {
        constexpr std::size_t vertex_bytes = 64, facet_bytes = 64;
        text_.reserve(mesh_.vertices.size() * vertex_bytes + mesh_.facets.size() * facet_bytes);
        add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"");
        add(unit_word(writing_.unit));
        add("\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
            "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
            "<metadata name=\"Application\">Facetmill</metadata>\n<resources>\n");
        add_colors();
        add("<object id=\"1\" type=\"model\"");
        if (!writing_.name.empty()) add(" name=\"" + escaped(printable(writing_.name, 400)) + "\"");
        if (!group_.colors.empty()) add(" pid=\"2\" pindex=\"0\"");
        add("><mesh>\n<vertices>\n");
        add_vertices();
        add("</vertices>\n<triangles>\n");
        add_facets();
        add("</triangles>\n</mesh></object>\n</resources>\n<build><item objectid=\"1\"/></build>\n"
            "</model>\n");
        return std::move(text_);
    }

private:
    void add(std::string_view more) { text_ += more; }
    template <class Number>
    void add_number(Number v) {
        char digits[40];
        const auto end = std::to_chars(std::begin(digits), std::end(digits), v);
        text_.append(digits, end.ptr);
    }
    void add_colors() {
        if (group_.colors.empty()) return;
        constexpr std::string_view digits = "0123456789ABCDEF";
        add("<m:colorgroup id=\"2\">\n");
        for (const VertexColor& color : group_.colors) {
            add("<m:color color=\"#");
            for (const std::uint8_t channel : color) {
                text_ += digits[channel >> 4];
                text_ += digits[channel & 15];
            }
            add("\"/>\n");
        }
        add("</m:colorgroup>\n");
    }
    void add_vertices() {
        const double mm = mm_per(written_unit(writing_.unit));
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            if (v % lines_per_check == 0) progress_.set(0.5 * double(v) / double(mesh_.vertices.size()));
            const Vec3 p = mesh_.vertices[v] / mm;
            check_vertex(p, v, file_);
            add("<vertex x=\"");
            add_number(p.x());
            add("\" y=\"");
            add_number(p.y());
            add("\" z=\"");
            add_number(p.z());
            add("\"/>\n");
        }
    }
    void add_facets() {
        static constexpr std::string_view corner_names[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
        static constexpr std::string_view color_names[] = {"\" pid=\"2\" p1=\"", "\" p2=\"", "\" p3=\""};
        for (std::size_t f = 0; f < mesh_.facets.size(); ++f) {
            if (f % lines_per_check == 0) progress_.set(0.5 + 0.5 * double(f) / double(mesh_.facets.size()));
            const Facet& facet = mesh_.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                add(corner_names[k]);
                add_number(facet[k]);
            }
            if (!group_.colors.empty())
                for (std::size_t k = 0; k < 3; ++k) {
                    add(color_names[k]);
                    add_number(group_.of_vertex[facet[k]]);
                }
            add("\"/>\n");
        }
    }

    const Mesh& mesh_;
    const MeshWriting& writing_;
    const OutputFile& file_;
    Progress progress_;
    ColorGroup group_;
    std::string text_;
};

constexpr std::string_view content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr std::string_view relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

} // namespace

void write_3mf(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress) {
    const std::string model = ModelText(mesh, writing, file, progress.part(0, 0.3)).text();
    std::uint64_t end = 0;
    write_archive(
        {{"[Content_Types].xml", content_types}, {"_rels/.rels", relationships}, {"3D/3dmodel.model", model}},
        [&](std::uint64_t at, std::string_view bytes) {
            if (at == end)
                file.write(bytes);
            else
                file.overwrite(std::size_t(at), bytes);
            end = std::max(end, at + bytes.size());
        },
        progress.part(0.3, 1));
    progress.check();
}

} // namespace facetmill::detail
