#include "core/gouge/contact_index.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/round_outward.h"
#include "core/base/tolerances.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/facet_duties.h"
#include "core/gouge/vertex_slopes.h"

#include <cmath>
#include <span>
#include <utility>

namespace facetmill {

namespace {

/// A facet, or a piece of one, on its way into a block: its middle, for splitting only.
struct Item {
    float at[3];
    Index facet;
    std::uint16_t piece, pieces;
};

struct Range {
    std::size_t begin, end;
};

/// A facet is listed in pieces where its box in the plan is so many times as large as it is; in so many at
/// most; and so many more than there are facets altogether.
constexpr double worth_pieces = 16, max_pieces = 8, max_more_pieces = 1e6;

/// Splits [begin, end) at `middle` across the widest extent of the middles. Equal keys are ordered by facet,
/// so that the two halves do not depend on the algorithm.
void split(LargeVector<Item>& items, std::size_t begin, std::size_t middle, std::size_t end) {
    float lo[3], hi[3];
    for (int k = 0; k < 3; ++k)
        lo[k] = hi[k] = items[begin].at[k];
    for (std::size_t i = begin; i < end; ++i)
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], items[i].at[k]);
            hi[k] = std::max(hi[k], items[i].at[k]);
        }
    int widest = 0;
    for (int k = 1; k < 3; ++k)
        if (hi[k] - lo[k] > hi[widest] - lo[widest]) widest = k;
    const auto at = [&](std::size_t i) { return items.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(begin), at(middle), at(end), [widest](const Item& a, const Item& b) {
        if (a.at[widest] != b.at[widest]) return a.at[widest] < b.at[widest];
        return a.facet != b.facet ? a.facet < b.facet : a.piece < b.piece;
    });
}

std::size_t blocks_of(const Range& range) {
    return (range.end - range.begin + block_width - 1) / block_width;
}

/// Divides a range into `count` parts of about as many blocks, at whole blocks; adds them to `parts`.
void divide(LargeVector<Item>& items, const Range& range, std::size_t count,
            std::array<Range, block_width>& parts, std::size_t& size) {
    if (count == 1) {
        parts[size++] = range;
        return;
    }
    const std::size_t left = count / 2, left_blocks = (blocks_of(range) * left + count - 1) / count;
    const std::size_t middle = range.begin + left_blocks * block_width;
    split(items, range.begin, middle, range.end);
    divide(items, {range.begin, middle}, left, parts, size);
    divide(items, {middle, range.end}, count - left, parts, size);
}

/// Parts of a node's range for its children: as few as the tree below can hold when its nodes are full. So
/// nodes that are not full are near the root, where there are few.
std::size_t split_for_children(LargeVector<Item>& items, const Range& range,
                               std::array<Range, block_width>& parts) {
    const std::size_t blocks = blocks_of(range);
    std::size_t capacity = 1; // of a child, in blocks
    while (capacity * block_width < blocks)
        capacity *= block_width;
    std::size_t size = 0;
    divide(items, range, (blocks + capacity - 1) / capacity, parts, size);
    return size;
}

void fill_block(FacetBlock& block, const Mesh& mesh, const std::vector<std::uint8_t>& duties,
                const LargeVector<Item>& items, std::size_t begin, std::size_t end) {
    block = {};
    for (std::size_t lane = 0; lane < block_width; ++lane) {
        block.facet[lane] = no_index;
        if (begin + lane >= end) { // out of reach of every cutter
            block.x[0][lane] = block.x[1][lane] = block.x[2][lane] = tolerance::nowhere;
            continue;
        }
        const Index f = items[begin + lane].facet;
        double longest = -1;
        std::size_t turned = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double length =
                (mesh.corner(f, int((k + 1) % 3)) - mesh.corner(f, int(k))).head<2>().squaredNorm();
            if (length > longest) {
                longest = length;
                turned = k;
            }
        }
        const std::uint8_t duty = duties[f];
        std::uint8_t mine = duty & duty_plane;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t source = (k + turned) % 3;
            const Vec3& p = mesh.corner(f, int(source));
            block.x[k][lane] = p.x();
            block.y[k][lane] = p.y();
            block.z[k][lane] = p.z();
            for (const unsigned bit : {duty_edge, duty_edge_anyway})
                if (duty & (bit << source)) mine |= std::uint8_t(bit << k);
        }
        block.facet[lane] = f;
        block.duty[lane] = mine;
        block.turned[lane] = std::uint8_t(turned);
    }
}

