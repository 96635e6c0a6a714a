// stock.stl, deviation.vtp and verify.json.
#include "core/base/file.h"
#include "core/job/new_folder.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/verify/stock_surface.h"

#include <bit>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little,
              "VTK files are written in the machine's byte order");

constexpr std::size_t values_per_write = std::size_t(1) << 16;

/// VTK's XML PolyData with its arrays appended as they are in memory.
class VtpWriter {
public:
    VtpWriter(OutputFile& file, const Progress& progress) : file_(&file), progress_(progress) {}

    /// One array of n values; `value(i)` gives the i-th.
    template <class T, class Value>
    void add(const char* type, const char* name, int components, std::size_t n, Value value) {
        declared_.push_back(std::string("<DataArray type=\"") + type + "\" Name=\"" + name
                            + "\" NumberOfComponents=\"" + std::to_string(components)
                            + "\" format=\"appended\" offset=\"" + std::to_string(offset_) + "\"/>");
        offset_ += sizeof(std::uint64_t) + n * sizeof(T);
        arrays_.push_back([this, n, value] {
            put(std::uint64_t(n * sizeof(T)));
            std::vector<T> block;
            for (std::size_t begin = 0; begin < n; begin += values_per_write) {
                progress_.check();
                block.clear();
                for (std::size_t i = begin; i < std::min(n, begin + values_per_write); ++i)
                    block.push_back(value(i));
                file_->write({reinterpret_cast<const char*>(block.data()), block.size() * sizeof(T)});
            }
        });
    }
    const std::string& declared(std::size_t i) const { return declared_[i]; }
    void finish(const std::string& head) {
        file_->write(head);
        for (const auto& array : arrays_)
            array();
        file_->write("\n  </AppendedData>\n</VTKFile>\n");
    }

private:
    void put(std::uint64_t v) { file_->write({reinterpret_cast<const char*>(&v), sizeof v}); }
    OutputFile* file_;
    Progress progress_;
    std::vector<std::string> declared_;
    std::vector<std::function<void()>> arrays_;
    std::uint64_t offset_ = 0;
};

void write_vtp(const DeviationSurface& s, OutputFile& file, double per, const Progress& progress) {
    VtpWriter vtp(file, progress);
    const std::size_t n = s.points.size(), m = s.triangles.size();
    vtp.add<float>("Float32", "Points", 3, 3 * n,
                   [&](std::size_t i) { return float(s.points[i / 3][i % 3] / per); });
    vtp.add<float>("Float32", "Normals", 3, 3 * n, [&](std::size_t i) { return s.normals[i / 3][i % 3]; });
    vtp.add<float>("Float32", "deviation", 1, n, [&](std::size_t i) { return float(s.deviation[i] / per); });
    vtp.add<std::uint8_t>("UInt8", "flag", 1, n, [&](std::size_t i) { return s.flags[i]; });
    vtp.add<std::int64_t>("Int64", "connectivity", 1, 3 * m,
                          [&](std::size_t i) { return std::int64_t(s.triangles[i / 3][i % 3]); });
    vtp.add<std::int64_t>("Int64", "offsets", 1, m, [&](std::size_t i) { return std::int64_t(3 * (i + 1)); });
    vtp.finish(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "  <PolyData>\n    <Piece NumberOfPoints=\""
        + std::to_string(n)
        + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
        + std::to_string(m) + "\">\n      <Points>" + vtp.declared(0)
        + "</Points>\n      <PointData Scalars=\"deviation\" Normals=\"Normals\">" + vtp.declared(1)
        + vtp.declared(2) + vtp.declared(3) + "</PointData>\n      <Polys>" + vtp.declared(4)
        + vtp.declared(5) + "</Polys>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _");
}

} // namespace

void add_verification(OutputSet& files, const Project& project, const Verification& result,
                      const fs::path& stock, const fs::path& deviation, const Progress& progress) {
    for (const fs::path& path : {stock, deviation})
        keep_inputs(project, path);
    StlStream stl(files.add(stock), project.unit);
    stock_triangles(
        *result.stock, [&](const Vec3& a, const Vec3& b, const Vec3& c) { stl.add(a, b, c); },
        progress.part(0.0, 0.7, "Writing the stock"));
    stl.finish();
    write_vtp(*result.surface, files.add(deviation), mm_per(project.unit), progress.part(0.7, 1.0));
}

std::vector<fs::path> write_verification(const Project& project, std::span<const VerifyProgram> programs,
                                         const Verification& result, const fs::path& folder,
                                         const Progress& progress, const std::function<void()>& before) {
    const NewFolder made(folder);
    OutputSet files;
    const std::vector<fs::path> paths = {folder / "stock.stl", folder / "deviation.vtp",
                                         folder / "verify.json"};
    add_verification(files, project, result, paths[0], paths[1], progress);
    keep_inputs(project, paths[2]);
    files.add(paths[2]).write(verify_json(project, programs, result));
    progress.check();
    files.commit(before);
    return paths;
}

} // namespace facetmill
