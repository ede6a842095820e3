// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Radial lines, added in rounds until the gaps between them are known well enough. Private to spiral.
 */
#pragma once

#include "line_gaps.h"
#include "line_source.h"

#include <pcl_spiral/spiral/impl/radial_lines_engine.h>

#include <vector>

namespace pcl_spiral {

/** Lines of one method: coarse ones, then one in the middle of each gap where lines or rim are not interpolated to the
 *  tolerance. */
class LineRounds {
public:
  /** All arguments must outlive the rounds. */
  LineRounds(const RadialLineRequest& request, const RimCurve& rim, LineSource& source);

  /** Makes the lines. Fails as the source does, or when cancelled. */
  Status run();

  /** In order along the rim. */
  std::vector<RadialLine>& lines() { return lines_; }

  /** Largest error that interpolation between the lines is expected to have, mm. */
  double largestError() const { return largest_error_; }

  /** Largest distance of a line of the last round from what its neighbours predicted, mm, and the line's middle. */
  double jump() const { return jump_; }
  const Eigen::Vector3d& jumpPlace() const { return jump_place_; }

private:
  /** The middles of the gaps that need a line. */
  void chooseGaps(int round);
  Status make(const std::vector<LinePlace>& places, std::vector<Polyline> guesses, std::vector<RadialLine>& lines);
  /** Compares \p added with what its neighbours predicted. */
  void judge(const std::vector<RadialLine>& added);
  void insert(std::vector<RadialLine> added);

  const RadialLineRequest& request_;
  const RimCurve& rim_;
  LineSource& source_;
  std::vector<LinePlace> places_;
  std::vector<RadialLine> lines_;
  std::vector<LinePlace> wanted_;
  std::vector<Polyline> guesses_; ///< of the wanted lines, to start from; empty: none
  std::vector<std::size_t> gaps_; ///< of the wanted lines
  double largest_error_ = 0.0, jump_ = 0.0;
  Eigen::Vector3d jump_place_ = Eigen::Vector3d::Zero();
};

} // namespace pcl_spiral
