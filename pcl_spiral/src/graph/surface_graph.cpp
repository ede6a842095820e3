// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/graph/impl/surface_graph.h>

#include "common/freed_memory.h"
#include "core/median.h"
#include "local_star.h"
#include "search/neighbour_search.h"
#include <pcl_spiral/core/impl/frame.h>

#include "grid_triangles.h"
#include "local_shape.h"
#include "normal_orientation.h"
#include "outlier_candidates.h"
#include "search/pieces.h"
#include "star_triangles.h"
#include "unseen_steps.h"
#include "void_joints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int most_neighbours = 256;
constexpr int pinhole_edges = 6;
constexpr double far_off = 32.0; // times the usual radius of a neighbourhood: not part of the surface

/** Tangent-plane coordinates of a neighbourhood, and its star. */
class StarWorker {
public:
  StarWorker(const PointBlocks& blocks, int k, double max_circumradius)
  : search_(blocks, k), wide_search_(blocks, 4 * k), blocks_(blocks), k_(k), max_circumradius_(max_circumradius)
  {}

  void setRun(std::size_t block)
  {
    block_ = block;
    search_.setRun(blocks_.blockBox(block));
    wide_ready_ = false;
  }

  /** Shape and star of point \p i; true if the first k neighbours were enough to settle the star. */
  bool visit(std::size_t i, LocalShape& shape)
  {
    near_ = &search_.find(blocks_.position(i));
    shape = localShape(*near_);
    const double max_circumradius = max_circumradius_ * evenSpacing(shape.radius, k_);
    computeStar(*near_, shape.normal, max_circumradius);
    if (shape.radius >= 2.0 * std::min(star_.reach(), max_circumradius))
      return true;
    if (!wide_ready_)
      wide_search_.setRun(blocks_.blockBox(block_));
    wide_ready_ = true;
    near_ = &wide_search_.find(blocks_.position(i));
    computeStar(*near_, shape.normal, max_circumradius);
    return false;
  }

  /** Append the star's spokes as indices. */
  void append(std::vector<std::uint32_t>& spokes) const
  {
    for (const LocalStar::Spoke& s : star_.spokes())
      spokes.push_back(near_->index[s.neighbour] | (s.triangle_next ? StarSet::triangle_flag : 0u));
  }
  std::size_t spokeCount() const { return star_.spokes().size(); }

private:
  void computeStar(const Neighbourhood& near, const Eigen::Vector3d& normal, double max_circumradius)
  {
    Eigen::Vector3d e1, e2;
    tangentFrame(normal, e1, e2);
    u_.resize(near.size);
    v_.resize(near.size);
    double *u = u_.data(), *v = v_.data();
#pragma omp simd
    for (int j = 0; j < near.size; ++j) {
      const double x = near.x[j], y = near.y[j], z = near.z[j];
      u[j] = x * e1.x() + y * e1.y() + z * e1.z();
      v[j] = x * e2.x() + y * e2.y() + z * e2.z();
    }
    star_.compute(u_.data(), v_.data(), near.size, max_circumradius);
  }

  NeighbourSearch search_, wide_search_;
  const PointBlocks& blocks_;
  int k_;
  double max_circumradius_;
  std::size_t block_ = 0;
  bool wide_ready_ = false;
  const Neighbourhood* near_ = nullptr;
  LocalStar star_;
  std::vector<double> u_, v_;
};

/** Enough neighbours to settle most stars; scan lines far apart need more than an even cloud. */
int
enoughNeighbours(const PointBlocks& blocks, const SurfaceGraphOptions& options)
{
  int k = std::min<int>(options.neighbours, static_cast<int>(blocks.size()));
  const std::size_t step = std::max<std::size_t>(1, blocks.blockCount() / 64);
  for (; 2 * k <= most_neighbours; k *= 2) {
    StarWorker worker(blocks, k, options.max_circumradius);
    std::size_t visited = 0, unsettled = 0;
    for (std::size_t b = 0; b < blocks.blockCount(); b += step) {
      worker.setRun(b);
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); i += 4) {
        LocalShape shape;
        unsettled += !worker.visit(i, shape);
        ++visited;
      }
    }
    if (3 * unsettled < visited)
      break;
  }
  return k;
}

/** One pass over all neighbourhoods: shapes (signs of normals arbitrary) and stars. */
StarSet
visitAll(const PointBlocks& blocks, double max_circumradius, PointShapes& shapes)
{
  constexpr std::int64_t run = 128; // blocks that one thread takes at a time
  const auto block_count = static_cast<std::int64_t>(blocks.blockCount()), runs = (block_count + run - 1) / run;
  shapes.normals.resize(blocks.size());
  shapes.radii.resize(blocks.size());
  shapes.heights.resize(blocks.size());
  shapes.offsets.resize(blocks.size());
  StarSet stars;
  stars.begin.assign(blocks.size() + 1, 0);
  std::vector<std::vector<std::uint32_t>> spokes(runs);
#pragma omp parallel
  {
    StarWorker worker(blocks, shapes.neighbours, max_circumradius);
#pragma omp for schedule(dynamic)
    for (std::int64_t r = 0; r < runs; ++r) {
      spokes[r].reserve(6 * run * PointBlocks::block_size);
      for (std::int64_t b = r * run; b < std::min(block_count, (r + 1) * run); ++b) {
        worker.setRun(b);
        for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
          LocalShape shape;
          worker.visit(i, shape);
          shapes.normals[i] = shape.normal.cast<float>();
          shapes.radii[i] = static_cast<float>(shape.radius);
          shapes.heights[i] = static_cast<float>(shape.height);
          shapes.offsets[i] = static_cast<float>(shape.offset);
          worker.append(spokes[r]);
          stars.begin[i + 1] = static_cast<std::uint32_t>(worker.spokeCount());
        }
      }
    }
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
    stars.begin[i + 1] += stars.begin[i];
  stars.spokes.resize(stars.begin.back());
#pragma omp parallel for schedule(static)
  for (std::int64_t r = 0; r < runs; ++r) {
    std::copy(spokes[r].begin(), spokes[r].end(), stars.spokes.begin() + stars.begin[blocks.blockBegin(r * run)]);
    std::vector<std::uint32_t>().swap(spokes[r]);
  }
  returnFreedMemory();
  return stars;
}

