// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What several calls take: cutter, choice of the part, progress.
 */
#pragma once

#include "arrays.h"
#include "running.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/planning/part_choice.h>

#include <string>
#include <vector>

namespace pcl_spiral::python {

/** Both. */
std::vector<Input> operator+(std::vector<Input> inputs, const std::vector<Input>& more);

/** holder= and progress=
 *  @{ */
extern const std::vector<Input> holder_input, progress_input;
/** @} */

/** The inputs of a scan, and crop=, keep_outs= and regions=. */
std::vector<Input> partInputs();

/** Sets the largest corner of \p cutter if none is asked for. Raises for a cutter that is none; a radius of 0 is a beam. */
void completeCutter(const Keywords& keywords, const Words& words, CutterShape& cutter);

/** A place of the user in the coordinates of the cloud. */
inline void
intoCloud(std::optional<Eigen::Vector3d>& place, const Eigen::Vector3d& shift)
{
  if (place)
    *place -= shift;
}

/** The scan of a call, how it is read, and how the call speaks of it. */
struct Call {
  GivenUnits units;
  Words words;
  GivenScan scan;

  /** Reads \p points, and takes the places of \p surface into its coordinates. \p normals: the keyword for them. */
  void read(const py::object& points, const Keywords& keywords, SurfaceSettings& surface, const std::string& normals = "normals");
  ReadOptions beside() const { return units.options(scan.shift); } ///< How what belongs to the scan is read.
  RunFiles files(const Diagnostics& warnings) const;               ///< For a report.
  std::vector<std::string> texts(const Diagnostics& warnings) const { return textsOf(warnings, words.vocabulary); }
};

/** A box of (xmin, xmax, ymin, ymax) or also zmin, zmax. */
Eigen::AlignedBox3d boxOf(const py::array_t<double>& numbers, const ReadOptions& read, const Words& words);

/** Whether \p given is one row of numbers. */
inline bool
isRow(const py::object& given)
{
  return py::isinstance<py::array>(given) && py::array(given).ndim() == 1;
}

/** Sets scan or mesh, crop, keep-outs and regions. */
template <typename Planner>
void
setPart(const Call& call, const Keywords& keywords, Planner& planner)
{
  if (call.scan.mesh)
    planner.setInputMesh(call.scan.mesh);
  else
    planner.setInputCloud(call.scan.cloud);
  call.scan.setSide(planner);
  const ReadOptions read = call.beside();
  if (const py::object crop = keywords["crop"]; isRow(crop))
    planner.setCropBox(boxOf(crop, read, call.words));
  else if (!crop.is_none())
    planner.setCrop(polygonOf("crop", crop, read, call.words));
  for (const py::handle keep_out : keywords.list("keep_outs"))
    planner.addKeepOut(polygonOf("keep_outs", py::reinterpret_borrow<py::object>(keep_out), read, call.words));
  for (const py::handle one : keywords.list("regions")) {
    const auto region = py::reinterpret_borrow<py::object>(one);
    if (isRow(region))
      planner.addRegion({std::nullopt, placeFrom(region) - call.scan.shift, ""});
    else
      planner.addRegion({polygonOf("regions", region, read, call.words), std::nullopt, ""});
  }
}

/** A planner whose settings of the surface can be set at once. */
template <typename Planner>
struct OpenPlanner : Planner {
  const SurfaceSettings& getSurface() const { return this->surfaceSettings(); }
  void setSurface(const SurfaceSettings& asked)
  {
    const bool strict = this->surfaceSettings().strict;
    this->surfaceSettings() = asked;
    this->surfaceSettings().strict = strict;
  }
};

/** Runs compute of \p planner for what is \p made, quietly and with progress=. Raises what it refuses. */
template <typename Planner, typename... Made>
void
compute(const std::shared_ptr<Planner>& planner, const Keywords& keywords, const Words& words, const std::shared_ptr<Made>&... made)
{
  const Run run(keywords["progress"]);
  planner->setQuiet(true);
  planner->setProgressCallback(run.progress());
  run([planner, made...] { planner->compute(*made...); });
  planner->setProgressCallback(nullptr);
  require(planner->getStatus(), words);
}

} // namespace pcl_spiral::python
