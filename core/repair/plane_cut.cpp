// Cut by a plane; what lies on the side of its normal goes.
#include "core/base/tolerances.h"
#include "core/mesh/index_pair.h"
#include "core/mesh/unused_vertices.h"
#include "core/repair/plane_polygon.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace facetmill::detail {

namespace {

class PlaneCut {
public:
    PlaneCut(const Mesh& mesh, const RepairStep& step)
        : mesh_(mesh), normal_(Vec3(step.normal[0], step.normal[1], step.normal[2]).normalized()),
          offset_(step.offset), result_(std::make_shared<Mesh>()) {
        const Box3 box = mesh.box();
        const double rounding =
            tolerance::coordinate_rounding * std::max(box.lo.norm(), std::max(box.hi.norm(), box.diagonal()));
        height_.resize(mesh.vertices.size());
        for (std::size_t v = 0; v < height_.size(); ++v) {
            const double h = normal_.dot(mesh.vertices[v]) - offset_;
            height_[v] = std::abs(h) <= rounding ? 0.0 : h;
        }
    }

    void cut(const Progress& progress) {
        result_->vertices = mesh_.vertices;
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            if (f % 65536 == 0) progress.set(double(f) / double(mesh_.facet_count()));
            cut_facet(f);
        }
    }

    /// Closes the section where its curves are closed.
    void close(const Progress& progress) {
        const auto rings = section_rings();
        if (rings.empty()) return;
        const Vec3 x = normal_.unitOrthogonal(), y = normal_.cross(x);
        std::vector<Vec2> points;
        std::vector<Index> vertex_of;
        std::vector<std::vector<Index>> numbered;
        double area = 0;
        for (const auto& ring : rings) {
            auto& numbers = numbered.emplace_back();
            for (const Index v : ring) {
                numbers.push_back(Index(points.size()));
                vertex_of.push_back(v);
                points.emplace_back(x.dot(result_->vertices[v]), y.dot(result_->vertices[v]));
            }
            area += ring_area(points, numbers);
        }
        // A mesh that is inside out has its section so too.
        const bool reversed = area < 0;
        if (reversed)
            for (Vec2& p : points)
                p.y() = -p.y();
        const auto facets = triangulate_rings(points, numbered, progress);
        if (!facets) {
            ++sections_open;
            return;
        }
        for (const Facet& f : *facets)
            result_->facets.push_back({vertex_of[f[0]], vertex_of[f[1]], vertex_of[f[2]]});
        section_facets = facets->size();
    }

    std::shared_ptr<Mesh> result(const Progress& progress) {
        drop_unused_vertices(*result_, progress);
        return result_;
    }

    std::size_t removed = 0, divided = 0, section_facets = 0, sections_open = 0;

private:
    bool on_plane(Index v) const { return v >= mesh_.vertices.size() || height_[v] == 0; }

    void cut_facet(std::size_t f) {
        const Facet& c = mesh_.facets[f];
        const std::array<double, 3> h{height_[c[0]], height_[c[1]], height_[c[2]]};
        const double high = std::max({h[0], h[1], h[2]}), low = std::min({h[0], h[1], h[2]});
        if (high == 0 && low == 0) {
            // In the plane: it stays where the part lies below it.
            keep(c, mesh_.facet_cross(f).dot(normal_) > 0);
        } else if (high <= 0 || low >= 0) {
            keep(c, high <= 0);
        } else {
            ++divided;
            std::vector<Index> below;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                if (h[k] <= 0) below.push_back(c[k]);
                if (h[k] * h[next] < 0) below.push_back(crossing(c[k], c[next]));
            }
            for (std::size_t i = 1; i + 1 < below.size(); ++i)
                result_->facets.push_back({below[0], below[i], below[i + 1]});
        }
    }
    void keep(const Facet& facet, bool stays) {
        if (stays)
            result_->facets.push_back(facet);
        else
            ++removed;
    }
    Index crossing(Index a, Index b) {
        const auto [it, fresh] = crossings_.try_emplace(pair_of(a, b), Index(result_->vertices.size()));
        if (fresh) {
            if (a > b) std::swap(a, b);
            const double t = height_[a] / (height_[a] - height_[b]);
            result_->vertices.push_back(
                rounded_to_float(mesh_.vertices[a] + t * (mesh_.vertices[b] - mesh_.vertices[a])));
        }
        return it->second;
    }

    /// The closed curves along the section, in the direction that facets in it run along them.
    std::vector<std::vector<Index>> section_rings() {
        std::unordered_map<std::uint64_t, int> sides;
        std::vector<std::pair<Index, Index>> in_order;
        for (const Facet& f : result_->facets)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = f[k], b = f[(k + 1) % 3];
                if (!on_plane(a) || !on_plane(b)) continue;
                ++sides[directed_pair(a, b)];
                in_order.emplace_back(b, a);
            }
        std::unordered_map<Index, std::vector<Index>> next;
        std::vector<Index> starts;
        for (const auto& [a, b] : in_order)
            if (sides.find(directed_pair(a, b)) == sides.end()) {
                next[a].push_back(b);
                starts.push_back(a);
            }
        std::vector<std::vector<Index>> rings;
        for (const Index start : starts) {
            std::vector<Index> ring;
            Index at = start;
            while (true) {
                auto it = next.find(at);
                if (it == next.end() || it->second.empty()) break;
                ring.push_back(at);
                at = it->second.back();
                it->second.pop_back();
                if (at == start) break;
            }
            if (ring.empty()) continue;
            if (at == start && ring.size() >= 3)
                rings.push_back(std::move(ring));
            else
                ++sections_open;
        }
        return rings;
    }

    const Mesh& mesh_;
    Vec3 normal_;
    double offset_;
    std::vector<double> height_;
    std::unordered_map<std::uint64_t, Index> crossings_;
    std::shared_ptr<Mesh> result_;
};

} // namespace

StepResult cut_by_plane(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    PlaneCut cut(mesh, step);
    cut.cut(progress.part(0, 0.6));
    StepResult result;
    const bool any = cut.removed + cut.divided > 0;
    if (any && step.close) cut.close(progress.part(0.6, 1));
    result.tell("facets_removed", cut.removed);
    result.tell("facets_divided", cut.divided);
    if (step.close) result.tell("section_facets", cut.section_facets);
    result.tell_any("sections_left_open", cut.sections_open);
    if (any) result.mesh = cut.result(progress);
    return result;
}

} // namespace facetmill::detail
