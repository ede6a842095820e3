// SPDX-License-Identifier: BSD-3-Clause
// Single stages: a surface, its loops, lines on it, and the spiral over what they give. Lengths and places in mm.
#include "stages.h"
#include "path.h"

#include "io/report/moved_places.h"
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <pybind11/stl.h>

#include <map>
#include <set>
#include <utility>

namespace pcl_spiral::python {
namespace {

using Point = pcl::PointXYZ;
using Loops = std::vector<ShiftedLoop>;
using ShiftedLines = Shifted<RadialLineSet>;
using ShiftedField = Shifted<StepOverDistance::ConstPtr>;
/** Loops, and the field that they were drawn on. */
struct FieldLoops {
  ScallopLoopSet set;
  StepOverDistance::ConstPtr field;
};
using ShiftedRings = Shifted<FieldLoops>;
using ShiftedPath = Shifted<LinkedPath>;

/** The settings of a spiral that each stage takes; none: those of cutter and turns. */
const std::map<std::string, std::set<std::string>> stage_settings{
    {"boundary_loops", {"hole_size"}},
    {"bridge_gaps", {"boundaries", "holes", "hole_size", "gaps"}},
    {"radial_lines", {"boundaries", "center", "start", "lines", "tool_radius", "scallop", "chord_error"}},
    {"step_over_field", {"tool_radius", "scallop"}},
    {"scallop_loops", {"threads"}},
    {"link_loops", {"direction", "sense", "start", "one_way"}},
    {"boundary_points", {"neighbours"}},
    {"project", {"neighbours"}},
    {"spiral_over", {}}};

/** A call of a stage that stands on what another one gave. */
struct StageCall {
  SpiralSettings settings;
  Keywords keywords;
  Words words;
  std::optional<Run> run;

  explicit StageCall(const std::string& name)
  : keywords(name,
             stage_settings.at(name).empty() ? cutterTable(settings) + turnTable(settings)
                                             : only(settingTable(settings), stage_settings.at(name)),
             (name == "spiral_over" ? own_stage_inputs : std::vector<Input>()) + progress_input)
  {}

  StageCall(const std::string& name, const py::dict& given, const Eigen::Vector3d& shift) : StageCall(name)
  {
    keywords.take(given);
    ReadOptions read;
    read.origin = shift;
    words = {keywords.vocabulary(), read};
    keywords.readPlaces(read);
    run.emplace(keywords["progress"]);
  }

