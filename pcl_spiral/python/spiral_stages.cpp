// SPDX-License-Identifier: BSD-3-Clause
// Stages of the spiral, and the lines of a ridge. Lengths and places in mm.
#include "path.h"
#include "stage_call.h"

#include "io/report/moved_places.h"
#include "planning/input_tables.h"
#include <pcl_spiral/planning/impl/ridge_planning.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pybind11/stl.h>

#include <utility>

namespace pcl_spiral::python {
namespace {

using Point = pcl::PointXYZ;
using ShiftedLines = Shifted<RadialLineSet>;
using ShiftedField = Shifted<StepOverDistance::ConstPtr>;
/** Loops, and the field that they were drawn on. */
struct FieldLoops {
  ScallopLoopSet set;
  StepOverDistance::ConstPtr field;
};
using ShiftedRings = Shifted<FieldLoops>;
using ShiftedPath = Shifted<LinkedPath>;

/** A stage whose settings can be set at once. */
template <typename Stage>
struct OpenStage : Stage {
  using Stage::settings_;
};

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
addSpiralStages(py::module_& module, py::dict& tables)
{
  addLines(module);
  module.def("radial_lines", &radialLines);
  module.def("step_over_field", &stepOverField);
  module.def("scallop_loops", &scallopLoops);
  module.def("link_loops", &linkLoops);
  module.def("spiral_over", &spiralOver);
  module.def("ridge_lines", &ridgeLines);
  RidgeLinesCall().keywords.addTo(tables);
  for (const auto& [name, settings] : stage_settings)
    StageCall(name).keywords.addTo(tables);
}

} // namespace pcl_spiral::python
