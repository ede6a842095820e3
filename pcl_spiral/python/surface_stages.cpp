// SPDX-License-Identifier: BSD-3-Clause
// Stages on a surface: loops, gaps, lines, feet. Lengths and places in mm.
#include "stage_call.h"

#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <pybind11/stl.h>

#include <utility>

namespace pcl_spiral::python {
namespace {

using Point = pcl::PointXYZ;

Loops
shifted(const std::vector<BoundaryLoop>& loops, const Eigen::Vector3d& shift)
{
  Loops all;
  for (const BoundaryLoop& loop : loops)
    all.push_back({loop, shift});
  return all;
}

struct SurfaceCall : Call {
  SurfaceSettings settings;
  Keywords keywords{"surface", settingTable(settings) + units.table(), std::vector<Input>{scanInputs().front()} + progress_input};
};

ShiftedSurface
surface(const py::object& points, const py::dict& given)
{
  SurfaceCall call;
  call.begin(call.keywords, given, points, call.settings);
  const auto scanned = std::make_shared<ScannedSurface<Point>>();
  scanned->setInputCloud(call.scan.cloud);
  scanned->setSettings(call.settings);
  call.scan.setSide(*scanned);
  const auto made = std::make_shared<Surface::ConstPtr>();
  compute(scanned, Run(call.keywords["progress"]), call.words, made);
  return {*made, call.scan.shift};
}

Loops
boundaryLoops(const ShiftedSurface& surface, const py::dict& given)
{
  StageCall call("boundary_loops", given, surface.shift);
  const auto stage = std::make_shared<BoundaryLoops<Point>>();
  stage->setInputSurface(surface.value);
  stage->setHoleSize(call.settings.hole_size);
  return shifted(call.made<std::vector<BoundaryLoop>>(stage), surface.shift);
}

std::pair<ShiftedSurface, Loops>
bridgeGaps(const ShiftedSurface& surface, const Loops& loops, const py::dict& given)
{
  StageCall call("bridge_gaps", given, surface.shift);
  const auto stage = over<GapBridging<Point>>(surface, loops);
  stage->setBoundaryMode(call.settings.boundary_mode);
  stage->setHoleHandling(call.settings.holes);
  stage->setHoleSize(call.settings.hole_size);
  stage->setGapHandling(call.settings.gaps);
  const auto bridged = call.made<BridgedSurface>(stage);
  return {{bridged.surface, surface.shift}, shifted(bridged.loops, surface.shift)};
}

std::vector<py::array>
geodesicPath(const ShiftedSurface& surface, const py::handle& source, const py::object& targets)
{
  ReadOptions read;
  read.origin = surface.shift;
  const Words words({{{"setSourcePoint", "source="}, {"setTargetPoints", "targets="}}, false, nullptr, nullptr}, read);
  const auto stage = std::make_shared<GeodesicPath<Point>>();
  stage->setInputSurface(surface.value);
  stage->setSourcePoint(placeFrom(source, read));
  stage->setTargetPoints(lineOf(targets, words));
  const auto lines = std::make_shared<std::vector<Polyline>>();
  compute(stage, Run(py::none()), words, lines);
  std::vector<py::array> rows;
  for (const Polyline& line : *lines)
    rows.push_back(rowsOf(line, surface.shift));
  return rows;
}

/** \p places as a cloud. */
pcl::PointCloud<Point>::Ptr
cloudOf(const Polyline& places)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  for (const Eigen::Vector3d& p : places)
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  return cloud;
}

Polyline
positionsOf(const Surface& surface)
{
  return placesOf(surface.size(), [&surface](std::size_t i) { return surface.position(i); });
}

Polyline
normalsOf(const Surface& surface)
{
  return placesOf(surface.size(), [&surface](std::size_t i) { return surface.normal(i); });
}

/** Feet and normals, (N, 3), and the principal curvatures, the larger first; not-a-number where a place has no foot. */
py::tuple
project(const ShiftedSurface& surface, const py::object& places, const py::dict& given)
{
  StageCall call("project", given, surface.shift);
  const auto stage = std::make_shared<MLSProjector<Point, pcl::PointNormal>>();
  stage->setInputSurface(surface.value);
  stage->setQueryCloud(cloudOf(lineOf(places, call.words)));
  stage->setKSearch(call.keywords.isGiven("neighbours") ? call.settings.neighbours : 0);
  const auto all = call.made<pcl::PointCloud<pcl::PointNormal>>(stage);
  std::vector<double> larger, smaller;
  stage->getPrincipalCurvatures(larger, smaller);
  return py::make_tuple(rowsOf(placesOf(all.size(), [&](std::size_t i) { return all[i].getVector3fMap().cast<double>(); }), surface.shift),
                        rowsOf(placesOf(all.size(), [&](std::size_t i) { return all[i].getNormalVector3fMap().cast<double>(); })),
                        numbersOf(larger), numbersOf(smaller));
}

/** Whether each point of \p surface is one of its boundary. */
py::array_t<bool>
boundaryPoints(const ShiftedSurface& surface, const py::dict& given)
{
  StageCall call("boundary_points", given, surface.shift);
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const Eigen::Vector3d& n : normalsOf(*surface.value))
    normals->emplace_back(static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()));
  const auto stage = std::make_shared<CentroidBoundaryEstimation<Point, pcl::Normal>>();
  stage->setInputCloud(cloudOf(positionsOf(*surface.value)));
  stage->setInputNormals(normals);
  stage->setKSearch(call.settings.neighbours);
  const auto found = std::make_shared<pcl::PointCloud<pcl::Boundary>>();
  (*call.run)([stage, found] { stage->compute(*found); });
  require(stage->getStatus(), call.words);
  py::array_t<bool> marks(static_cast<py::ssize_t>(found->size()));
  for (std::size_t i = 0; i < found->size(); ++i)
    marks.mutable_at(static_cast<py::ssize_t>(i)) = (*found)[i].boundary_point != 0;
  return marks;
}

