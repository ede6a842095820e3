// SPDX-License-Identifier: BSD-3-Clause
#include "path.h"

#include "io/byte_file.h"
#include <pcl_spiral/common/tool_tip.h>
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/io/path_exchange.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace pcl_spiral::python {

ToolPoses
posesOf(const pcl::PointCloud<ToolpathPoint>& points, const ToolpathMotion& motion)
{
  ToolPoses poses(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    poses[i].contact = points[i].getVector3fMap().cast<double>() + motion.origin;
    poses[i].normal = points[i].getNormalVector3fMap().cast<double>();
    poses[i].axis = points[i].getAxisVector3fMap().cast<double>();
    poses[i].tip = (motion.tips.empty() ? toolTip(points[i], motion.tool_radius) : motion.tips[i]) + motion.origin;
  }
  return poses;
}

namespace {

/** A column of the poses, which are made at the first call. */
template <Eigen::Vector3d ToolPose::*Member>
py::array
poseColumn(Path& path)
{
  if (!path.poses)
    path.poses = std::make_shared<const ToolPoses>(posesOf(*path.points, path.motion));
  const ToolPoses& poses = *path.poses;
  return viewOf(path.poses, poses.empty() ? nullptr : (poses.front().*Member).data(), poses.size(), sizeof(ToolPose), true);
}

template <auto Member>
py::array
pointColumn(const Path& path)
{
  const auto& points = *path.points;
  const auto owner = std::make_shared<pcl::PointCloud<ToolpathPoint>::ConstPtr>(path.points);
  return viewOf(owner, points.empty() ? nullptr : &(points.points.front().*Member), points.size(), sizeof(ToolpathPoint), false);
}

/** The points of the part, (N, 3), without the shift; none if the path does not know them. */
py::array
partOf(const Path& path)
{
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  if (path.source)
    cloud = path.source->spiral ? path.source->spiral->cloud : path.source->passes->cloud;
  const auto owner = std::make_shared<pcl::PointCloud<pcl::PointXYZ>::ConstPtr>(cloud);
  const std::size_t size = cloud ? cloud->size() : 0;
  return viewOf(owner, size == 0 ? nullptr : cloud->points.front().data, size, sizeof(pcl::PointXYZ), true);
}

/** Where each pass begins and ends. */
std::vector<std::pair<std::size_t, std::size_t>>
rangesOf(const Path& path)
{
  std::vector<std::pair<std::size_t, std::size_t>> ranges{{0, path.points->size()}};
  for (const std::size_t begin : path.motion.passes) {
    ranges.back().second = begin;
    ranges.emplace_back(begin, path.points->size());
  }
  return ranges;
}

/** The rows of each pass. */
py::tuple
passesOf(const Path& path)
{
  py::list passes;
  for (const auto& [begin, end] : rangesOf(path))
    passes.append(py::slice(static_cast<py::ssize_t>(begin), static_cast<py::ssize_t>(end), 1));
  return py::tuple(passes);
}

/** Each pass as poses, in the coordinates of the scan. */
std::vector<ToolPoses>
posePasses(const Path& path)
{
  const ToolPoses all = path.poses ? *path.poses : posesOf(*path.points, path.motion);
  std::vector<ToolPoses> passes;
  for (const auto& [begin, end] : rangesOf(path))
    passes.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(begin), all.begin() + static_cast<std::ptrdiff_t>(end));
  return passes;
}

void
writeTo(const Path& path, const std::string& file, const std::string& extension)
{
  if (extension == ".6d" || extension == ".5d")
    return extension == ".6d" ? writePoseVectors(file, posePasses(path)) : writePoseAngles(file, posePasses(path));
  if (extension != ".json")
    return writeToolpath(file, *path.points, path.motion);
  ByteFile out(file);
  out.write(path.report);
  out.close();
}

void
save(const Path& path, const std::string& file)
{
  const std::string extension = lowerExtension(file);
  const auto& known = toolpathExtensions();
  const bool is_known =
      std::find(known.begin(), known.end(), extension) != known.end() || extension == ".6d" || extension == ".5d" || extension == ".json";
  if (!is_known)
    raise("invalid-argument",
          Diagnostic(file, ": the extension '", extension,
                     "' is not known; use .csv .pcd .ply .vtp .6d .5d or .json, and program() for programs, CLDATA and robot frames"));
  if (!path.motion.tips.empty() && (extension == ".pcd" || extension == ".ply"))
    raise("invalid-argument",
          Diagnostic(file, ": this format holds contacts, and only for a ball do they give the tips; write the path of this tool as .csv, "
                           ".vtp, .6d or a program"));
  withFiles({}, [&file, &extension, held = path] { // which another thread may read meanwhile
    OutputFiles files({file});
    writeTo(held, files.temporary(0), extension);
    files.commit();
  });
}

constexpr const char* broken_pickle =
    "the pickled path is broken, or was made by another build of pcl_spiral: make it again, or save it as .csv";

/** The values of a vector as bytes. */
template <typename Values>
py::bytes
bytesOf(const Values& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])};
}

