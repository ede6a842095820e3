// SPDX-License-Identifier: BSD-3-Clause
// Check a given field, and find where its ridges run.
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include "step_over_march.h"

#include <pcl_spiral/core/diagnostic.h>

#include <cmath>

namespace pcl_spiral {

Status
checkField(const StepOverDistance& field)
{
  const std::size_t nodes = field.mesh.size(), triangles = field.mesh.triangles.triangleCount();
  if (nodes == 0 || triangles == 0)
    return {StatusCode::InvalidInput, "the field is empty: give a field made by {StepOverField}, or a null pointer and a cloud"};
  if (field.mesh.rims.empty() || field.mesh.metric.size() != nodes || field.mesh.normals.size() != nodes ||
      field.distance.size() != nodes || field.edge.size() != nodes || field.is_fine.size() != nodes || field.is_weak.size() != triangles)
    return {StatusCode::InvalidInput, Diagnostic("the field has ", nodes, " nodes and ", triangles, " triangles, but ",
                                                 field.distance.size(), " distances, ", field.is_weak.size(), " marks of triangles and ",
                                                 field.mesh.rims.size(), " rims: give a field made by {StepOverField}")};
  return Status::success();
}

std::vector<std::uint32_t>
ridgeNodes(const StepOverDistance& field)
{
  const auto least = static_cast<float>(std::cos(14.0 * pi / 180.0));
  const std::vector<float> agreement = gradientAgreement(field.mesh, field.distance);
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t v = 0; v < agreement.size(); ++v)
    if (agreement[v] < least)
      nodes.push_back(v);
  return nodes;
}

} // namespace pcl_spiral
