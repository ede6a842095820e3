// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.h"

#include "io/read/scaled_points.h"
#include "io/setting_names.h"
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/polygon_reader.h>

#include <pcl/conversions.h>

#include <algorithm>
#include <limits>

namespace pcl_spiral::python {
namespace {

py::array
arrayOf(const std::string& name, const py::object& object)
{
  py::array array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    raiseType(Diagnostic(name, "= is no array of numbers: give a numpy array of shape (N, 3), or the name of a file"));
  }
  return array;
}

std::string
shapeText(const py::array& array)
{
  return py::str(array.attr("shape"));
}

/** \p array as float32 or float64 in the order of this machine: itself, or a copy of another type. */
py::array
asNumbers(const std::string& name, const py::array& array)
{
  const char kind = array.dtype().kind();
  const bool is_native = array.dtype().attr("isnative").cast<bool>();
  if (kind == 'f' && is_native && (array.itemsize() == 4 || array.itemsize() == 8))
    return array;
  if (kind != 'f' && kind != 'i' && kind != 'u')
    raiseType(Diagnostic(name, "= has the type ", std::string(py::str(array.dtype())),
                         ", which is no number: give float32 or float64, such as ", name, ".astype(float)"));
  return array.attr("astype")("float64");
}

NumberColumn
columnOf(const py::array& array, py::ssize_t offset, py::ssize_t stride, py::ssize_t size)
{
  return {static_cast<const char*>(array.data()) + offset, stride, static_cast<std::size_t>(size), array.itemsize() == 4};
}

/** The fields of a structured array. */
ArrayColumns
fieldsOf(const std::string& name, const py::array& array, const std::vector<std::string>& fields)
{
  ArrayColumns found;
  const py::object names = array.dtype().attr("names");
  for (std::size_t c = 0; c < 3; ++c) {
    if (!names.contains(fields[c]))
      raiseType(Diagnostic(name, "= has no field ", fields[c], "; it has ", std::string(py::str(names)), ": give fields x, y and z"));
    const py::array field = asNumbers(name, array.attr("__getitem__")(fields[c]).attr("reshape")(-1));
    found.columns[c] = columnOf(field, 0, field.strides(0), field.shape(0));
    found.arrays.push_back(field);
  }
  return found;
}

void
requireRows(const std::string& name, const ArrayColumns& found, std::size_t rows)
{
  if (found.columns[0].size() != rows)
    raise("invalid-argument", Diagnostic(name, "= has ", found.columns[0].size(), " rows for ", rows, " points: give one a point"), {});
}

/** The normals of normals=, or fields nx ny nz of \p points; null: none. */
pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const py::object& given, const py::object& points, std::size_t size)
{
  if (!given.is_none()) {
    const ArrayColumns found = columnsOf("normals", given, {"nx", "ny", "nz"});
    requireRows("normals", found, size);
    return unitNormals(found.columns);
  }
  const py::object names = arrayOf("points", points).dtype().attr("names");
  for (const std::vector<std::string>& fields :
       {std::vector<std::string>{"nx", "ny", "nz"}, std::vector<std::string>{"normal_x", "normal_y", "normal_z"}})
    if (!names.is_none() && std::all_of(fields.begin(), fields.end(), [&](const auto& field) { return names.contains(field); }))
      return unitNormals(columnsOf("points", points, fields).columns);
  return nullptr;
}

pcl::PolygonMesh::ConstPtr
meshOf(const pcl::PointCloud<pcl::PointXYZ>& vertices, const py::object& faces)
{
  const py::array given = arrayOf("faces", faces);
  const char kind = given.dtype().kind();
  if (given.ndim() != 2 || given.shape(1) != 3 || (kind != 'i' && kind != 'u'))
    raiseType(Diagnostic("faces= has the shape ", shapeText(given), " and the type ", std::string(py::str(given.dtype())),
                         ": give (M, 3) integers, the rows of points= that are the corners, or faces=True for those of a file"));
  const auto corners = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(given);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(vertices, mesh->cloud);
  mesh->polygons.resize(static_cast<std::size_t>(corners.shape(0)));
  const auto rows = corners.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    for (py::ssize_t k = 0; k < 3; ++k) {
      if (rows(i, k) < 0 || rows(i, k) >= static_cast<std::int64_t>(vertices.size()))
        raise("invalid-input",
              Diagnostic("faces= names the point ", rows(i, k), " in row ", i, ", but there are ", vertices.size(),
                         " points: give rows of points=, from 0"),
              {});
      mesh->polygons[static_cast<std::size_t>(i)].vertices.push_back(static_cast<pcl::index_t>(rows(i, k)));
    }
  return mesh;
}

