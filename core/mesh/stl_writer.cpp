#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/mesh_io.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace facetmill {

namespace {

void put_word(char* to, std::uint32_t word) {
    for (int i = 0; i < 4; ++i)
        to[i] = char(word >> (8 * i) & 0xFF);
}

void put_vector(char* to, const Vec3& v) {
    for (int i = 0; i < 3; ++i)
        put_word(to + 4 * i, std::bit_cast<std::uint32_t>(float(v[i])));
}

} // namespace

void write_stl(const Mesh& mesh, OutputFile& file, LengthUnit unit, const Progress& progress) {
    const std::string name = printable(file.target().string(), 400);
    if (mesh.facets.empty())
        throw Error(ErrorCode::no_facets, name, "the mesh to write has no facet", "nothing was written");
    if (mesh.facets.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::too_large, name, "an STL file holds at most 4 294 967 294 facets",
                    "write the part in pieces");
    const double mm = mm_per(unit);
    std::array<char, 84> header{};
    // Not "solid": that would look like a text.
    const std::string title = "facetmill binary STL, " + std::string(unit_name(unit));
    std::memcpy(header.data(), title.data(), title.size());
    put_word(&header[80], std::uint32_t(mesh.facets.size()));
    file.write({header.data(), header.size()});

    constexpr std::size_t block = 16384, record = 50;
    std::vector<char> buffer(block * record);
    for (std::size_t begin = 0; begin < mesh.facets.size(); begin += block) {
        progress.set(double(begin) / double(mesh.facets.size()));
        const std::size_t end = std::min(mesh.facets.size(), begin + block);
        for (std::size_t f = begin; f < end; ++f) {
            char* to = &buffer[(f - begin) * record];
            put_vector(to, mesh.facet_normal(f));
            for (int k = 0; k < 3; ++k) {
                const Vec3 corner = mesh.corner(f, k) / mm;
                if (!corner.allFinite()
                    || corner.cwiseAbs().maxCoeff() > double(std::numeric_limits<float>::max()))
                    throw Error(corner.allFinite() ? ErrorCode::coordinate_range : ErrorCode::non_finite,
                                name + ", facet " + std::to_string(f + 1),
                                "a corner cannot be written as a float", "nothing was written");
                put_vector(to + 12 + 12 * k, corner);
            }
            to[48] = to[49] = 0;
        }
        file.write({buffer.data(), (end - begin) * record});
    }
    progress.check();
}

void save_stl(const Mesh& mesh, const std::filesystem::path& path, LengthUnit unit,
              const Progress& progress) {
    OutputFile file(path);
    write_stl(mesh, file, unit, progress);
    file.commit();
}

} // namespace facetmill