/// The corners of a facet, or of a piece of one: what lies between two planes across its longer side in the
/// plan, and a little more, so that the pieces hold all of it.
constexpr std::size_t max_piece_corners = 5;
class PieceCorners {
public:
    PieceCorners(const Mesh& mesh, const Item& item) {
        for (int k = 0; k < 3; ++k)
            corners_[std::size_t(k)] = mesh.corner(item.facet, k);
        if (item.pieces == 1) return;
        Box3 box;
        for (std::size_t k = 0; k < 3; ++k)
            box.add(corners_[k]);
        const int axis = box.size().x() >= box.size().y() ? 0 : 1;
        const double lo = box.lo[axis], length = box.size()[axis], more = 1e-9 * length;
        const auto at = [&](int piece) { return lo + length * (double(piece) / item.pieces); };
        clip(axis, 1, at(item.piece) - more);
        clip(axis, -1, -(at(item.piece + 1) + more));
    }
    std::size_t count() const { return count_; }
    const Vec3& operator[](std::size_t k) const { return corners_[k]; }
    Vec3 middle() const {
        Box3 box;
        for (std::size_t k = 0; k < count_; ++k)
            box.add(corners_[k]);
        return box.center();
    }

private:
    /// Keeps what has sign * p[axis] >= least.
    void clip(int axis, double sign, double least) {
        const std::array<Vec3, max_piece_corners> before = corners_;
        const std::size_t n = std::exchange(count_, 0);
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 &a = before[k], &b = before[(k + 1) % n];
            const double da = sign * a[axis] - least, db = sign * b[axis] - least;
            if (da >= 0) corners_[count_++] = a;
            if ((da >= 0) != (db >= 0)) corners_[count_++] = a + da / (da - db) * (b - a);
        }
    }

    std::array<Vec3, max_piece_corners> corners_;
    std::size_t count_ = 3;
};

/// A plane over a box: no higher than z + x (at.x - mx) + y (at.y - my), with (mx, my) the middle of the box.
struct Roof {
    double z = 0, x = 0, y = 0;
};

/// Two planes about a box: -below <= normal . (q - middle) <= above for all q in it. The normal is made of
/// floats, a unit vector but for their rounding; zero: none.
struct Slab {
    Vec3 normal = Vec3::Zero();
    double above = 0, below = 0;
};

/// Two upright planes about a box: lo <= across . (q - middle) <= hi for all q in it. `turned`: the sum of
/// the squares of the facets' longest edges, as complex numbers, whose direction has twice the angle of
/// theirs.
struct Strip {
    Vec2 turned = Vec2::Zero(), across = Vec2(1, 0);
    double lo = infinity, hi = -infinity;

    void add_edge(const Vec2& edge) {
        turned += Vec2(edge.x() * edge.x() - edge.y() * edge.y(), 2 * edge.x() * edge.y());
    }
    void find_across() {
        if (turned == Vec2::Zero()) return;
        const double angle = 0.5 * std::atan2(turned.y(), turned.x());
        across = Vec2(-std::sin(angle), std::cos(angle));
    }
    void add(double from, double to) {
        lo = std::min(lo, from);
        hi = std::max(hi, to);
    }
};

/// What a node knows of a child, relative to the index's origin.
struct Cover {
    Box3 box;
    Roof roof;
    Slab slab;
    SlopeRange slopes = SlopeRange::none();
    double highest = -infinity; ///< z of the facets' corners themselves
    Strip strip;
};

/// Sums up normals whose sign says nothing, as the winding of a scan may not.
class NormalSum {
public:
    void add(const Vec3& n) { sum_ += sum_.dot(n) < 0 ? Vec3(-n) : n; }
    /// Made of floats; zero where nothing is left.
    Vec3 normal() const {
        const double length = sum_.norm();
        if (!(length > 0)) return Vec3::Zero();
        return rounded_to_float(sum_ / length);
    }

private:
    Vec3 sum_ = Vec3::Zero();
};

