#include "core/mesh/mesh_report.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace facetmill {

namespace {

struct Sentence {
    const char* word;
    const char* text;
};

constexpr Sentence sentences[] = {
    {"attribute_data",
     "The attribute words of the binary STL file are not zero (colours of some writers); they were ignored."},
    {"attribute_payload", "Bytes follow every facet of the binary STL file, as many as its attribute word "
                          "says; they were skipped."},
    {"bad_normals", "Some stored normals are missing or not numbers; normals are computed from the corners, "
                    "so nothing is lost."},
    {"big_endian", "The binary STL file has its bytes in reverse order; it was read accordingly."},
    {"binary_solid_header",
     "The binary STL file starts with the word 'solid' like a text; it was read as binary."},
    {"chord_exceeded",
     "Some facets lie farther from their surface than the chord tolerance that was asked for; the "
     "deviation says how far."},
    {"coarse_resolution", "The part lies so far from the origin (or is so large) that 32-bit coordinates are "
                          "more than 0.01 mm apart; export it near the origin."},
    {"comma_decimal", "Numbers have decimal commas; they were read as such."},
    {"count_wrong",
     "The facet count in the header is wrong; the facets up to the end of the file were read."},
    {"degenerate_facets", "Some facets have no area (equal or collinear corners); they were left out."},
    {"duplicate_facets", "Some facets occur more than once, in this or the other winding; all were kept."},
    {"empty_solid", "A solid without facets is in the file; it was ignored."},
    {"free_form_ignored", "The OBJ file has curves or surfaces beside its facets; they were ignored."},
    {"inconsistent_winding", "Neighbouring facets run along their common edge in the same direction: some "
                             "are turned over. None was turned back."},
    {"inside_out", "The mesh is closed but wound inside out; it was left so. Cutter contact does not depend "
                   "on the winding."},
    {"lines_ignored", "The file has points or lines beside its facets; they were ignored."},
    {"loose_surfaces", "Surfaces of the file belong to no solid; they were taken as sheets."},
    {"missing_endsolid",
     "The word endsolid is missing; the mesh is closed, so the file was taken as complete."},
    {"multiple_shells", "The mesh consists of several pieces that share no edge; all are machined."},
    {"multiple_solids", "The file has several solids; their facets were put together."},
    {"non_manifold_edges", "Some edges have more than two facets; all facets were kept."},
    {"normals_disagree",
     "Some stored normals point against the winding of their facets; the winding counts."},
    {"objects_left_out",
     "Objects of the file that are no part of the model (supports, modifiers) were left out."},
    {"open_edges", "Some edges have only one facet: the mesh is a sheet or has gaps. Nothing was healed; a "
                   "cutter may enter a gap."},
    {"picture_colours",
     "The picture has colours: their brightness (0.2126 red, 0.7152 green, 0.0722 blue) is the height."},
    {"picture_pages", "The file has further pictures; the first was read."},
    {"picture_reduced", "The picture has more pixels than a mesh of it may have points (4 million): each "
                        "point is a mean of the pixels around it."},
    {"picture_size_assumed", "A picture does not say how large it is: where the job does not either, it was "
                             "taken as 100 mm wide and 5 mm high."},
    {"picture_steps", "The picture has 256 levels of grey or fewer, which become steps of the surface; "
                      "smoothing takes them away."},
    {"picture_transparent",
     "Parts of the picture are transparent: the more so, the nearer they lie to the ground."},
    {"polygons_folded", "Some polygons cross themselves; they were cut into triangles that overlap."},
    {"polygons_triangulated", "Polygons with more than three corners were cut into triangles."},
    {"scaled", "The project scales the part: it is not as large as its file and unit say."},
    {"several_bodies", "The file has several parts or solids; all are in their places."},
    {"shapes_at_rest",
     "The file moves its meshes by bones, or into other shapes: they were read as they are modelled."},
    {"slices_ignored",
     "Objects have slices beside their mesh, which may be a coarse stand-in for them; the mesh was read."},
    {"surfaces_joined", "Surfaces that lie edge to edge within the chord tolerance were joined: the file "
                        "does not say that they hang together."},
    {"surfaces_missing", "Some surfaces of the file could not be tessellated: the mesh has gaps."},
    {"trailing_data", "Bytes follow the end of the mesh; they were ignored."},
    {"unit_differs",
     "The file states its own unit, which is not the one that the job says: that of the file counts."},
    {"unit_suspect", "The part is smaller than 1 mm or larger than 10 m: the file may be in another unit."},
    {"unknown_lines", "Lines that the format does not know were ignored."},
    {"unterminated_line",
     "The last line has no line end: the file may have been cut. It was read as it stands."},
    {"weights_ignored", "Vertices have rational weights other than 1; they were ignored."},
    {"y_up_turned", "Files of this format have Y pointing up: the part was turned so that Z does."},
};

/// Sets of things that are joined, from any number of threads: the root of a set is its smallest number, so
/// the sets do not depend on the order of joining.
class JoinedSets {
public:
    explicit JoinedSets(std::size_t count) : parent_(count) {
        for (std::size_t i = 0; i < count; ++i)
            parent_[i].store(Index(i), std::memory_order_relaxed);
    }
    void join(Index a, Index b) {
        for (;;) {
            a = root(a);
            b = root(b);
            if (a == b) return;
            if (a < b) std::swap(a, b);
            Index expected = a;
            if (parent_[a].compare_exchange_weak(expected, b, std::memory_order_relaxed)) return;
        }
    }
    bool is_root(std::size_t i) const { return parent_[i].load(std::memory_order_relaxed) == i; }

private:
    Index root(Index i) {
        for (;;) {
            Index up = parent_[i].load(std::memory_order_relaxed);
            if (up == i) return i;
            const Index further = parent_[up].load(std::memory_order_relaxed);
            if (further != up) parent_[i].compare_exchange_weak(up, further, std::memory_order_relaxed);
            i = further;
        }
    }
    std::vector<std::atomic<Index>> parent_;
};

struct EdgeCounts {
    std::size_t duplicate = 0, open = 0, non_manifold = 0, inconsistent = 0;

