// VTK data sets around flat arrays, without copying them and without a call per cell.
#pragma once

#include "viz/part_display.h"
#include "viz/path_display.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace facetmill {

/// The arrays are only referred to: they must outlive the data set.
vtkSmartPointer<vtkPolyData> triangle_data(const std::vector<float>& points,
                                           const std::vector<float>& normals,
                                           const std::vector<std::int32_t>& triangles);
/// The same in pieces of at most `most` triangles, at least one piece. They share points and normals, which
/// go to the graphics card once.
std::vector<vtkSmartPointer<vtkPolyData>> triangle_pieces(const std::vector<float>& points,
                                                          const std::vector<float>& normals,
                                                          const std::vector<std::int32_t>& triangles,
                                                          std::size_t most);
/// Triangles between the points of `like`, which are on the graphics card once for both.
vtkSmartPointer<vtkPolyData> triangles_like(vtkPolyData* like, const std::vector<std::int32_t>& triangles);
/// Poly data of arrays that lie elsewhere: three numbers a point and a normal, three indices a triangle.
vtkSmartPointer<vtkPolyData> triangle_data(const float* points, const float* normals, std::size_t point_count,
                                           const std::int32_t* triangles, std::size_t triangle_count);
/// Dots at points, three numbers each.
vtkSmartPointer<vtkPolyData> dot_data(const std::vector<float>& points);
/// Gives data a colour per point (RGBA). The array is referred to, and shared by all data it is given to.
void set_point_colors(const std::vector<vtkSmartPointer<vtkPolyData>>& data,
                      const std::vector<std::uint8_t>& colors);
/// Separate segments, two indices each.
vtkSmartPointer<vtkPolyData> segment_data(const std::vector<float>& points,
                                          const std::vector<std::int32_t>& segments);
/// Pieces of segments between the points of `like`, which are on the graphics card once for both.
std::vector<vtkSmartPointer<vtkPolyData>>
segment_pieces(vtkPolyData* like, const std::vector<std::int32_t>& segments, std::size_t most);
vtkSmartPointer<vtkPolyData> polyline_data(const Polylines& lines);
/// The points of the polylines as dots.
vtkSmartPointer<vtkPolyData> dot_data(const Polylines& lines);

} // namespace facetmill
