// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/location_mesh.h>

#include "coordinate_rounding.h"

#include <algorithm>

namespace pcl_spiral {

LocationMesh::LocationMesh(const SurfaceMesh::ConstPtr& mesh) : mesh_(mesh), faces_(facesOf(*mesh)), rim_(rimOf(*mesh))
{
  for (std::size_t v = 0; v < mesh->vertexCount(); ++v)
    rounding_ = std::max(rounding_, coordinate_rounding * mesh->position(v).cwiseAbs().maxCoeff());
}

} // namespace pcl_spiral
