// SPDX-License-Identifier: BSD-3-Clause
// Sections of meshes with a known exact surface: errors of contacts and ball centres for each kind of normals and edges, as shares of
// the errors of plain sections.
#include "cases.h"
#include "table.h"

#include "support/mesh_surfaces.h"
#include "support/meshes.h"

#include <pcl_spiral/mesh/mesh_sections.h>

#include <algorithm>
#include <cstdio>

namespace pcl_spiral::acceptance {
namespace {

using namespace pcl_spiral::test;

constexpr double tool_radius = 5.0, scallop = 0.01; // mm

struct MeshRow {
  std::string name;
  SurfacePtr surface;
  TriangleMesh mesh;
};

std::vector<MeshRow>
meshRows(const Options& options)
{
  const Eigen::Vector2d field(100.0, 100.0), hood(1400.0, 1000.0);
  const auto wanted = [&](const char* name) { return options.only.empty() || options.only == name; };
  std::vector<MeshRow> rows;
  if (wanted("grid"))
    rows.push_back({"landform grid", landform(), gridMesh(*landform(), field, 49)});
  if (wanted("moved"))
    rows.push_back({"landform moved", landform(), gridMesh(*landform(), field, 49, 0.3, options.seed)});
  if (wanted("random"))
    rows.push_back({"landform random", landform(), delaunayMesh(*landform(), field, 2482, 160, options.seed)});
  if (wanted("bonnet"))
    rows.push_back({"bonnet", bonnet(), delaunayMesh(*bonnet(), hood, 54800, 442, options.seed)});
  return rows;
}

struct Method {
  const char* name;
  MeshNormals normals;
  MeshEdges edges;
};

constexpr Method methods[] = {{"plain", MeshNormals::Max, MeshEdges::Straight},
                              {"area, published", MeshNormals::AreaWeighted, MeshEdges::Published},
                              {"Max, robust", MeshNormals::Max, MeshEdges::Robust},
                              {"Fitted, robust", MeshNormals::Fitted, MeshEdges::Robust}};

struct Errors {
  double mean = 0.0, most = 0.0;
  std::size_t count = 0;

  void add(double error)
  {
    mean += error;
    most = std::max(most, error);
    ++count;
  }
  void finish() { mean /= static_cast<double>(std::max<std::size_t>(1, count)); }
};

struct SectionErrors {
  Errors contacts, centres, moves;
};

/** Errors of contacts, of ball centres off the offset surface, and of places along the straight moves. */
SectionErrors
errorsOf(const AnalyticSurface& surface, const DrivePasses& passes)
{
  constexpr int along = 4; // places per move
  SectionErrors errors;
  for (const DrivePass& pass : passes)
    for (std::size_t i = 0; i < pass.points.size(); ++i) {
      const DrivePoint& p = pass.points[i];
      errors.contacts.add(std::abs(surface.signedDistance(p.position)));
      errors.centres.add(std::abs(surface.signedDistance(p.position + tool_radius * p.normal) - tool_radius));
      if (i + 1 < pass.points.size())
        for (int k = 0; k < along; ++k)
          errors.moves.add(std::abs(surface.signedDistance(p.position + (k + 0.5) / along * (pass.points[i + 1].position - p.position))));
    }
  errors.contacts.finish();
  errors.centres.finish();
  errors.moves.finish();
  return errors;
}

SectionErrors
sectionErrors(const MeshRow& row, const Method& method, double chord_error)
{
  MeshSections sections;
  sections.setInputMesh(row.mesh.polygons());
  sections.setNormals(method.normals);
  sections.setEdges(method.edges);
  sections.setStepOver(2.0 * std::sqrt((2.0 * tool_radius - scallop) * scallop)); // equation (4)
  if (row.name == "bonnet")
    sections.setStepOver(25.0 * sections.getStepOver());
  sections.setChordError(chord_error);
  DrivePasses passes;
  sections.compute(passes);
  return errorsOf(*row.surface, passes);
}

} // namespace

int
judgeMeshes(const Options& options)
{
  constexpr double no_chord_error = 1e3, chord_error = 0.001; // mm
  Table table("contacts of mesh sections against the exact surface");
  for (const MeshRow& row : meshRows(options)) {
    std::printf("%s: %zu faces\n", row.name.c_str(), row.mesh.faces.size());
    SectionErrors plain, best;
    for (const Method& method : methods) {
      const SectionErrors e = sectionErrors(row, method, no_chord_error);
      if (method.edges == MeshEdges::Straight)
        plain = e;
      best = e;
      std::printf("  %-16s contacts %.5f %.4f mm (%.3f %.3f)  centres %.5f %.4f (%.3f %.3f)  moves %.5f %.4f (%.3f %.3f)\n", method.name,
                  e.contacts.mean, e.contacts.most, e.contacts.mean / plain.contacts.mean, e.contacts.most / plain.contacts.most,
                  e.centres.mean, e.centres.most, e.centres.mean / plain.centres.mean, e.centres.most / plain.centres.most, e.moves.mean,
                  e.moves.most, e.moves.mean / plain.moves.mean, e.moves.most / plain.moves.most);
    }
    table.atMost(row.name + ": mean of contacts, of plain", best.contacts.mean / plain.contacts.mean, 0.1, "");
    table.atMost(row.name + ": largest of contacts, of plain", best.contacts.most / plain.contacts.most, 0.2, "");
    const SectionErrors along = sectionErrors(row, methods[3], chord_error);
    table.atMost(row.name + ": mean along the moves", along.moves.mean, 0.1 * plain.moves.mean + 0.5 * chord_error);
    table.atMost(row.name + ": largest along the moves", along.moves.most, 0.2 * plain.moves.most + chord_error);
  }
  return table.broken();
}

int
judgeNoisyMeshes(const Options& options)
{
  Table table("sections of a landform whose vertices have noise of 0.02 mm");
  for (MeshRow& row : meshRows(options)) {
    if (row.name == "bonnet")
      continue;
    row.mesh = withNoise(row.mesh, 0.02, options.seed);
    const SectionErrors plain = sectionErrors(row, methods[0], 1e3), max = sectionErrors(row, methods[2], 1e3),
                        best = sectionErrors(row, methods[3], 1e3);
    table.note(row.name + ": Max, mean of plain", max.contacts.mean / plain.contacts.mean, "");
    table.note(row.name + ": Max, largest of plain", max.contacts.most / plain.contacts.most, "");
    table.atMost(row.name + ": mean of contacts, of plain", best.contacts.mean / plain.contacts.mean, 0.9, "");
    table.atMost(row.name + ": largest of contacts, of plain", best.contacts.most / plain.contacts.most, 0.9, "");
  }
  return table.broken();
}

} // namespace pcl_spiral::acceptance