    EdgeCounts& operator+=(const EdgeCounts& o) {
        duplicate += o.duplicate;
        open += o.open;
        non_manifold += o.non_manifold;
        inconsistent += o.inconsistent;
        return *this;
    }
};

/// What the edges tell: counts, facets joined to shells, corners joined to the fans around their vertex.
class EdgeCensus {
public:
    EdgeCensus(const Mesh& mesh, JoinedSets& shells, JoinedSets& fans)
        : mesh_(mesh), shells_(shells), fans_(fans) {}

    /// `sides` are those of the edge between `low` and `high`.
    void count(Index low, Index high, std::span<const EdgeSide> sides, EdgeCounts& counts) {
        join_fans(low, high, sides);
        if (low == high) return; // no edge: a facet that names a vertex twice
        const auto leaves = [&](const EdgeSide& s) { return side_start(mesh_, s.side) == low; };
        counts.open += sides.size() == 1;
        counts.non_manifold += sides.size() > 2;
        counts.inconsistent += sides.size() == 2 && leaves(sides[0]) == leaves(sides[1]);
        if (sides.size() == 1) return;
        for (std::size_t i = 1; i < sides.size(); ++i)
            shells_.join(sides[0].facet(), sides[i].facet());
        // A corner set a < b < c is looked for at its edge a-b only.
        thirds_.clear();
        for (const EdgeSide& s : sides)
            if (side_across(mesh_, s.side) > high) thirds_.push_back(side_across(mesh_, s.side));
        std::sort(thirds_.begin(), thirds_.end());
        for (std::size_t i = 1; i < thirds_.size(); ++i)
            counts.duplicate += thirds_[i] == thirds_[i - 1];
    }

private:
    /// The corner 3 f + k is named by the side that starts at it.
    void join_fans(Index low, Index high, std::span<const EdgeSide> sides) {
        const auto corner_at = [&](const EdgeSide& s, Index vertex) {
            return side_start(mesh_, s.side) == vertex ? s.side : 3 * s.facet() + (s.corner() + 1) % 3;
        };
        if (low == high)
            for (const EdgeSide& s : sides)
                fans_.join(s.side, 3 * s.facet() + (s.corner() + 1) % 3);
        for (std::size_t i = 1; i < sides.size(); ++i) {
            fans_.join(corner_at(sides[0], low), corner_at(sides[i], low));
            if (high != low) fans_.join(corner_at(sides[0], high), corner_at(sides[i], high));
        }
    }

