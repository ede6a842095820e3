// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The prepared surface that all stages share.
 */
#pragma once

#include <pcl_spiral/cleaning/standing_cluster.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/impl/scan_voids.h>
#include <pcl_spiral/surface/surface_settings.h>

#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** What happened to the points of a cloud: input is the sum of the entries down to used. */
struct SurfaceReport {
  std::size_t input = 0;          ///< of the cloud, or of its indices
  std::size_t nonfinite = 0;      ///< NaN, infinite, or marker values beyond 1e12
  std::size_t duplicate = 0;      ///< at the same place as an earlier point
  std::size_t outlier = 0;        ///< removed by the statistical filter
  std::size_t thinned = 0;        ///< removed by the voxel grid
  std::size_t surplus = 0;        ///< much closer together than the points around them, as along scan lines
  std::size_t isolated = 0;       ///< single points off the surface
  std::size_t clustered = 0;      ///< in clusters apart from the surface
  std::size_t other_part = 0;     ///< in separate parts other than the one kept, left out on request
  std::size_t used = 0;           ///< points of the surface
  std::size_t separate_parts = 0; ///< left out on request
  std::size_t guessed = 0;        ///< points put into gaps, in addition to those used
  int passes = 0;                 ///< over all neighbourhoods, to make the surface

  /** Outliers: single points and clusters off the surface. */
  std::size_t offSurface() const { return isolated + clustered; }
  /** \deprecated Renamed offSurface. */
  [[deprecated("use offSurface")]] std::size_t strays() const { return offSurface(); }
};

/** \deprecated Use SurfaceReport. */
using SurfaceCounts [[deprecated("use SurfaceReport")]] = SurfaceReport;

/** Why a point is not part of the surface. */
enum class LeftOut : std::uint8_t {
  Outlier,  ///< removed by the statistical filter
  Thinned,  ///< removed by the voxel grid
  Surplus,  ///< much closer to its neighbours than the points around it
  Isolated, ///< a single point off the surface
  Cluster,  ///< in a cluster apart from the surface
  OtherPart ///< in a part other than the one kept
};

/** Finite and different points of the cloud that are not part of the surface. Parallel arrays, indices ascending. */
struct LeftOutPoints {
  std::vector<Eigen::Vector3f> positions; ///< mm
  pcl::Indices indices;                   ///< in the cloud
  std::vector<LeftOut> why;               ///< reason of each
};

/** A scan that is ready for use: clean points in spatial order with oriented normals, spacing, triangulation and local fit, and
 *  the points left out. Immutable. Made by ScannedSurface, or by GapBridging with points put into gaps. Every stage can share it
 *  (setInputSurface). Lengths in mm. Memory: about 110 bytes per point.
 */
class Surface {
public:
  using Ptr = std::shared_ptr<Surface>;            ///< A shared pointer.
  using ConstPtr = std::shared_ptr<const Surface>; ///< A shared pointer to a constant one.

  /** sourceIndex of a point put into a gap. */
  static constexpr std::uint32_t no_source = std::numeric_limits<std::uint32_t>::max();

  /** The parts of a Surface; see makeSurface. */
  struct Parts {
    SurfaceGraph graph;                    ///< order, normals, spacing, triangles
    std::vector<std::uint32_t> source;     ///< cloud index of each point that the graph was built from; empty: the whole cloud, in order
    SurfaceSettings settings;              ///< by which it was made
    SurfaceReport counts;                  ///< what happened to the points
    LeftOutPoints left_out;                ///< points that are not part of it
    std::size_t input_size = 0;            ///< number of points in the cloud
    OuterSide side;                        ///< see side()
    std::vector<StandingCluster> clusters; ///< see clusters()
    std::vector<Eigen::Vector3f> isolated; ///< see isolatedPoints()
    Diagnostic kept_part;                  ///< see keptPart()
    Diagnostics warnings;                  ///< see warnings()
  };
  explicit Surface(Parts parts);                ///< Takes the parts and fits the surface to them.
  Surface(const Surface&) = default;            ///< The same data, shared.
  Surface& operator=(const Surface&) = default; ///< The same data, shared.

  /** The same surface without triangles, which are the larger half of its memory: for stages that need only neighbourhoods. It shares all
   *  else, and the triangles are freed with the last surface that has them. */
  static ConstPtr withoutTriangulation(const ConstPtr& surface);

  /** Order, normals, spacing and triangles. This function and those below use the order of points in the graph. */
  const SurfaceGraph& graph() const { return graph_; }
  /** The moving-least-squares surface. The noise sets the width of its fits. */
  const MlsSurface& fit() const { return fit_; }

  /** Places without points that triangles cover: holes and gaps too narrow to be loops. */
  const ScanVoids& voids() const { return *voids_; }

