#include "viz/poly_data.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>

namespace facetmill {

namespace {

// VTK takes the pointer as not const and, with `save` 1, neither writes to it nor frees it.
template <class Array, class Value>
vtkNew<Array> borrowed(const Value* values, std::size_t n, int components) {
    vtkNew<Array> array;
    array->SetNumberOfComponents(components);
    array->SetArray(const_cast<Value*>(values), vtkIdType(n), 1);
    return array;
}

template <class Array, class Value>
vtkNew<Array> borrowed(const std::vector<Value>& values, int components) {
    return borrowed<Array>(values.data(), values.size(), components);
}

vtkSmartPointer<vtkPolyData> with_points(const std::vector<float>& points) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> p;
    p->SetData(borrowed<vtkFloatArray>(points, 3));
    data->SetPoints(p);
    return data;
}

vtkNew<vtkTypeInt32Array> counting(std::size_t n) {
    vtkNew<vtkTypeInt32Array> array;
    array->SetNumberOfValues(vtkIdType(n));
    std::iota(array->GetPointer(0), array->GetPointer(0) + n, 0);
    return array;
}

/// 0, step, ... n * step: where n cells of so many indices begin, and the last one ends.
vtkSmartPointer<vtkTypeInt32Array> multiples_of(int step, std::size_t n) {
    auto array = vtkSmartPointer<vtkTypeInt32Array>::New();
    array->SetNumberOfValues(vtkIdType(n + 1));
    int value = -step;
    std::generate_n(array->GetPointer(0), n + 1, [&] { return value += step; });
    return array;
}

/// Cells of `size` indices each, at most `most` in a piece; `like` brings points and normals.
std::vector<vtkSmartPointer<vtkPolyData>> pieces_of(vtkPolyData* like,
                                                    const std::vector<std::int32_t>& indices, int size,
                                                    std::size_t most,
                                                    void (vtkPolyData::*set)(vtkCellArray*)) {
    std::vector<vtkSmartPointer<vtkPolyData>> pieces;
    const std::size_t step = std::max<std::size_t>(1, most) * std::size_t(size);
    vtkSmartPointer<vtkTypeInt32Array> begins; // of cells: the same in all pieces but the last one
    std::size_t from = 0;
    do {
        auto piece = vtkSmartPointer<vtkPolyData>::New();
        piece->SetPoints(like->GetPoints());
        piece->GetPointData()->SetNormals(like->GetPointData()->GetNormals());
        vtkNew<vtkCellArray> cells;
        const std::size_t n = std::min(step, indices.size() - from);
        const std::size_t count = n / std::size_t(size);
        if (!begins || begins->GetNumberOfValues() != vtkIdType(count + 1))
            begins = multiples_of(size, count);
        cells->SetData(begins, borrowed<vtkTypeInt32Array>(indices.data() + from, n, 1));
        (piece->*set)(cells);
        pieces.push_back(std::move(piece));
        from += n;
    } while (from < indices.size());
    return pieces;
}

} // namespace

vtkSmartPointer<vtkPolyData> triangle_data(const float* points, const float* normals, std::size_t point_count,
                                           const std::int32_t* triangles, std::size_t triangle_count) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> p;
    p->SetData(borrowed<vtkFloatArray>(points, 3 * point_count, 3));
    data->SetPoints(p);
    const auto n = borrowed<vtkFloatArray>(normals, 3 * point_count, 3);
    n->SetName("Normals");
    data->GetPointData()->SetNormals(n);
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, borrowed<vtkTypeInt32Array>(triangles, 3 * triangle_count, 1));
    data->SetPolys(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> dot_data(const std::vector<float>& points) {
    auto data = with_points(points);
    vtkNew<vtkCellArray> cells;
    cells->SetData(1, counting(points.size() / 3));
    data->SetVerts(cells);
    return data;
}

void set_point_colors(const std::vector<vtkSmartPointer<vtkPolyData>>& data,
                      const std::vector<std::uint8_t>& colors) {
    const auto array = borrowed<vtkUnsignedCharArray>(colors, 4);
    array->SetName("Colors");
    for (const auto& d : data)
        d->GetPointData()->SetScalars(array);
}

vtkSmartPointer<vtkPolyData> triangle_data(const std::vector<float>& points,
                                           const std::vector<float>& normals,
                                           const std::vector<std::int32_t>& triangles) {
    return triangle_pieces(points, normals, triangles, triangles.size()).front();
}

std::vector<vtkSmartPointer<vtkPolyData>> triangle_pieces(const std::vector<float>& points,
                                                          const std::vector<float>& normals,
                                                          const std::vector<std::int32_t>& triangles,
                                                          std::size_t most) {
    const auto data = with_points(points);
    if (!normals.empty()) {
        const auto n = borrowed<vtkFloatArray>(normals, 3);
        n->SetName("Normals");
        data->GetPointData()->SetNormals(n);
    }
    return pieces_of(data, triangles, 3, most, &vtkPolyData::SetPolys);
}

vtkSmartPointer<vtkPolyData> triangles_like(vtkPolyData* like, const std::vector<std::int32_t>& triangles) {
    return pieces_of(like, triangles, 3, triangles.size(), &vtkPolyData::SetPolys).front();
}

vtkSmartPointer<vtkPolyData> segment_data(const std::vector<float>& points,
                                          const std::vector<std::int32_t>& segments) {
    return segment_pieces(with_points(points), segments, segments.size()).front();
}

std::vector<vtkSmartPointer<vtkPolyData>>
segment_pieces(vtkPolyData* like, const std::vector<std::int32_t>& segments, std::size_t most) {
    vtkNew<vtkPolyData> data; // without normals: lines have no light
    data->SetPoints(like->GetPoints());
    return pieces_of(data, segments, 2, most, &vtkPolyData::SetLines);
}

vtkSmartPointer<vtkPolyData> polyline_data(const Polylines& lines) {
    auto data = with_points(lines.points);
    vtkNew<vtkCellArray> cells;
    cells->SetData(borrowed<vtkTypeInt32Array>(lines.offsets, 1), counting(lines.points.size() / 3));
    data->SetLines(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> dot_data(const Polylines& lines) {
    auto data = with_points(lines.points);
    vtkNew<vtkCellArray> cells;
    cells->SetData(1, counting(lines.points.size() / 3));
    data->SetVerts(cells);
    return data;
}

} // namespace facetmill
