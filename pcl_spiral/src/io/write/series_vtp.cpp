// SPDX-License-Identifier: BSD-3-Clause
#include "common/formatted_text.h"
#include "io/byte_file.h"
#include "io/write/vtp_file.h"
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/scene_writer.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <stdexcept>

namespace pcl_spiral {

void
writeMoment(const std::string& file, const StockMesh& stock, const CutMoment& moment, double tool_length, const Eigen::Vector3d& origin)
{
  if (moment.heights.size() != stock.places.size())
    throw std::invalid_argument("a moment needs one height for each place of the stock");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Stock");
  vtkNew<vtkCellArray> triangles, tool;
  for (std::size_t i = 0; i < stock.places.size(); ++i) {
    const float more = moment.heights[i] - stock.stock[i];
    points->InsertNextPoint(Eigen::Vector3d((stock.places[i] + more * stock.normals[i]).cast<double>() + origin).data());
    heights->InsertNextValue(moment.heights[i]);
  }
  for (const auto& [a, b, c] : stock.triangles) {
    const vtkIdType corners[3] = {a, b, c};
    triangles->InsertNextCell(3, corners);
  }
  vtkIdType ends[2];
  for (int k = 0; k < 2; ++k) {
    ends[k] = points->InsertNextPoint(Eigen::Vector3d(moment.tip + k * tool_length * moment.axis + origin).data());
    heights->InsertNextValue(0.0f);
  }
  tool->InsertNextCell(2, ends);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->SetLines(tool);
  data->GetPointData()->SetScalars(heights);
  writePolyData(file, data);
}

void
writeSeries(const std::string& file, const std::vector<std::string>& names, const std::vector<double>& seconds)
{
  ByteFile out(file);
  out.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n");
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string name;
    for (const char c : names[i])
      name += c == '&' ? "&amp;" : c == '"' ? "&quot;" : c == '<' ? "&lt;" : std::string(1, c);
    out.write(formatted("<DataSet timestep=\"%.6f\" part=\"0\" file=\"", seconds[i]) + name + "\"/>\n");
  }
  out.write("</Collection>\n</VTKFile>\n");
  out.close();
}

} // namespace pcl_spiral