/// The plane with these slopes over all points, or the level one where that is lower in the middle. Points
/// (and `level`, the highest of them) relative to the middle.
template <class HighestOver>
Roof lower_roof(double slope_x, double slope_y, double level, HighestOver&& highest_over) {
    const double steep = tolerance::steepest_roof;
    if (!(std::abs(slope_x) <= steep && std::abs(slope_y) <= steep)) return {level, 0, 0};
    const double x = double(float(slope_x)), y = double(float(slope_y)), z = highest_over(x, y);
    return z < level ? Roof{z, x, y} : Roof{level, 0, 0};
}

Cover cover_of(std::span<const Item> items, const Vec3& origin, const Mesh& mesh,
               const std::vector<SlopeRange>& vertex_slopes) {
    Cover cover;
    std::array<Vec3, max_piece_corners * block_width> points;
    std::size_t n = 0;
    NormalSum normals;
    for (const Item& item : items) {
        for (const Index v : mesh.facets[item.facet]) {
            cover.slopes.add(vertex_slopes[v]);
            cover.highest = std::max(cover.highest, mesh.vertices[v].z());
        }
        const PieceCorners piece(mesh, item);
        for (std::size_t k = 0; k < piece.count(); ++k) {
            points[n] = piece[k] - origin;
            cover.box.add(points[n++]);
        }
        normals.add(mesh.facet_cross(item.facet));
        Vec2 longest = Vec2::Zero();
        for (int k = 0; k < 3; ++k) {
            const Vec2 edge = (mesh.corner(item.facet, (k + 1) % 3) - mesh.corner(item.facet, k)).head<2>();
            if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
        }
        cover.strip.add_edge(longest);
    }
    const Vec3 middle = cover.box.center();
    cover.strip.find_across();
    for (std::size_t i = 0; i < n; ++i) {
        const double aside = cover.strip.across.dot((points[i] - middle).head<2>());
        cover.strip.add(aside, aside);
    }
    cover.slab = {normals.normal(), -infinity, -infinity};
    for (std::size_t i = 0; i < n; ++i) {
        const double out = cover.slab.normal.dot(points[i] - middle);
        cover.slab.above = std::max(cover.slab.above, out);
        cover.slab.below = std::max(cover.slab.below, -out);
    }
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i)
        mean += points[i] / double(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = points[i] - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
        xz += d.x() * d.z();
        yz += d.y() * d.z();
    }
    const double det = xx * yy - xy * xy; // 0 gives no number, and that a level roof
    cover.roof = lower_roof((xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det, cover.box.hi.z(),
                            [&](double sx, double sy) {
                                double z = -infinity;
                                for (std::size_t i = 0; i < n; ++i)
                                    z = std::max(z, points[i].z() - sx * (points[i].x() - middle.x())
                                                        - sy * (points[i].y() - middle.y()));
                                return z;
                            });
    return cover;
}

/// What lies in a part's box and in its strip, `from_middle` away.
void add_part(Strip& strip, const Cover& part, const Vec2& from_middle) {
    const Vec2 half = 0.5 * part.box.size().head<2>(), &own = part.strip.across;
    const double middle = strip.across.dot(from_middle), by_box = strip.across.cwiseAbs().dot(half);
    const double same = strip.across.dot(own), other = strip.across.dot(Vec2(-own.y(), own.x()));
    const double along = std::abs(other) * Vec2(-own.y(), own.x()).cwiseAbs().dot(half);
    const double a = same * part.strip.lo, b = same * part.strip.hi;
    strip.add(middle + std::max(-by_box, std::min(a, b) - along),
              middle + std::min(by_box, std::max(a, b) + along));
}

