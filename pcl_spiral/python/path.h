// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path as Python has it.
 */
#pragma once

#include "arrays.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/planning/spiral_plan.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral::python {

/** What a path was made from; a path that was unpickled has none. */
struct PathSource {
  std::shared_ptr<const SpiralPlan> spiral; ///< null: passes
  std::shared_ptr<const PassPlan> passes;   ///< null: a spiral
  PassSettings tool;                        ///< of passes
  std::string title;                        ///< the name of its scan, for comments in programs
  ReadOptions read;                         ///< how the coordinates of the user become those of the cloud
};

/** A path. The arrays are views of this object, and live as long as one of them. */
struct Path {
  pcl::PointCloud<ToolpathPoint>::ConstPtr points; ///< never null
  ToolpathMotion motion;                           ///< radius, feed, tips of a cutter that is no ball, passes, shift
  std::shared_ptr<const ToolPoses> poses;          ///< in the coordinates of the scan; null: not made yet
  std::string report;                              ///< JSON
  std::vector<std::string> warnings;
  std::shared_ptr<const PathSource> source; ///< null: unpickled
};

/** Poses of a path in the coordinates of the scan. */
ToolPoses posesOf(const pcl::PointCloud<ToolpathPoint>& points, const ToolpathMotion& motion);

/** Numbers (N, 3) or (N), where they stand in \p owner, \p stride bytes apart; read only. */
template <typename Number, typename Owner>
py::array
viewOf(const std::shared_ptr<Owner>& owner, const Number* first, std::size_t size, std::size_t stride, bool triples)
{
  const py::capsule keep(new std::shared_ptr<Owner>(owner), [](void* held) { delete static_cast<std::shared_ptr<Owner>*>(held); });
  const auto rows = static_cast<py::ssize_t>(size), step = static_cast<py::ssize_t>(stride);
  const auto width = static_cast<py::ssize_t>(sizeof(Number));
  py::array view = triples ? py::array(py::dtype::of<Number>(), {rows, py::ssize_t{3}}, {step, width}, first, keep)
                           : py::array(py::dtype::of<Number>(), {rows}, {step}, first, keep);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

/** \p path as a program, CLDATA or robot frames; what is reported of it. */
py::dict writeProgram(const Path& path, const std::string& file, const py::dict& given);

/** Adds to \p module its classes and calls, and to \p tables the keywords of each call.
 *  @{ */
void addPath(py::module_& module);
void addPlanning(py::module_& module, py::dict& tables);
void addPrograms(py::dict& tables);
void addVerification(py::module_& module, py::dict& tables);
void addSurfaceStages(py::module_& module, py::dict& tables);
void addSpiralStages(py::module_& module, py::dict& tables);
/** @} */

} // namespace pcl_spiral::python
