// SPDX-License-Identifier: BSD-3-Clause
#include "scallop_size.h"

#include "common/available_memory.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t samples = 1000;
constexpr double bytes_a_node = 400.0; // for a mesh with its distances, while it is cut
constexpr double most_nodes = 3e8;     // indices have 32 bits, and a node has six half-edges

/** Mean number of moves per millimetre, over the surface and both principal directions. */
double
movesPerMillimetre(const Surface& surface, const SpiralSettings& settings)
{
  std::vector<Eigen::Vector3d> queries;
  const std::size_t stride = std::max<std::size_t>(1, surface.size() / samples);
  for (std::size_t i = 0; i < surface.size(); i += stride)
    queries.push_back(surface.position(i));
  std::vector<SurfaceFoot> feet;
  surface.fit().project(queries, feet);
  const double longest = settings.max_step > 0.0 ? settings.max_step : settings.tool_radius;
  double sum = 0.0, count = 0.0;
  for (const SurfaceFoot& foot : feet)
    for (const double curvature : {foot.valid ? foot.curvature1 : 0.0, foot.valid ? foot.curvature2 : 0.0}) {
      const double spaced = spacingCurvature(settings.tool_radius, curvature);
      sum += 1.0 / stepFromChordErrorAtCentre(settings.tool_radius, spaced, settings.chord_error, longest);
      count += 1.0;
    }
  return sum / std::max(count, 1.0);
}

} // namespace

Status
checkMeshSize(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen, int parts, const StepOverOptions& options)
{
  const auto cut = static_cast<double>(std::count(chosen.begin(), chosen.end(), 1));
  const double nodes = static_cast<double>(mesh.size()) + 0.5 * cut * parts * parts;
  const auto memory = availableMemory();
  if (nodes <= most_nodes && !(memory && bytes_a_node * nodes > *memory))
    return Status::success();
  return {StatusCode::Failed,
          Diagnostic("at a scallop height of ", options.scallop_height,
                     " {mm} turns lie much closer together than the points of the {scan}: ", std::ceil(1e-6 * nodes),
                     " million nodes between these points would be needed, and ", std::ceil(1e-9 * bytes_a_node * nodes),
                     " GB of memory; raise the scallop height, or {scan more densely}")};
}

PathSize
scallopPathSize(const StepOverDistance& field, const Surface& surface, const SpiralSettings& settings)
{
  PathSize size;
  size.turns = field.largest;
  size.points = field.least_length * movesPerMillimetre(surface, settings);
  size.knots = field.least_length / (0.5 * surface.spacing());
  size.step_over = stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(0.0);
  size.step = field.least_length / size.points;
  return size;
}

} // namespace pcl_spiral
