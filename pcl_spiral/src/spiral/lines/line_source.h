// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines from the centre or inner loop to given places on the rim. Private.
 */
#pragma once

#include "geodesic/harmonic_field.h"
#include "surface_centre.h"
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>

#include <cstdint>

namespace pcl_spiral {

/** Makes batches of lines by one method. */
class LineSource {
public:
  /** \p harmonic: gradient lines as they are; otherwise geodesics, which start from the centre's rough lines (one boundary)
   *  or the harmonic function's lines (two). */
  LineSource(const RadialLineRequest& request, const SurfaceCentre& centre, bool harmonic);

  /** Solve the field behind the lines. */
  Status prepare();

  /** Whether a line may start from a guess. */
  bool takesGuesses() const { return !harmonic_ && !request_.inner; }

  /** A line to each place on the rim, started from its guess, the line predicted from its neighbours (none or empty:
   *  no guess). On failure the message names the place. */
  Status make(const Polyline& rim_places, std::vector<Polyline> guesses, std::vector<RadialLine>& lines) const;

private:
  Polyline traced(const Eigen::Vector3d& place) const;
  Status refine(const Polyline& rim_places, std::vector<Polyline>& starts, const std::vector<std::uint8_t>& guessed,
                std::vector<RadialLine>& lines) const;
  Status putOnSurface(std::vector<Polyline>& traces, std::vector<RadialLine>& lines) const;
  Status fit(std::vector<RadialLine>& lines) const;

  const RadialLineRequest& request_;
  const SurfaceCentre& centre_;
  bool harmonic_;
  HarmonicField potential_;
};

} // namespace pcl_spiral
