#include <pcl_spiral/search/stray_removal.h>

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

} // namespace

Status
buildWithoutStrays(std::vector<Eigen::Vector3f> points, SurfaceGraphOptions options, SurfaceGraph& graph,
                   std::vector<std::uint32_t>& source)
{
  constexpr int rounds = 3;
  source.resize(points.size());
  std::iota(source.begin(), source.end(), 0u);
  for (int round = 0;; ++round) {
    if (const Status status = graph.build(std::move(points), options); !status.ok())
      return status;
    if (graph.strayPoints().empty() || round == rounds)
      return Status::success();
    points.resize(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i)
      points[graph.blocks().originalIndex(i)] = graph.blocks().point(i);
    for (auto stray = graph.strayPoints().rbegin(); stray != graph.strayPoints().rend(); ++stray) {
      removeAt(points, *stray);
      removeAt(source, *stray);
      if (!options.given_normals.empty())
        removeAt(options.given_normals, *stray);
    }
  }
}

} // namespace pcl_spiral
