// SPDX-License-Identifier: BSD-3-Clause
// Single stages: a surface, its loops, bridged gaps, radial lines, and the spiral over them.
#include "parts.h"
#include "path.h"

#include "io/report/moved_places.h"
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pybind11/stl.h>

namespace pcl_spiral::python {
namespace {

using Point = pcl::PointXYZ;

/** The prepared surface of a scan. */
struct ScanSurface {
  Surface::ConstPtr surface;
  Eigen::Vector3d shift; ///< see Scan::shift
};

/** A loop, and the shift of its scan. */
struct ShiftedLoop {
  BoundaryLoop loop;
  Eigen::Vector3d shift;
};

struct ShiftedLines {
  RadialLineSet set;
  Eigen::Vector3d shift;
};

/** (N, 3) of what \p at gives for each of \p size numbers. */
template <typename At>
py::array_t<double>
rowsOf(std::size_t size, const Eigen::Vector3d& shift, At at)
{
  py::array_t<double> rows({static_cast<py::ssize_t>(size), py::ssize_t{3}});
  for (std::size_t i = 0; i < size; ++i)
    Eigen::Map<Eigen::Vector3d>(rows.mutable_data(static_cast<py::ssize_t>(i), 0)) = at(i) + shift;
  return rows;
}

py::array_t<double>
rowsOf(const Polyline& line, const Eigen::Vector3d& shift)
{
  return rowsOf(line.size(), shift, [&line](std::size_t i) { return line[i]; });
}

/** The settings of a spiral that a stage takes, and its surface. */
struct StageCall {
  SpiralSettings settings;
  Words words;
  Keywords keywords;

  StageCall(const std::string& function, const std::set<std::string>& names)
  : keywords(function, only(settingTable(settings), names), progress_input)
  {}

  static std::vector<Setting> only(const std::vector<Setting>& table, const std::set<std::string>& names)
  {
    std::vector<Setting> kept;
    for (const Setting& setting : table)
      if (names.count(setting.name) > 0)
        kept.push_back(setting);
    return kept;
  }

  /** A stage of \p given keywords over \p surface. */
  template <typename Stage>
  std::shared_ptr<Stage> stage(const ScanSurface& surface, const py::dict& given)
  {
    keywords.take(given);
    words = {movedBy(surface.shift, keywords.vocabulary()), surface.shift};
    intoCloud(settings.centre, surface.shift);
    intoCloud(settings.start_point, surface.shift);
    const auto made = std::make_shared<Stage>();
    made->setInputSurface(surface.surface);
    return made;
  }
};

struct SurfaceCall : Call {
  SurfaceSettings settings;
  Keywords keywords{"surface", settingTable(settings) + units.table(), std::vector<Input>{scanInputs().front()} + progress_input};
};
struct LoopsCall : StageCall {
  LoopsCall() : StageCall("boundary_loops", {"hole_size"}) {}
};
struct GapsCall : StageCall {
  GapsCall() : StageCall("bridge_gaps", {"boundaries", "holes", "hole_size", "gaps"}) {}
};
struct LinesCall : StageCall {
  LinesCall() : StageCall("radial_lines", {"boundaries", "center", "start", "lines", "tool_radius", "scallop", "chord_error"}) {}
};
struct OverCall : StageCall {
  OverCall() : StageCall("spiral_over", namesOf()) {}

