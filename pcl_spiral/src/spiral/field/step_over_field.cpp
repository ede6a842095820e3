// SPDX-License-Identifier: BSD-3-Clause
#include "core/median.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include "edge_walk.h"
#include "mesh_distance.h"
#include "mesh_refinement.h"
#include "ridge_edges.h"
#include "scallop_size.h"
#include "step_over_march.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
 *  (test one_way), at 1.0 to 1.2 a path over a rough scan crossed itself (test reach_map); from 1.3 on neither. Of 80 such scans 1 is
 *  refused with 1.4, 2 with 1.6, 1 with 2.0. */
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
  return medianOf(std::move(edges));
}

/** Triangles with a corner within \p width step-overs of a ridge of \p distance. */
std::vector<std::uint8_t>
aboutRidges(const StepOverMesh& mesh, const std::vector<double>& distance, double width)
{
  const std::vector<float> agreement = gradientAgreement(mesh, distance);
  const auto least = static_cast<float>(std::cos(ridge_turn * pi / 180.0));
  std::vector<std::uint8_t> on_ridge(mesh.size());
  std::transform(agreement.begin(), agreement.end(), on_ridge.begin(), [least](float a) -> std::uint8_t { return a < least; });
  const std::vector<float> walked = walkedFrom(mesh, on_ridge, width);
  std::vector<std::uint8_t> chosen(mesh.triangles.triangleCount(), 0);
  const auto count = static_cast<std::int64_t>(chosen.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t t = 0; t < count; ++t)
    for (const std::uint32_t v : mesh.triangles.triangle(t))
      chosen[t] |= walked[v] < width;
  return chosen;
}

/** One a node: 1 at the corners of triangles in which the length of the gradient of \p distance is below \p least. */
std::vector<std::uint8_t>
weakCorners(const StepOverMesh& mesh, const std::vector<double>& distance, double least)
{
  const std::vector<float> lengths = gradientLengths(mesh, distance);
  std::vector<std::uint8_t> weak(mesh.size(), 0);
  for (std::size_t t = 0; t < lengths.size(); ++t)
    if (lengths[t] < least)
      for (const std::uint32_t v : mesh.triangles.triangle(t))
        weak[v] = 1;
  return weak;
}

