// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include "mesh_distance.h"
#include "mesh_refinement.h"
#include "ridge_edges.h"
#include "scallop_size.h"
#include "step_over_march.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

/** Edges a step-over about the ridges. Measured on the table of outlines, with edges along the ridges, for 3, 4, 4.5 and 5: highest
 *  scallops of 1.134, 1.097, 1.095 and 1.093 h in the mean; 20, 27, 27 and 26 rows of 30 within every limit. The figures of 3 were
 *  taken with fingers of 0.42 in place of 0.49. In the middle of a disc D is late by more than an eighth of the spacing with 4 (test
 *  step_over_cost). */
constexpr double parts_a_step = 4.5;
constexpr double ridge_turn = 14.0; // degrees
/** Step-overs on either side of a ridge. A place that is not covered lies within half a step-over of a ridge, and a finger there blends
 *  into its loop within 0.55 of its axis: 1.05 at least. Measured: at 0.8 a pass that is moved far left a ridge of 1.55 times the height
 *  (test one_way), at 1.0 to 1.2 a path over a rough scan crossed itself (test reach_map); from 1.3 on neither. */
constexpr double band_width = 1.4;
constexpr double band_gradient = 0.94; // |grad D| below which triangles join the band
constexpr double weak_gradient = 0.97;
constexpr double least_clear = 2.5;                   // spacings
constexpr std::size_t triangles_looked_at = 1u << 18; // for the median of their sides
constexpr std::size_t sum_block = 4096;               // triangles

double
medianEdge(const StepOverMesh& mesh)
{
  const std::size_t stride = mesh.triangles.triangleCount() / triangles_looked_at + 1;
  std::vector<float> edges;
  for (std::size_t t = 0; t < mesh.triangles.triangleCount(); t += stride)
    for (const double side : stepOverSides(mesh, t))
      edges.push_back(static_cast<float>(side));
  std::nth_element(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2), edges.end());
  return edges[edges.size() / 2];
}

/** Add \p rings times the triangles that share a node with those chosen. */
void
grow(const Triangulation& triangles, std::vector<std::uint8_t>& chosen, int rings)
{
  std::vector<std::uint32_t> added;
  for (std::uint32_t t = 0; t < chosen.size(); ++t)
    if (chosen[t])
      added.push_back(t);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::uint32_t> last;
    last.swap(added);
    for (const std::uint32_t t : last)
      for (const std::uint32_t v : triangles.triangle(t))
        for (std::size_t o = triangles.outgoingBegin(v); o < triangles.outgoingBegin(v + 1); ++o)
          if (const std::uint32_t beside = triangles.outgoing(o) / 3; !chosen[beside]) {
            chosen[beside] = 1;
            added.push_back(beside);
          }
  }
}

/** Triangles about the ridges of \p distance. \p edge: of the mesh there. */
std::vector<std::uint8_t>
aboutRidges(const StepOverMesh& mesh, const std::vector<double>& distance, double edge)
{
  const std::vector<float> agreement = gradientAgreement(mesh, distance);
  const auto least = static_cast<float>(std::cos(ridge_turn * pi / 180.0));
  std::vector<std::uint8_t> chosen(mesh.triangles.triangleCount(), 0);
  const auto count = static_cast<std::int64_t>(chosen.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t t = 0; t < count; ++t)
    for (const std::uint32_t v : mesh.triangles.triangle(t))
      chosen[t] |= agreement[v] < least;
  grow(mesh.triangles, chosen, static_cast<int>(std::ceil(band_width / edge)));
  return chosen;
}

/** Triangles about the ridges of \p distance, and triangles in which it is not a true distance. */
std::vector<std::uint8_t>
ridgeBand(const StepOverMesh& mesh, const std::vector<double>& distance, double edge)
{
  std::vector<std::uint8_t> chosen = aboutRidges(mesh, distance, edge);
  const std::vector<float> lengths = gradientLengths(mesh, distance);
  std::vector<std::uint8_t> weak(chosen.size(), 0);
  for (std::size_t t = 0; t < chosen.size(); ++t)
    weak[t] = lengths[t] < band_gradient;
  grow(mesh.triangles, weak, 1);
  for (std::size_t t = 0; t < chosen.size(); ++t)
    chosen[t] |= weak[t];
  return chosen;
}

/** One a node: 1 at the corners of \p chosen triangles. */
std::vector<std::uint8_t>
cornersOf(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen)
{
  std::vector<std::uint8_t> corners(mesh.size(), 0);
  for (std::size_t t = 0; t < chosen.size(); ++t)
    if (chosen[t])
      for (const std::uint32_t v : mesh.triangles.triangle(t))
        corners[v] = 1;
  return corners;
}

/** Refuse a surface with points too far apart to know its rim and feet: the place farthest from the rims lies less than two and a
 *  half spacings from them. */
