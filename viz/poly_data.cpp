#include "viz/poly_data.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <numeric>

namespace facetmill {

namespace {

// VTK takes the pointer as not const and, with `save` 1, neither writes to it nor frees it.
template <class Array, class Value>
vtkNew<Array> borrowed(const std::vector<Value>& values, int components) {
    vtkNew<Array> array;
    array->SetNumberOfComponents(components);
    array->SetArray(const_cast<Value*>(values.data()), vtkIdType(values.size()), 1);
    return array;
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

} // namespace

vtkSmartPointer<vtkPolyData> triangle_data(const std::vector<float>& points,
                                           const std::vector<float>& normals,
                                           const std::vector<std::int32_t>& triangles) {
    auto data = with_points(points);
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, borrowed<vtkTypeInt32Array>(triangles, 1));
    data->SetPolys(cells);
    if (!normals.empty()) {
        const auto n = borrowed<vtkFloatArray>(normals, 3);
        n->SetName("Normals");
        data->GetPointData()->SetNormals(n);
    }
    return data;
}

vtkSmartPointer<vtkPolyData> segment_data(const std::vector<float>& points,
                                          const std::vector<std::int32_t>& segments) {
    auto data = with_points(points);
    vtkNew<vtkCellArray> cells;
    cells->SetData(2, borrowed<vtkTypeInt32Array>(segments, 1));
    data->SetLines(cells);
    return data;
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
