// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs of SpiralPlanner with trials of remedies. Lengths in mm.
 */
#pragma once

#include "support/plate_scans.h"
#include "support/remedies.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include "planning/single_change.h"
#include <pcl_spiral/planning/spiral_planner.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace pcl_spiral::test {

/** A planner that shows what it plans. */
struct Spiral : SpiralPlanner<pcl::PointXYZ> {
  PlanInput input() const
  {
    PlanInput input;
    input.cloud = this->input_;
    input.settings = this->settings_;
    input.choice = this->choice();
    input.holder = this->holder_;
    input.flank_length = getFlankLength();
    return input;
  }
};
using SpiralChange = Change<Spiral>;
using SpiralRemedies = std::vector<Remedy<Spiral>>;

/** Whether the value \p given is the one \p proposed: a number to 1 %, as it is rounded; of keep-outs one that covers the box, and any for
 *  a number, by which one grows. */
inline bool
isTried(const Proposed& proposed, const Given& given)
{
  if (proposed.setting != given.setting)
    return false;
  const auto *box = std::get_if<Extents>(&proposed.value), *given_box = std::get_if<Extents>(&given.value);
  const auto *number = std::get_if<double>(&proposed.value), *given_number = std::get_if<double>(&given.value);
  if (box && given_box)
    return (given_box->low.array() <= box->low.array()).all() && (given_box->high.array() >= box->high.array()).all();
  if (number && given_number)
    return std::abs(*number - *given_number) <= 0.01 * *number;
  if (number && given_box)
    return proposed.setting == "addKeepOut";
  return Diagnostic(proposed) == Diagnostic(Proposed(given));
}

/** What is wrong: each value that the refusal of \p planner proposes for a setting must be among the changes that are tried. */
inline std::string
proposedButNotTried(const Spiral& planner)
{
  const Status& status = planner.getStatus();
  if (status.ok() || status.code() == StatusCode::InvalidArgument) // its value alone is wrong
    return "";
  const std::vector<SingleChange> changes = singleChanges(planner.input(), {status, true});
  for (const Proposed& proposed : status.diagnostic().proposed()) {
    const auto tries = [&](const SingleChange& change) {
      const std::vector<Given> given = change.words.settings.given();
      return std::any_of(given.begin(), given.end(), [&](const Given& g) { return isTried(proposed, g); });
    };
    if (std::none_of(changes.begin(), changes.end(), tries))
      return "\n    " + proposed.setting + " is proposed, but " + Diagnostic(proposed).text() + " is not tried";
  }
  return "";
}

inline Said
saySpiral(Spiral& planner)
{
  planner.compute();
  if (const std::string fault = proposedButNotTried(planner); !fault.empty())
    return {{StatusCode::Failed, Diagnostic(planner.getStatus().message(), fault)}, {}};
  return {planner.getStatus(), planner.getWarnings()};
}

/** A path of a ball of radius 3 over \p scan, with \p change. */
inline RemediedJob
spiralOver(const std::function<ScanPtr()>& scan, const char* words, const SpiralChange& change, const SpiralRemedies& remedies)
{
  const SpiralChange prepare = [scan, change](Spiral& planner) {
    planner.setInputCloud(scan());
    planner.setToolRadius(3.0);
    planner.setScallopHeight(0.05);
    planner.setRemedyTries(0); // what the refusal itself names
    change(planner);
  };
  return remediedJob<Spiral>(words, saySpiral, prepare, remedies);
}

/** A cap of a ball of radius 10. */
inline ScanPtr
dome()
{
  return toCloud(sampleUniform(*ball(10.0, Region({circle({0, 0}, 9.0)})), 3000, 5).points);
}

inline Prism
box(double x0, double x1, double y0, double y1)
{
  return Prism({{x0, y0, 0.0}, {x1, y0, 0.0}, {x1, y1, 0.0}, {x0, y1, 0.0}}, Eigen::Vector3d::UnitZ());
}

inline SpiralChange
keepOut(const Prism& prism)
{
  return [prism](Spiral& s) { s.addKeepOut(prism); };
}

/** Keeps out of the box that the diagnostic has from its place \p first on. */
inline SpiralChange
keepOutOf(std::size_t first)
{
  return [first](Spiral& s, const Diagnostic& said) {
    const Eigen::Vector3d a = said.places().at(first), b = said.places().at(first + 1);
    s.addKeepOut(box(a.x(), b.x(), a.y(), b.y()));
  };
}

inline SpiralChange
crop(const Prism& prism)
{
  return [prism](Spiral& s) { s.setCrop(prism); };
}

inline SpiralChange
method(SpiralMethod method)
{
  return [method](Spiral& s) { s.setMethod(method); };
}

} // namespace pcl_spiral::test
