// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A call of one stage.
 */
#pragma once

#include "stages.h"

#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral::python {

using Loops = std::vector<ShiftedLoop>;

/** The settings of a spiral that each stage takes; none: those of cutter and turns. */
extern const std::map<std::string, std::set<std::string>> stage_settings;

/** A call of a stage that stands on what another one gave. */
struct StageCall {
  SpiralSettings settings;
  Keywords keywords;
  Words words;
  std::optional<Run> run;

  explicit StageCall(const std::string& name);
  StageCall(const std::string& name, const py::dict& given, const Eigen::Vector3d& shift);

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

/** The place \p at(i) of each of \p size. */
template <typename At>
Polyline
placesOf(std::size_t size, At at)
{
  Polyline places(size);
  for (std::size_t i = 0; i < size; ++i)
    places[i] = at(i);
  return places;
}

} // namespace pcl_spiral::python