    const Mesh& mesh_;
    JoinedSets &shells_, &fans_;
    std::vector<Index> thirds_;
};

struct Connections {
    EdgeCounts edges;
    std::size_t shells = 0;
    std::size_t used_vertices = 0;  ///< that a facet names
    std::size_t split_vertices = 0; ///< whose facets form more than one fan
};

Connections connections_of(const Mesh& mesh, const Progress& progress) {
    const std::size_t facets = mesh.facet_count();
    JoinedSets shells(facets), fans(3 * facets);
    const EdgeTable table(mesh, progress.part(0.0, 0.5));
    Connections found;
    found.edges = parallel_reduce(
        table.vertex_count(), 4096, EdgeCounts{}, progress.part(0.5, 0.9),
        [&](std::size_t first, std::size_t last) {
            EdgeCounts counts;
            EdgeCensus census(mesh, shells, fans);
            for (std::size_t v = first; v < last; ++v)
                table.for_edges(v, [&](Index high, std::span<const EdgeSide> sides) {
                    census.count(Index(v), high, sides, counts);
                });
            return counts;
        },
        [](EdgeCounts total, const EdgeCounts& part) { return total += part; });
    enum : std::uint8_t { unused, one_fan, more_fans };
    std::vector<std::uint8_t> around(mesh.vertices.size(), unused);
    for (std::size_t f = 0; f < facets; ++f) {
        if ((f & 0xFFFF) == 0) progress.check();
        found.shells += shells.is_root(f);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!fans.is_root(3 * f + k)) continue;
            std::uint8_t& at = around[mesh.facets[f][k]];
            at = at == unused ? one_fan : more_fans;
        }
    }
    for (const std::uint8_t at : around) {
        found.used_vertices += at != unused;
        found.split_vertices += at == more_fans;
    }
    return found;
}

/// Sums over the facets, about `center`.
struct Integrals {
    double volume = 0.0, area = 0.0;
    Vec3 area_vector = Vec3::Zero();
};

Integrals integrate(const Mesh& mesh, const Vec3& center, const Progress& progress) {
    return parallel_reduce(
        mesh.facets.size(), 16384, Integrals{}, progress,
        [&](std::size_t first, std::size_t last) {
            Integrals sum;
            for (std::size_t f = first; f < last; ++f) {
                const Vec3 a = mesh.corner(f, 0) - center;
                const Vec3 cross = mesh.facet_cross(f);
                sum.volume += a.dot(cross);
                sum.area += cross.norm();
                sum.area_vector += cross;
            }
            return sum;
        },
        [](Integrals total, const Integrals& part) {
            total.volume += part.volume;
            total.area += part.area;
            total.area_vector += part.area_vector;
            return total;
        });
}

} // namespace

Box3 MeshReport::box_mm() const {
    Box3 box = file_box;
    box.lo *= mm_per(assumed_unit);
    box.hi *= mm_per(assumed_unit);
    return box;
}

namespace {

/// A part of such an extent (mm) is rare.
bool is_suspect(double extent) {
    return extent < tolerance::suspect_small_extent || extent > tolerance::suspect_large_extent;
}

} // namespace

