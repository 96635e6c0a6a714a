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
        detail::stl_format(),  detail::obj_format(),  detail::ply_format(), detail::threemf_format(),
        detail::step_format(), detail::iges_format(), detail::png_format(), detail::tiff_format(),
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

std::string mesh_format_names(std::string_view last) {
    std::string names;
    const auto& all = mesh_formats();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0) names += i + 1 == all.size() ? last : ", ";
        names += all[i].name;
    }
    return names;
}

} // namespace facetmill
