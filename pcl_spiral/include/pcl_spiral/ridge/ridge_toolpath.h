// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath over a ridge from two measured lines.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/ridge/ridge_rows.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Rows over the ridge that a measured generator sweeps along a measured rail. Use it to harden, deburr
 *  or grind an edge without a full scan of it. The points of both lines may come in any order.
 *  \code
 *  RidgeToolpath<pcl::PointXYZ> ridge;
 *  ridge.setInputCloud(rail);          // along the ridge
 *  ridge.setInputGenerator(generator); // across it, square to the rail, once
 *  ridge.setSpot(4.0, 0.25);           // mm, share that the next row covers again
 *  DrivePasses rows;
 *  ridge.compute(rows);
 *  if (!ridge.getStatus().ok()) ...    // names place, value and remedy
 *  \endcode
 *  Use the rows like any drive passes: in ToolAxis, CutterLocation::setDrivePasses, programs and writers.
 *  setIndices selects points of the rail. Lengths in mm, angles in degrees. Source: the feature-line method
 *  for ridges in 3-D laser surface hardening (China Mechanical Engineering). \sa RidgeSurface, planRidgeRows */
template <typename PointT>
class RidgeToolpath : public pcl::PCLBase<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<RidgeToolpath>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const RidgeToolpath>; ///< A shared pointer to a constant one.
  using Cloud = pcl::PointCloud<PointT>;                 ///< Points of one line.

  /** The points measured across the ridge. */
  void setInputGenerator(const typename Cloud::ConstPtr& generator) { generator_ = generator; }
  typename Cloud::ConstPtr getInputGenerator() const { return generator_; } ///< The value of setInputGenerator.

  /** Normal of the reference plane; (0, 0, 1) by default. The chord of the generator keeps its angle with
   *  this plane, and the normal defines which side is up. For a vertical rail, take a normal across the rail. */
  void setReferenceNormal(const Eigen::Vector3d& normal) { settings_.reference = normal; }
  const Eigen::Vector3d& getReferenceNormal() const { return settings_.reference; } ///< The value of setReferenceNormal.
  /** Standard deviation of a coordinate of the points, mm; 0, the default: found from the points. */
  void setMeasuringError(double error) { settings_.measuring_error = error; }
  double getMeasuringError() const { return settings_.measuring_error; } ///< The value of setMeasuringError.
  /** Whether the tool comes from the other side of the ridge; false by default. */
  void setFlipNormals(bool flip) { settings_.flip = flip; }
  bool getFlipNormals() const { return settings_.flip; } ///< The value of setFlipNormals.

  /** Direction of the rows; RidgeDirection::AlongRail by default. */
  void setDirection(RidgeDirection direction) { rows_.direction = direction; }
  RidgeDirection getDirection() const { return rows_.direction; } ///< The value of setDirection.
  /** Whether rows run in zigzag or all in one direction; true, zigzag, by default. */
  void setZigzag(bool zigzag) { rows_.zigzag = zigzag; }
  bool getZigzag() const { return rows_.zigzag; } ///< The value of setZigzag.
  /** Largest distance between neighbouring rows, mm. Set exactly one of these three: setStepOver, setSpot, setScallopHeight. */
  void setStepOver(double step) { rows_.step_over = step; }
  double getStepOver() const { return rows_.step_over; } ///< The value of setStepOver.
  /** Diameter of the spot of a beam, mm, and the share of it that the next row covers again. */
  void setSpot(double size, double overlap)
  {
    rows_.spot_size = size;
    rows_.overlap = overlap;
  }
  double getSpotSize() const { return rows_.spot_size; } ///< The size of setSpot, mm.
  double getOverlap() const { return rows_.overlap; }    ///< The overlap of setSpot.
  /** Radius of the ball cutter that the scallop height is for, mm. */
  void setToolRadius(double radius) { rows_.tool_radius = radius; }
  double getToolRadius() const { return rows_.tool_radius; } ///< The value of setToolRadius.
  /** Largest height of the ridges that the ball may leave, mm. */
  void setScallopHeight(double height) { rows_.scallop_height = height; }
  double getScallopHeight() const { return rows_.scallop_height; } ///< The value of setScallopHeight.
  /** \deprecated Use setToolRadius and setScallopHeight. */
  [[deprecated("use setToolRadius and setScallopHeight")]] void setScallop(double radius, double height)
  {
    setToolRadius(radius), setScallopHeight(height);
  }

  /** Largest distance between consecutive points on the surface, mm; 1 by default. For RidgeSteps::Stations: along rail or generator. */
  void setPointSpacing(double spacing) { rows_.point_spacing = spacing; }
  double getPointSpacing() const { return rows_.point_spacing; }     ///< The value of setPointSpacing.
  void setSteps(RidgeSteps steps) { rows_.steps = steps; }           ///< spacing of the points of a row; RidgeSteps::EqualOnRow by default
  RidgeSteps getSteps() const { return rows_.steps; }                ///< The value of setSteps.
  void setNormals(RidgeNormals normals) { rows_.normals = normals; } ///< which normals the points have; RidgeNormals::True by default
  RidgeNormals getNormals() const { return rows_.normals; }          ///< The value of setNormals.
  /** Largest error of straight moves, for the contact and the tool, mm; 0.01 by default.
   *  Equal steps are made shorter until it holds; 0: only the spacing counts. */
  void setChordError(double error) { rows_.chord_error = error; }
  double getChordError() const { return rows_.chord_error; } ///< The value of setChordError.
  /** Distance of the tool from the contact along the normal, mm; 0 by default. */
  void setStandOff(double distance) { rows_.stand_off = distance; }
  double getStandOff() const { return rows_.stand_off; } ///< The value of setStandOff.
  /** Lean of the axis forward along the row, degrees; 0 by default. The tool stays on the normal. So a
   *  leaning beam meets the surface next to its row, by the stand-off times the tangent of the angle. */
  void setLeadAngle(double degrees) { rows_.lead = degrees; }
  /** \deprecated Renamed setLeadAngle. */
  [[deprecated("use setLeadAngle")]] void setLead(double degrees) { setLeadAngle(degrees); }
  double getLeadAngle() const { return rows_.lead; } ///< The value of setLeadAngle.
  /** Lean of the axis to the right of travel, degrees; 0 by default. */
  void setTiltAngle(double degrees) { rows_.tilt = degrees; }
  /** \deprecated Renamed setTiltAngle. */
  [[deprecated("use setTiltAngle")]] void setTilt(double degrees) { setTiltAngle(degrees); }
  double getTiltAngle() const { return rows_.tilt; } ///< The value of setTiltAngle.
  /** Straight extension before each row that is not closed, mm; 0 by default. */
  void setRunIn(double length) { rows_.run_in = length; }
  double getRunIn() const { return rows_.run_in; }          ///< The value of setRunIn.
  void setRunOut(double length) { rows_.run_out = length; } ///< straight extension after each row that is not closed, mm; 0 by default
  double getRunOut() const { return rows_.run_out; }        ///< The value of setRunOut.

  /** Computes the rows. \p passes is empty on failure. */
  void compute(DrivePasses& passes);

  const Status& getStatus() const { return status_; } ///< Result of the last compute.
  /** The ridge of the last compute; null before, and if none could be made. */
  RidgeSurface::ConstPtr getRidge() const { return ridge_; }
  const RidgeRowReport& getReport() const { return report_; } ///< Figures and warnings of the last compute.
  /** Whether to print no message on failure; false by default. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

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
