#include "viz/part_display.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t items_per_check = 1u << 16; // vertices or facets: a few ms
constexpr double cells_a_side = 100;              // along the longest side of the part's box

Vec3 vector_at(const std::vector<float>& values, std::size_t i) {
    return {double(values[3 * i]), double(values[3 * i + 1]), double(values[3 * i + 2])};
}

/// Which of the six directions +X -X +Y -Y +Z -Z a normal is nearest to.
std::size_t side_of(const Vec3& n) {
    Eigen::Index axis = 0;
    n.cwiseAbs().maxCoeff(&axis);
    return 2 * std::size_t(axis) + (n[axis] < 0 ? 1 : 0);
}

void append_vector(std::vector<float>& values, const Vec3& v) {
    values.insert(values.end(), {float(v.x()), float(v.y()), float(v.z())});
}

} // namespace

PartPreview make_preview(const PartDisplay& part, const Progress& progress) {
    std::vector<std::int32_t> merged;
    PartPreview preview =
        make_preview(part.points, part.normals, part.triangles, part.box.size(), &merged, progress);
    preview.merged = std::move(merged);
    return preview;
}

PartPreview make_preview(const std::vector<float>& points, const std::vector<float>& all_normals,
                         const std::vector<std::int32_t>& triangles, const Vec3& size,
                         std::vector<std::int32_t>* merged_out, const Progress& progress) {
    PartPreview preview;
    if (merged_out) merged_out->assign(points.size() / 3, 0);
    const double step = size.maxCoeff() / cells_a_side;
    if (!(step > 0)) return preview;
    const Eigen::Array<std::size_t, 3, 1> cells = (size.array() / step).floor().cast<std::size_t>() + 1;
    const auto cell_of = [&](const Vec3& p) {
        const auto at = [&](int k) {
            const double c = std::floor((p[k] + size[k] / 2) / step);
            return std::min(std::size_t(std::max(0.0, c)), cells[k] - 1);
        };
        return at(0) + cells[0] * (at(1) + cells[1] * at(2));
    };

    // One position per cell, so that nothing comes apart; one vertex and normal per cell and side.
    struct Sum {
        Vec3 total = Vec3::Zero();
        double count = 0;
    };
    const std::size_t vertices = points.size() / 3;
    std::vector<std::int32_t> place_of_cell(cells.prod(), -1);
    std::vector<Sum> places;
    std::vector<std::array<std::int32_t, 6>> vertex_of_place;
    std::vector<Sum> normals;
    std::vector<std::int32_t> place_of_vertex, merged(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        if (v % items_per_check == 0) progress.check();
        const Vec3 p = vector_at(points, v), n = vector_at(all_normals, v);
        std::int32_t& place = place_of_cell[cell_of(p)];
        if (place < 0) {
            place = std::int32_t(places.size());
            places.emplace_back();
            vertex_of_place.push_back({-1, -1, -1, -1, -1, -1});
        }
        places[std::size_t(place)].total += p;
        places[std::size_t(place)].count += 1;
        std::int32_t& vertex = vertex_of_place[std::size_t(place)][side_of(n)];
        if (vertex < 0) {
            vertex = std::int32_t(normals.size());
            normals.emplace_back();
            place_of_vertex.push_back(place);
        }
        normals[std::size_t(vertex)].total += n;
        merged[v] = vertex;
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Sum& place = places[std::size_t(place_of_vertex[i])];
        append_vector(preview.points, place.total / place.count);
        const double length = normals[i].total.norm();
        append_vector(preview.normals, length > 0 ? Vec3(normals[i].total / length) : Vec3(0, 0, 1));
    }
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        if (t % (3 * items_per_check) == 0) progress.check();
        std::array<std::int32_t, 3> corner{}, place{};
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = merged[std::size_t(triangles[t + k])];
            place[k] = place_of_vertex[std::size_t(corner[k])];
        }
        if (place[0] == place[1] || place[1] == place[2] || place[2] == place[0]) continue;
        // A thin facet may have been turned over; its normals still say which side is out.
        const auto at = [&](std::size_t k) { return vector_at(preview.points, std::size_t(corner[k])); };
        Vec3 out = Vec3::Zero();
        for (const std::int32_t c : corner)
            out += vector_at(preview.normals, std::size_t(c));
        if ((at(1) - at(0)).cross(at(2) - at(0)).dot(out) < 0) std::swap(corner[1], corner[2]);
        preview.triangles.insert(preview.triangles.end(), corner.begin(), corner.end());
    }
    if (merged_out) *merged_out = std::move(merged);
    return preview;
}

} // namespace facetmill