/** Flags of the \p normals that do not point \p along. */
std::vector<std::uint8_t>
signsAlong(const Eigen::Vector3d& along, const std::vector<Eigen::Vector3f>& normals)
{
  std::vector<std::uint8_t> flipped(normals.size());
  const Eigen::Vector3f up = along.cast<float>();
  forPoints(normals.size(), [&](std::uint32_t i) { flipped[i] = normals[i].dot(up) < 0.0f; });
  return flipped;
}

/** Remove the flagged triangles; no flags at all: none. */
void
remove(const std::vector<std::uint8_t>& flagged, std::size_t points, Triangulation& mesh)
{
  if (std::find(flagged.begin(), flagged.end(), 1) == flagged.end())
    return;
  std::vector<Triangulation::Triangle> kept;
  for (std::uint32_t t = 0; t < flagged.size(); ++t)
    if (!flagged[t])
      kept.push_back(mesh.triangle(t));
  mesh = Triangulation(points, std::move(kept));
}

} // namespace

double
SurfaceGraph::spacing(std::size_t i) const
{
  return evenSpacing(points_->radii[i], points_->neighbours);
}

Status
SurfaceGraph::build(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options)
{
  return build(PointBlocks(std::move(points)), options);
}

Status
SurfaceGraph::build(PointBlocks blocks, const SurfaceGraphOptions& options)
{
  if (blocks.size() < fewest_points)
    return {StatusCode::InvalidInput, Diagnostic("the {cloud} has ", blocks.size(), " usable points; a surface needs at least ",
                                                 fewest_points, ": {scan more densely} or thin less")};
  *this = SurfaceGraph(); // frees what it was made of before
  const auto made = std::make_shared<Points>();
  Points& p = *made;
  p.blocks = std::move(blocks);
  p.neighbours = enoughNeighbours(p.blocks, options);
  PointShapes shapes;
  shapes.neighbours = p.neighbours;
  StarSet stars = visitAll(p.blocks, options.max_circumradius, shapes);
  const double usual_radius = medianOf(shapes.radii);
  p.isolated = pcl_spiral::isolatedPoints(p.blocks, stars, shapes, far_off * usual_radius);
  p.spike_candidates = pcl_spiral::spikeCandidates(stars, shapes);
  p.normals = std::move(shapes.normals);
  p.radii = std::move(shapes.radii);
  std::vector<float>().swap(shapes.heights);
  p.spacing = evenSpacing(usual_radius, p.neighbours);
  if (!(p.spacing > 0.0))
    return {StatusCode::InvalidInput, "most points of the {cloud} coincide: remove duplicates or check the units"};

  std::vector<std::uint8_t> flipped = options.heights ? signsAlong(options.heights->along(), p.normals) : consistentSigns(p.normals, stars);
  p.side = chooseOuterSide(p.blocks, p.normals, p.radii, far_off * usual_radius, options, flipped);
  const Eigen::Vector4d zero = Eigen::Vector4d::Zero();
  const Eigen::Vector4d sum = sumOverPoints(p.blocks.size(), zero, [&](std::uint32_t i, Eigen::Vector4d& part) {
    if (flipped[i]) {
      p.normals[i] = -p.normals[i];
      stars.reverse(i);
    }
    const double area = p.radii[i] > far_off * usual_radius ? 0.0 : static_cast<double>(p.radii[i]) * p.radii[i];
    part += area * p.normals[i].cast<double>().homogeneous();
  });
  p.mean_normal = sum.head<3>() / sum.w();
  const auto triangles = std::make_shared<Triangulation>(options.heights ? gridTriangles(p.blocks.points(), *options.heights)
                                                                         : triangulate(p.blocks.points(), std::move(stars), pinhole_edges));
  if (!options.heights) {
    const TriangulatedPoints cloud{p.blocks, p.normals, p.radii, static_cast<float>(evenSpacing(1.0, p.neighbours))};
    remove(voidJoints(cloud, shapes.offsets, options.max_circumradius, *triangles), p.blocks.size(), *triangles);
    remove(unseenSteps(cloud, *triangles), p.blocks.size(), *triangles);
  }
  points_ = made;
  triangulation_ = triangles;
  return Status::success();
}

SurfaceGraph
SurfaceGraph::withoutTriangulation() const
{
  SurfaceGraph graph;
  graph.points_ = points_;
  return graph;
}

double
surfaceArea(const SurfaceGraph& graph)
{
  double area = 0.0;
  for (std::size_t i = 0; i < graph.size(); ++i)
    area += graph.spacing(i) * graph.spacing(i);
  return area;
}

} // namespace pcl_spiral
