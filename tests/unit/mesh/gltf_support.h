// glTF files made in memory: a box, and ways of saying it.
#pragma once

#include "tests/unit/mesh/mesh_io_support.h"

#include <QByteArray>

#include <cmath>
#include <string>
#include <vector>

namespace facetmill::test {

inline const Vec3 gltf_size(2, 3, 4);

inline std::string base64_of(const std::string& bytes) {
    return QByteArray(bytes.data(), qsizetype(bytes.size())).toBase64().toStdString();
}

/// A file, put together of its parts. The box stands in metres, Y up: (x, y, z) of the part are (x, z, -y) of
/// the file.
struct GltfMaker {
    int number_type = 5126, index_type = 5123, mode = 4;
    bool indexed = true, normalized = false;
    std::size_t stride = 12;
    std::string asset = R"("version":"2.0")", primitive, more;
    std::string nodes = R"([{"mesh":0,"name":"Box"}])", scenes = R"([{"nodes":[0]}])";
    std::string meshes; ///< in place of the box
    std::vector<Index> corners;

    GltfMaker() {
        for (const Facet& f : box().facets)
            corners.insert(corners.end(), {f[0], f[1], f[2]});
    }
    static Mesh box() { return box_mesh(Vec3(0, 0, 0), gltf_size / 1000); }

    std::string data() const {
        std::string bytes;
        const std::vector<Vec3> points = box().vertices;
        for (std::size_t k = 0; k < (indexed ? points.size() : corners.size()); ++k) {
            const Vec3& p = points[indexed ? k : corners[k]];
            for (const double v : {p.x(), p.z(), -p.y()}) {
                const auto f = float(v);
                const auto whole = std::int16_t(std::lround(1000 * v)); // of a file in millimetres
                if (number_type == 5126)
                    append_raw(bytes, &f, 4);
                else
                    append_raw(bytes, &whole, 2);
            }
            const std::size_t each = number_type == 5126 ? 12 : 6;
            bytes.append(stride - each, '\x7F');
        }
        bytes.resize((bytes.size() + 3) / 4 * 4);
        for (const Index corner : corners)
            append_raw(bytes, &corner, index_type == 5121 ? 1 : index_type == 5123 ? 2 : 4);
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return bytes;
    }
    std::string json(const std::string& buffer) const {
        const std::size_t count = indexed ? 8 : corners.size(), first = (count * stride + 3) / 4 * 4;
        const std::size_t indices = corners.size() * (index_type == 5121 ? 1 : index_type == 5123 ? 2 : 4);
        const auto n = [](std::size_t v) { return std::to_string(v); };
        return R"({"asset":{)" + asset + R"(},"scene":0,"scenes":)" + scenes + R"(,"nodes":)" + nodes
               + R"(,"meshes":)"
               + (!meshes.empty() ? meshes
                                  : R"([{"primitives":[{"attributes":{"POSITION":0})"
                                        + std::string(indexed ? R"(,"indices":1)" : "") + R"(,"mode":)"
                                        + std::to_string(mode) + primitive + "}]}]")
               + R"(,"accessors":[{"bufferView":0,"componentType":)" + std::to_string(number_type)
               + R"(,"count":)" + n(count) + R"(,"type":"VEC3","normalized":)"
               + (normalized ? "true" : "false") + R"(},{"bufferView":1,"componentType":)"
               + std::to_string(index_type) + R"(,"count":)" + n(corners.size())
               + R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" + n(first)
               + R"(,"byteStride":)" + n(stride) + R"(},{"buffer":0,"byteOffset":)" + n(first)
               + R"(,"byteLength":)" + n(indices) + R"(}],"buffers":[{"byteLength":)" + n(data().size())
               + buffer + "}]" + more + "}";
    }
    std::string text() const {
        return json(R"(,"uri":"data:application/octet-stream;base64,)" + base64_of(data()) + '"');
    }
    static std::string binary(std::string json, const std::string& bin) {
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const auto chunk = [](const std::string& bytes, const char* kind) {
            const auto size = std::uint32_t(bytes.size());
            std::string all;
            append_raw(all, &size, 4);
            return all + std::string(kind, 4) + bytes;
        };
        const std::string chunks = chunk(json, "JSON") + (bin.empty() ? "" : chunk(bin, "BIN\0"));
        const std::uint32_t version = 2, length = std::uint32_t(12 + chunks.size());
        std::string all = "glTF";
        append_raw(all, &version, 4);
        append_raw(all, &length, 4);
        return all + chunks;
    }
    std::string glb() const { return binary(json(""), data()); }
};

} // namespace facetmill::test