void
addSurface(py::module_& module)
{
  py::class_<ShiftedSurface>(module, "Surface")
      .def_property_readonly("points", [](const ShiftedSurface& s) { return rowsOf(positionsOf(*s.value), s.shift); })
      .def_property_readonly("normals", [](const ShiftedSurface& s) { return rowsOf(normalsOf(*s.value)); })
      .def_property_readonly("spacing", [](const ShiftedSurface& s) { return s.value->spacing(); })
      .def_property_readonly("noise", [](const ShiftedSurface& s) { return s.value->noise(); })
      .def_property_readonly("area", [](const ShiftedSurface& s) { return s.value->area(); })
      .def("__len__", [](const ShiftedSurface& s) { return s.value->size(); });
  py::class_<ShiftedLoop>(module, "BoundaryLoop")
      .def_property_readonly("points", [](const ShiftedLoop& l) { return rowsOf(l.value.points, l.shift); })
      .def_property_readonly("curve", [](const ShiftedLoop& l) { return rowsOf(l.value.curve, l.shift); })
      .def_property_readonly("length", [](const ShiftedLoop& l) { return l.value.length; })
      .def_property_readonly("type", [](const ShiftedLoop& l) {
        return l.value.type == LoopType::Outer ? "outer" : l.value.type == LoopType::Inner ? "inner" : "gap";
      });
}

} // namespace

void
addSurfaceStages(py::module_& module, py::dict& tables)
{
  addSurface(module);
  module.def("surface", &surface);
  module.def("boundary_loops", &boundaryLoops);
  module.def("bridge_gaps", &bridgeGaps);
  module.def("geodesic_path", &geodesicPath);
  module.def("project", &project);
  module.def("boundary_points", &boundaryPoints);
  SurfaceCall().keywords.addTo(tables);
}

} // namespace pcl_spiral::python