std::string units_guess_name(const MeshReport& report) {
    return std::string(unit_name(report.unit_guess));
}

void add_scale_warnings(MeshReport& report, const Box3& box) {
    auto& words = report.warnings;
    std::erase(words, "unit_suspect");
    words.emplace_back("scaled");
    if (is_suspect(box.size().maxCoeff()) && !report.is_relief) words.emplace_back("unit_suspect");
    std::sort(words.begin(), words.end());
}

std::string explain_warning(const std::string& word) {
    for (const Sentence& s : sentences)
        if (word == s.word) return s.text;
    return {};
}

std::vector<std::string> warning_words() {
    std::vector<std::string> words;
    for (const Sentence& s : sentences)
        words.emplace_back(s.word);
    return words;
}

void analyse_mesh(const Mesh& mesh, MeshReport& report, const Progress& progress) {
    const double mm = mm_per(report.assumed_unit);
    const std::size_t facet_count = mesh.facets.size();
    const Connections found = connections_of(mesh, progress.part(0.0, 0.85));
    const EdgeCounts& edges = found.edges;
    report.shells = found.shells;
    report.duplicate = edges.duplicate;
    report.open_edges = edges.open;
    report.non_manifold_edges = edges.non_manifold;
    report.inconsistent_edges = edges.inconsistent;
    report.non_manifold_vertices = found.split_vertices;
    report.watertight =
        facet_count > 0 && edges.open == 0 && edges.non_manifold == 0 && edges.inconsistent == 0;
    report.vertices = mesh.vertices.size();
    if (report.facets == 0) report.facets = facet_count;
    if (report.welded_vertices == 0) report.welded_vertices = found.used_vertices;

    Box3 box = report.box_mm();
    if (report.file_box.empty()) {
        box = mesh.box();
        if (!box.empty()) {
            report.file_box.lo = box.lo / mm;
            report.file_box.hi = box.hi / mm;
        }
    }
    // About the middle of the part, where rounding is least. The volume about the origin of coordinates
    // differs by the sum of the area vectors, which vanishes for a closed mesh.
    const Vec3 center = box.empty() ? Vec3(Vec3::Zero()) : box.center();
    const Integrals sum = integrate(mesh, center, progress.part(0.85, 1.0));
    double volume = sum.volume / 6.0;
    if (!report.watertight) volume += center.dot(sum.area_vector) / 6.0;
    report.file_volume = volume / (mm * mm * mm);
    report.file_area = 0.5 * sum.area / (mm * mm);

    const double extent = box.size().maxCoeff();
    const double numbers = extent / mm;
    report.unit_guess = report.unit_known || report.is_relief ? report.assumed_unit
                        : numbers < guess_metre_below         ? LengthUnit::m
                        : numbers < guess_inch_below          ? LengthUnit::inch
                                                              : LengthUnit::mm;

    const auto warn = [&](bool condition, const char* word) {
        if (condition) report.warnings.emplace_back(word);
    };
    warn(report.degenerate > 0, "degenerate_facets");
    warn(report.duplicate > 0, "duplicate_facets");
    warn(report.open_edges > 0 && !report.is_relief, "open_edges"); // a relief is a sheet
    warn(report.non_manifold_edges > 0, "non_manifold_edges");
    warn(report.inconsistent_edges > 0, "inconsistent_winding");
    warn(report.shells > 1, "multiple_shells");
    warn(report.open_edges == 0 && volume < -tolerance::flat_volume * 0.5 * sum.area * box.diagonal(),
         "inside_out");
    warn(facet_count > 0 && is_suspect(extent) && !report.is_relief, "unit_suspect");
    std::sort(report.warnings.begin(), report.warnings.end());
    report.warnings.erase(std::unique(report.warnings.begin(), report.warnings.end()), report.warnings.end());
}

} // namespace facetmill
