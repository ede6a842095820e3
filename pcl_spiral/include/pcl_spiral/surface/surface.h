/** \file
 *  The one prepared surface that all stages share.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/impl/mls_surface.h>
#include <pcl_spiral/surface/impl/scan_voids.h>
#include <pcl_spiral/surface/impl/surface_settings.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Where the points of a cloud went: input is the sum of those down to used. */
struct SurfaceCounts {
  std::size_t input = 0;      ///< of the cloud, or of its indices
  std::size_t nonfinite = 0;  ///< NaN, infinite, or markers beyond 1e12
  std::size_t duplicate = 0;  ///< at the same place as an earlier point
  std::size_t outlier = 0;    ///< dropped by the statistical filter
  std::size_t thinned = 0;    ///< dropped by the voxel grid
  std::size_t surplus = 0;    ///< much closer to others than these to the next, as along scan lines
  std::size_t isolated = 0;   ///< alone off the surface
  std::size_t speck = 0;      ///< in specks apart from the surface
  std::size_t other_part = 0; ///< in separate parts beside the largest, left out as asked
  std::size_t used = 0;
  std::size_t separate_parts = 0; ///< left out as asked
  std::size_t guessed = 0;    ///< points of the surface that were put into gaps, beside those used
  int passes = 0;             ///< over all neighbourhoods, that making the surface took
};

/** Why a point is no point of the surface. */
enum class LeftOut : std::uint8_t { Outlier, Thinned, Surplus, Isolated, Speck, OtherPart };

/** Finite and different points of the cloud that are no points of the surface: parallel arrays, indices ascending. */
struct LeftOutPoints {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> indices; ///< in the cloud
  std::vector<LeftOut> why;
};

/** A scan made ready: clean points in spatial order with oriented normals, spacing, triangulation, local fit; and what was
 *  left out. Immutable, made by ScannedSurface (or by GapBridging, with points put into gaps), shared by every stage
 *  (setInputSurface). Lengths in mm. Memory: about 110 bytes a point.
 */
class Surface {
public:
  using Ptr = std::shared_ptr<Surface>;
  using ConstPtr = std::shared_ptr<const Surface>;

  /** sourceIndex of a point that was put into a gap. */
  static constexpr std::uint32_t no_source = std::numeric_limits<std::uint32_t>::max();

  /** What a Surface is made of; see makeSurface. */
  struct Parts {
    SurfaceGraph graph;
    std::vector<std::uint32_t> source; ///< index in the cloud of each point the graph was built of; empty: all of it, in order
    SurfaceSettings settings;
    SurfaceCounts counts;
    LeftOutPoints left_out;
    std::size_t input_size = 0;
    bool side_is_clear = true;
    std::vector<std::string> warnings;
  };
  explicit Surface(Parts parts);
  Surface(const Surface&) = delete; // the fit refers to the graph
  Surface& operator=(const Surface&) = delete;

  /** Order, normals, spacing and triangles. Points have the graph's order here and below. */
  const SurfaceGraph& graph() const { return parts_.graph; }
  /** The moving-least-squares surface, its fits as wide as the noise asks for. */
  const MlsSurface& fit() const { return fit_; }

  /** Places without points that the triangles close: holes and gaps too narrow to be loops. */
  const ScanVoids& voids() const { return voids_; }

  std::size_t size() const { return parts_.graph.size(); }
  Eigen::Vector3d position(std::size_t i) const { return parts_.graph.position(i); }
  /** Unit, out of the material. */
  Eigen::Vector3d normal(std::size_t i) const { return parts_.graph.normal(i); }
  /** Median distance between neighbouring points, as if they were spread evenly. */
  double spacing() const { return parts_.graph.spacing(); }
  /** Standard deviation of the points about the fit. */
  double noise() const { return fit_.noise(); }

  /** Index in the cloud of point \p i; no_source for a point put into a gap. */
  std::uint32_t sourceIndex(std::size_t i) const { return sourceOfOriginal(parts_.graph.blocks().originalIndex(i)); }
  /** Whether point \p i was put into a gap: the surface about it is a guess. */
  bool isGuessed(std::size_t i) const { return sourceIndex(i) == no_source; }
  /** Index in the cloud of point \p i of those the graph was built of, in their order there (BoundaryLoop::indices of
   *  findBoundaryLoops). */
  std::uint32_t
  sourceOfOriginal(std::size_t i) const
  {
    return parts_.source.empty() ? static_cast<std::uint32_t>(i) : parts_.source[i];
  }
  /** Points of the cloud, whether used or not. */
  std::size_t inputSize() const { return parts_.input_size; }

  const SurfaceSettings& settings() const { return parts_.settings; }
  const SurfaceCounts& counts() const { return parts_.counts; }
  const LeftOutPoints& leftOut() const { return parts_.left_out; }
  /** Whether normals, a view point or +z told the outer side; else the convex side was taken. */
  bool sideIsClear() const { return parts_.side_is_clear; }
  /** What was left out and where the side is a guess, in words. */
  const std::vector<std::string>& warnings() const { return parts_.warnings; }

private:
  friend void dropTriangulation(const ConstPtr& surface);

  Parts parts_;
  MlsSurface fit_;
  ScanVoids voids_;
};

/** The points a surface is made of. */
struct SurfacePoints {
  std::vector<Eigen::Vector3f> positions; ///< finite and all different
  std::vector<Eigen::Vector3f> normals;   ///< one a point, zero for none; or empty: the side they face is the outer
  std::vector<std::uint32_t> source;      ///< index of each in the cloud; empty: all of it, in order
};

/** Make a surface of \p points by \p settings, whose filters have been run already: leave outliers, surplus points and specks
 *  out, orient, and with largest_part keep the largest part. \p why has for each of the points given whether and why it was
 *  left out (-1: it was not), or is empty: none was. \p counts holds what was dropped before. Fails on fewer than 50 points,
 *  where the points form no surface, and when strict, where more than a tenth of them stand alone. How far they scatter is not
 *  looked at here: checkSingleSheet does, for ScannedSurface. */
Status
makeSurface(SurfacePoints points, const SurfaceSettings& settings, const SurfaceCounts& counts, Surface::Parts& parts,
            std::vector<std::int8_t>& why);

/** Make a surface of \p surface and further points, such as \p bridges over a gap. \p surface is given up before the new
 *  one is made, so that no two stand in memory where the caller has moved the only reference. \p result is null on failure. */
Status
addPoints(Surface::ConstPtr surface, const std::vector<Eigen::Vector3f>& bridges, Surface::ConstPtr& result);

/** Ok; or the surface scatters by more than 0.35 spacings about its fit, and is no single sheet: says where. */
Status
checkSingleSheet(const Surface& surface);

/** Free the triangulation, the larger half of a surface's memory, where \p surface is the only reference to it, for who
 *  needs neighbourhoods alone from now on; does nothing to a surface that is shared. */
void
dropTriangulation(const Surface::ConstPtr& surface);

} // namespace pcl_spiral
