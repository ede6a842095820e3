/** \file
 *  The chain of stages from clean points to a spiral, free of PCL.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/common/stage_clock.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/surface_boundary.h>
#include <pcl_spiral/features/surface_parts.h>
#include <pcl_spiral/surface/clean_graph.h>
#include <pcl_spiral/toolpath/radial_line_builder.h>
#include <pcl_spiral/toolpath/spiral_curve.h>
#include <pcl_spiral/toolpath/spiral_report.h>
#include <pcl_spiral/toolpath/spiral_settings.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** A toolpath as parallel arrays: in double precision what others are derived from. */
struct SpiralPath {
  Polyline contacts;
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material
  std::vector<Eigen::Vector3f> axes;    ///< unit, tip to shank
  std::vector<double> arc_lengths;
  std::vector<float> turns;
  std::vector<std::uint8_t> over_gap; ///< 1 where the scan has a gap
};

/** Ok, or the setting that cannot be, with its value and remedy. */
Status
checkSettings(const SpiralSettings& settings);

/** Plans one spiral over one set of points. */
class SpiralPlanner {
public:
  /** \p clock writes into the stages of \p report; the first stage, "surface", began when its last one ended. */
  SpiralPlanner(const SpiralSettings& settings, ProgressCallback progress, SpiralReport& report, StageClock& clock);

  /** \p points: finite and all different; \p normals: out of the material, one a point, or empty. */
  Status plan(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals, SpiralPath& path);

private:
  Status prepareSurface(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals);
  Status makeGraph(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals);
  Status keepLargestPart();
  /** Build the graph anew of one of its parts, and of points that belong to none. */
  Status keepPart(const SurfaceParts& parts, std::size_t part);
  Status checkScale();
  Status prepareBoundaries();
  /** Loops of the surface, while progress goes \p from one share \p to another. */
  Status findLoops(double from, double to);
  void reportStrays(const BoundaryCounts& counts);
  Status bridgeGaps();
  Status makeLines(bool two, RadialLineSet& set);
  Status makeCurve(bool two, std::vector<SpiralPoint>& curve);
  Status putOnSurface(const std::vector<SpiralPoint>& curve, SpiralPath& path);
  bool isOverGap(const SurfaceFoot& foot) const;
  Status reportGaps(const SpiralPath& path);
  void halveStretchedSteps(SpiralPath& path);
  Status setAxes(SpiralPath& path);
  Status checkPath(const SpiralPath& path);
  bool report(double share, const std::string& stage);

  const SpiralSettings& settings_;
  ProgressCallback progress_;
  SpiralReport& report_;
  StageClock& clock_;
  SurfaceGraph graph_;
  GraphSource source_; ///< which of the points given each of the graph's was
  std::vector<Eigen::Vector3f> normals_; ///< of these, or empty
  std::size_t strays_ = 0;               ///< points that were left out because they stand alone
  std::unique_ptr<MlsSurface> surface_;
  std::vector<Eigen::Vector3f> bridges_; ///< points that were put into gaps
  std::size_t first_bridge_ = 0;         ///< of the points given to the graph
};

} // namespace pcl_spiral
