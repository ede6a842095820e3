// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/turn_wobble.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** Deviation at the place where the path has made \p turn turns; NaN beyond its ends. */
double
deviationAt(double turn, const std::vector<float>& turns, const std::vector<float>& deviation)
{
  const auto next = std::upper_bound(turns.begin(), turns.end(), turn) - turns.begin();
  if (next == 0 || next == static_cast<std::ptrdiff_t>(turns.size()))
    return std::numeric_limits<double>::quiet_NaN();
  const double from = turns[next - 1], to = turns[next], share = (turn - from) / (to - from);
  return share == 0.0 ? deviation[next - 1] : (1.0 - share) * deviation[next - 1] + share * deviation[next];
}

/** Whether the turns of most moves do not grow: then they count rows and give no neighbouring place. */
bool
countRows(const CutterPath& path)
{
  std::size_t still = 0;
  for (std::size_t i = 1; i < path.turns.size(); ++i)
    still += path.turns[i] == path.turns[i - 1];
  return 2 * still > path.turns.size();
}

} // namespace

TurnWobble
turnWobble(const CutterPath& path, const std::vector<float>& deviation)
{
  TurnWobble wobble;
  const std::vector<float>& turns = path.turns;
  if (turns.size() != deviation.size() || !std::is_sorted(turns.begin(), turns.end()) || countRows(path))
    return wobble;
  double squares = 0.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double beside = deviationAt(turns[i] - 1.0, turns, deviation) + deviationAt(turns[i] + 1.0, turns, deviation);
    const double off = deviation[i] - 0.5 * beside;
    if (!std::isfinite(off))
      continue;
    ++wobble.measured;
    squares += off * off;
    if (std::abs(off) > std::abs(wobble.max.value))
      wobble.max = {off, path.contacts[i], i};
  }
  if (wobble.measured > 0)
    wobble.rms = std::sqrt(squares / static_cast<double>(wobble.measured));
  return wobble;
}

} // namespace pcl_spiral
