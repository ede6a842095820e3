// SPDX-License-Identifier: BSD-3-Clause
#include "io/write/vtp_file.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

namespace pcl_spiral {
namespace {

/** A named array of \p components values per point, filled by \p value(point, component). */
template <typename Array, typename Value>
vtkSmartPointer<Array>
pointArray(const char* name, int components, const pcl::PointCloud<ToolpathPoint>& path, Value value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i)
    for (int c = 0; c < components; ++c)
      array->SetTypedComponent(static_cast<vtkIdType>(i), c, value(path[i], c));
  return array;
}

/** Adds \p values under \p name if there are any. */
template <typename Value>
void
addValues(vtkPointData* arrays, const char* name, const std::vector<Value>& values)
{
  if (values.empty())
    return;
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (const Value value : values)
    array->InsertNextValue(static_cast<float>(value));
  arrays->AddArray(array);
}

vtkSmartPointer<vtkPolyData>
polyData(const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion, const PathValues& values)
{
  using P = ToolpathPoint;
  vtkNew<vtkPoints> points;
  if (motion.origin.isZero())
    points->SetData(pointArray<vtkFloatArray>("Points", 3, path, [](const P& p, int c) { return p.data[c]; }));
  else
    points->SetData(pointArray<vtkDoubleArray>("Points", 3, path, [&](const P& p, int c) { return p.data[c] + motion.origin[c]; }));
  std::vector<vtkIdType> order(path.size());
  std::iota(order.begin(), order.end(), 0);
  vtkNew<vtkCellArray> lines;
  const std::vector<std::size_t> passes = motion.passes.empty() ? passBegins(path) : motion.passes;
  std::vector<std::size_t> begins{0};
  begins.insert(begins.end(), passes.begin(), passes.end());
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : order.size();
    const std::array<vtkIdType, 2> alone{order[begins[i]], order[begins[i]]}; // VTK cannot write a line of one point
    if (end == begins[i] + 1)
      lines->InsertNextCell(2, alone.data());
    else
      lines->InsertNextCell(static_cast<vtkIdType>(end - begins[i]), order.data() + begins[i]);
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  vtkPointData* const arrays = data->GetPointData();
  arrays->SetNormals(pointArray<vtkFloatArray>("Normals", 3, path, [](const P& p, int c) { return p.data_n[c]; }));
  arrays->AddArray(pointArray<vtkFloatArray>("ToolAxis", 3, path, [](const P& p, int c) { return p.data_axis[c]; }));
  if (!values.feed.empty())
    addValues(arrays, "Feed", values.feed);
  else if (motion.feed > 0.0)
    addValues(arrays, "Feed", std::vector<double>(path.size(), motion.feed));
  arrays->AddArray(pointArray<vtkFloatArray>("Turn", 1, path, [](const P& p, int) { return p.turn; }));
  arrays->AddArray(pointArray<vtkDoubleArray>("ArcLength", 1, path, [](const P& p, int) { return p.arc_length; }));
  const auto over_gap = [](const P& p) { return p.over_gap != 0; };
  if (std::any_of(path.begin(), path.end(), over_gap))
    arrays->AddArray(pointArray<vtkUnsignedCharArray>("OverGap", 1, path, [](const P& p, int) { return p.over_gap; }));
  const auto lifted = [](const P& p) { return p.lift != 0.0f; };
  if (std::any_of(path.begin(), path.end(), lifted))
    arrays->AddArray(pointArray<vtkFloatArray>("Lift", 1, path, [](const P& p, int) { return p.lift; }));
  if (!motion.tips.empty()) {
    vtkNew<vtkDoubleArray> tips;
    tips->SetName("Tip");
    tips->SetNumberOfComponents(3);
    for (const Eigen::Vector3d& tip : motion.tips)
      tips->InsertNextTuple(Eigen::Vector3d(tip + motion.origin).data());
    arrays->AddArray(tips);
  }
  addValues(arrays, "Deviation", values.deviation);
  addValues(arrays, "Scallop", values.scallop);
  return data;
}

void
requireOneAPoint(std::size_t values, std::size_t points, const char* what)
{
  if (values != 0 && values != points)
    throw std::invalid_argument(std::to_string(values) + " values of " + what + " for " + std::to_string(points) +
                                " path points; give one value per point");
}

} // namespace

void
writeToolpathVTP(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion,
                 const PathValues& values)
{
  if (path.empty()) // VTK cannot hold a line without points
    throw FileError(file, "not written: the path has no points");
  requireOneAPoint(values.feed.size(), path.size(), "feed");
  requireOneAPoint(values.deviation.size(), path.size(), "deviation");
  requireOneAPoint(values.scallop.size(), path.size(), "scallop");
  writePolyData(file, polyData(path, motion, values));
}

} // namespace pcl_spiral
