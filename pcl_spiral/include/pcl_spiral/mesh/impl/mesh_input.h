// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings that are allowed with a mesh, if a cloud could be given as well.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/surface.h>

#include <string>

namespace pcl_spiral {

/** Ok, or an error if a setting for clouds is not at its default: it has no meaning for a mesh. */
inline Status
checkBesideMesh(const SurfaceSettings& settings, bool with_normals, bool with_indices)
{
  const std::string setter = with_normals ? "setInputNormals" : with_indices ? "setIndices" : disagreement(settings, SurfaceSettings());
  if (setter.empty())
    return Status::success();
  return {StatusCode::InvalidArgument, setter + " was called beside setInputMesh, and has no meaning for a mesh: leave it out, or give a "
                                                "cloud; a mesh is turned by MeshSettings::flip"};
}

} // namespace pcl_spiral
