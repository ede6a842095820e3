// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/impl/clean_graph.h>

#include "even_spread.h"
#include "isolated_outliers.h"
#include "spike_outliers.h"

#include <algorithm>
#include <iterator>

namespace pcl_spiral {
namespace {

using Indices = std::vector<std::uint32_t>;

template <typename T>
std::vector<T>
selected(const Indices& indices, const std::vector<T>& values)
{
  std::vector<T> some(indices.size());
  std::transform(indices.begin(), indices.end(), some.begin(), [&](std::uint32_t i) { return values[i]; });
  return some;
}

/** Remove the values at ascending \p indices; the last values take their places. */
template <typename T>
void
removeAll(const Indices& indices, std::vector<T>& values)
{
  for (auto i = indices.rbegin(); i != indices.rend(); ++i) {
    values[*i] = values.back();
    values.pop_back();
  }
}

/** The points that blocks were made from, in their original order. */
std::vector<Eigen::Vector3f>
firstOrder(const PointBlocks& blocks)
{
  std::vector<Eigen::Vector3f> points(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    points[blocks.originalIndex(i)] = blocks.point(i);
  return points;
}

Indices
unionOf(const Indices& a, const Indices& b)
{
  Indices both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/** The work of buildCleanGraph. */
class CleanGraph {
public:
  CleanGraph(const SurfaceGraphOptions& options, SurfaceGraph& graph, GraphSource& source, const CloudCheck& check)
  : options_(options), graph_(graph), source_(source), check_(check)
  {}

  Status build(std::vector<Eigen::Vector3f> points)
  {
    left_out_.assign(points.size(), 0);
    source_ = GraphSource();
    Status status = buildEvenly(points);
    if (status.ok() && !options_.heights)
      status = leaveOutliersOut();
    if (status.ok() && source_.surplus > 0 && any_left_out_) {
      status = buildEvenly(points);
      if (status.ok())
        status = leaveOutliersOut();
    }
    for (const std::uint32_t i : isolated_)
      left_out_[i] = 1;
    source_.outliers.clear();
    for (std::uint32_t i = 0; i < left_out_.size(); ++i)
      if (left_out_[i])
        source_.outliers.push_back(i);
    return status;
  }

private:
  /** Build from an even choice of the points that were not left out. \p points are kept if the choice is not all of them. */
  Status buildEvenly(std::vector<Eigen::Vector3f>& points)
  {
    source_.indices.clear();
    for (std::uint32_t i = 0; i < left_out_.size(); ++i)
      if (!left_out_[i])
        source_.indices.push_back(i);
    PointBlocks blocks(selected(source_.indices, points));
    if (check_ && !any_left_out_)
      if (const Status status = check_(blocks); !status.ok())
        return status;
    EvenSpread spread = options_.heights ? EvenSpread() : evenSpread(blocks);
    if (spread.kept.size() < SurfaceGraph::fewest_points) // a strip two or three points wide is a line everywhere
      spread = EvenSpread();
    source_.surplus = spread.surplus;
    isolated_ = selected(spread.isolated, source_.indices);
    if (!spread.kept.empty()) {
      source_.indices = selected(spread.kept, source_.indices);
      blocks = PointBlocks(selected(source_.indices, points));
    }
    else
      std::vector<Eigen::Vector3f>().swap(points);
    ++source_.passes;
    return graph_.build(std::move(blocks), ownOptions());
  }

  Status leaveOutliersOut()
  {
    constexpr int rounds = 5;
    constexpr double some = 0.001; // of the points
    for (int round = 0; round < rounds; ++round) {
      Indices found = unionOf(unionOf(graph_.isolatedPoints(), sparseClusters(graph_)), spikeOutliers(graph_));
      const std::size_t used = source_.indices.size(), outliers = left_out_.size() - source_.surplus - used + found.size();
      if (static_cast<double>(outliers) > some * static_cast<double>(used))
        found = unionOf(found, isolatedOutliers(graph_));
      if (found.empty())
        break;
      if (const Status status = buildWithout(found); !status.ok())
        return status;
    }
    return Status::success();
  }

  /** Build again without some points, given by their original indices in the graph. */
  Status buildWithout(const Indices& outliers)
  {
    for (const std::uint32_t i : outliers)
      left_out_[source_.indices[i]] = 1;
    any_left_out_ = true;
    std::vector<Eigen::Vector3f> points = firstOrder(graph_.blocks());
    removeAll(outliers, points);
    removeAll(outliers, source_.indices);
    ++source_.passes;
    return graph_.build(std::move(points), ownOptions());
  }

  /** The options, with only the normals of the points in use. */
  SurfaceGraphOptions ownOptions() const
  {
    SurfaceGraphOptions own = options_;
    if (!options_.given_normals.empty())
      own.given_normals = selected(source_.indices, options_.given_normals);
    return own;
  }

  const SurfaceGraphOptions& options_;
  SurfaceGraph& graph_;
  GraphSource& source_;
  const CloudCheck& check_;
  std::vector<std::uint8_t> left_out_; ///< of the points given
  Indices isolated_;                   ///< not in the last even choice, but possibly in the next
  bool any_left_out_ = false;
};

} // namespace

Status
buildCleanGraph(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options, SurfaceGraph& graph, GraphSource& source,
                const CloudCheck& check)
{
  return CleanGraph(options, graph, source, check).build(std::move(points));
}

} // namespace pcl_spiral
