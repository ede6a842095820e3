// SPDX-License-Identifier: BSD-3-Clause
#include "chain_crossings.h"

#include "spiral/path/moves_cross.h"

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr int ramp_moves = 24;
constexpr double strip_reach = 2.0; // step-overs of a loop on either side of its strip
constexpr int beside_moves = 20;

Polyline
rampLine(const CutLoops& loops, const RampStrip& a, const RampStrip& b)
{
  Polyline line;
  for (int k = 0; k <= ramp_moves; ++k)
    line.push_back(onRamp(loops, a, b, static_cast<double>(k) / ramp_moves));
  return line;
}

/** Part of a loop from \p from over \p length. */
Polyline
partLine(const ScallopLoop& loop, double from, double length)
{
  Polyline line;
  for (int k = 0; k <= beside_moves; ++k)
    line.push_back(loop.at(from + length * k / beside_moves));
  return line;
}

std::size_t
crossings(const Polyline& a, const Polyline& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (std::size_t j = 0; j + 1 < b.size(); ++j)
      count += movesCross(a[i], a[i + 1], b[j], b[j + 1]);
  return count;
}

} // namespace

std::size_t
chainCrossings(const CutLoops& loops, const std::vector<RampStrip>& chain)
{
  const auto ramps = static_cast<std::int64_t>(chain.size()) - 1;
  std::size_t count = 0;
#pragma omp parallel for schedule(dynamic, 4) reduction(+ : count)
  for (std::int64_t i = 0; i < ramps; ++i) {
    const Polyline ramp = rampLine(loops, chain[i], chain[i + 1]);
    if (i > 0)
      count += crossings(rampLine(loops, chain[i - 1], chain[i]), ramp);
    for (const RampStrip* s : {&chain[i], &chain[i + 1]}) {
      const ScallopLoop& loop = loops.loop(s->loop);
      const double reach = std::min(strip_reach, 0.5 * (loop.length() - s->length));
      count += crossings(ramp, partLine(loop, s->u - s->length - reach, reach)) + crossings(ramp, partLine(loop, s->u, reach));
    }
  }
  return count;
}

} // namespace pcl_spiral
