// SPDX-License-Identifier: BSD-3-Clause
#include "spike_outliers.h"

#include "core/lanes.h"
#include "search/neighbour_search.h"

#include "fit/local_fit.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr int fit_neighbours = 48; // without the point itself
constexpr int fewest_for_fit = 24;
constexpr int company = 8; // nearest neighbours that may be outliers as well
constexpr int nearest_for_normal = 12;
constexpr double over_scatter = 6.0, over_spacing = 0.03, half = 0.5;

/** Fits to the neighbours of a point that are no candidates, without the point. One object per thread. */
class DeletedResidual {
public:
  DeletedResidual(const SurfaceGraph& graph, const std::vector<std::uint8_t>& is_candidate)
  : graph_(graph), is_candidate_(is_candidate), search_(graph.blocks(), std::min<int>(fit_neighbours + 1, static_cast<int>(graph.size())))
  {}

  /** Distance of point \p i from the surface of the others; 0 if that is not determined, or if their noise is as large. */
  double operator()(std::uint32_t i)
  {
    Box place;
    place.extend(graph_.blocks().point(i).data());
    search_.setRun(place);
    near_ = search_.find(graph_.position(i));
    const Neighbourhood others = chosen();
    const Eigen::Vector3d up = meanNormal(others.index, std::min(others.size, nearest_for_normal), graph_.normals());
    const SurfaceFoot foot = robustQuarticFoot(graph_.position(i), others, up);
    const double off = (foot.position - graph_.position(i)).norm();
    return foot.valid && off > std::max(over_scatter * foot.residual, over_spacing * graph_.spacing(i)) ? off : 0.0;
  }

  /** The nearest neighbours of the last point asked for. */
  std::vector<std::uint32_t> nearest() const { return {near_.index + 1, near_.index + 1 + std::min(company, near_.size - 1)}; }

private:
  /** The neighbours that are no candidates (two outliers side by side support each other), or all if those are few. */
  Neighbourhood chosen()
  {
    places_.clear();
    for (int j = 1; j < near_.size; ++j)
      if (!is_candidate_[near_.index[j]])
        places_.push_back(j);
    if (static_cast<int>(places_.size()) < fewest_for_fit) {
      places_.resize(near_.size - 1);
      std::iota(places_.begin(), places_.end(), 1);
    }
    index_.clear();
    for (auto& values : values_)
      values.clear();
    for (const int j : places_) {
      index_.push_back(near_.index[j]);
      const float of[] = {near_.x[j], near_.y[j], near_.z[j], near_.squared_distance[j]};
      for (int d = 0; d < 4; ++d)
        values_[d].push_back(of[d]);
    }
    for (auto& values : values_)
      values.resize((values.size() + lane_count - 1) / lane_count * lane_count, 0.0f);
    return {static_cast<int>(places_.size()), values_[0].data(), values_[1].data(), values_[2].data(), values_[3].data(), index_.data()};
  }

  const SurfaceGraph& graph_;
  const std::vector<std::uint8_t>& is_candidate_;
  NeighbourSearch search_;
  Neighbourhood near_;
  std::vector<int> places_;
  std::array<std::vector<float>, 4> values_;
  std::vector<std::uint32_t> index_;
};

bool
isSpike(std::uint32_t i, DeletedResidual& residual)
{
  const double off = residual(i);
  if (!(off > 0.0))
    return false;
  int others = 0;
  for (const std::uint32_t j : residual.nearest())
    if (residual(j) > half * off && ++others > 1)
      return false;
  return true;
}

} // namespace

std::vector<std::uint32_t>
spikeOutliers(const SurfaceGraph& graph)
{
  const std::vector<std::uint32_t>& candidates = graph.spikeCandidates();
  std::vector<std::uint8_t> found(candidates.size(), 0), is_candidate(graph.size(), 0);
  for (const std::uint32_t i : candidates)
    is_candidate[i] = 1;
#pragma omp parallel
  {
    DeletedResidual residual(graph, is_candidate);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t d = 0; d < static_cast<std::int64_t>(candidates.size()); ++d)
      found[d] = isSpike(candidates[d], residual);
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t d = 0; d < candidates.size(); ++d)
    if (found[d])
      indices.push_back(graph.blocks().originalIndex(candidates[d]));
  std::sort(indices.begin(), indices.end());
  return indices;
}

} // namespace pcl_spiral
