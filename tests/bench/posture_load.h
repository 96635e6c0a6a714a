// What the benchmarks of postures share: tool, contact points, and the plain method as the measure.
#pragma once

#include "core/mesh/mesh.h"
#include "core/setup/tool.h"
#include "core/setup/tool_pose.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/scalar/axial_elements.h"
#include "tests/bench/scalar/lower_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace facetmill::bench {

/// Flat end D 0.5 in with shank and holder.
inline Tool the_tool() {
    Tool tool;
    tool.diameter = 12.7;
    tool.flute_length = 25.4;
    tool.shank_diameter = 12.7;
    tool.shank_length = 25.4;
    tool.holder = {{40, 30}, {60, 40}};
    return tool;
}

/// Number i of `wanted` contact points over the facets of a mesh, and the normal there, upward.
inline std::pair<Vec3, Vec3> contact_point(const Mesh& mesh, std::size_t i, std::size_t wanted) {
    const auto f = std::size_t((double(i) + 0.5) * double(mesh.facet_count()) / double(wanted));
    Vec3 normal = mesh.facet_normal(f);
    if (normal.z() < 0) normal = -normal;
    if (normal.norm() < 0.5 || std::abs(normal.x()) > 0.99) normal = Vec3::UnitZ();
    return {(mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3, normal};
}

/// Every facet whose corners come near enough, body by body; no index.
class PlainTool {
public:
    explicit PlainTool(const Tool& tool) {
        bodies_.emplace_back(scalar::LowerSurface(CutterProfile(tool.cutter())), 0);
        double height = tool.flute_length + tool.shank_length;
        for (const HolderSection& s : tool.holder) {
            bodies_.emplace_back(scalar::LowerSurface(CutterProfile(AptCutter::flat(s.diameter, s.length))),
                                 height);
            height += s.length;
        }
    }
    double lift(const Mesh& mesh, const ToolPose& pose) const {
        const Vec3 u = pose.axis.unitOrthogonal(), v = pose.axis.cross(u);
        double best = -infinity;
        for (const Facet& f : mesh.facets) {
            Vec3 p[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 d = mesh.vertices[f[k]] - pose.tip;
                p[k] = Vec3(d.dot(u), d.dot(v), d.dot(pose.axis));
            }
            const double lo_x = std::min({p[0].x(), p[1].x(), p[2].x()}),
                         hi_x = std::max({p[0].x(), p[1].x(), p[2].x()});
            const double lo_y = std::min({p[0].y(), p[1].y(), p[2].y()}),
                         hi_y = std::max({p[0].y(), p[1].y(), p[2].y()});
            for (const auto& [surface, offset] : bodies_) {
                const double r = surface.max_radius();
                if (lo_x > r || hi_x < -r || lo_y > r || hi_y < -r) continue;
                double lift = -infinity;
                for (std::size_t k = 0; k < 3; ++k)
                    lift = std::max({lift, scalar::vertex_lift(surface, p[k]).tip_z,
                                     scalar::edge_lift(surface, p[k], p[(k + 1) % 3]).tip_z});
                lift = std::max(lift, scalar::facet_lift(surface, p[0], p[1], p[2]).tip_z);
                best = std::max(best, lift - offset);
            }
        }
        return best;
    }

private:
    std::vector<std::pair<scalar::LowerSurface, double>> bodies_;
};

} // namespace facetmill::bench
