// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What several calls take: cutter, choice of the part, progress.
 */
#pragma once

#include "arrays.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/planning/part_choice.h>

#include <string>
#include <vector>

namespace pcl_spiral::python {

/** Both. */
std::vector<Input> operator+(std::vector<Input> inputs, const std::vector<Input>& more);

/** progress= */
extern const std::vector<Input> progress_input;

/** The inputs of a scan, and crop=, keep_outs= and regions=. */
std::vector<Input> partInputs();

/** The cutter; \p radius: what its radius may be. */
std::vector<Setting> cutterTable(const NumberRange& radius, CutterShape& cutter, double& corner_radius);

/** Sets the corner of \p cutter: the one asked for, else the largest. Raises for a cutter that is none; a radius of 0 is a beam. */
void completeCutter(const Keywords& keywords, double corner_radius, const Words& words, CutterShape& cutter);

/** A box of (xmin, xmax, ymin, ymax) or also zmin, zmax; nothing if \p given is no array of so many numbers. */
std::optional<Eigen::AlignedBox3d> boxOf(const py::object& given, const ReadOptions& read, const Words& words);

/** A polygon, or a place on a separate part. */
PlanRegion regionOf(const py::object& given, const ReadOptions& read, const Eigen::Vector3d& shift, const Words& words);

/** Sets crop, keep-outs and regions. */
template <typename Planner>
void
setPart(const Keywords& keywords, const ReadOptions& read, const Eigen::Vector3d& shift, const Words& words, Planner& planner)
{
  if (const py::object crop = keywords["crop"]; !crop.is_none()) {
    if (const auto box = boxOf(crop, read, words))
      planner.setCropBox(*box);
    else
      planner.setCrop(polygonOf("crop", crop, read, words));
  }
  if (const py::object keep_outs = keywords["keep_outs"]; !keep_outs.is_none())
    for (const py::handle keep_out : keep_outs)
      planner.addKeepOut(polygonOf("keep_outs", py::reinterpret_borrow<py::object>(keep_out), read, words));
  if (const py::object regions = keywords["regions"]; !regions.is_none())
    for (const py::handle region : regions)
      planner.addRegion(regionOf(py::reinterpret_borrow<py::object>(region), read, shift, words));
}

} // namespace pcl_spiral::python
