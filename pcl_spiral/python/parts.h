// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What several calls take: cutter, choice of the part, progress.
 */
#pragma once

#include "arrays.h"
#include "running.h"

#include "planning/idle_settings.h"
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

/** Refuses a setting that was asked for and does nothing. */
void requireUsed(const std::optional<IdleSetting>& idle, const Words& words);

/** The scan of a call, how it is read, and how the call speaks of it. */
struct Call {
  GivenUnits units;
  Words words;
  GivenScan scan;

  /** Takes the keywords, reads \p points, and takes the places of the settings into its coordinates. \p surface: those of the surface.
   *  \p normals: the keyword for them. */
  void begin(Keywords& keywords, const py::dict& given, const py::object& points, SurfaceSettings& surface,
             const std::string& normals = "normals");
  AskedJob asked(const Keywords& keywords) const { return {scan.mesh != nullptr, keywords.isGiven("holder")}; }
  RunFiles files(const Diagnostics& warnings) const; ///< For a report.
  std::vector<std::string> texts(const Diagnostics& warnings) const { return textsOf(warnings, words.vocabulary); }
};

/** A box of (xmin, xmax, ymin, ymax) or also zmin, zmax. */
Eigen::AlignedBox3d boxOf(const py::array_t<double>& numbers, const Words& words);

/** Whether \p given is one row of numbers. */
inline bool
isRow(const py::object& given)
{
  return py::isinstance<py::array>(given) && py::array(given).ndim() == 1;
}

/** Sets scan or mesh, and its side. */
template <typename Stage>
void
setScan(const GivenScan& scan, Stage& stage)
{
  if (scan.mesh)
    stage.setInputMesh(scan.mesh);
  else
    stage.setInputCloud(scan.cloud);
  scan.setSide(stage);
}

/** Sets scan or mesh, crop, keep-outs and regions. */
template <typename Planner>
void
setPart(const Call& call, const Keywords& keywords, Planner& planner)
{
  setScan(call.scan, planner);
  if (const py::object crop = keywords["crop"]; isRow(crop))
    planner.setCropBox(boxOf(crop, call.words));
  else if (!crop.is_none())
    planner.setCrop(polygonOf("crop", crop, call.words));
  for (const py::handle keep_out : keywords.list("keep_outs"))
    planner.addKeepOut(polygonOf("keep_outs", py::reinterpret_borrow<py::object>(keep_out), call.words));
  for (const py::handle one : keywords.list("regions")) {
    const auto region = py::reinterpret_borrow<py::object>(one);
    if (isRow(region))
      planner.addRegion({std::nullopt, placeFrom(region, call.words.read), ""});
    else
      planner.addRegion({polygonOf("regions", region, call.words), std::nullopt, ""});
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

/** Sets the progress of a stage that has one.
 *  @{ */
template <typename Stage>
auto
setProgress(Stage& stage, const ProgressCallback& progress, int) -> decltype(stage.setProgressCallback(progress))
{
  stage.setProgressCallback(progress);
}
template <typename Stage>
void
setProgress(Stage& /*stage*/, const ProgressCallback& /*progress*/, long)
{}
/** @} */

/** Runs compute of \p planner for what is \p made, quietly. Raises what it refuses. */
template <typename Planner, typename... Made>
void
compute(const std::shared_ptr<Planner>& planner, const Run& run, const Words& words, const std::shared_ptr<Made>&... made)
{
  planner->setQuiet(true);
  setProgress(*planner, run.progress(), 0);
  run([planner, made...] { planner->compute(*made...); });
  setProgress(*planner, nullptr, 0);
  require(planner->getStatus(), words);
}

} // namespace pcl_spiral::python