/** Triangles about the ridges of \p distance, and those about triangles in which it is not a true distance. */
std::vector<std::uint8_t>
ridgeBand(const StepOverMesh& mesh, const std::vector<double>& distance, double width)
{
  std::vector<std::uint8_t> chosen = aboutRidges(mesh, distance, width);
  const std::vector<std::uint8_t> weak = weakCorners(mesh, distance, band_gradient);
  for (std::size_t t = 0; t < chosen.size(); ++t)
    for (const std::uint32_t v : mesh.triangles.triangle(t))
      chosen[t] |= weak[v];
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

/** In how many parts the sides of triangles with edges of \p edge step-overs are cut, first about the ridges found on them, then about
 *  those found on the finer ones: the two numbers that make the fewest nodes. Triangles reach out of their band by half an edge on either
 *  side, more or less. */
std::array<int, 2>
partsOfSides(double edge)
{
  const double whole = std::max(1.0, std::ceil(parts_a_step * edge));
  const auto nodes = [edge](int first, int parts) {
    return (first > 1 ? (band_width + edge) * first * first : 0.0) + (band_width + edge / first) * parts * parts;
  };
  std::array<int, 2> best{1, static_cast<int>(whole)};
  for (int first = 2; first <= whole; ++first)
    if (const auto second = static_cast<int>(std::ceil(whole / first)); nodes(first, first * second) < nodes(best[0], best[0] * best[1]))
      best = {first, second};
  return best;
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

/** Makes the field on a mesh. */
class FieldMaker {
public:
  FieldMaker(StepOverDistance& field, const StepOverOptions& options, const ProgressCallback& progress)
  : field_(field), options_(options), progress_(progress), edge_(medianEdge(field.mesh))
  {
    field_.edge.assign(field_.mesh.size(), static_cast<float>(edge_));
  }

  Status run(double spacing)
  {
    if (!marchOn(field_.mesh, marched_, part(0.1, 0.4)))
      return cancelled();
    if (const Status status = checkWidth(field_.mesh, marched_.distance, spacing); !status.ok())
      return status;
    const auto [first, second] = partsOfSides(edge_);
    if (const Status status = cutAboutRidges(first, second, part(0.4, 0.6)); !status.ok())
      return status;
    if (const Status status = cutAboutRidges(second, 1, part(0.6, 1.0)); !status.ok())
      return status;
    findRidges();
    return takeDistances();
  }

private:
  static Status cancelled() { return {StatusCode::Cancelled, "cancelled"}; }
  std::function<bool(double)> part(double from, double to) const { return partOf(progress_, from, to, "step-over field"); }
  Status cutAboutRidges(int parts, int later, const std::function<bool(double)>& progress);
  void findRidges();
  Status takeDistances();

  StepOverDistance& field_;
  const StepOverOptions& options_;
  const ProgressCallback& progress_;
  double edge_; ///< about the ridges, step-overs
  MarchedDistances marched_;
  std::vector<std::uint8_t> is_cut_; ///< one a node: 1 where the mesh was cut last; empty if it was not
};

/** Cut the sides of the triangles about the ridges into \p parts, and measure the distance again behind them. Refuse if there is not
 *  enough memory to cut all of these into \p later more. */
Status
FieldMaker::cutAboutRidges(int parts, int later, const std::function<bool(double)>& progress)
{
  if (parts == 1)
    return Status::success();
  StepOverMesh& mesh = field_.mesh;
  const double known_within = is_cut_.empty() ? edge_ : 0.0; // ridges on the first mesh
  const std::vector<std::uint8_t> band = ridgeBand(mesh, marched_.distance, band_width + known_within);
  if (const Status status = checkMeshSize(mesh, band, parts * later, options_); !status.ok())
    return status;
  forgetBehind(mesh, band, marched_);
  mesh = refined(std::move(mesh), band, parts, is_cut_);
  field_.edge.resize(mesh.size(), static_cast<float>(edge_));
  edge_ /= parts;
  for (std::size_t v = 0; v < mesh.size(); ++v)
    if (is_cut_[v])
      field_.edge[v] = static_cast<float>(edge_);
  return marchOn(mesh, marched_, progress) ? Status::success() : cancelled();
}

void
FieldMaker::findRidges()
{
  if (is_cut_.empty())
    is_cut_ = cornersOf(field_.mesh, ridgeBand(field_.mesh, marched_.distance, band_width));
  field_.mesh = withRidgeEdges(std::move(field_.mesh), marched_, is_cut_);
  field_.edge.resize(field_.mesh.size(), static_cast<float>(edge_));
  field_.is_fine = cornersOf(field_.mesh, aboutRidges(field_.mesh, marched_.distance, band_width));
  for (std::size_t v = 0; v < field_.mesh.size(); ++v)
    field_.is_fine[v] &= is_cut_[v];
}

Status
FieldMaker::takeDistances()
{
  field_.distance = std::move(marched_.distance);
  for (std::size_t v = 0; v < field_.mesh.size(); ++v) {
    if (!std::isfinite(field_.distance[v]))
      return {StatusCode::Failed,
              Diagnostic("the surface is disconnected: no way leads over it from the rim to ", Place(field_.mesh.positions[v]),
                         ", because parts of the {scan} touch at a single point; {scan it again, more densely}")};
    field_.largest = std::max(field_.largest, field_.distance[v]);
  }
  const std::vector<std::uint8_t> weak = weakCorners(field_.mesh, field_.distance, weak_gradient);
  field_.is_weak.resize(field_.mesh.triangles.triangleCount());
  for (std::size_t t = 0; t < field_.is_weak.size(); ++t) {
    const auto& c = field_.mesh.triangles.triangle(t);
    const bool fine = field_.is_fine[c[0]] && field_.is_fine[c[1]] && field_.is_fine[c[2]];
    field_.is_weak[t] = !fine && (weak[c[0]] || weak[c[1]] || weak[c[2]]);
  }
  return Status::success();
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
  field = StepOverDistance();
  field.basis = {options.tool_radius, options.scallop_height};
  field.least_length = leastLength(mesh, options.reserve);
  field.mesh = std::move(mesh);
  return FieldMaker(field, options, progress).run(spacing);
}

} // namespace pcl_spiral
