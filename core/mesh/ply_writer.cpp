// PLY, binary, little endian: vertices with colours and a value where there are some, facets.
#include "core/base/error.h"
#include "core/mesh/mesh_writer.h"

#include <bit>
#include <limits>

namespace facetmill::detail {

namespace {

constexpr std::size_t bytes_per_write = std::size_t(1) << 18;

/// Bytes on their way into the file.
class Bytes {
public:
    explicit Bytes(OutputFile& file) : file_(file) { buffer_.reserve(bytes_per_write + 64); }

    template <class Word>
    void put(Word word) {
        for (std::size_t i = 0; i < sizeof word; ++i)
            buffer_.push_back(char(word >> (8 * i) & 0xFF));
    }
    void put(float v) { put(std::bit_cast<std::uint32_t>(v)); }
    void put(double v) { put(std::bit_cast<std::uint64_t>(v)); }
    /// True when it was much, and time for a look at the progress.
    bool flush(std::size_t from = bytes_per_write) {
        if (buffer_.size() < from) return false;
        file_.write({buffer_.data(), buffer_.size()});
        buffer_.clear();
        return true;
    }

private:
    OutputFile& file_;
    std::vector<char> buffer_;
};

bool fits_float(const Vec3& p) {
    return rounded_to_float(p) == p;
}

std::string header_of(const Mesh& mesh, const MeshWriting& writing, const char* number) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment facetmill, lengths in "
                       + std::string(unit_name(writing.unit)) + "\nelement vertex "
                       + std::to_string(mesh.vertices.size());
    for (const char* axis : {"x", "y", "z"})
        text += std::string("\nproperty ") + number + " " + axis;
    if (!writing.colors.empty())
        for (const char* channel : {"red", "green", "blue"})
            text += std::string("\nproperty uchar ") + channel;
    if (!writing.values.empty()) text += "\nproperty float " + writing.value_name;
    return text + "\nelement face " + std::to_string(mesh.facets.size())
           + "\nproperty list uchar int vertex_indices\nend_header\n";
}

} // namespace

void write_ply(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress) {
    const std::string name = printable(file.target().string(), 400);
    if (writing.value_name.empty()
        || writing.value_name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") != std::string::npos)
        throw Error(ErrorCode::out_of_range, name,
                    "'" + printable(writing.value_name, 40) + "' names no property",
                    "use small letters and _");
    if (mesh.vertices.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
        throw Error(ErrorCode::too_large, name, "a PLY file holds at most 2 147 483 647 vertices",
                    "write the part in pieces");
    const double mm = mm_per(writing.unit);
    bool single = true;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (v % 65536 == 0) progress.check();
        check_vertex(mesh.vertices[v] / mm, v, file);
        single = single && fits_float(mesh.vertices[v] / mm);
    }
    file.write(header_of(mesh, writing, single ? "float" : "double"));
    Bytes bytes(file);
    const double all = double(mesh.vertices.size() + mesh.facets.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3 p = mesh.vertices[v] / mm;
        for (int i = 0; i < 3; ++i)
            single ? bytes.put(float(p[i])) : bytes.put(p[i]);
        if (!writing.colors.empty())
            for (const std::uint8_t channel : writing.colors[v])
                bytes.put(channel);
        if (!writing.values.empty()) bytes.put(float(double(writing.values[v]) / mm));
        if (bytes.flush()) progress.set(double(v) / all);
    }
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        bytes.put(std::uint8_t(3));
        for (const Index v : mesh.facets[f])
            bytes.put(v);
        if (bytes.flush()) progress.set(double(mesh.vertices.size() + f) / all);
    }
    bytes.flush(1);
    progress.check();
}

} // namespace facetmill::detail