template <typename Values>
void
fromBytes(const py::handle& bytes, Values& values)
{
  const std::string data = bytes.cast<std::string>();
  if (data.size() % sizeof(values[0]) != 0)
    raiseType(broken_pickle);
  values.resize(data.size() / sizeof(values[0]));
  std::memcpy(static_cast<void*>(values.data()), data.data(), data.size());
}

constexpr int pickle_version = 1;

py::tuple
stateOf(const Path& path)
{
  const ToolpathMotion& m = path.motion;
  const bool has_own_poses = !m.tips.empty();
  return py::make_tuple(pickle_version, bytesOf(path.points->points), m.tool_radius, m.feed, bytesOf(m.tips), m.passes,
                        py::make_tuple(m.origin.x(), m.origin.y(), m.origin.z()), has_own_poses ? bytesOf(*path.poses) : py::bytes(),
                        path.report, path.warnings);
}

Path
fromState(const py::tuple& state)
{
  if (state.size() != 10 || state[0].cast<int>() != pickle_version)
    raiseType("this path was pickled by another version of pcl_spiral; make it again, or save it as .csv");
  Path path;
  const auto points = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  fromBytes(state[1], points->points);
  points->width = static_cast<std::uint32_t>(points->points.size());
  points->height = 1;
  path.points = points;
  path.motion.tool_radius = state[2].cast<double>();
  path.motion.feed = state[3].cast<double>();
  fromBytes(state[4], path.motion.tips);
  path.motion.passes = state[5].cast<std::vector<std::size_t>>();
  path.motion.origin = placeFrom(state[6]);
  if (py::len(state[7]) > 0) {
    ToolPoses poses;
    fromBytes(state[7], poses);
    path.poses = std::make_shared<const ToolPoses>(std::move(poses));
  }
  const auto fits = [size = points->size()](std::size_t count) { return count == 0 || count == size; };
  const std::vector<std::size_t>& passes = path.motion.passes;
  if (!fits(path.motion.tips.size()) || !fits(path.poses ? path.poses->size() : 0) || !std::is_sorted(passes.begin(), passes.end()) ||
      (!passes.empty() && passes.back() >= points->size()))
    raiseType(broken_pickle);
  path.report = state[8].cast<std::string>();
  path.warnings = state[9].cast<std::vector<std::string>>();
  return path;
}

} // namespace

void
addPath(py::module_& module)
{
  py::class_<Path>(module, "Path")
      .def_property_readonly("contact", &poseColumn<&ToolPose::contact>)
      .def_property_readonly("normal", &poseColumn<&ToolPose::normal>)
      .def_property_readonly("tip", &poseColumn<&ToolPose::tip>)
      .def_property_readonly("axis", &poseColumn<&ToolPose::axis>)
      .def_property_readonly("turn", &pointColumn<&ToolpathPoint::turn>)
      .def_property_readonly("arc_length", &pointColumn<&ToolpathPoint::arc_length>)
      .def_property_readonly("lift", &pointColumn<&ToolpathPoint::lift>)
      .def_property_readonly("over_gap", [](const Path& path) { return pointColumn<&ToolpathPoint::over_gap>(path).attr("view")("bool"); })
      .def_property_readonly("passes", &passesOf)
      .def_property_readonly("tool_radius", [](const Path& path) { return path.motion.tool_radius; })
      .def_property_readonly("feed", [](const Path& path) { return path.motion.feed; })
      .def_property_readonly("warnings", [](const Path& path) { return py::tuple(py::cast(path.warnings)); })
      .def_property_readonly("_part", &partOf)
      .def_property_readonly("_origin", [](const Path& path) { return rowsOf(Polyline{path.motion.origin}); })
      .def_property_readonly("_report_text", [](const Path& path) { return path.report; })
      .def("__len__", [](const Path& path) { return path.points->size(); })
      .def("_write", &save)
      .def("_write_program", &writeProgram)
      .def(py::pickle(&stateOf, &fromState));
}

} // namespace pcl_spiral::python
