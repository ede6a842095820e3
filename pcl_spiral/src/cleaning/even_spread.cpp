// SPDX-License-Identifier: BSD-3-Clause
#include "even_spread.h"

#include "core/median.h"
#include "disc_thinning.h"
#include "graph/spread_shape.h"
#include "search/all_neighbourhoods.h"
#include "search/own_frame.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Eigenvalues>

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double most_points = 0.5;    // of a block: if at least this share of the points shows something, it holds for the whole block
constexpr float line_growth = 1.5f;    // of the step along a line, per round
constexpr float double_growth = 0.25f; // of the spacing: points nearly at one place are thinned to this distance
constexpr float steepest = 0.12f;      // change of the spacing per distance
constexpr float uneven = 1.75f;        // times the spacing: a smaller difference is left as it is
constexpr float even_fill = 0.8f;      // distance of thinned points over the spacing that results

/** Points in the order of their blocks, and what is known of each. */
struct Spread {
  PointBlocks blocks;
  std::vector<std::uint32_t> source; ///< index of each point in the first cloud
  std::vector<SpreadShape> shapes;

  void measure()
  {
    shapes.resize(blocks.size());
    forNeighbourhoods(blocks, SpreadShape::neighbours, omp_get_max_threads(),
                      [&](std::size_t i, const Neighbourhood& near) { shapes[i] = spreadShape(near); });
  }

  /** Go on with only some of the points. */
  void keep(const std::vector<std::uint8_t>& kept)
  {
    std::vector<Eigen::Vector3f> points, gone;
    std::vector<std::uint32_t> from;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (kept[i]) {
        points.push_back(blocks.point(i));
        from.push_back(static_cast<std::uint32_t>(i));
      }
      else
        gone.push_back(blocks.point(i));
    if (gone.empty())
      return;
    const std::vector<SpreadShape> before = std::move(shapes);
    const std::vector<std::uint32_t> source_before = std::move(source);
    blocks = PointBlocks(std::move(points));
    source.resize(from.size());
    shapes.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      source[i] = source_before[from[blocks.originalIndex(i)]];
      shapes[i] = before[from[blocks.originalIndex(i)]];
    }
    if (gone.size() < few_gone * from.size())
      measureNear(PointBlocks(std::move(gone)));
    else
      measure();
  }

private:
  static constexpr double few_gone = 0.01; // of the points: then most neighbourhoods stay, and to tell which takes less than to measure all

  /** Measure again the points that had one of \p gone among their neighbours. */
  void measureNear(const PointBlocks& gone)
  {
    const float whole = 1.001f * std::sqrt(static_cast<float>(SpreadShape::neighbours) / static_cast<float>(pi));
#pragma omp parallel
    {
      NeighbourSearch search(blocks, SpreadShape::neighbours);
#pragma omp for schedule(dynamic, 64)
      for (std::int64_t b = 0; b < static_cast<std::int64_t>(blocks.blockCount()); ++b) {
        search.setRun(blocks.blockBox(b));
        for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i)
          if ((gone.point(gone.nearest(blocks.position(i))) - blocks.point(i)).norm() <= whole * shapes[i].spacing)
            shapes[i] = spreadShape(search.find(blocks.position(i)));
      }
    }
  }
};

/** Distance that the points of a block should keep from each other, from their shapes; 0 for any. It is above 0 if most of them
 *  lie along lines, or nearly at one place. */
float
distanceAsked(const SpreadShape* shape, std::size_t count)
{
  std::size_t lines = 0, doubles = 0;
  float step = 0.0f, spacing = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    lines += shape[i].line_step > 0.0f;
    step += shape[i].line_step;
    doubles += shape[i].is_double;
    spacing += shape[i].is_double ? shape[i].spacing : 0.0f;
  }
  const double needed = most_points * static_cast<double>(count);
  float distance = 0.0f;
  if (static_cast<double>(lines) >= needed)
    distance = line_growth * step / static_cast<float>(lines);
  if (static_cast<double>(doubles) >= needed)
    distance = std::max(distance, double_growth * spacing / static_cast<float>(doubles));
  return distance;
}

