// Time and memory of loading a binary STL file (and the same part as ASCII, OBJ): a closed, wavy torus with a
// million facets, written to a temporary folder first. Each load runs in a process of its own, so that its
// peak memory is its own.
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh_io.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace facetmill;

namespace {

Mesh make_torus(std::size_t around, std::size_t across) {
    Mesh mesh;
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t j = 0; j < across; ++j) {
            const double u = 2 * pi * double(i) / double(around), v = 2 * pi * double(j) / double(across);
            const double r = 12 + std::sin(9 * u) * std::cos(5 * v);
            mesh.vertices.emplace_back((40 + r * std::cos(v)) * std::cos(u),
                                       (40 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
        }
    const auto vertex = [&](std::size_t i, std::size_t j) { return Index(i % around * across + j % across); };
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t j = 0; j < across; ++j) {
            mesh.facets.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.facets.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

void write_ascii(const Mesh& mesh, const std::filesystem::path& path) {
    OutputFile file(path);
    std::string text = "solid torus\n";
    char line[160];
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec3 n = mesh.facet_normal(f);
        std::snprintf(line, sizeof line, "facet normal %.6e %.6e %.6e\n outer loop\n", n.x(), n.y(), n.z());
        text += line;
        for (int k = 0; k < 3; ++k) {
            const Vec3& p = mesh.corner(f, k);
            std::snprintf(line, sizeof line, "  vertex %.6e %.6e %.6e\n", p.x(), p.y(), p.z());
            text += line;
        }
        text += " endloop\nendfacet\n";
        if (text.size() > (1u << 20)) {
            file.write(text);
            text.clear();
        }
    }
    file.write(text + "endsolid torus\n");
    file.commit();
}

void write_obj(const Mesh& mesh, const std::filesystem::path& path) {
    OutputFile file(path);
    char line[120];
    std::string text;
    for (const Vec3& p : mesh.vertices) {
        std::snprintf(line, sizeof line, "v %.7g %.7g %.7g\n", p.x(), p.y(), p.z());
        text += line;
    }
    for (const Facet& f : mesh.facets) {
        std::snprintf(line, sizeof line, "f %u %u %u\n", f[0] + 1, f[1] + 1, f[2] + 1);
        text += line;
    }
    file.write(text);
    file.commit();
}

/// Loads in a child process and prints one line; false when that failed.
bool measure(const std::filesystem::path& path, int threads) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child == 0) {
        set_thread_count(threads);
        struct ::rusage usage {};
        ::getrusage(RUSAGE_SELF, &usage);
        const double base = double(usage.ru_maxrss) * 1024.0;
        const auto start = std::chrono::steady_clock::now();
        const LoadedMesh loaded = load_mesh(path, LengthUnit::mm, Progress());
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        ::getrusage(RUSAGE_SELF, &usage);
        const double facets = double(loaded.report.facets);
        std::printf("%-12s %8d %12zu %10.3f %14.0f %14.0f\n", loaded.report.format.c_str(), threads,
                    loaded.report.facets, seconds.count(), double(usage.ru_maxrss) * 1024.0 / facets,
                    (double(usage.ru_maxrss) * 1024.0 - base) / facets);
        std::fflush(stdout);
        ::_exit(loaded.report.watertight ? 0 : 1);
    }
    int status = 1;
    return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
}

} // namespace

int main(int argc, char** argv) {
    const double facets = argc > 1 ? std::atof(argv[1]) : 1e6;
    const auto side = std::size_t(std::max(3.0, std::sqrt(facets / 2)));
    std::string folder_name = (std::filesystem::temp_directory_path() / "facetmill-bench-XXXXXX").string();
    if (!::mkdtemp(folder_name.data())) return 1;
    const std::filesystem::path folder = folder_name;
    bool good = true;
    try {
        {
            const pid_t writer = ::fork(); // its memory must not count as the loader's
            if (writer == 0) {
                const Mesh mesh = make_torus(side, side);
                save_stl(mesh, folder / "torus.stl", LengthUnit::mm, Progress());
                write_ascii(mesh, folder / "ascii.stl");
                write_obj(mesh, folder / "torus.obj");
                ::_exit(0);
            }
            int status = 1;
            good = writer > 0 && ::waitpid(writer, &status, 0) == writer && status == 0;
        }
        std::printf("%-12s %8s %12s %10s %14s %14s\n", "format", "threads", "facets", "seconds",
                    "peak B/facet", "of it loading");
        for (const char* name : {"torus.stl", "ascii.stl", "torus.obj"})
            for (const int threads : {1, 2})
                good = good && measure(folder / name, threads);
    } catch (const Error& e) {
        std::fprintf(stderr, "%s\n", e.what());
        good = false;
    }
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return good ? 0 : 1;
}
