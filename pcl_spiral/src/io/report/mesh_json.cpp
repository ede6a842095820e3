// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_json.h"

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

Json
findingJson(const MeshFinding& finding)
{
  Json json = {{"count", finding.count}};
  if (finding.count > 0)
    json["first"] = {finding.place.x(), finding.place.y(), finding.place.z()};
  return json;
}

} // namespace

Json
meshJson(const RunMesh& mesh)
{
  const MeshReport& c = mesh.counts;
  return {{"given_faces", c.given_faces},
          {"faces", c.faces},
          {"vertices", c.vertices},
          {"parts", c.parts},
          {"boundaries", c.loops},
          {"sample_spacing", mesh.sample_spacing},
          {"welded_vertices", findingJson(c.welded)},
          {"faces_without_area", findingJson(c.without_area)},
          {"repeated_faces", findingJson(c.repeated)},
          {"turned_faces", findingJson(c.turned)},
          {"crowded_edges", findingJson(c.crowded_edges)},
          {"one_sided_edges", findingJson(c.one_sided_edges)},
          {"crease_edges", findingJson(c.creases)},
          {"crease_length", c.crease_length},
          {"edges_left_straight", findingJson(c.limited)}};
}

} // namespace pcl_spiral