/** Whether some blocks show lines, or the sizes of the blocks differ more than they do at one density. */
bool
looksUneven(const PointBlocks& blocks)
{
  constexpr std::size_t blocks_looked_at = 128;
  constexpr float large = 2.0f, small = 0.4f; // times the usual diagonal
  constexpr double few = 0.002;               // of the blocks
  std::size_t other = 0;
  for (std::size_t b = 0; b < blocks.blockCount(); ++b) {
    const float diagonal = blocks.blockBox(b).diagonal();
    other += diagonal > large * blocks.usualDiagonal() || diagonal < small * blocks.usualDiagonal();
  }
  if (static_cast<double>(other) > few * static_cast<double>(blocks.blockCount()))
    return true;
  NeighbourSearch search(blocks, SpreadShape::neighbours);
  const std::size_t step = std::max<std::size_t>(1, blocks.blockCount() / blocks_looked_at);
  std::vector<SpreadShape> shapes;
  for (std::size_t b = step / 2; b < blocks.blockCount(); b += step) {
    search.setRun(blocks.blockBox(b));
    shapes.clear();
    for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); i += 2)
      shapes.push_back(spreadShape(search.find(blocks.position(i))));
    if (distanceAsked(shapes.data(), shapes.size()) > 0.0f)
      return true;
  }
  return false;
}

/** Distance of the query from the plane of those of its neighbours that \p counts accepts. */
template <typename Counts>
double
heightOver(const Neighbourhood& near, Counts counts)
{
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double number = 0.0;
  for (int j = 1; j < near.size; ++j)
    if (counts(near.index[j])) {
      const Eigen::Vector3d d(near.x[j], near.y[j], near.z[j]);
      mean += d;
      moment += d * d.transpose();
      number += 1.0;
    }
  mean /= number;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moment - number * mean * mean.transpose());
  return std::abs(solver.eigenvectors().col(0).dot(mean));
}

float
medianOfNear(const std::vector<SpreadShape>& shapes)
{
  std::vector<float> values;
  values.reserve(shapes.size());
  for (const SpreadShape& shape : shapes)
    values.push_back(shape.near);
  return medianOf(std::move(values));
}

/** Isolated points off the surface: their neighbours lie much farther from them than the points nearby lie from each other, and
 *  not around them. */
std::vector<std::uint8_t>
withoutIsolated(const Spread& spread)
{
  constexpr int many = 256;
  constexpr float far = 3.0f, high = 0.3f; // times the usual distance nearby; share of the own distance
  const float usually_far = 4.0f * medianOfNear(spread.shapes);
  std::vector<std::uint8_t> suspect(spread.blocks.size());
  forNeighbourhoods(spread.blocks, 9, omp_get_max_threads(), [&](std::size_t i, const Neighbourhood& near) {
    const float farthest = far * spread.shapes[near.index[near.size / 2]].near;
    suspect[i] = spread.shapes[i].is_off || spread.shapes[i].near > std::min(farthest, usually_far);
  });
  std::vector<std::uint8_t> kept(spread.blocks.size(), 1);
#pragma omp parallel
  {
    NeighbourSearch wide(spread.blocks, many);
    std::vector<float> about;
#pragma omp for schedule(dynamic, 256)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(kept.size()); ++i) {
      if (!suspect[i])
        continue;
      Box place;
      place.extend(spread.blocks.point(i).data());
      wide.setRun(place);
      const Neighbourhood& near = wide.find(spread.blocks.position(i));
      about.clear();
      for (int j = 1; j < near.size; ++j)
        about.push_back(spread.shapes[near.index[j]].near);
      const float own = spread.shapes[i].near, usual = far * medianOf(about);
      const auto isUsual = [&](std::uint32_t k) { return spread.shapes[k].near <= usual; };
      kept[i] = isUsual(static_cast<std::uint32_t>(i)) || heightOver(near, isUsual) <= high * own;
    }
  }
  return kept;
}