Status
checkWidth(const StepOverMesh& mesh, const std::vector<double>& distance, double spacing)
{
  std::size_t middle = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) // nodes that no way leads to are refused later
    if (std::isfinite(distance[v]) && distance[v] > distance[middle])
      middle = v;
  double clear = std::numeric_limits<double>::max();
  for (const std::vector<std::uint32_t>& rim : mesh.rims)
    for (const std::uint32_t v : rim)
      clear = std::min(clear, (mesh.positions[v] - mesh.positions[middle]).norm());
  if (clear >= least_clear * spacing)
    return Status::success();
  return {StatusCode::Failed,
          Diagnostic("the surface is too narrow for the spacing of its points: its middle ", Place(mesh.positions[middle]), " lies only ",
                     clear, " {mm} from the rim, and the points lie ", spacing,
                     " {mm} apart: {scan more densely}, with at least seven points across, or machine the part in another way")};
}

/** Integral of dA over the largest step-over, plus half the rims, because the path runs on them. Without the reserve. */
double
leastLength(const StepOverMesh& mesh, double reserve)
{
  const auto blocks = static_cast<std::int64_t>((mesh.triangles.triangleCount() + sum_block - 1) / sum_block);
  std::vector<double> sums(blocks, 0.0); // by blocks: rounding depends on the order of a sum
#pragma omp parallel for schedule(static)
  for (std::int64_t b = 0; b < blocks; ++b)
    for (std::size_t t = b * sum_block; t < std::min(mesh.triangles.triangleCount(), (b + 1) * sum_block); ++t) {
      const auto& c = mesh.triangles.triangle(t);
      const Eigen::Vector3d area = 0.5 * (mesh.positions[c[1]] - mesh.positions[c[0]]).cross(mesh.positions[c[2]] - mesh.positions[c[0]]);
      sums[b] += area.norm() * (1.0 - reserve) / longestStepOver(mesh.metric[c[0]]);
    }
  double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  for (const std::vector<std::uint32_t>& rim : mesh.rims)
    for (std::size_t i = 0; i < rim.size(); ++i)
      sum += 0.5 * (mesh.positions[rim[(i + 1) % rim.size()]] - mesh.positions[rim[i]]).norm();
  return sum;
}

} // namespace

Status
measureStepOvers(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options, StepOverDistance& field,
                 const ProgressCallback& progress)
{
  field = StepOverDistance();
  if (progress && !progress(0.0, "step-over field"))
    return {StatusCode::Cancelled, "cancelled"};
  StepOverMesh mesh;
  if (const Status status = makeStepOverMesh(surface, outlines, options, mesh); !status.ok())
    return status;
  return measureOnMesh(std::move(mesh), surface.spacing(), options, field, progress);
}

Status
measureOnMesh(StepOverMesh mesh, double spacing, const StepOverOptions& options, StepOverDistance& field, const ProgressCallback& progress)
{
  const Status cancelled{StatusCode::Cancelled, "cancelled"};
  const auto part = [&progress](double from, double to) { return partOf(progress, from, to, "step-over field"); };
  field = StepOverDistance();
  field.basis = {options.tool_radius, options.scallop_height};
  field.usual_edge = medianEdge(mesh);
  field.least_length = leastLength(mesh, options.reserve);
  field.mesh = std::move(mesh);
  MarchedDistances marched;
  if (!marchOn(field.mesh, marched, part(0.1, 0.4)))
    return cancelled;
  if (const Status status = checkWidth(field.mesh, marched.distance, spacing); !status.ok())
    return status;
  const std::vector<std::uint8_t> band = ridgeBand(field.mesh, marched.distance, field.usual_edge);
  const double parts = std::max(1.0, std::ceil(parts_a_step * field.usual_edge));
  field.cut_edge = field.usual_edge / parts;
  if (parts > 1.0) {
    if (const Status status = checkMeshSize(field.mesh, band, static_cast<int>(parts), options); !status.ok())
      return status;
    forgetBehind(field.mesh, band, marched);
    field.mesh = refined(std::move(field.mesh), band, static_cast<int>(parts), field.is_cut);
    if (!marchOn(field.mesh, marched, part(0.5, 1.0)))
      return cancelled;
  }
  else
    field.is_cut = cornersOf(field.mesh, band);
  field.mesh = withRidgeEdges(std::move(field.mesh), marched, field.is_cut);
  field.is_fine = cornersOf(field.mesh, aboutRidges(field.mesh, marched.distance, field.cut_edge));
  for (std::size_t v = 0; v < field.mesh.size(); ++v)
    field.is_fine[v] &= field.is_cut[v];
  field.distance = std::move(marched.distance);
  for (std::size_t v = 0; v < field.mesh.size(); ++v) {
    if (!std::isfinite(field.distance[v]))
      return {StatusCode::Failed,
              Diagnostic("the surface is disconnected: no way leads over it from the rim to ", Place(field.mesh.positions[v]),
                         ", because parts of the {scan} touch at a single point; {scan it again, more densely}")};
    field.largest = std::max(field.largest, field.distance[v]);
  }
  const std::vector<float> lengths = gradientLengths(field.mesh, field.distance);
  field.is_weak.resize(lengths.size());
  for (std::size_t t = 0; t < lengths.size(); ++t) {
    const auto& corners = field.mesh.triangles.triangle(t);
    const bool fine = field.is_fine[corners[0]] && field.is_fine[corners[1]] && field.is_fine[corners[2]];
    field.is_weak[t] = !fine && lengths[t] < weak_gradient;
  }
  return Status::success();
}

} // namespace pcl_spiral
