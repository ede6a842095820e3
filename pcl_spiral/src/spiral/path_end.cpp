#include "path_end.h"

#include "moves_cross.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double tail = 5.0;      // step-overs
constexpr double searched = 60.0; // of the path before
constexpr double clear = 0.12;

} // namespace

void
trimEnd(LinkedPath& path)
{
  const std::size_t n = path.points.size();
  std::vector<double> to_end(n, 0.0);
  for (std::size_t i = n - 1; i > 0; --i)
    to_end[i - 1] = to_end[i] + between(path.metric[i - 1], path.metric[i], 0.5).length(path.points[i] - path.points[i - 1]);
  const auto first = static_cast<std::size_t>(std::find_if(to_end.begin(), to_end.end(), [](double s) { return s < tail; }) - to_end.begin());
  const auto begin = static_cast<std::size_t>(std::find_if(to_end.begin(), to_end.end(), [](double s) { return s < searched; }) - to_end.begin());
  for (std::size_t i = std::max<std::size_t>(first, 3); i + 1 < n; ++i)
    for (std::size_t j = begin; j + 2 < i; ++j)
      if (movesCross(path.points[i], path.points[i + 1], path.points[j], path.points[j + 1])) {
        std::size_t last = i;
        while (last > 3 && to_end[last] - to_end[i] < clear)
          --last;
        path.points.resize(last + 1);
        path.metric.resize(last + 1);
        path.turns.resize(last + 1);
        path.reversed.resize(last + 1);
        return;
      }
}

} // namespace pcl_spiral