/** Thin points along lines and at one place, a little more in each round. Returns whether any were removed. */
bool
thinLines(Spread& spread)
{
  constexpr int most_rounds = 24;
  constexpr double little = 0.95; // share kept: lines side by side are a wider step apart than they look
  float widened = 1.0f;
  bool thinned = false;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<float> distance(spread.blocks.size(), 0.0f);
    bool any = false;
    for (std::size_t b = 0; b < spread.blocks.blockCount(); ++b) {
      const std::size_t begin = spread.blocks.blockBegin(b), end = spread.blocks.blockEnd(b);
      const float asked = widened * distanceAsked(spread.shapes.data() + begin, end - begin);
      std::fill(distance.begin() + begin, distance.begin() + end, asked);
      any = any || asked > 0.0f;
    }
    if (!any)
      break;
    const std::size_t before = spread.blocks.size();
    spread.keep(thinToDistance(spread.blocks, distance));
    thinned = thinned || spread.blocks.size() < before;
    widened = static_cast<double>(spread.blocks.size()) > little * static_cast<double>(before) ? 1.25f * widened : 1.0f;
  }
  return thinned;
}

/** Spacing at each point, raised so that it falls by no more than a share of the distance from where it is larger. */
std::vector<float>
gradedSpacing(const Spread& spread)
{
  constexpr int reach = 16, company = 8;
  const std::size_t n = spread.blocks.size();
  std::vector<std::uint32_t> to(n * reach);
  std::vector<float> graded(n), way(n * reach);
  std::vector<std::uint8_t> counts(n, 1);
  forNeighbourhoods(spread.blocks, reach + 1, omp_get_max_threads(), [&](std::size_t i, const Neighbourhood& near) {
    int like = 0; // a point off the surface is far from it, but its neighbours are close to each other
    for (int j = 0; j < reach; ++j) {
      const int k = std::min(j + 1, near.size - 1);
      to[i * reach + j] = near.index[k];
      way[i * reach + j] = std::sqrt(near.squared_distance[k]);
      like += 2.0f * spread.shapes[near.index[k]].fine >= spread.shapes[i].fine && !spread.shapes[near.index[k]].is_off;
    }
    counts[i] = like >= company && !spread.shapes[i].is_off;
    graded[i] = spread.shapes[i].fine;
  });
  std::priority_queue<std::pair<float, std::uint32_t>> queue;
  for (std::size_t i = 0; i < n; ++i)
    if (counts[i])
      queue.emplace(graded[i], static_cast<std::uint32_t>(i));
  while (!queue.empty()) {
    const auto [spacing, i] = queue.top();
    queue.pop();
    if (spacing < graded[i])
      continue;
    for (int j = 0; j < reach; ++j) {
      const std::uint32_t k = to[i * reach + j];
      const float least = spacing - steepest * way[i * reach + j];
      if (least > graded[k]) {
        graded[k] = least;
        queue.emplace(least, k);
      }
    }
  }
  return graded;
}

/** Thin beside sparser parts. Returns whether any were removed. */
bool
thinSteps(Spread& spread)
{
  std::vector<float> distance = gradedSpacing(spread);
  bool any = false;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const bool thin = distance[i] > uneven * spread.shapes[i].spacing;
    distance[i] = thin ? even_fill * distance[i] : 0.0f;
    any = any || thin;
  }
  if (any)
    spread.keep(thinToDistance(spread.blocks, distance));
  return any;
}

} // namespace

EvenSpread
evenSpread(const PointBlocks& blocks)
{
  if (blocks.size() <= SpreadShape::neighbours || !(blocks.usualDiagonal() > 0.0f) || !looksUneven(blocks))
    return {};
  // Blocks, and the order in which points are thinned, follow the part, not the axes along which it happens to lie.
  Spread spread{PointBlocks(inOwnFrame(blocks.points())), {}, {}};
  for (std::size_t i = 0; i < blocks.size(); ++i)
    spread.source.push_back(blocks.originalIndex(spread.blocks.originalIndex(i)));
  spread.measure();
  const std::vector<std::uint8_t> on_surface = withoutIsolated(spread);
  EvenSpread even;
  for (std::size_t i = 0; i < on_surface.size(); ++i)
    if (!on_surface[i])
      even.isolated.push_back(spread.source[i]);
  spread.keep(on_surface);
  const bool lines = thinLines(spread), steps = thinSteps(spread);
  if (!lines && !steps)
    return {};
  even.kept = std::move(spread.source);
  std::sort(even.kept.begin(), even.kept.end());
  std::sort(even.isolated.begin(), even.isolated.end());
  even.surplus = blocks.size() - even.kept.size() - even.isolated.size();
  return even;
}

} // namespace pcl_spiral
