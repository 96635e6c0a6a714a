// 3MF files made in memory, sound ones and others.
#pragma once

#include "core/base/archive.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <string>
#include <vector>

namespace facetmill::test {

struct Maker3mf {
    std::string objects, items = "<item objectid=\"1\"/>";
    std::string unit = "unit=\"millimeter\"";
    std::string model_attributes;
    std::string model_name = "3D/3dmodel.model", target = "/3D/3dmodel.model";
    std::string before_model; ///< in the model's file
    std::vector<ArchiveFile> more;

    std::string model() const {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + before_model + "<model " + unit
               + " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
                 "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
               + model_attributes + "><resources>" + objects + "</resources><build>" + items
               + "</build></model>";
    }
    std::string relationships() const {
        return "<?xml version=\"1.0\"?><Relationships "
               "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
               "Id=\"r\" "
               "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\""
               + target + "\"/></Relationships>";
    }
};

inline std::string threemf_bytes(const Maker3mf& maker) {
    std::vector<ArchiveFile> files = {{"[Content_Types].xml", "<Types/>"},
                                      {"_rels/.rels", maker.relationships()},
                                      {maker.model_name, maker.model()}};
    files.insert(files.end(), maker.more.begin(), maker.more.end());
    return archive_bytes(files);
}

inline std::string mesh_3mf(const Mesh& mesh, int id = 1, const std::string& attributes = {}) {
    std::string text = "<object id=\"" + std::to_string(id) + "\" " + attributes + "><mesh><vertices>";
    for (const Vec3& v : mesh.vertices)
        text += "<vertex x=\"" + number_text(v.x()) + "\" y=\"" + number_text(v.y()) + "\" z=\""
                + number_text(v.z()) + "\"/>";
    text += "</vertices><triangles>";
    for (const Facet& f : mesh.facets)
        text += "<triangle v1=\"" + std::to_string(f[0]) + "\" v2=\"" + std::to_string(f[1]) + "\" v3=\""
                + std::to_string(f[2]) + "\"/>";
    return text + "</triangles></mesh></object>";
}

inline std::string components_3mf(int id, const std::string& components, const std::string& attributes = {}) {
    return "<object id=\"" + std::to_string(id) + "\" " + attributes + "><components>" + components
           + "</components></object>";
}

} // namespace facetmill::test
