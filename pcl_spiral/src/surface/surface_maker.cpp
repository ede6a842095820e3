// SPDX-License-Identifier: BSD-3-Clause
// From clean points to a Surface.
#include <pcl_spiral/surface/surface.h>

#include <pcl_spiral/cleaning/impl/clean_graph.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/surface/impl/side_text.h>

#include "cleaning/standing_clusters.h"
#include "count_warnings.h"
#include "disconnected_scan.h"
#include "graph_options.h"
#include "part_choice.h"
#include "space_filling.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace pcl_spiral {
namespace {

/** The work of makeSurface. */
class SurfaceMaker {
public:
  SurfaceMaker(const SurfaceSettings& settings, Surface::Parts& parts, std::vector<std::int8_t>& why)
  : settings_(settings), parts_(parts), why_(why)
  {}

  Status make(SurfacePoints points)
  {
    all_ = points.positions;
    parts_.source = std::move(points.source);
    normals_ = std::move(points.normals);
    if (const Status status = build(std::move(points.positions)); !status.ok())
      return status;
    if (isChosen())
      if (const Status status = keepOnePart(); !status.ok())
        return status;
    if (const Status status = checkConnected(); !status.ok())
      return status;
    if (const Status status = leaveClustersOut(); !status.ok())
      return status;
    if (!settings_.heights) // what stands there is of the surface
      if (const Status status = checkClusters(); !status.ok())
        return status;
    finish();
    return Status::success();
  }

private:
  /** Build the graph of points whose indices among those given are place_. */
  Status build(std::vector<Eigen::Vector3f> points)
  {
    SurfaceGraphOptions options = graphOptions(settings_);
    options.given_normals = normals_;
    GraphSource source;
    const std::size_t given = points.size();
    CloudCheck check;
    if (settings_.strict && place_.empty() && !settings_.heights)
      check = [this](const PointBlocks& blocks) { return checkFillsSpace(blocks, settings_); };
    const Status status = buildCleanGraph(std::move(points), options, parts_.graph, source, check);
    parts_.counts.passes += source.passes;
    if (!status.ok())
      return status;
    parts_.counts.isolated += source.outliers.size();
    parts_.counts.surplus += source.surplus;
    for (const std::uint32_t i : source.outliers)
      isolated_.push_back(placeOf(i));
    if (source.indices.size() == given)
      return Status::success();
    for (std::uint32_t i = 0; i < given; ++i)
      mark(i, LeftOut::Surplus); // until found among those kept, or isolated
    for (const std::uint32_t i : source.outliers)
      mark(i, LeftOut::Isolated);
    for (const std::uint32_t i : source.indices)
      why_[placeOf(i)] = -1;
    keepOf(source.indices);
    return Status::success();
  }

  /** Index of point \p i of those in use among those given. */
  std::uint32_t placeOf(std::uint32_t i) const { return place_.empty() ? i : place_[i]; }

  void mark(std::uint32_t i, LeftOut reason)
  {
    why_.resize(all_.size(), -1);
    why_[placeOf(i)] = static_cast<std::int8_t>(reason);
  }

  /** Keep only \p kept of the points in use, in that order. */
  void keepOf(const std::vector<std::uint32_t>& kept)
  {
    const auto select = [&](auto& values) {
      std::remove_reference_t<decltype(values)> some(kept.size());
      std::transform(kept.begin(), kept.end(), some.begin(), [&](std::uint32_t i) { return values[i]; });
      values = std::move(some);
    };
    for (std::vector<std::uint32_t>* indices : {&place_, &parts_.source})
      if (indices->empty())
        *indices = kept;
      else
        select(*indices);
    if (!normals_.empty())
      select(normals_);
  }

  /** Refuse too many isolated points. If a part was chosen, only those over it count; the others are other things beside it. */
  Status checkConnected()
  {
    if (!settings_.strict || !areMany(isolated_.size(), all_.size()))
      return Status::success();
    std::vector<Eigen::Vector3f> over, beside;
    for (const std::uint32_t i : isolated_) {
      const bool counts = !isChosen() || isOverPart(parts_.graph, all_[i].cast<double>());
      (counts ? over : beside).push_back(all_[i]);
      if (!counts)
        why_[i] = static_cast<std::int8_t>(LeftOut::OtherPart);
    }
    if (!isChosen())
      return disconnectedRefusal(parts_.graph, over, all_.size());
    parts_.counts.isolated -= beside.size();
    parts_.counts.other_part += beside.size();
    const std::size_t about = parts_.graph.size() + over.size();
    return areMany(over.size(), about) ? disconnectedRefusal(parts_.graph, over, about) : Status::success();
  }

  bool isChosen() const { return settings_.largest_part || settings_.part_at; }

  /** Whether \p isolated of \p points are too many to be outliers. */
  static bool areMany(std::size_t isolated, std::size_t points)
  {
    constexpr double most_isolated = 0.1;
    return static_cast<double>(isolated) > most_isolated * static_cast<double>(points);
  }

  Status keepOnePart()
  {
    SurfaceParts found = surfaceParts(parts_.graph);
    std::size_t kept = 0;
    if (const Status status = choosePart(parts_.graph, found, settings_, kept); !status.ok())
      return status;
    if (found.parts.size() < 2)
      return Status::success();
    const std::vector<std::uint8_t> apart = apartFrom(parts_.graph, found, kept);
    parts_.counts.separate_parts = found.parts.size() - 1;
    parts_.counts.other_part = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
    parts_.kept_part = keptPartText(parts_.graph.size(), parts_.counts.other_part, found, settings_, kept);
    parts_.warnings.push_back(parts_.kept_part);
    return keepPart(apart, LeftOut::OtherPart);
  }

