// SPDX-License-Identifier: BSD-3-Clause
#include "drive_lines.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_spiral {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/** The line that follows each line, and whether a line has one before it. */
struct Links {
  std::vector<std::size_t> after;
  std::vector<bool> follows;
};

Links
linksOf(const std::vector<DriveLine>& lines, double most)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < lines.size() && !lines[i].closed; ++j) {
      const double gap = (lines[j].points.front() - lines[i].points.back()).norm();
      if (!lines[j].closed && gap <= most && (i != j || length(lines[i].points) > 4.0 * most))
        pairs.emplace_back(gap, i, j);
    }
  std::sort(pairs.begin(), pairs.end());
  Links links{std::vector<std::size_t>(lines.size(), none), std::vector<bool>(lines.size(), false)};
  for (const auto& [gap, i, j] : pairs)
    if (links.after[i] == none && !links.follows[j]) {
      links.after[i] = j;
      links.follows[j] = true;
    }
  return links;
}

double
distanceFrom(const Polyline& line, const Eigen::Vector3d& x)
{
  double least = INFINITY;
  for (const Eigen::Vector3d& p : line)
    least = std::min(least, (p - x).norm());
  return least;
}

} // namespace

Triangulation
withoutFlaws(const SurfaceGraph& graph)
{
  constexpr double shortest_loop = 8.0; // in spacings
  Triangulation mesh = graph.triangulation();
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  const auto loops = mesh.boundaryLoops();
  std::vector<double> lengths, longest(sizes.size(), 0.0);
  for (const auto& loop : loops) {
    double length = 0.0;
    for (const std::uint32_t h : loop)
      length += (graph.position(mesh.target(h)) - graph.position(mesh.origin(h))).norm();
    lengths.push_back(length);
    longest[part[loop.front() / 3]] = std::max(longest[part[loop.front() / 3]], length);
  }
  std::vector<Triangulation::Triangle> fans;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (lengths[l] > shortest_loop * graph.spacing() || lengths[l] >= longest[part[loops[l].front() / 3]])
      continue;
    const std::uint32_t hub = mesh.origin(loops[l].front());
    for (const std::uint32_t h : loops[l])
      if (mesh.origin(h) != hub && mesh.target(h) != hub)
        fans.push_back({hub, mesh.target(h), mesh.origin(h)});
  }
  mesh.append(fans);
  return mesh;
}

std::vector<DriveLine>
driveLines(const std::vector<LevelLine>& lines, const SurfaceGraph& graph)
{
  std::vector<DriveLine> all;
  all.reserve(lines.size());
  for (const LevelLine& line : lines)
    all.push_back({pointsOf(line, graph.blocks()), line.closed});
  return all;
}

std::vector<DriveLine>
joined(std::vector<DriveLine> lines, double most)
{
  const Links links = linksOf(lines, most);
  std::vector<DriveLine> whole;
  std::vector<bool> used(lines.size(), false);
  for (const bool from_begin : {true, false}) // the lines left after that are circles
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (used[i] || (from_begin && links.follows[i]))
        continue;
      DriveLine line{{}, lines[i].closed || !from_begin};
      for (std::size_t at = i; at != none && !used[at]; at = links.after[at]) {
        used[at] = true;
        line.points.insert(line.points.end(), lines[at].points.begin(), lines[at].points.end());
      }
      whole.push_back(std::move(line));
    }
  return whole;
}

std::size_t
dropShort(std::vector<DriveLine>& lines, double spacing)
{
  std::vector<double> lengths;
  lengths.reserve(lines.size());
  for (const DriveLine& line : lines)
    lengths.push_back(length(line.points, line.closed));
  const auto isSecondSheet = [&](std::size_t i) {
    const Eigen::Vector3d middle = lines[i].points[lines[i].points.size() / 2];
    for (std::size_t j = 0; j < lines.size(); ++j)
      if (lengths[j] > lengths[i] && distanceFrom(lines[j].points, middle) < 2.0 * spacing)
        return true;
    return false;
  };
  std::vector<DriveLine> kept;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lengths[i] >= spacing && (lengths[i] >= 4.0 * spacing || !isSecondSheet(i)))
      kept.push_back(lines[i]);
  const std::size_t dropped = lines.size() - kept.size();
  lines = std::move(kept);
  return dropped;
}

} // namespace pcl_spiral