  static std::set<std::string> namesOf()
  {
    SpiralSettings settings;
    std::set<std::string> names;
    for (const Setting& setting : cutterTable(settings) + turnTable(settings))
      names.insert(setting.name);
    return names;
  }
};

ScanSurface
surface(const py::object& points, const py::dict& given)
{
  SurfaceCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.settings);
  const auto scanned = std::make_shared<ScannedSurface<Point>>();
  scanned->setInputCloud(call.scan.cloud);
  scanned->setSettings(call.settings);
  call.scan.setSide(*scanned);
  const auto made = std::make_shared<Surface::ConstPtr>();
  compute(scanned, call.keywords, call.words, made);
  return {*made, call.scan.shift};
}

std::vector<BoundaryLoop>
loopsOf(const std::vector<ShiftedLoop>& loops)
{
  std::vector<BoundaryLoop> all;
  for (const ShiftedLoop& one : loops)
    all.push_back(one.loop);
  return all;
}

std::vector<ShiftedLoop>
shifted(const std::vector<BoundaryLoop>& loops, const Eigen::Vector3d& shift)
{
  std::vector<ShiftedLoop> all;
  for (const BoundaryLoop& loop : loops)
    all.push_back({loop, shift});
  return all;
}

std::vector<ShiftedLoop>
boundaryLoops(const ScanSurface& surface, const py::dict& given)
{
  LoopsCall call;
  const auto stage = call.stage<BoundaryLoops<Point>>(surface, given);
  stage->setMinHoleWidth(call.settings.hole_size);
  const auto loops = std::make_shared<std::vector<BoundaryLoop>>();
  compute(stage, call.keywords, call.words, loops);
  return shifted(*loops, surface.shift);
}

std::pair<ScanSurface, std::vector<ShiftedLoop>>
bridgeGaps(const ScanSurface& surface, const std::vector<ShiftedLoop>& loops, const py::dict& given)
{
  GapsCall call;
  const auto stage = call.stage<GapBridging<Point>>(surface, given);
  stage->setBoundaryLoops(loopsOf(loops));
  stage->setBoundaryMode(call.settings.boundary_mode);
  stage->setHoleHandling(call.settings.holes);
  stage->setHoleSize(call.settings.hole_size);
  stage->setGapHandling(call.settings.gaps);
  const auto bridged = std::make_shared<BridgedSurface>();
  compute(stage, call.keywords, call.words, bridged);
  return {{bridged->surface, surface.shift}, shifted(bridged->loops, surface.shift)};
}

ShiftedLines
radialLines(const ScanSurface& surface, const std::vector<ShiftedLoop>& loops, const py::dict& given)
{
  LinesCall call;
  const auto stage = call.stage<RadialLines<Point>>(surface, given);
  stage->setBoundaryLoops(loopsOf(loops));
  stage->setBoundaryMode(call.settings.boundary_mode);
  stage->setLineMethod(call.settings.lines);
  if (call.settings.centre)
    stage->setCenter(*call.settings.centre);
  if (call.settings.start_point)
    stage->setStartPoint(*call.settings.start_point);
  if (call.keywords.isGiven("tool_radius") && call.keywords.isGiven("scallop"))
    stage->setTolerance(lineTolerance(call.settings)); // as the spiral sets them
  stage->setFitTolerance(lineFitTolerance(call.settings));
  const auto lines = std::make_shared<RadialLineSet>();
  compute(stage, call.keywords, call.words, lines);
  return {*lines, surface.shift};
}

Path
spiralOver(const ScanSurface& surface, const std::vector<ShiftedLoop>& loops, const ShiftedLines* lines, const py::dict& given)
{
  OverCall call;
  const auto stage = call.stage<SpiralToolpathGenerator<Point>>(surface, given);
  stage->setSettings(call.settings);
  if (!loops.empty())
    stage->setBoundaryLoops(loopsOf(loops));
  if (lines != nullptr)
    stage->setRadialLines(lines->set);
  const auto points = std::make_shared<pcl::PointCloud<ToolpathPoint>>();
  compute(stage, call.keywords, call.words, points);
  RunReport run;
  run.report = stage->getReport();
  run.settings = call.settings;
  RunFiles files;
  files.shift = surface.shift;
  files.words = call.keywords.vocabulary();
  return {pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(*points),
          {call.settings.tool_radius, call.settings.feed, {}, run.report.pass_begins, surface.shift},
          nullptr,
          reportJSON(files, run),
          textsOf(run.report.warnings, call.words.vocabulary),
          nullptr};
}

std::vector<py::array_t<double>>
geodesicPath(const ScanSurface& surface, const py::handle& source, const py::object& targets)
{
  const auto stage = std::make_shared<GeodesicPath<Point>>();
  stage->setQuiet(true);
  stage->setInputSurface(surface.surface);
  stage->setSourcePoint(placeFrom(source) - surface.shift);
  ReadOptions read;
  read.origin = surface.shift;
  stage->setTargetPoints(lineOf(targets, read, {}));
  const auto lines = std::make_shared<std::vector<Polyline>>();
  Run(py::none())([stage, lines] { stage->compute(*lines); });
  require(stage->getStatus(), {movedBy(surface.shift, Vocabulary{{}, false, nullptr}), surface.shift});
  std::vector<py::array_t<double>> rows;
  for (const Polyline& line : *lines)
    rows.push_back(rowsOf(line, surface.shift));
  return rows;
}

} // namespace

void
addStages(py::module_& module, py::dict& tables)
{
  py::class_<ScanSurface>(module, "Surface")
      .def_property_readonly(
          "points",
          [](const ScanSurface& s) { return rowsOf(s.surface->size(), s.shift, [&s](std::size_t i) { return s.surface->position(i); }); })
      .def_property_readonly("normals",
                             [](const ScanSurface& s) {
                               const Eigen::Vector3d none = Eigen::Vector3d::Zero();
                               return rowsOf(s.surface->size(), none, [&s](std::size_t i) { return s.surface->normal(i); });
                             })
      .def_property_readonly("spacing", [](const ScanSurface& s) { return s.surface->spacing(); })
      .def_property_readonly("noise", [](const ScanSurface& s) { return s.surface->noise(); })
      .def_property_readonly("area", [](const ScanSurface& s) { return s.surface->area(); })
      .def("__len__", [](const ScanSurface& s) { return s.surface->size(); });
  py::class_<ShiftedLoop>(module, "BoundaryLoop")
      .def_property_readonly("points", [](const ShiftedLoop& l) { return rowsOf(l.loop.points, l.shift); })
      .def_property_readonly("curve", [](const ShiftedLoop& l) { return rowsOf(l.loop.curve, l.shift); })
      .def_property_readonly("length", [](const ShiftedLoop& l) { return l.loop.length; })
      .def_property_readonly("type", [](const ShiftedLoop& l) {
        return l.loop.type == LoopType::Outer ? "outer" : l.loop.type == LoopType::Inner ? "inner" : "gap";
      });
  py::class_<ShiftedLines>(module, "RadialLines")
      .def("__len__", [](const ShiftedLines& l) { return l.set.lines.size(); })
      .def_property_readonly("lines", [](const ShiftedLines& l) {
        py::list lines;
        for (const RadialLine& line : l.set.lines)
          lines.append(rowsOf(line.feet.size(), l.shift, [&line](std::size_t i) -> Eigen::Vector3d { return line.feet[i].position; }));
        return lines;
      });
  module.def("surface", &surface);
  module.def("boundary_loops", &boundaryLoops);
  module.def("bridge_gaps", &bridgeGaps);
  module.def("radial_lines", &radialLines);
  module.def("spiral_over", &spiralOver);
  module.def("geodesic_path", &geodesicPath);
  tables["surface"] = SurfaceCall().keywords.table();
  tables["boundary_loops"] = LoopsCall().keywords.table();
  tables["bridge_gaps"] = GapsCall().keywords.table();
  tables["radial_lines"] = LinesCall().keywords.table();
  tables["spiral_over"] = OverCall().keywords.table();
}

} // namespace pcl_spiral::python
