// The seam of two scans: strips of facets between the cut through one and the border of the other that lies
// beside it.
#include "core/mesh/box_tree.h"
#include "core/repair/join.h"

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

/// A stretch of a cut, in the direction of the hole; closed ones end where they begin.
struct Stretch {
    std::vector<Index> vertices;
    bool closed = false;
};

std::vector<Stretch> stretches_of(const std::vector<Index>& next) {
    std::vector<char> has_before(next.size(), 0), seen(next.size(), 0);
    for (const Index to : next)
        if (to != no_index) has_before[to] = 1;
    std::vector<Stretch> all;
    const auto follow = [&](std::size_t from) {
        Stretch& s = all.emplace_back();
        std::size_t v = from;
        while (true) {
            s.vertices.push_back(Index(v));
            seen[v] = 1;
            if (next[v] == no_index) return;
            v = next[v];
            if (seen[v]) break;
        }
        s.vertices.push_back(Index(v));
        s.closed = v == from;
    };
    for (std::size_t v = 0; v < next.size(); ++v)
        if (next[v] != no_index && !has_before[v]) follow(v);
    for (std::size_t v = 0; v < next.size(); ++v)
        if (next[v] != no_index && !seen[v]) follow(v);
    return all;
}

/// The vertices of a border, to be found by place.
class BorderPlaces {
public:
    BorderPlaces(const Mesh& mesh, const std::vector<Index>& next, const Progress& progress) : mesh_(mesh) {
        std::vector<Box3> boxes;
        for (std::size_t v = 0; v < next.size(); ++v) {
            if (next[v] == no_index) continue;
            vertices_.push_back(Index(v));
            boxes.emplace_back().add(mesh.vertices[v]);
        }
        tree_ = BoxTree(boxes, progress);
    }
    /// The nearest one within the limit; no_index: none.
    Index nearest(const Vec3& p, double limit) const {
        Index found = no_index;
        double near2 = limit * limit;
        tree_.nearest(p, near2, [&](std::size_t i) {
            const double d2 = (mesh_.vertices[vertices_[i]] - p).squaredNorm();
            if (d2 >= near2) return;
            near2 = d2;
            found = vertices_[i];
        });
        return found;
    }

private:
    const Mesh& mesh_;
    std::vector<Index> vertices_;
    BoxTree tree_;
};

class Seam {
public:
    Seam(const Mesh& mesh, const std::vector<Index>& border, double reach, const Progress& progress)
        : mesh_(mesh), border_(border), reach_(reach), places_(mesh, border, progress),
          taken_(border.size(), 0) {}

    /// False, and nothing added, where no border runs beside the stretch.
    bool close(const Stretch& stretch, std::vector<Facet>& facets) {
        const std::vector<Index>& cut = stretch.vertices;
        const double limit = limit_of(cut);
        const Index first = places_.nearest(place(cut.front()), limit);
        const Index last = places_.nearest(place(cut.back()), limit);
        if (first == no_index || last == no_index) return false;
        // In the hole the border runs from the cut's end back to its beginning.
        std::vector<Index> back{last};
        for (Index v = last; v != first || (stretch.closed && back.size() == 1);) {
            v = border_[v];
            if (v == no_index || back.size() > border_.size()) return false;
            back.push_back(v);
            if (v == last) break;
        }
        std::reverse(back.begin(), back.end());
        for (std::size_t j = 0; j + 1 < back.size(); ++j)
            if (taken_[back[j + 1]]) return false;
        std::vector<Facet> strip = strip_between(cut, back, limit);
        if (strip.empty()) return false;
        // Each side of the border is used once: it is known by where it begins in the hole.
        for (std::size_t j = 0; j + 1 < back.size(); ++j)
            taken_[back[j + 1]] = 1;
        facets.insert(facets.end(), strip.begin(), strip.end());
        return true;
    }

private:
    const Vec3& place(Index v) const { return mesh_.vertices[v]; }
    double limit_of(const std::vector<Index>& cut) const {
        double longest = 0;
        for (std::size_t i = 0; i + 1 < cut.size(); ++i)
            longest = std::max(longest, (place(cut[i + 1]) - place(cut[i])).norm());
        constexpr double sides = 3; // the gap is about as wide as a facet that was taken out
        return reach_ + sides * longest;
    }
    /// Facets between two courses that run the same way, the shorter of both sides first; empty where they
    /// part by more than the limit.
    std::vector<Facet> strip_between(const std::vector<Index>& cut, const std::vector<Index>& back,
                                     double limit) const {
        std::vector<Facet> facets;
        double longest = limit;
        for (std::size_t j = 0; j + 1 < back.size(); ++j)
            longest = std::max(longest, limit + (place(back[j + 1]) - place(back[j])).norm());
        std::size_t i = 0, j = 0;
        while (i + 1 < cut.size() || j + 1 < back.size()) {
            const double along_cut =
                i + 1 < cut.size() ? (place(cut[i + 1]) - place(back[j])).norm() : infinity;
            const double along_back =
                j + 1 < back.size() ? (place(back[j + 1]) - place(cut[i])).norm() : infinity;
            if (std::min(along_cut, along_back) > longest) return {};
            if (along_cut <= along_back) {
                facets.push_back({cut[i], cut[i + 1], back[j]});
                ++i;
            } else {
                facets.push_back({back[j + 1], back[j], cut[i]});
                ++j;
            }
        }
        return facets;
    }

    const Mesh& mesh_;
    const std::vector<Index>& border_;
    double reach_;
    BorderPlaces places_;
    std::vector<char> taken_;
};

} // namespace

std::vector<Facet> seam_facets(const Mesh& mesh, const std::vector<Index>& cut,
                               const std::vector<Index>& border, double reach, std::size_t& unjoined,
                               const Progress& progress) {
    std::vector<Facet> facets;
    Seam seam(mesh, border, reach, progress);
    unjoined = 0;
    for (const Stretch& stretch : stretches_of(cut)) {
        progress.check();
        unjoined += !seam.close(stretch, facets);
    }
    return facets;
}

} // namespace facetmill::detail
