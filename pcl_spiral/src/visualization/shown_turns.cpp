// SPDX-License-Identifier: BSD-3-Clause
#include "shown_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_samples = 20000;
constexpr double least_facing = 0.1; ///< cosine between the surface normal and the view
constexpr double crowded_share = 0.1;
constexpr int fewest_shown = 6;

/** Distance of \p p from the line through \p a and \p b. */
double
distanceFromLine(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const Eigen::Vector2d along = b - a, off = p - a;
  const double length = along.norm();
  return length > 1e-9 ? std::abs(along.x() * off.y() - along.y() * off.x()) / length : off.norm();
}

/** The distance in the view such that a share of the path's length is below it. */
double
crowdedPitch(const pcl::PointCloud<ToolpathPoint>& path, const ParallelView& view)
{
  const Eigen::Vector3d towards = view.towards();
  const auto place = [&](std::size_t i) { return view.project(path[i].getVector3fMap().cast<double>()); };
  const auto faces = [&](std::size_t i) { return path[i].getNormalVector3fMap().cast<double>().dot(towards) > least_facing; };
  std::vector<std::pair<double, double>> pitches; // distance to the next turn, length of path with it; pixels
  const std::size_t stride = path.size() / most_samples + 1;
  std::size_t next = 1;
  double all = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); i += stride) {
    while (next < path.size() && path[next].turn < path[i].turn + 1.0f)
      ++next;
    if (next == path.size())
      break;
    if (!faces(i) || !faces(next))
      continue;
    const double weight = (place(i + 1) - place(i)).norm();
    pitches.emplace_back(distanceFromLine(place(i), place(next - 1), place(next)), weight);
    all += weight;
  }
  std::sort(pitches.begin(), pitches.end());
  double sum = 0.0;
  for (const auto& [pitch, weight] : pitches)
    if ((sum += weight) >= crowded_share * all)
      return pitch;
  return 0.0;
}

} // namespace

std::string
ShownTurns::caption() const
{
  if (every == 1)
    return "every turn shown";
  const int last = every % 10;
  const bool teen = every % 100 / 10 == 1;
  const char* const ending = teen ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return "every " + std::to_string(every) + ending + " turn shown";
}

ShownTurns
chooseTurns(const pcl::PointCloud<ToolpathPoint>& path, const ParallelView& view, double least_pixels)
{
  ShownTurns result;
  if (path.empty())
    return result;
  result.turns = std::max(1, static_cast<int>(std::lround(path.back().turn)));
  const int most = std::max(1, result.turns / fewest_shown);
  const double pitch = crowdedPitch(path, view);
  result.every = pitch * most > least_pixels ? std::max(1, static_cast<int>(std::ceil(least_pixels / pitch))) : most;
  return result;
}

} // namespace pcl_spiral
