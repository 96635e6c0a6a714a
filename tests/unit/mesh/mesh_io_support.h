// What the tests of mesh files share: writers of small files in every format, and a few meshes.
#pragma once

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace facetmill::test {

/// Closed box from lo to hi, 8 vertices and 12 facets, wound outwards.
inline Mesh box_mesh(const Vec3& lo, const Vec3& hi) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back(i & 1 ? hi.x() : lo.x(), i & 2 ? hi.y() : lo.y(), i & 4 ? hi.z() : lo.z());
    for (const auto& q : {std::array<Index, 4>{0, 2, 3, 1},
                          {4, 5, 7, 6},
                          {0, 1, 5, 4},
                          {2, 6, 7, 3},
                          {0, 4, 6, 2},
                          {1, 3, 7, 5}}) {
        mesh.facets.push_back({q[0], q[1], q[2]});
        mesh.facets.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}

/// Closed torus with 2 * around * across facets.
inline Mesh torus_mesh(Index around, Index across) {
    Mesh mesh;
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j) {
            const double u = 2 * pi * i / around, v = 2 * pi * j / across;
            mesh.vertices.emplace_back((30 + 10 * std::cos(v)) * std::cos(u),
                                       (30 + 10 * std::cos(v)) * std::sin(u), 10 * std::sin(v));
        }
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < across; ++j) {
            const Index a = i * across + j, b = (i + 1) % around * across + j;
            const Index c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
            mesh.facets.push_back({a, b, c});
            mesh.facets.push_back({a, c, d});
        }
    return mesh;
}

inline void append_raw(std::string& bytes, const void* value, std::size_t size, bool reverse = false) {
    std::string raw(static_cast<const char*>(value), size);
    if (reverse) std::reverse(raw.begin(), raw.end());
    bytes += raw;
}

inline std::string binary_stl(const Mesh& mesh, std::string header = "test") {
    header.resize(80, '\0');
    const auto count = std::uint32_t(mesh.facets.size());
    append_raw(header, &count, 4);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Eigen::Vector3f n = mesh.facet_normal(f).cast<float>();
        append_raw(header, n.data(), 12);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3f p = mesh.corner(f, k).cast<float>();
            append_raw(header, p.data(), 12);
        }
        header += std::string(2, '\0');
    }
    return header;
}

inline std::string number_text(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}
inline std::string vector_text(const Vec3& v) {
    return number_text(v.x()) + " " + number_text(v.y()) + " " + number_text(v.z());
}

inline std::string ascii_stl(const Mesh& mesh, const std::string& name = "part") {
    std::string text = "solid " + name + "\n";
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        text += "facet normal " + vector_text(mesh.facet_normal(f)) + "\n outer loop\n";
        for (int k = 0; k < 3; ++k)
            text += "  vertex " + vector_text(mesh.corner(f, k)) + "\n";
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

inline std::string obj_text(const Mesh& mesh) {
    std::string text = "# a part\no part\n";
    for (const Vec3& v : mesh.vertices)
        text += "v " + vector_text(v) + "\n";
    for (const Facet& f : mesh.facets)
        text += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " "
                + std::to_string(f[2] + 1) + "\n";
    return text;
}

inline std::string ply_header(const std::string& format, std::size_t vertices, std::size_t faces,
                              const std::string& coordinate = "double") {
    return "ply\nformat " + format + " 1.0\ncomment a part\nelement vertex " + std::to_string(vertices)
           + "\nproperty " + coordinate + " x\nproperty " + coordinate + " y\nproperty " + coordinate
           + " z\nelement face " + std::to_string(faces)
           + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ascii_ply(const Mesh& mesh) {
    std::string text = ply_header("ascii", mesh.vertices.size(), mesh.facets.size());
    for (const Vec3& v : mesh.vertices)
        text += vector_text(v) + "\n";
    for (const Facet& f : mesh.facets)
        text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
    return text;
}

inline std::string binary_ply(const Mesh& mesh, bool big_endian) {
    std::string bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian",
                                   mesh.vertices.size(), mesh.facets.size());
    for (const Vec3& v : mesh.vertices)
        for (int i = 0; i < 3; ++i)
            append_raw(bytes, &v[i], 8, big_endian);
    for (const Facet& f : mesh.facets) {
        bytes += '\3';
        for (const Index v : f)
            append_raw(bytes, &v, 4, big_endian);
    }
    return bytes;
}

inline LoadedMesh read(const std::string& bytes, const std::string& name, LengthUnit unit = LengthUnit::mm) {
    return read_mesh(bytes, name, unit, Progress());
}

/// Error word of the reading, or the warnings joined by commas: one text to compare.
inline std::string outcome(const std::string& bytes, const std::string& name,
                           LengthUnit unit = LengthUnit::mm) {
    try {
        std::string words = "ok";
        for (const std::string& w : read(bytes, name, unit).report.warnings)
            words += "," + w;
        return words;
    } catch (const Error& e) {
        return std::string(code_name(e.code()));
    }
}

/// With the occurrence `which` of a text, counted from 0, replaced; it must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to, int which = 0) {
    std::size_t at = text.find(from);
    for (; which > 0 && at != std::string::npos; --which)
        at = text.find(from, at + 1);
    if (at == std::string::npos) throw std::logic_error("the text to replace is not there: " + from);
    return text.replace(at, from.size(), to);
}

inline std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// What the error of the reading says.
inline std::string error_line(const std::string& bytes, const std::string& name) {
    try {
        read(bytes, name);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

inline bool same_mesh(const Mesh& a, const Mesh& b) {
    return a.facets == b.facets && a.vertices.size() == b.vertices.size()
           && std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vec3)) == 0;
}

} // namespace facetmill::test
