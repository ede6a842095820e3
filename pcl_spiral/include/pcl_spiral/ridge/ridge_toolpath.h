/** \file
 *  A toolpath over a ridge of which two lines were measured.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/ridge/ridge_rows.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Rows over the ridge that a measured generator sweeps along a measured rail: to harden, deburr or grind an edge without a full
 *  scan of it. Points of both lines may come in any order.
 *  \code
 *  RidgeToolpath<pcl::PointXYZ> ridge;
 *  ridge.setInputCloud(rail);          // along the ridge
 *  ridge.setInputGenerator(generator); // across it, square to the rail, once
 *  ridge.setSpot(4.0, 0.25);           // mm, share that the next row covers again
 *  DrivePasses rows;
 *  ridge.compute(rows);
 *  if (!ridge.getStatus().ok()) ...    // names place, value and remedy
 *  \endcode
 *  The rows go on as any drive passes: to ToolAxis, CutterLocation::setDrivePasses, programs and writers. setIndices chooses among
 *  the rail's points. Lengths in mm, angles in degrees. Source: the feature-line method for ridges in 3-D laser surface hardening
 *  (China Mechanical Engineering). \sa RidgeSurface, planRidgeRows */
template <typename PointT>
class RidgeToolpath : public pcl::PCLBase<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<RidgeToolpath>;
  using ConstPtr = pcl::shared_ptr<const RidgeToolpath>;
  using Cloud = pcl::PointCloud<PointT>;

  /** The points measured across the ridge. */
  void setInputGenerator(const typename Cloud::ConstPtr& generator) { generator_ = generator; }
  typename Cloud::ConstPtr getInputGenerator() const { return generator_; }

  /** Normal of the plane with which the generator's chord keeps its angle, and which tells what is up; (0, 0, 1) by default. For a rail that
   *  stands upright take one across it. */
  void setReferenceNormal(const Eigen::Vector3d& normal) { settings_.reference = normal; }
  const Eigen::Vector3d& getReferenceNormal() const { return settings_.reference; }
  /** Standard deviation of a coordinate of the points, mm; 0, the default: found from them. */
  void setMeasuringError(double error) { settings_.measuring_error = error; }
  double getMeasuringError() const { return settings_.measuring_error; }
  /** The tool comes from the other side of the ridge. */
  void setFlipNormals(bool flip) { settings_.flip = flip; }
  bool getFlipNormals() const { return settings_.flip; }

  /** RidgeDirection::AlongRail by default. */
  void setDirection(RidgeDirection direction) { rows_.direction = direction; }
  RidgeDirection getDirection() const { return rows_.direction; }
  /** To and fro, by default, or all one way. */
  void setZigzag(bool zigzag) { rows_.zigzag = zigzag; }
  bool getZigzag() const { return rows_.zigzag; }
  /** How far rows are apart is told by one of these three. */
  void setStepOver(double step) { rows_.step_over = step; }
  double getStepOver() const { return rows_.step_over; }
  /** Diameter of a beam's spot, and the share of it that the next row covers again. */
  void
  setSpot(double size, double overlap)
  {
    rows_.spot_size = size;
    rows_.overlap = overlap;
  }
  double getSpotSize() const { return rows_.spot_size; }
  double getOverlap() const { return rows_.overlap; }
  /** Radius of a ball cutter, and the height of the ridges it may leave. */
  void
  setScallop(double tool_radius, double height)
  {
    rows_.tool_radius = tool_radius;
    rows_.scallop_height = height;
  }
  double getToolRadius() const { return rows_.tool_radius; }
  double getScallopHeight() const { return rows_.scallop_height; }

  /** Largest distance of consecutive points on the surface, mm; 1 by default. Of RidgeSteps::Stations, along the rail or the generator. */
  void setPointSpacing(double spacing) { rows_.point_spacing = spacing; }
  double getPointSpacing() const { return rows_.point_spacing; }
  void setSteps(RidgeSteps steps) { rows_.steps = steps; }
  RidgeSteps getSteps() const { return rows_.steps; }
  void setNormals(RidgeNormals normals) { rows_.normals = normals; }
  RidgeNormals getNormals() const { return rows_.normals; }
  /** Largest error of straight moves, of the contact and of the tool, mm; 0.01 by default. Equal steps are made shorter until it holds;
   *  0: the spacing alone tells. */
  void setChordError(double error) { rows_.chord_error = error; }
  double getChordError() const { return rows_.chord_error; }
  /** Of the tool from the contact along the normal, mm; 0 by default. */
  void setStandOff(double distance) { rows_.stand_off = distance; }
  double getStandOff() const { return rows_.stand_off; }
  /** Of the axis, forward along the row; 0 by default. The tool stays on the normal: a beam that leans meets the surface beside its row, by the stand-off
   *  times the tangent of the angle. */
  void setLead(double degrees) { rows_.lead = degrees; }
  double getLead() const { return rows_.lead; }
  /** Of the axis, to the right of travel; 0 by default. */
  void setTilt(double degrees) { rows_.tilt = degrees; }
  double getTilt() const { return rows_.tilt; }
  /** Straight on before and behind each row that does not go round, mm; 0 by default. */
  void setRunIn(double length) { rows_.run_in = length; }
  double getRunIn() const { return rows_.run_in; }
  void setRunOut(double length) { rows_.run_out = length; }
  double getRunOut() const { return rows_.run_out; }

  /** \p passes is empty on failure. */
  void compute(DrivePasses& passes);

  const Status& getStatus() const { return status_; }
  /** Of the last compute; null before, and where none could be made. */
  RidgeSurface::ConstPtr getRidge() const { return ridge_; }
  const RidgeRowReport& getReport() const { return report_; }
  /** No message of a failure is printed. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; }

private:
  Status run(DrivePasses& passes);

  typename Cloud::ConstPtr generator_;
  RidgeSettings settings_;
  RidgeRowSettings rows_;
  RidgeSurface::ConstPtr ridge_;
  RidgeRowReport report_;
  Status status_;
  bool quiet_ = false;
};

} // namespace pcl_spiral

#include <pcl_spiral/ridge/impl/ridge_toolpath.hpp>

namespace pcl_spiral {
extern template class RidgeToolpath<pcl::PointXYZ>;
extern template class RidgeToolpath<pcl::PointXYZRGB>;
extern template class RidgeToolpath<pcl::PointNormal>;
} // namespace pcl_spiral
