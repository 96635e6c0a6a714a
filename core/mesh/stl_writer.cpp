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

constexpr std::size_t facets_per_write = 16384, stl_record_bytes = 50, written_header_size = 84;

void put_word(char* to, std::uint32_t word) {
    for (int i = 0; i < 4; ++i)
        to[i] = char(word >> (8 * i) & 0xFF);
}

void put_vector(char* to, const Vec3& v) {
    for (int i = 0; i < 3; ++i)
        put_word(to + 4 * i, std::bit_cast<std::uint32_t>(float(v[i])));
}

} // namespace

StlStream::StlStream(OutputFile& file, LengthUnit unit)
    : file_(&file), name_(printable(file.target().string(), 400)), mm_(mm_per(unit)) {
    std::array<char, written_header_size> header{};
    // Not "solid": that would look like a text.
    const std::string title = "facetmill binary STL, " + std::string(unit_name(unit));
    std::memcpy(header.data(), title.data(), title.size());
    file_->write({header.data(), header.size()});
    buffer_.reserve(facets_per_write * stl_record_bytes);
}

void StlStream::add(const Vec3& a, const Vec3& b, const Vec3& c, std::uint16_t attribute) {
    if (++count_ >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::too_large, name_, "an STL file holds at most 4 294 967 294 facets",
                    "write the part in pieces");
    std::array<char, stl_record_bytes> bytes{};
    const Vec3 cross = (b - a).cross(c - a);
    const double length = cross.norm();
    put_vector(bytes.data(), length > 0 ? Vec3(cross / length) : Vec3(Vec3::Zero()));
    for (int k = 0; k < 3; ++k) {
        const Vec3 corner = (k == 0 ? a : k == 1 ? b : c) / mm_;
        if (!corner.allFinite() || corner.cwiseAbs().maxCoeff() > double(std::numeric_limits<float>::max()))
            throw Error(corner.allFinite() ? ErrorCode::coordinate_range : ErrorCode::non_finite,
                        name_ + ", facet " + std::to_string(count_), "a corner cannot be written as a float",
                        "nothing was written");
        put_vector(bytes.data() + 12 + 12 * k, corner);
    }
    bytes[stl_record_bytes - 2] = char(attribute & 0xFF);
    bytes[stl_record_bytes - 1] = char(attribute >> 8);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    if (buffer_.size() >= facets_per_write * stl_record_bytes) flush();
}

void StlStream::flush() {
    file_->write({buffer_.data(), buffer_.size()});
    buffer_.clear();
}

void StlStream::finish() {
    flush();
    std::array<char, 4> count;
    put_word(count.data(), std::uint32_t(count_));
    file_->overwrite(written_header_size - count.size(), {count.data(), count.size()});
}

void write_stl(const Mesh& mesh, OutputFile& file, LengthUnit unit, const Progress& progress) {
    if (mesh.facets.empty())
        throw Error(ErrorCode::no_facets, printable(file.target().string(), 400),
                    "the mesh to write has no facet", "nothing was written");
    StlStream stl(file, unit);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        if (f % facets_per_write == 0) progress.set(double(f) / double(mesh.facets.size()));
        stl.add(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
    }
    stl.finish();
    progress.check();
}

void save_stl(const Mesh& mesh, const std::filesystem::path& path, LengthUnit unit,
              const Progress& progress) {
    OutputFile file(path);
    write_stl(mesh, file, unit, progress);
    file.commit();
}

} // namespace facetmill