Cover cover_of(const std::array<Cover, block_width>& parts, std::size_t n) {
    Cover cover;
    double slope_x = 0, slope_y = 0;
    NormalSum normals;
    for (std::size_t i = 0; i < n; ++i) {
        cover.box.add(parts[i].box);
        cover.slopes.add(parts[i].slopes);
        cover.highest = std::max(cover.highest, parts[i].highest);
        normals.add(parts[i].slab.normal);
        slope_x += parts[i].roof.x / double(n);
        slope_y += parts[i].roof.y / double(n);
        cover.strip.turned += parts[i].strip.turned;
    }
    const Vec3 middle = cover.box.center();
    cover.strip.find_across();
    for (std::size_t i = 0; i < n; ++i)
        add_part(cover.strip, parts[i], (parts[i].box.center() - middle).head<2>());
    const Vec3 normal = normals.normal();
    cover.slab = {normal, -infinity, -infinity};
    for (std::size_t i = 0; i < n; ++i) {
        const Slab& part = parts[i].slab;
        const Vec3 half = 0.5 * parts[i].box.size();
        const bool turned = part.normal.dot(normal) < 0;
        const double out = normal.dot(parts[i].box.center() - middle), by_box = normal.cwiseAbs().dot(half),
                     by_slab = (normal - (turned ? -1 : 1) * part.normal).cwiseAbs().dot(half);
        cover.slab.above =
            std::max(cover.slab.above, out + std::min(by_box, by_slab + (turned ? part.below : part.above)));
        cover.slab.below =
            std::max(cover.slab.below, -out + std::min(by_box, by_slab + (turned ? part.above : part.below)));
    }
    cover.roof = lower_roof(slope_x, slope_y, cover.box.hi.z(), [&](double sx, double sy) {
        double z = -infinity;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 at = parts[i].box.center(), half = 0.5 * parts[i].box.size();
            const Roof& roof = parts[i].roof;
            const double here = roof.z - sx * (at.x() - middle.x()) - sy * (at.y() - middle.y());
            z = std::max(z, here + std::abs(roof.x - sx) * half.x() + std::abs(roof.y - sy) * half.y());
        }
        return z;
    });
    return cover;
}

void set_child(TreeNode& node, std::size_t lane, const Cover& cover, Index child) {
    const Vec3 middle = cover.box.center();
    const auto half = [&](int k, float at) {
        return rounded_up(std::max(cover.box.hi[k] - double(at), double(at) - cover.box.lo[k]));
    };
    node.cx[lane] = float(middle.x());
    node.cy[lane] = float(middle.y());
    node.cz[lane] = float(middle.z());
    node.hx[lane] = half(0, node.cx[lane]);
    node.hy[lane] = half(1, node.cy[lane]);
    node.hz[lane] = half(2, node.cz[lane]);
    const Roof& roof = cover.roof;
    node.slope_x[lane] = float(roof.x); // they are floats
    node.slope_y[lane] = float(roof.y);
    node.roof[lane] = rounded_up(roof.z + roof.x * (double(node.cx[lane]) - middle.x())
                                 + roof.y * (double(node.cy[lane]) - middle.y()));
    const Slab& slab = cover.slab;
    const double shift = slab.normal.dot(middle - Vec3(node.cx[lane], node.cy[lane], node.cz[lane]));
    node.normal_x[lane] = float(slab.normal.x()); // they are floats
    node.normal_y[lane] = float(slab.normal.y());
    node.normal_z[lane] = float(slab.normal.z());
    node.above[lane] = rounded_up(slab.above + shift);
    node.below[lane] = rounded_up(slab.below - shift);
    node.slope_lo_x[lane] = cover.slopes.lo_x;
    node.slope_hi_x[lane] = cover.slopes.hi_x;
    node.slope_lo_y[lane] = cover.slopes.lo_y;
    node.slope_hi_y[lane] = cover.slopes.hi_y;
    node.highest[lane] = cover.highest;
    const Strip& strip = cover.strip;
    node.across_x[lane] = float(strip.across.x());
    node.across_y[lane] = float(strip.across.y());
    const double aside =
        strip.across.dot((middle - Vec3(node.cx[lane], node.cy[lane], node.cz[lane])).head<2>());
    // The direction is rounded: by less than its last digit, which at the box's corners is as much as this.
    const double turn = std::numeric_limits<float>::epsilon() * (double(node.hx[lane]) + node.hy[lane]);
    node.strip_lo[lane] = -rounded_up(turn - (strip.lo + aside));
    node.strip_hi[lane] = rounded_up(turn + strip.hi + aside);
    node.child[lane] = child;
}

