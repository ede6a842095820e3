// SPDX-License-Identifier: BSD-3-Clause
// A Surface with points added where the scan has gaps.
#include <pcl_spiral/surface/surface.h>

#include "graph_options.h"

#include <utility>

namespace pcl_spiral {

Status
addPoints(Surface::ConstPtr surface, const std::vector<Eigen::Vector3f>& bridges, Surface::ConstPtr& result)
{
  result.reset();
  Surface::Parts parts;
  parts.settings = surface->settings();
  parts.counts = surface->report();
  parts.left_out = surface->leftOut();
  parts.input_size = surface->inputSize();
  parts.side = surface->side();
  parts.kept_part = surface->keptPart();
  parts.warnings = surface->warnings();
  parts.clusters = surface->clusters();
  parts.isolated = surface->isolatedPoints();
  SurfaceGraphOptions options = graphOptions(parts.settings);
  options.flip_normals = false; // the outer side is that of the surface given
  options.given_normals = surface->graph().normals();
  options.given_normals.resize(surface->size() + bridges.size(), Eigen::Vector3f::Zero());
  std::vector<Eigen::Vector3f> points = surface->graph().blocks().points();
  for (std::size_t i = 0; i < surface->size(); ++i)
    parts.source.push_back(surface->sourceIndex(i));
  surface.reset();
  // Nothing more is left out: the counts stay valid.
  points.insert(points.end(), bridges.begin(), bridges.end());
  parts.source.resize(points.size(), Surface::no_source);
  parts.counts.guessed += bridges.size();
  if (const Status status = parts.graph.build(std::move(points), options); !status.ok())
    return status;
  ++parts.counts.passes;
  const auto made = std::make_shared<const Surface>(std::move(parts));
  if (made->settings().strict)
    if (const Status status = checkSingleSheet(*made); !status.ok())
      return status;
  result = made;
  return Status::success();
}

} // namespace pcl_spiral
