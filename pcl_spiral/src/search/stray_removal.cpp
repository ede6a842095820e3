#include <pcl_spiral/search/stray_removal.h>

#include "even_spread.h"

#include <numeric>

namespace pcl_spiral {
namespace {

/** Put the last one in the place of number \p i. */
template <typename T>
void
removeAt(std::vector<T>& values, std::size_t i)
{
  values[i] = values.back();
  values.pop_back();
}

/** The points that blocks were made from, in their first order. */
std::vector<Eigen::Vector3f>
firstOrder(const PointBlocks& blocks)
{
  std::vector<Eigen::Vector3f> points(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    points[blocks.originalIndex(i)] = blocks.point(i);
  return points;
}

/** Those of ascending \p indices alone. */
template <typename T>
void
keepOnly(const std::vector<std::uint32_t>& indices, std::vector<T>& values)
{
  for (std::size_t i = 0; i < indices.size(); ++i)
    values[i] = values[indices[i]];
  values.resize(indices.size());
}

} // namespace

Status
buildWithoutStrays(std::vector<Eigen::Vector3f> points, SurfaceGraphOptions options, SurfaceGraph& graph,
                   GraphSource& source)
{
  constexpr int rounds = 3;
  const std::size_t given = points.size();
  source.indices.resize(given);
  std::iota(source.indices.begin(), source.indices.end(), 0u);
  PointBlocks blocks(std::move(points));
  EvenSpread spread = evenSpread(blocks);
  if (spread.kept.size() < SurfaceGraph::fewest_points) // a strip two or three points wide is a line all along
    spread = EvenSpread();
  source.surplus = spread.surplus;
  if (!spread.kept.empty()) {
    points = firstOrder(blocks);
    keepOnly(spread.kept, points);
    keepOnly(spread.kept, source.indices);
    if (!options.given_normals.empty())
      keepOnly(spread.kept, options.given_normals);
    blocks = PointBlocks(std::move(points));
  }
  for (int round = 0;; ++round) {
    if (const Status status = graph.build(std::move(blocks), options); !status.ok())
      return status;
    source.strays = given - source.surplus - source.indices.size();
    if (graph.strayPoints().empty() || round == rounds)
      return Status::success();
    points = firstOrder(graph.blocks());
    for (auto stray = graph.strayPoints().rbegin(); stray != graph.strayPoints().rend(); ++stray) {
      removeAt(points, *stray);
      removeAt(source.indices, *stray);
      if (!options.given_normals.empty())
        removeAt(options.given_normals, *stray);
    }
    blocks = PointBlocks(std::move(points));
  }
}

} // namespace pcl_spiral
