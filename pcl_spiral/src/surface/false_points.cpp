#include <pcl_spiral/surface/false_points.h>

#include <pcl_spiral/search/neighbour_search.h>

#include "local_fit.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int fit_neighbours = 48; // without the point itself
constexpr int company = 8;         // nearest neighbours that may be off as well
constexpr int nearest_for_normal = 12;
constexpr double over_scatter = 6.0, over_spacing = 0.03, half = 0.5;

/** Fits to the neighbours of a point, without the point. One object a thread. */
class DeletedResidual {
public:
  explicit DeletedResidual(const SurfaceGraph& graph)
  : graph_(graph), search_(graph.blocks(), std::min<int>(fit_neighbours + 1, static_cast<int>(graph.size())))
  {
  }

  /** How far point \p i lies off the surface of the others; 0 where that is not determined or they scatter as much. */
  double
  operator()(std::uint32_t i)
  {
    Box place;
    place.extend(graph_.blocks().point(i).data());
    search_.setRun(place);
    near_ = search_.find(graph_.position(i));
    Neighbourhood others = near_;
    ++others.x, ++others.y, ++others.z, ++others.squared_distance, ++others.index, --others.size;
    const Eigen::Vector3d up = meanNormal(others.index, std::min(others.size, nearest_for_normal), graph_.normals());
    const SurfaceFoot foot = robustQuarticFoot(graph_.position(i), others, up);
    const double off = (foot.position - graph_.position(i)).norm();
    return foot.valid && off > std::max(over_scatter * foot.residual, over_spacing * graph_.spacing(i)) ? off : 0.0;
  }

  /** The nearest neighbours of the point that was asked for last. */
  std::vector<std::uint32_t>
  nearest() const
  {
    return {near_.index + 1, near_.index + 1 + std::min(company, near_.size - 1)};
  }

private:
  const SurfaceGraph& graph_;
  NeighbourSearch search_;
  Neighbourhood near_;
};

bool
isFalse(std::uint32_t i, DeletedResidual& residual)
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
falsePoints(const SurfaceGraph& graph)
{
  const std::vector<std::uint32_t>& doubtful = graph.doubtfulPoints();
  std::vector<std::uint8_t> found(doubtful.size(), 0);
#pragma omp parallel
  {
    DeletedResidual residual(graph);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t d = 0; d < static_cast<std::int64_t>(doubtful.size()); ++d)
      found[d] = isFalse(doubtful[d], residual);
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t d = 0; d < doubtful.size(); ++d)
    if (found[d])
      indices.push_back(graph.blocks().originalIndex(doubtful[d]));
  std::sort(indices.begin(), indices.end());
  return indices;
}

} // namespace pcl_spiral