GivenScan
readFile(const std::string& file, const Keywords& keywords, const ReadOptions& options)
{
  GivenScan scan;
  if (const py::object faces = keywords["faces"]; !faces.is_none() && !faces.is(py::bool_(false))) {
    if (!faces.is(py::bool_(true)))
      raiseType(Diagnostic(file, ": its own faces are used by faces=True; an array of faces belongs to an array of points"));
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

ArrayColumns
columnsOf(const std::string& name, const py::object& object, const std::vector<std::string>& fields)
{
  const py::array given = arrayOf(name, object);
  if (!given.dtype().attr("names").is_none())
    return fieldsOf(name, given, fields);
  if (given.dtype().kind() == 'O')
    asNumbers(name, given); // raises
  if (given.ndim() != 2 || given.shape(1) != 3)
    raise("invalid-input",
          Diagnostic(name, "= has the shape ", shapeText(given), ": give (N, 3), one row a point, or an array with fields x, y and z"), {});
  const py::array array = asNumbers(name, given);
  ArrayColumns found;
  for (py::ssize_t c = 0; c < 3; ++c)
    found.columns[static_cast<std::size_t>(c)] = columnOf(array, c * array.strides(1), array.strides(0), array.shape(0));
  found.arrays.push_back(array);
  return found;
}

std::vector<Setting>
GivenUnits::table()
{
  return {Setting("unit", "ReadOptions::unit", "unit of the numbers", "unit of the points, and of polygons, lines and places in files", "m",
                  unit),
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
  if (const std::optional<std::string> file = fileOf(points))
    return withFiles(words, [&] { return readFile(*file, keywords, options); });
  const ArrayColumns found = columnsOf("points", points);
  if (found.columns[0].size() > std::numeric_limits<std::uint32_t>::max() / 2)
    raise("invalid-input", Diagnostic("points= has ", found.columns[0].size(), " rows: at most 2^31 points can be numbered; thin them"),
          {});
  GivenScan scan;
  ScaledPoints scaled = scaledPoints("points", found.columns, options);
  scan.cloud = scaled.cloud;
  scan.shift = scaled.shift;
  scan.warnings = scaled.warnings;
  scan.normals = normalsOf(keywords[normals], points, scan.cloud->size());
  if (keywords.isGiven("faces"))
    scan.mesh = meshOf(*scan.cloud, keywords["faces"]);
  return scan;
}

Polyline
lineOf(const std::string& name, const py::object& points, const ReadOptions& read, const Words& words)
{
  Polyline line;
  if (const std::optional<std::string> file = fileOf(points)) {
    const Scan scan = withFiles(words, [&] { return readCloud(*file, read); });
    for (const pcl::PointXYZ& p : *scan.cloud)
      line.push_back(p.getVector3fMap().cast<double>());
    return line;
  }
  const ArrayColumns found = columnsOf(name, points);
  for (std::size_t i = 0; i < found.columns[0].size(); ++i) {
    const Eigen::Vector3d p(found.columns[0][i], found.columns[1][i], found.columns[2][i]);
    line.push_back(millimetres(read.unit) * (p - read.origin));
  }
  return line;
}

Prism
polygonOf(const std::string& name, const py::object& corners, const ReadOptions& read, const Words& words)
{
  if (const std::optional<std::string> file = fileOf(corners))
    return withFiles(words, [&] { return readPolygon(*file, read); });
  const py::array given = arrayOf(name, corners);
  if (given.ndim() != 2 || (given.shape(1) != 2 && given.shape(1) != 3))
    raise("invalid-argument", Diagnostic(name, "= has the shape ", shapeText(given), ": give corners (N, 2) or (N, 3), or a file"), {});
  const auto rows = py::array_t<double, py::array::c_style | py::array::forcecast>(asNumbers(name, given));
  std::vector<Eigen::Vector3d> places;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double z = rows.shape(1) == 3 ? rows.at(i, 2) : read.origin.z();
    places.push_back(millimetres(read.unit) * (Eigen::Vector3d(rows.at(i, 0), rows.at(i, 1), z) - read.origin));
  }
  Prism prism = prismOver(places, rows.shape(1) == 3);
  if (!prism.fault().empty())
    raise("invalid-argument", Diagnostic(name, "= is no area: ", prism.fault()), words);
  return prism;
}

std::optional<std::string>
fileOf(const py::handle& object)
{
  if (!py::isinstance<py::str>(object) && !py::hasattr(object, "__fspath__"))
    return std::nullopt;
  return py::str(py::module_::import("os").attr("fspath")(object)).cast<std::string>();
}

std::vector<ToolSegment>
holderOf(const py::object& given)
{
  std::vector<ToolSegment> segments;
  if (given.is_none())
    return segments;
  for (const py::handle part : given) {
    const std::size_t size = py::isinstance<py::sequence>(part) ? py::len(part) : 0;
    if (size != 2 && size != 3)
      raiseType(
          "holder= takes parts of (radius, length) or (lower radius, upper radius, length), upwards, such as [(6, 40), (20, 25, 60)]");
    const auto number = [&](std::size_t i) { return numberFrom("holder", part[py::int_(i)]); };
    segments.push_back(
        {number(0), number(size - 2), number(size - 1), "segment " + std::to_string(segments.size() + 1) + " of the holder"});
  }
  return segments;
}

} // namespace pcl_spiral::python