void check_corners(const Mesh& mesh, std::size_t f) {
    for (int k = 0; k < 3; ++k) {
        if (mesh.facets[f][std::size_t(k)] >= mesh.vertices.size())
            throw Error(ErrorCode::internal, "facet " + std::to_string(f),
                        "names a vertex that does not exist", "report this");
        const Vec3& p = mesh.corner(f, k);
        const auto good = [](double v) {
            return std::abs(v) <= tolerance::largest_coordinate;
        }; // not for nan
        if (!good(p.x()) || !good(p.y()) || !good(p.z()))
            throw Error(ErrorCode::non_finite, "facet " + std::to_string(f),
                        "has a corner that is not finite or out of range",
                        "check the mesh's units and numbers");
    }
}

/// In how many pieces a facet is best listed: a box about a needle that lies askew in the plan holds little
/// of it, and boxes about its pieces hold little else.
double pieces_wanted(const Mesh& mesh, std::size_t f, double extent) {
    Box3 box;
    for (int k = 0; k < 3; ++k)
        box.add(mesh.corner(f, k));
    const double x = box.size().x(), y = box.size().y(), length = std::max(x, y);
    const double area = 0.5 * std::abs(mesh.facet_cross(f).z());
    if (!(x * y > worth_pieces * area)) return 1;
    const double by_waste = area > 0 ? std::sqrt(x * y / area) : max_pieces;
    return std::clamp(std::floor(std::min(by_waste, max_pieces * length / extent)), 1.0, max_pieces);
}

LargeVector<Item> listed_facets(const Mesh& mesh, const Progress& progress) {
    const std::size_t n = mesh.facet_count();
    std::vector<std::uint16_t> pieces(n, 1);
    parallel_for(n, 20000, progress.part(0, 0.3), [&](std::size_t f) { check_corners(mesh, f); });
    const Vec3 size = mesh.box().size();
    const double extent = std::max({size.x(), size.y(), tolerance::smallest_extent});
    const auto each = [&](auto&& call) { parallel_for(n, 20000, progress.part(0.3, 0.6), call); };
    each([&](std::size_t f) { pieces[f] = std::uint16_t(pieces_wanted(mesh, f, extent)); });
    double more = 0;
    for (const std::uint16_t p : pieces)
        more += p - 1;
    const double share = std::min(1.0, max_more_pieces / std::max(more, 1.0));
    if (share < 1)
        each([&](std::size_t f) { pieces[f] = std::uint16_t(1 + std::floor(share * (pieces[f] - 1))); });
    LargeVector<std::size_t> first(n + 1, 0);
    for (std::size_t f = 0; f < n; ++f)
        first[f + 1] = first[f] + pieces[f];
    LargeVector<Item> items(first[n]);
    parallel_for(n, 20000, progress.part(0.6, 1), [&](std::size_t f) {
        for (std::uint16_t k = 0; k < pieces[f]; ++k) {
            Item& item = items[first[f] + k];
            item = {{}, Index(f), k, pieces[f]};
            const Vec3 middle = PieceCorners(mesh, item).middle();
            for (int axis = 0; axis < 3; ++axis)
                item.at[axis] = float(middle[axis]);
        }
    });
    return items;
}

} // namespace

ContactIndex::~ContactIndex() = default;

std::size_t ContactIndex::memory() const {
    return sizeof(Impl) + impl_->blocks.capacity() * sizeof(FacetBlock)
           + impl_->nodes.capacity() * sizeof(TreeNode);
}

