// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What stages give to Python, and stages of the user's own.
 */
#pragma once

#include "parts.h"

#include <pcl_spiral/spiral/path_planner.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral::python {

/** What a stage gives, and the shift of its scan, see Scan::shift. */
template <typename Value>
struct Shifted {
  Value value;
  Eigen::Vector3d shift;
};
using ShiftedSurface = Shifted<Surface::ConstPtr>;
using ShiftedLoop = Shifted<BoundaryLoop>;

/** planner= and modifiers= */
extern const std::vector<Input> own_stage_inputs;

/** A function of Python as the planner or the modifier of a run: it is given arrays in coordinates before \p shift was subtracted.
 *  @{ */
std::shared_ptr<const PathPlanner> ownPlanner(const py::object& plan, const Run& run, const Eigen::Vector3d& shift);
std::shared_ptr<const PathModifier> ownModifier(const py::object& modify, const Run& run, const Eigen::Vector3d& shift);
/** @} */

/** Sets planner= and modifiers=. */
template <typename Stage>
void
setOwnStages(const Keywords& keywords, const Run& run, const Eigen::Vector3d& shift, Stage& stage)
{
  if (keywords.isGiven("planner"))
    stage.setPlanner(ownPlanner(keywords["planner"], run, shift));
  for (const py::handle modify : keywords.list("modifiers"))
    stage.addModifier(ownModifier(py::reinterpret_borrow<py::object>(modify), run, shift));
}

} // namespace pcl_spiral::python