  /** What \p stage makes over \p surface. */
  template <typename Made, typename Stage>
  Made made(const std::shared_ptr<Stage>& stage)
  {
    const auto made = std::make_shared<Made>();
    compute(stage, *run, words, made);
    return std::move(*made);
  }
};

/** A stage over \p surface, whose loops are \p loops. */
template <typename Stage>
std::shared_ptr<Stage>
over(const ShiftedSurface& surface, const Loops& loops)
{
  const auto stage = std::make_shared<Stage>();
  stage->setInputSurface(surface.value);
  std::vector<BoundaryLoop> all;
  for (const ShiftedLoop& one : loops)
    all.push_back(one.value);
  if (!all.empty())
    stage->setBoundaryLoops(all);
  return stage;
}

/** A stage whose settings can be set at once. */
template <typename Stage>
struct OpenStage : Stage {
  using Stage::settings_;
};

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

ShiftedLines
radialLines(const ShiftedSurface& surface, const Loops& loops, const py::dict& given)
{
  StageCall call("radial_lines", given, surface.shift);
  const auto stage = over<RadialLines<Point>>(surface, loops);
  stage->setBoundaryMode(call.settings.boundary_mode);
  stage->setLineMethod(call.settings.lines);
  if (call.settings.centre)
    stage->setCenter(*call.settings.centre);
  if (call.settings.start_point)
    stage->setStartPoint(*call.settings.start_point);
  if (call.keywords.isGiven("tool_radius") && call.keywords.isGiven("scallop"))
    stage->setTolerance(lineTolerance(call.settings)); // as the spiral sets them
  stage->setFitTolerance(lineFitTolerance(call.settings));
  return {call.made<RadialLineSet>(stage), surface.shift};
}

ShiftedField
stepOverField(const ShiftedSurface& surface, const Loops& loops, const py::dict& given)
{
  StageCall call("step_over_field", given, surface.shift);
  const auto stage = over<OpenStage<StepOverField<Point>>>(surface, loops);
  stage->settings_ = call.settings;
  return {call.made<StepOverDistance::ConstPtr>(stage), surface.shift};
}

ShiftedRings
scallopLoops(const ShiftedField& field, const py::dict& given)
{
  StageCall call("scallop_loops", given, field.shift);
  const auto stage = std::make_shared<OpenStage<ScallopLoops<Point>>>();
  stage->settings_ = call.settings;
  stage->setInputField(field.value);
  return {{call.made<ScallopLoopSet>(stage), field.value}, field.shift};
}

ShiftedPath
linkLoops(const ShiftedRings& loops, const py::dict& given)
{
  StageCall call("link_loops", given, loops.shift);
  const auto stage = std::make_shared<OpenStage<LoopLinking<Point>>>();
  stage->settings_ = call.settings;
  stage->setInputField(loops.value.field);
  stage->setInputLoops(loops.value.set.loops);
  return {call.made<LinkedPath>(stage), loops.shift};
}

/** Sets lines, a field, loops or a linked path in place of what the generator makes. */
void
setMade(const py::object& made, SpiralToolpathGenerator<Point>& stage)
{
  if (py::isinstance<ShiftedLines>(made))
    stage.setRadialLines(made.cast<const ShiftedLines&>().value);
  else if (py::isinstance<ShiftedField>(made))
    stage.setStepOverField(made.cast<const ShiftedField&>().value);
  else if (py::isinstance<ShiftedRings>(made)) {
    const FieldLoops& loops = made.cast<const ShiftedRings&>().value;
    stage.setScallopLoops(loops.set.loops);
    stage.setStepOverField(loops.field);
  }
  else if (py::isinstance<ShiftedPath>(made))
    stage.setLinkedPath(made.cast<const ShiftedPath&>().value);
  else if (!made.is_none())
    raiseType("made= must be RadialLines, a StepOverField, ScallopLoops or a LinkedPath, as the stages give them");
}

Path
spiralOver(const ShiftedSurface& surface, const Loops& loops, const py::object& made, const py::dict& given)
{
  StageCall call("spiral_over", given, surface.shift);
  const auto stage = over<SpiralToolpathGenerator<Point>>(surface, loops);
  stage->setSettings(call.settings);
  setMade(made, *stage);
  setOwnStages(call.keywords, *call.run, surface.shift, *stage);
  auto points = call.made<pcl::PointCloud<ToolpathPoint>>(stage);
  RunReport run;
  run.report = stage->getReport();
  run.settings = call.settings;
  RunFiles files;
  files.shift = surface.shift;
  files.words = call.keywords.vocabulary();
  return {pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(points)),
          {call.settings.tool_radius, call.settings.feed, {}, run.report.pass_begins, surface.shift},
          nullptr,
          reportJSON(files, run),
          textsOf(run.report.warnings, call.words.vocabulary),
          nullptr};
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

template <typename At>
Polyline
placesOf(std::size_t size, At at)
{
  Polyline places(size);
  for (std::size_t i = 0; i < size; ++i)
    places[i] = at(i);
  return places;
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

struct RidgeLinesCall : Call {
  SurfaceSettings settings;
  RidgePlanInput input;
  Keywords keywords{"ridge_lines",
                    only(settingTable(input), {"half_width", "closed"}) + only(settingTable(input.ridge), {"reference", "flip_normals"}) +
                        only(settingTable(settings), {"largest", "thin", "threads"}) + units.table(),
                    std::vector<Input>{{"through", "ArrayLike | File | None", "rough points on the ridge, in order", {"setRoughPoints"}}} +
                        progress_input};
};

/** Rail and generator of a ridge in a scan. */
py::tuple
ridgeLines(const py::object& points, const py::dict& given)
{
  RidgeLinesCall call;
  call.begin(call.keywords, given, points, call.settings);
  const auto stage = std::make_shared<RidgeLines<Point>>();
  stage->setInputCloud(call.scan.cloud);
  stage->setLargestPart(call.settings.largest_part);
  stage->setThinning(call.settings.thinning);
  stage->setNumberOfThreads(call.settings.threads);
  stage->setRoughPoints(lineOf(call.keywords["through"], call.words));
  stage->setHalfWidth(call.input.half_width);
  stage->setClosed(call.input.closed);
  stage->setReferenceNormal(call.input.ridge.reference);
  stage->setFlipNormals(call.input.ridge.flip);
  const auto rail = std::make_shared<pcl::PointCloud<Point>>(), generator = std::make_shared<pcl::PointCloud<Point>>();
  compute(stage, Run(call.keywords["progress"]), call.words, rail, generator);
  return py::make_tuple(rowsOf(stage->getRail(), call.scan.shift), rowsOf(stage->getGenerator(), call.scan.shift));
}

/** The lines of \p shifted, which \p lineAt gives. */
template <typename Value, typename LineAt>
py::list
linesOf(const Shifted<Value>& shifted, std::size_t size, LineAt lineAt)
{
  py::list lines;
  for (std::size_t i = 0; i < size; ++i)
    lines.append(rowsOf(lineAt(i), shifted.shift));
  return lines;
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

void
addLines(py::module_& module)
{
  py::class_<ShiftedLines>(module, "RadialLines")
      .def("__len__", [](const ShiftedLines& l) { return l.value.lines.size(); })
      .def_property_readonly("lines", [](const ShiftedLines& l) {
        return linesOf(l, l.value.lines.size(), [&l](std::size_t i) {
          const auto& feet = l.value.lines[i].feet;
          return placesOf(feet.size(), [&feet](std::size_t k) -> Eigen::Vector3d { return feet[k].position; });
        });
      });
  py::class_<ShiftedField>(module, "StepOverField")
      .def_property_readonly("points", [](const ShiftedField& f) { return rowsOf(f.value->mesh.positions, f.shift); })
      .def_property_readonly("distance", [](const ShiftedField& f) { return numbersOf(f.value->distance); })
      .def_property_readonly("largest", [](const ShiftedField& f) { return f.value->largest; })
      .def_property_readonly("least_length", [](const ShiftedField& f) { return f.value->least_length; });
  py::class_<ShiftedRings>(module, "ScallopLoops")
      .def("__len__", [](const ShiftedRings& r) { return r.value.set.loops.size(); })
      .def_property_readonly("loops",
                             [](const ShiftedRings& r) {
                               return linesOf(r, r.value.set.loops.size(), [&r](std::size_t i) { return r.value.set.loops[i].points; });
                             })
      .def_property_readonly("levels", [](const ShiftedRings& r) {
        py::list levels;
        for (const ScallopLoop& loop : r.value.set.loops)
          levels.append(loop.level);
        return levels;
      });
  py::class_<ShiftedPath>(module, "LinkedPath")
      .def_property_readonly("points", [](const ShiftedPath& p) { return rowsOf(p.value.points, p.shift); })
      .def_property_readonly("chain_loops", [](const ShiftedPath& p) { return p.value.chain_loops; })
      .def_property_readonly("bridges", [](const ShiftedPath& p) { return p.value.bridges; });
}

} // namespace

void
addStages(py::module_& module, py::dict& tables)
{
  addSurface(module);
  addLines(module);
  module.def("surface", &surface);
  module.def("boundary_loops", &boundaryLoops);
  module.def("bridge_gaps", &bridgeGaps);
  module.def("radial_lines", &radialLines);
  module.def("step_over_field", &stepOverField);
  module.def("scallop_loops", &scallopLoops);
  module.def("link_loops", &linkLoops);
  module.def("spiral_over", &spiralOver);
  module.def("geodesic_path", &geodesicPath);
  module.def("project", &project);
  module.def("boundary_points", &boundaryPoints);
  module.def("ridge_lines", &ridgeLines);
  SurfaceCall().keywords.addTo(tables);
  RidgeLinesCall().keywords.addTo(tables);
  for (const auto& [name, settings] : stage_settings)
    StageCall(name).keywords.addTo(tables);
}

} // namespace pcl_spiral::python