ContactIndex::ContactIndex(MeshPtr mesh, const Progress& progress) : mesh_(std::move(mesh)), impl_(new Impl) {
    if (mesh_->facet_count() == 0) return;
    if (mesh_->facet_count() > std::size_t(TreeNode::leaf) / 3)
        throw Error(ErrorCode::too_large, "mesh", "has more facets than the contact index can hold",
                    "use a mesh of at most " + std::to_string(TreeNode::leaf / 3) + " facets");
    std::vector<std::uint8_t> is_open;
    const std::vector<std::uint8_t> duties = facet_duties(*mesh_, progress.part(0, 0.4), &is_open);
    const std::vector<SlopeRange> slopes = vertex_slopes(*mesh_, is_open, progress.part(0.4, 0.45));
    LargeVector<Item> items = listed_facets(*mesh_, progress.part(0.45, 0.5));
    impl_->has_strips = items.size() > mesh_->facet_count();
    impl_->mostly_needles = items.size() > 2 * mesh_->facet_count();
    Box3 box;
    for (std::size_t f = 0; f < mesh_->facet_count(); ++f)
        for (int k = 0; k < 3; ++k)
            box.add(mesh_->corner(f, k));
    const Vec3 origin = box.center(), half = 0.5 * box.size();
    for (int k = 0; k < 3; ++k) {
        impl_->origin[std::size_t(k)] = origin[k];
        impl_->half_size[std::size_t(k)] = half[k];
    }

    // Top down, a level at a time: every range of a level is split by itself, then the children get their
    // places in the order of the ranges.
    struct Level {
        std::size_t first_node;
        std::vector<Range> ranges;
    };
    std::vector<Level> levels{{0, {{0, items.size()}}}};
    impl_->nodes.resize(1);
    const std::size_t whole_blocks = (items.size() + block_width - 1) / block_width;
    impl_->blocks.resize(whole_blocks);
    const Progress splitting = progress.part(0.5, 0.8), filling = progress.part(0.8, 0.9),
                   covering = progress.part(0.9, 1.0);
    for (;;) {
        const std::vector<Range>& ranges = levels.back().ranges;
        std::vector<std::array<Range, block_width>> parts(ranges.size());
        std::vector<std::size_t> counts(ranges.size());
        parallel_for(ranges.size(), 1, splitting,
                     [&](std::size_t i) { counts[i] = split_for_children(items, ranges[i], parts[i]); });
        Level next{impl_->nodes.size(), {}};
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            TreeNode node{};
            for (std::size_t lane = 0; lane < block_width; ++lane) {
                node.hx[lane] = node.hy[lane] = node.hz[lane] = -std::numeric_limits<float>::infinity();
                node.highest[lane] = -infinity;
                node.child[lane] = no_index;
                if (lane >= counts[i]) continue;
                const Range& p = parts[i][lane];
                if (p.end - p.begin <= block_width) {
                    node.child[lane] = TreeNode::leaf | Index(p.begin / block_width);
                } else {
                    node.child[lane] = Index(next.first_node + next.ranges.size());
                    next.ranges.push_back({p.begin, p.end});
                }
            }
            impl_->nodes[levels.back().first_node + i] = node;
        }
        if (next.ranges.empty()) break;
        impl_->nodes.resize(next.first_node + next.ranges.size());
        levels.push_back(std::move(next));
    }
    parallel_for(whole_blocks, 2000, filling, [&](std::size_t b) {
        fill_block(impl_->blocks[b], *mesh_, duties, items, b * block_width,
                   std::min(items.size(), (b + 1) * block_width));
    });
    // Boxes, roofs and slabs bottom up, a level at a time.
    LargeVector<Cover> covers(impl_->nodes.size());
    const auto cover_below = [&](Index child) {
        if ((child & TreeNode::leaf) == 0) return covers[child];
        const std::size_t begin = std::size_t(child & ~TreeNode::leaf) * block_width;
        return cover_of(std::span(items).subspan(begin, std::min(items.size() - begin, block_width)), origin,
                        *mesh_, slopes);
    };
    const auto cover_node = [&](std::size_t n) {
        TreeNode& node = impl_->nodes[n];
        std::array<Cover, block_width> parts;
        std::size_t count = 0;
        for (; count < block_width && node.child[count] != no_index; ++count) {
            parts[count] = cover_below(node.child[count]);
            set_child(node, count, parts[count], node.child[count]);
        }
        covers[n] = cover_of(parts, count);
    };
    for (std::size_t level = levels.size(); level-- > 0;)
        parallel_for(levels[level].ranges.size(), 250, covering.part(0, 0),
                     [&](std::size_t i) { cover_node(levels[level].first_node + i); });
    impl_->nodes.shrink_to_fit();
}

} // namespace facetmill
