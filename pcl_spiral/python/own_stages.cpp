// SPDX-License-Identifier: BSD-3-Clause
// Planners and modifiers that the user writes in Python.
#include "stages.h"

#include "io/report/moved_places.h"

#include <pybind11/stl.h>

namespace pcl_spiral::python {
namespace {

/** A function of Python, what it is called with, and the run that it is called from. */
struct OwnStage {
  OwnStage(const py::object& python, const Run& of_run, const Eigen::Vector3d& of_shift)
  : function(new py::object(python),
             [](const py::object* held) {
               const py::gil_scoped_acquire acquire; // the last run that has it may end without the lock
               delete held;
             }),
    run(of_run), shift(of_shift)
  {}

  py::object surfaceOf(const Surface& surface) const
  {
    return py::cast(ShiftedSurface{std::make_shared<const Surface>(surface), shift}); // which shares its data
  }
  py::dict settingsOf(const SpiralSettings& given) const
  {
    SpiralSettings settings = movedBy(shift, given);
    return valuesOf(settingTable(settings));
  }
  Polyline placesOf(const py::handle& rows) const
  {
    Polyline places = vectorsOf<Eigen::Vector3d>(py::reinterpret_borrow<py::object>(rows));
    for (Eigen::Vector3d& place : places)
      place -= shift;
    return places;
  }

  std::shared_ptr<const py::object> function;
  Run run;
  Eigen::Vector3d shift;
};

struct OwnPlanner : PathPlanner, OwnStage {
  using OwnStage::OwnStage;
  Status plan(const PlannerInput& input, LinkedPath& path) const override
  {
    return run.call([&] {
      py::list loops;
      for (const BoundaryLoop& loop : input.boundaries)
        loops.append(ShiftedLoop{loop, shift});
      const py::tuple made = (*function)(surfaceOf(input.surface), loops, settingsOf(input.settings));
      path.points = placesOf(made[0]);
      path.passes = made[1].cast<std::vector<std::size_t>>();
    });
  }
};

struct OwnModifier : PathModifier, OwnStage {
  using OwnStage::OwnStage;
  Status modify(const Surface& surface, const SpiralSettings& settings, SpiralPath& path) const override
  {
    return run.call([&] {
      py::dict arrays(py::arg("contact") = rowsOf(path.contacts, shift), py::arg("normal") = rowsOf(path.normals),
                      py::arg("axis") = rowsOf(path.axes), py::arg("turn") = path.turns, py::arg("over_gap") = path.over_gap,
                      py::arg("foot") = rowsOf(path.feet, shift), py::arg("lift") = path.lifts, py::arg("passes") = path.passes);
      arrays = (*function)(surfaceOf(surface), settingsOf(settings), arrays);
      path.contacts = placesOf(arrays["contact"]);
      path.normals = vectorsOf<Eigen::Vector3d>(py::object(arrays["normal"]));
      path.axes = vectorsOf<Eigen::Vector3f>(py::object(arrays["axis"]));
      path.turns = arrays["turn"].cast<std::vector<float>>();
      path.over_gap = arrays["over_gap"].cast<std::vector<std::uint8_t>>();
      path.feet = placesOf(arrays["foot"]);
      path.lifts = arrays["lift"].cast<std::vector<float>>();
      path.passes = arrays["passes"].cast<std::vector<std::size_t>>();
    });
  }
};

} // namespace

const std::vector<Input> own_stage_inputs{
    {"planner",
     "Planner | None",
     "makes the curve in place of the spiral: an object with plan(surface, boundaries, settings)",
     {"setPlanner"}},
    {"modifiers",
     "Sequence[Modifier]",
     "change the path before it is checked, one after the other: objects with modify(surface, settings, path)",
     {"addModifier"}}};

std::shared_ptr<const PathPlanner>
ownPlanner(const py::object& plan, const Run& run, const Eigen::Vector3d& shift)
{
  return std::make_shared<OwnPlanner>(plan, run, shift);
}

std::shared_ptr<const PathModifier>
ownModifier(const py::object& modify, const Run& run, const Eigen::Vector3d& shift)
{
  return std::make_shared<OwnModifier>(modify, run, shift);
}

} // namespace pcl_spiral::python
