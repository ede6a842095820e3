// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.h"

#include "io/read/scaled_points.h"
#include "io/setting_names.h"
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/polygon_reader.h>

#include <pcl/conversions.h>

namespace pcl_spiral::python {
namespace {

NumberColumn
columnOf(const py::handle& object)
{
  if (!py::isinstance<py::array>(object))
    raiseType("the points are no columns of numbers: give a numpy array of shape (N, 3), or the name of a file");
  const auto column = py::reinterpret_borrow<py::array>(object);
  return {column.data(), column.strides(0), static_cast<std::size_t>(column.shape(0)), column.itemsize() == 4};
}

/** The normals, one for each of \p size points; null: none are given. */
pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const py::object& given, const std::string& name, std::size_t size)
{
  if (given.is_none())
    return nullptr;
  const PointColumns columns = columnsOf(given);
  if (columns[0].size() != size)
    raise("invalid-argument", Diagnostic(name, "= has ", columns[0].size(), " rows for ", size, " points: give one a point"), {}, {name});
  return unitNormals(columns);
}

pcl::PolygonMesh::ConstPtr
meshOf(const pcl::PointCloud<pcl::PointXYZ>& vertices, const py::array_t<std::int64_t>& faces)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(vertices, mesh->cloud);
  const auto rows = faces.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    mesh->polygons.emplace_back();
    for (py::ssize_t k = 0; k < 3; ++k)
      mesh->polygons.back().vertices.push_back(static_cast<pcl::index_t>(rows(i, k)));
  }
  return mesh;
}

GivenScan
readFile(const std::string& file, bool has_faces, const ReadOptions& options)
{
  GivenScan scan;
  if (has_faces) {
    const MeshFile mesh = readMesh(file, options);
    scan.mesh = mesh.mesh;
    scan.shift = mesh.shift;
    scan.warnings = mesh.warnings;
  }
  else
    static_cast<Scan&>(scan) = readCloud(file, options);
  scan.name = file;
  return scan;
}

} // namespace

PointColumns
columnsOf(const py::object& columns)
{
  return {columnOf(columns[py::int_(0)]), columnOf(columns[py::int_(1)]), columnOf(columns[py::int_(2)])};
}

std::vector<Setting>
GivenUnits::table()
{
  return {
      Setting("unit", "ReadOptions::unit", "unit of the numbers", "unit of the points, and of all places, polygons and lines", "m", unit),
      Setting("origin", "ReadOptions::origin", "origin",
              "subtracted from the points, in their unit; the path is then relative to it. Without it map coordinates are shifted "
              "inside, and back in the results",
              "393775,3689071,0", origin)
          .zeroFor("none, or a found one")};
}

ReadOptions
GivenUnits::options() const
{
  ReadOptions options;
  options.unit = unit;
  options.origin = origin.value_or(Eigen::Vector3d::Zero());
  options.find_origin = !origin;
  return options;
}

ReadOptions
GivenUnits::options(const Eigen::Vector3d& shift) const
{
  ReadOptions asked = options();
  asked.origin += shift / millimetres(unit);
  asked.find_origin = false;
  return asked;
}

std::vector<Input>
scanInputs()
{
  return {{"normals", "ArrayLike | None", "(N, 3), one a point, out of the material; only their side counts", {"setInputNormals"}},
          {"faces",
           "ArrayLike | bool | None",
           "(M, 3) rows of points: they are a mesh, whose faces define the side; True: the faces of the file",
           {"setInputMesh"}}};
}

GivenScan
scanOf(const py::object& points, const Keywords& keywords, const GivenUnits& units, const Words& words, const std::string& normals)
{
  const ReadOptions options = units.options();
  const py::object faces = keywords["faces"];
  const bool own_faces = faces.is(py::bool_(true)), has_rows = py::isinstance<py::array>(faces);
  if (py::isinstance<py::str>(points)) {
    const auto file = points.cast<std::string>();
    if (has_rows)
      raiseType(Diagnostic(file, ": its own faces are used by faces=True; an array of faces belongs to an array of points"));
    return withFiles(words, [&] { return readFile(file, own_faces, options); });
  }
  const PointColumns columns = columnsOf(points);
  const ScaledPoints scaled = withFiles(
      words, [&] { return scaledPoints("points", columns, options); }, "invalid-input");
  GivenScan scan;
  scan.cloud = scaled.cloud;
  scan.shift = scaled.shift;
  scan.warnings = scaled.warnings;
  scan.normals = normalsOf(keywords[normals], normals, scan.cloud->size());
  if (has_rows)
    scan.mesh = meshOf(*scan.cloud, faces);
  else if (own_faces)
    raiseType("faces=True uses the faces of a file, and points= is an array: give rows of points=, (M, 3)");
  return scan;
}

Polyline
lineOf(const py::object& points, const Words& words)
{
  Polyline line;
  if (py::isinstance<py::str>(points)) {
    const auto file = points.cast<std::string>();
    const Scan scan = withFiles(words, [&] { return readCloud(file, words.read); });
    for (const pcl::PointXYZ& p : *scan.cloud)
      line.push_back(p.getVector3fMap().cast<double>());
  }
  else if (!points.is_none()) {
    const py::array_t<double> rows = points;
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
      const double z = rows.shape(1) == 3 ? rows.at(i, 2) : words.read.origin.z();
      line.push_back(millimetres(words.read.unit) * (Eigen::Vector3d(rows.at(i, 0), rows.at(i, 1), z) - words.read.origin));
    }
  }
  return line;
}

py::array
rowsOf(Polyline places, const Eigen::Vector3d& shift)
{
  for (Eigen::Vector3d& place : places)
    place += shift;
  return rowsOf(places);
}

Prism
polygonOf(const std::string& name, const py::object& corners, const Words& words)
{
  if (py::isinstance<py::str>(corners)) {
    const auto file = corners.cast<std::string>();
    return withFiles(words, [&] { return readPolygon(file, words.read); });
  }
  Prism prism = prismOver(lineOf(corners, words), py::array(corners).shape(1) == 3);
  if (!prism.fault().empty())
    raise("invalid-argument", Diagnostic(name, "= is no area: ", prism.fault()), words, {name});
  return prism;
}

std::vector<ToolSegment>
holderOf(const py::list& parts)
{
  std::vector<ToolSegment> segments;
  for (const py::handle part : parts) {
    const Eigen::Vector3d measures = placeFrom(part);
    segments.push_back({measures[0], measures[1], measures[2], "segment " + std::to_string(segments.size() + 1) + " of the holder"});
  }
  return segments;
}

} // namespace pcl_spiral::python
