#include "core/mesh/mesh_format.h"

#include "core/mesh/mesh_reader.h"

#include <algorithm>

namespace facetmill {

namespace detail {

std::string_view content_of(std::string_view bytes, std::string_view but) {
    if (const auto what = foreign_content(bytes); !what.empty()) return what;
    for (const MeshFormat& format : mesh_formats())
        if (format.name != but && format.sniff(bytes)) return format.label;
    return {};
}

} // namespace detail

const std::vector<MeshFormat>& mesh_formats() {
    static const std::vector<MeshFormat> all = {
        detail::stl_format(),     detail::obj_format(),  detail::ply_format(),
        detail::threemf_format(), detail::gltf_format(), detail::step_format(),
        detail::iges_format(),    detail::png_format(),  detail::tiff_format(),
    };
    return all;
}

const MeshFormat* mesh_format_of(std::string_view extension) {
    for (const MeshFormat& format : mesh_formats())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension)
            != format.extensions.end())
            return &format;
    return nullptr;
}

const MeshFormat* mesh_format_named(const std::string& file) {
    return mesh_format_of(detail::lower_extension(file));
}

namespace {

std::string names_of(const std::vector<MeshFormat>& formats, std::string_view last) {
    std::string names;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (i > 0) names += i + 1 == formats.size() ? last : ", ";
        names += formats[i].name;
    }
    return names;
}

} // namespace

std::string mesh_format_names(std::string_view last) {
    return names_of(mesh_formats(), last);
}

std::string solid_format_names(std::string_view last) {
    std::vector<MeshFormat> solid;
    for (const MeshFormat& format : mesh_formats())
        if (!format.is_picture) solid.push_back(format);
    return names_of(solid, last);
}

} // namespace facetmill