  Status leaveClustersOut()
  {
    std::vector<std::size_t> sizes;
    parts_.graph.triangulation().parts(sizes);
    if (sizes.size() < 2)
      return Status::success();
    const SurfaceParts found = surfaceParts(parts_.graph);
    if (otherParts(found.parts, largest_cluster) != OtherParts::Clusters)
      return Status::success(); // the stages that need a single part refuse it
    const std::vector<std::uint8_t> apart = apartFrom(parts_.graph, found, 0);
    parts_.counts.clustered = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
    return parts_.counts.clustered > 0 ? keepPart(apart, LeftOut::Cluster) : Status::success();
  }

  /** Build again from the points of the graph that are not \p apart, one flag each. */
  Status keepPart(const std::vector<std::uint8_t>& apart, LeftOut reason)
  {
    const SurfaceGraph& graph = parts_.graph;
    std::vector<Eigen::Vector3f> points;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const std::uint32_t original = graph.blocks().originalIndex(i);
      if (apart[i]) {
        mark(original, reason);
        continue;
      }
      points.push_back(graph.blocks().point(i));
      kept.push_back(original);
    }
    keepOf(kept);
    return build(std::move(points));
  }

  /** Find clusters among the points left out and the spike candidates. \p apart: one flag per point of the graph, 1 in a cluster. */
  void findClusters(std::vector<std::uint8_t>& apart)
  {
    const auto& candidates = parts_.graph.spikeCandidates();
    std::vector<std::uint32_t> given;
    for (std::uint32_t i = 0; i < why_.size(); ++i)
      if (why_[i] == static_cast<std::int8_t>(LeftOut::Isolated) || why_[i] == static_cast<std::int8_t>(LeftOut::Cluster))
        given.push_back(i);
    const std::size_t outliers = given.size();
    for (const std::uint32_t i : candidates)
      given.push_back(placeOf(parts_.graph.blocks().originalIndex(i)));
    std::vector<Eigen::Vector3f> points;
    points.reserve(given.size());
    for (const std::uint32_t i : given)
      points.push_back(all_[i]);
    parts_.clusters = standingPoints(parts_.graph, points).clusters;
    apart.assign(parts_.graph.size(), 0);
    for (StandingCluster& cluster : parts_.clusters)
      for (pcl::index_t& index : cluster.indices) {
        const auto i = static_cast<std::size_t>(index);
        if (i >= outliers)
          apart[candidates[i - outliers]] = 1;
        index = static_cast<pcl::index_t>(given[i]);
      }
  }

  /** Refuse clusters on the surface, leave them out, or warn of them. */
  Status checkClusters()
  {
    constexpr int most_rounds = 4; // without the others, a last point of a cluster is seen to stand off, too
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<std::uint8_t> apart;
      findClusters(apart);
      if (!parts_.clusters.empty() && settings_.clusters == ClusterHandling::Refuse && settings_.strict) {
        const Status status = checkChosen(parts_.graph, settings_);
        return status.ok() ? refusalOf(parts_.clusters, parts_.graph.spacing()) : status;
      }
      const auto left_out = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
      if (left_out == 0 || settings_.clusters == ClusterHandling::Refuse)
        break;
      parts_.counts.clustered += left_out;
      if (const Status status = keepPart(apart, LeftOut::Cluster); !status.ok())
        return status;
    }
    if (!parts_.clusters.empty())
      parts_.warnings.push_back(Diagnostic(
          clustersText(parts_.clusters, parts_.graph.spacing()),
          (settings_.clusters == ClusterHandling::Ride ? "; the ball rides over what is there" : "; a path may go through what is there")));
    return Status::success();
  }

  /** The single points left out, without those of clusters. */
  std::vector<Eigen::Vector3f> isolatedPoints() const
  {
    std::vector<std::uint32_t> clustered;
    for (const StandingCluster& cluster : parts_.clusters)
      clustered.insert(clustered.end(), cluster.indices.begin(), cluster.indices.end());
    std::sort(clustered.begin(), clustered.end());
    std::vector<Eigen::Vector3f> points;
    for (const std::uint32_t i : isolated_)
      if (why_[i] == static_cast<std::int8_t>(LeftOut::Isolated) && !std::binary_search(clustered.begin(), clustered.end(), i))
        points.push_back(all_[i]);
    return points;
  }

  void finish()
  {
    SurfaceReport& counts = parts_.counts;
    counts.used = parts_.graph.size();
    parts_.isolated = isolatedPoints();
    parts_.settings = settings_;
    parts_.side = parts_.graph.side();
    if (settings_.heights)
      parts_.side.vote = SideVote::ToolAxis;
    for (Diagnostic& warning : countWarnings(counts, parts_.graph.spacing()))
      parts_.warnings.push_back(std::move(warning));
    for (Diagnostic& warning : sideWarnings(parts_.side))
      parts_.warnings.push_back(std::move(warning));
  }

  const SurfaceSettings& settings_;
  Surface::Parts& parts_;
  std::vector<std::int8_t>& why_;
  std::vector<Eigen::Vector3f> all_; ///< the points given
  std::vector<std::uint32_t> place_; ///< indices of the points in use among those given; empty: all of them, in order
  std::vector<Eigen::Vector3f> normals_;
  std::vector<std::uint32_t> isolated_; ///< indices among the points given
};

} // namespace

Status
makeSurface(SurfacePoints points, const SurfaceSettings& settings, const SurfaceReport& counts, Surface::Parts& parts,
            std::vector<std::int8_t>& why)
{
  parts = Surface::Parts();
  parts.counts = counts;
  return SurfaceMaker(settings, parts, why).make(std::move(points));
}

} // namespace pcl_spiral
