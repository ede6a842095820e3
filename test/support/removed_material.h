// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Stock and gouges of a ball cutter, against an exact surface. Lengths in mm.
 */
#pragma once

#include "support/checked_path.h"
#include "support/surfaces.h"

#include <cstddef>
#include <cstdint>

namespace pcl_spiral::test {

struct RemovalSettings {
  double tool_radius = 0.0;
  double scallop_height = 0.0;
  std::size_t samples = 100000; ///< by area; the ridge is searched at each sample
  std::uint64_t seed = 1;
  int threads = 0; ///< 0: all
};

/** Stock at surface samples. */
struct StockReport {
  std::size_t samples = 0;
  double p50 = 0.0, p90 = 0.0, p99 = 0.0, p999 = 0.0;
  Place max;
  double uncut_share = 0.0; ///< nothing met within 20 scallop heights
  Place uncut;              ///< one such place; value is the share
};

struct RemovalReport {
  StockReport stock; ///< at the samples themselves, farther than the band from the outline
  StockReport ridge; ///< highest within the pitch round each sample; max also searches along the path
  StockReport rim;   ///< at the samples within the band
  Place gouge;       ///< deepest, anywhere
  double band = 0.0; ///< width left out at the outline: the largest exact step-over on the surface
};

/** Sweeps the ball along the linear moves of its centre (contact + R normal) and measures at exact surface
 * samples.
 *
 *  Stock at x is the smallest t at which x + t n enters the swept solid, a union of capsules. Cusps are
 * V-shaped, so from every sample the top of the ridge is searched across the feed. A gouge is where x is
 * inside; the deepest penetration of a ball at centre q is R minus the distance of q to the surface, and is
 * also searched along every move.
 */
RemovalReport removedMaterial(const AnalyticSurface& surface, const CheckedPath& path, const RemovalSettings& settings);

} // namespace pcl_spiral::test
