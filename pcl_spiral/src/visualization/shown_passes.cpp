// SPDX-License-Identifier: BSD-3-Clause
#include "shown_passes.h"

#include "path_layer.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double free_share = 0.4;         ///< of the visible part of a pass
constexpr double most_passes = 16777216.0; ///< largest count in single precision

std::size_t
numberOf(double turn)
{
  return turn > 0.0 ? static_cast<std::size_t>(std::min(turn, most_passes)) : 0;
}

/** Pixels near chosen lines. */
class Taken {
public:
  explicit Taken(double reach) : reach_(reach), taken_(static_cast<std::size_t>(Canvas::width) * Canvas::height, false) {}

  bool has(const Eigen::Vector2d& at) const
  {
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return isOn(x, y) && taken_[index(x, y)];
  }
  void add(const Eigen::Vector2d& at)
  {
    const int reach = static_cast<int>(std::ceil(reach_)), x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    for (int v = -reach; v <= reach; ++v)
      for (int u = -reach; u <= reach; ++u)
        if (u * u + v * v < reach_ * reach_ && isOn(x + u, y + v))
          taken_[index(x + u, y + v)] = true;
  }

private:
  static bool isOn(int x, int y) { return x >= 0 && x < Canvas::width && y >= 0 && y < Canvas::height; }
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * Canvas::width + static_cast<std::size_t>(x); }

  double reach_;
  std::vector<bool> taken_;
};

/** The visible places in the picture, one per pixel, along the points from \p begin to before \p end. */
std::vector<Eigen::Vector2d>
seenPlaces(const pcl::PointCloud<ToolpathPoint>& path, const PassRange& range, const Canvas& canvas, const DepthMap& depth)
{
  std::vector<Eigen::Vector2d> seen;
  const Eigen::Vector3d towards = canvas.projection().towards();
  const auto add = [&](const Eigen::Vector3d& place, const Eigen::Vector3d& normal) {
    if (normal.dot(towards) > 0.0 && !depth.hides(place))
      seen.push_back(canvas.onScreen(place));
  };
  Eigen::Vector3d last = placeOf(path[range.begin]);
  add(last, normalOf(path[range.begin]));
  for (std::size_t i = range.begin + 1; i < range.end; ++i) {
    const Eigen::Vector3d place = placeOf(path[i]), from = last;
    const int steps = static_cast<int>((canvas.onScreen(place) - canvas.onScreen(last)).norm());
    for (int k = 1; k <= steps; ++k)
      add(last = from + (place - from) * k / steps, normalOf(path[i]));
  }
  return seen;
}

/** Runs of points of one pass and one whole number of turns; the point that ends the last turn belongs to it. */
std::vector<PassRange>
stretches(const pcl::PointCloud<ToolpathPoint>& path)
{
  std::vector<std::size_t> begins;
  const std::vector<std::size_t> passes = passBegins(path);
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    if (numberOf(path[i].turn) != numberOf(path[i - 1].turn) || beginsPass(passes, i))
      begins.push_back(i);
  return passRanges(begins, path.size());
}

} // namespace

bool
ShownPasses::shows(double turn) const
{
  return !shown.empty() && shown[std::min(numberOf(turn), shown.size() - 1)];
}

std::string
ShownPasses::caption(const std::string& turn) const
{
  const std::size_t count = static_cast<std::size_t>(std::count(shown.begin(), shown.end(), true));
  if (count == shown.size())
    return "every " + turn + " shown";
  return std::to_string(count) + " of " + std::to_string(shown.size()) + (turn == "pass" ? " passes" : " " + turn + "s") + " shown" +
         (count == seen ? ", the rest hidden" : "");
}

ShownPasses
choosePasses(const pcl::PointCloud<ToolpathPoint>& path, const Canvas& canvas, const DepthMap& depth, double least)
{
  ShownPasses result;
  std::vector<bool> has_seen;
  Taken taken(least);
  for (const PassRange& range : stretches(path)) {
    const std::size_t number = numberOf(path[range.begin].turn);
    result.shown.resize(std::max(result.shown.size(), number + 1), false);
    has_seen.resize(result.shown.size(), false);
    const std::vector<Eigen::Vector2d> places = seenPlaces(path, range, canvas, depth);
    has_seen[number] = has_seen[number] || !places.empty();
    const auto free = std::count_if(places.begin(), places.end(), [&](const auto& at) { return !taken.has(at); });
    if (!(static_cast<double>(free) > free_share * static_cast<double>(places.size())))
      continue;
    result.shown[number] = true;
    for (const Eigen::Vector2d& at : places)
      taken.add(at);
  }
  result.seen = static_cast<std::size_t>(std::count(has_seen.begin(), has_seen.end(), true));
  return result;
}

} // namespace pcl_spiral