  std::size_t size() const { return graph_.size(); }                           ///< Number of points.
  Eigen::Vector3d position(std::size_t i) const { return graph_.position(i); } ///< Point \p i, mm.
  /** Unit normal, out of the material. */
  Eigen::Vector3d normal(std::size_t i) const { return graph_.normal(i); }
  /** Median distance between neighbouring points, as if they were spread evenly. */
  double spacing() const { return graph_.spacing(); }
  /** Area, mm2: the sum of each point's share, also of those put into gaps. */
  double area() const { return surfaceArea(graph_); }
  /** Standard deviation of the points about the fit. */
  double noise() const { return fit_.noise(); }

  /** Index of point \p i in the cloud; no_source for a point put into a gap. */
  std::uint32_t sourceIndex(std::size_t i) const { return sourceOfOriginal(graph_.blocks().originalIndex(i)); }
  /** True if point \p i was put into a gap: the surface around it is guessed. */
  bool isGuessed(std::size_t i) const { return sourceIndex(i) == no_source; }
  /** Cloud index of point \p i, counted in the order of the points that the graph was built from (BoundaryLoop::indices of
   *  findBoundaryLoops). */
  std::uint32_t sourceOfOriginal(std::size_t i) const { return parts_->source.empty() ? static_cast<std::uint32_t>(i) : parts_->source[i]; }
  /** Number of points in the cloud, used or not. */
  std::size_t inputSize() const { return parts_->input_size; }

  const SurfaceSettings& settings() const { return parts_->settings; }                  ///< The settings it was made with.
  const SurfaceReport& report() const { return parts_->counts; }                        ///< What happened to the points of the cloud.
  [[deprecated("use report")]] const SurfaceReport& counts() const { return report(); } ///< \deprecated Use report.
  const LeftOutPoints& leftOut() const { return parts_->left_out; }                     ///< The points left out, and why.
  /** True if normals, a view point or +z gave the outer side. If false, the convex side was taken. */
  bool sideIsClear() const { return parts_->side.vote != SideVote::Convex; }
  /** What decided the outer side, and how clearly. */
  const OuterSide& side() const { return parts_->side; }
  /** Clusters of points that stand on it, the highest first. */
  const std::vector<StandingCluster>& clusters() const { return parts_->clusters; }
  /** Points of the clusters that a ball must clear: all with ClusterHandling::Ride, else none. */
  std::vector<Eigen::Vector3f> riddenPoints() const;
  /** Single points off the surface that were left out, in no cluster: false echoes, or the edge of a step too low for the scan. */
  const std::vector<Eigen::Vector3f>& isolatedPoints() const { return parts_->isolated; }
  /** Which of several parts was kept, and where the others are; empty if there is one. */
  const Diagnostic& keptPart() const { return parts_->kept_part; }
  /** Which points were left out, with keptPart(), and whether the side is guessed. */
  const Diagnostics& warnings() const { return parts_->warnings; }

private:
  SurfaceGraph graph_;
  std::shared_ptr<const Parts> parts_; ///< their graph is empty
  MlsSurface fit_;
  std::shared_ptr<const ScanVoids> voids_;
};

/** The points that a surface is made from. */
struct SurfacePoints {
  std::vector<Eigen::Vector3f> positions; ///< finite and all different
  std::vector<Eigen::Vector3f> normals;   ///< one per point, zero for none; or empty; they face the outer side
  std::vector<std::uint32_t> source;      ///< index of each in the cloud; empty: the whole cloud, in order
};

/** Make a surface from \p points by \p settings, whose filters must have run before. Leave out outliers, surplus points and
 *  clusters, orient the normals, and keep one part, with part_at or largest_part. \p why has one entry per given point: why it was
 *  left out, or -1 if it was kept; empty if none was left out. \p counts holds what was dropped before. Fails on fewer than 50
 *  points, if the points form no surface, and when strict, if more than a tenth of them are isolated. The noise is not checked
 *  here; checkSingleSheet checks it for ScannedSurface. */
Status makeSurface(SurfacePoints points, const SurfaceSettings& settings, const SurfaceReport& counts, Surface::Parts& parts,
                   std::vector<std::int8_t>& why);

/** Make a surface from \p surface and further points, such as \p bridges over a gap. \p surface is released before the new
 *  one is made: if the caller moved the only reference, memory holds only one. \p result is null on failure. */
Status addPoints(Surface::ConstPtr surface, const std::vector<Eigen::Vector3f>& bridges, Surface::ConstPtr& result);

/** Ok, or an error with the place if the noise is above 0.35 spacings: the surface is then no single sheet. */
Status checkSingleSheet(const Surface& surface);

} // namespace pcl_spiral
