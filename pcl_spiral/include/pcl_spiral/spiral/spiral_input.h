// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input and settings of all classes that make a whole spiral.
 */
#pragma once

#include <pcl_spiral/spiral/path_planner.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** A scan and the settings of a spiral over it. Base of SpiralToolpathGenerator and SpiralPlanner. */
template <typename PointInT, typename PointNT = pcl::Normal>
class SpiralInput : public SurfaceInput<pcl::PCLBase<PointInT>, PointInT, PointNT> {
public:
  /** Changes the path after its axes are made, before it is checked; several in this order. Published takes none. */
  void addModifier(const std::shared_ptr<const PathModifier>& modifier) { modifiers_.push_back(modifier); }
  const std::vector<std::shared_ptr<const PathModifier>>& getModifiers() const { return modifiers_; } ///< Those of addModifier.
  void clearModifiers() { modifiers_.clear(); }                                                       ///< Takes back addModifier.

  /** Radius of the ball cutter, mm. Must be set, above the scallop height. */
  void setToolRadius(double radius) { settings_.tool_radius = radius; }
  double getToolRadius() const { return settings_.tool_radius; } ///< The value of setToolRadius.

  /** Allowed height of the ridge between neighbouring turns, mm. Must be set. */
  void setScallopHeight(double height) { settings_.scallop_height = height; }
  double getScallopHeight() const { return settings_.scallop_height; } ///< The value of setScallopHeight.

  /** Allowed distance between a linear move and the curve on the surface, mm; 0.005 by default. */
  void setChordError(double error) { settings_.chord_error = error; }
  double getChordError() const { return settings_.chord_error; } ///< The value of setChordError.

  /** Longest linear move, mm; 0, the default, means the tool radius. */
  void setMaxStep(double step) { settings_.max_step = step; }
  double getMaxStep() const { return settings_.max_step; } ///< The value of setMaxStep.

  /** Side tilt of the tool axis about the feed direction, degrees; 15 by default. */
  void setTiltAngle(double degrees) { settings_.tilt_angle = degrees; }
  double getTiltAngle() const { return settings_.tilt_angle; } ///< The value of setTiltAngle.

  /** Lead of the tool axis in the feed direction, degrees; 0 by default. */
  void setLeadAngle(double degrees) { settings_.lead_angle = degrees; }
  double getLeadAngle() const { return settings_.lead_angle; } ///< The value of setLeadAngle.

  /** One tool axis for the whole path, from tip to shank, of any length, for machines with three axes or one fixed tilt; by default there
   *  is none, and tilt and lead count. A surface that leans away from it by 89 degrees or more is refused. */
  void setFixedAxis(const Eigen::Vector3d& axis) { settings_.fixed_axis = axis; }
  /** Back to tilt and lead. */
  void clearFixedAxis() { settings_.fixed_axis.reset(); }
  const std::optional<Eigen::Vector3d>& getFixedAxis() const { return settings_.fixed_axis; } ///< The value of setFixedAxis.

  /** Largest turn of the tool axis, degrees per mm of path; 10 by default. Published ignores it. */
  void setMaxAxisRate(double degrees_per_mm) { settings_.max_axis_rate = degrees_per_mm; }
  double getMaxAxisRate() const { return settings_.max_axis_rate; } ///< The value of setMaxAxisRate.

  /** Smoothing length of the tool axis, mm: shorter changes are removed; 50 by default, 0 for none. Published ignores it. See AxisField. */
  void setAxisSmoothing(double length) { settings_.axis_smoothing = length; }
  double getAxisSmoothing() const { return settings_.axis_smoothing; } ///< The value of setAxisSmoothing.

  /** How far smoothing may move the axis from the requested tilt, mean over its length, degrees; 2 by default. Published ignores it. */
  void setAxisDeviation(double degrees) { settings_.axis_deviation = degrees; }
  double getAxisDeviation() const { return settings_.axis_deviation; } ///< The value of setAxisDeviation.

  /** Centre of a surface with one boundary; projected onto the surface. Without it, a balanced one: the point x with the
   *  least max d / sqrt(min d), where d are the distances to the rim along the surface (balancedCentre). It makes few turns and
   *  stays away from the rim. */
  void setCenter(const Eigen::Vector3d& centre) { settings_.centre = centre; }
  const std::optional<Eigen::Vector3d>& getCenter() const { return settings_.centre; } ///< The value of setCenter.
  void clearCenter() { settings_.centre.reset(); }                                     ///< Takes back setCenter.

  /** The path begins (or if outward, ends) at the rim near this point. */
  void setStartPoint(const Eigen::Vector3d& point) { settings_.start_point = point; }
  const std::optional<Eigen::Vector3d>& getStartPoint() const { return settings_.start_point; } ///< The value of setStartPoint.
  void clearStartPoint() { settings_.start_point.reset(); }                                     ///< Takes back setStartPoint.

  /** Every setting at once, also those of the surface. */
  void setSettings(const SpiralSettings& settings) { settings_ = settings; }
  const SpiralSettings& getSettings() const { return settings_; } ///< The value of setSettings.

  /** How the whole path is made; Shortest by default. Given radial lines or a given centre select Radial instead. With Published,
   *  given boundaries replace the walk. */
  void setMethod(SpiralMethod method) { settings_.method = method; }
  SpiralMethod getMethod() const { return settings_.method; } ///< The value of setMethod.
  /** Speed along the path at the contact, mm/min; 1000 by default. With the acceleration it decides which method is faster. */
  void setFeed(double feed) { settings_.feed = feed; }
  double getFeed() const { return settings_.feed; } ///< The value of setFeed.
  /** Acceleration of the machine along the path, mm/s2; 2000 by default. */
  void setAcceleration(double acceleration) { settings_.acceleration = acceleration; }
  double getAcceleration() const { return settings_.acceleration; } ///< The value of setAcceleration.
  /** Least radius of turns, in step-overs, 0 to 0.25; 0.2 by default. The report of ConstantScallop has the radius and place of the
   *  sharpest turn, and warns of turns that are too sharp; the corners of the rim itself do not count. */
  void setLeastTurnRadius(double step_overs) { settings_.least_turn_radius = step_overs; }
  double getLeastTurnRadius() const { return settings_.least_turn_radius; } ///< The value of setLeastTurnRadius.
  /** Where the pass along the rim runs, mm: 0, the default, on the rim; above 0 this far beyond it, on the surface continued
   *  straight; below 0 inside it. */
  void setRimOverhang(double overhang) { settings_.rim_overhang = overhang; }
  double getRimOverhang() const { return settings_.rim_overhang; } ///< The value of setRimOverhang.
  /** What to do with holes of the part; Around by default. */
  void setHoleHandling(HoleHandling holes) { settings_.holes = holes; }
  HoleHandling getHoleHandling() const { return settings_.holes; } ///< The value of setHoleHandling.
  /** Least width of a hole of the part, mm; narrower holes are gaps in the data, for which setGapHandling decides. 0, the default:
   *  from the scan (BoundaryOptions). */
  void setHoleSize(double width) { settings_.hole_size = width; }
  double getHoleSize() const { return settings_.hole_size; } ///< The value of setHoleSize.
  /** The path stays this far from holes, mm; 0 by default. */
  void setHoleMargin(double margin) { settings_.hole_margin = margin; }
  double getHoleMargin() const { return settings_.hole_margin; } ///< The value of setHoleMargin.
  /** Number of boundaries between which the spiral runs; Automatic by default: the rim and every hole of the part. */
  void setBoundaryMode(BoundaryMode mode) { settings_.boundary_mode = mode; }
  BoundaryMode getBoundaryMode() const { return settings_.boundary_mode; } ///< The value of setBoundaryMode.
  /** Direction of the spiral; Outward by default. */
  void setDirection(SpiralDirection direction) { settings_.direction = direction; }
  SpiralDirection getDirection() const { return settings_.direction; } ///< The value of setDirection.
  /** Which way the cutter travels round, seen from outside the material; CounterClockwise by default. */
  void setSense(SpiralSense sense) { settings_.sense = sense; }
  SpiralSense getSense() const { return settings_.sense; } ///< The value of setSense.
  /** Never cut against the sense: where loops lie beside each other, ConstantScallop makes several passes with lifts between them
   *  (getPassBegins), and no bridges. Off by default. Radial and Published paths are spirals, which are always one way. */
  void setOneWay(bool one_way) { settings_.one_way = one_way; }
  bool getOneWay() const { return settings_.one_way; } ///< The value of setOneWay.
  /** Direction in which the distance between turns is measured; AcrossFeed by default. Published ignores it. */
  void setPitch(Pitch pitch) { settings_.pitch = pitch; }
  Pitch getPitch() const { return settings_.pitch; } ///< The value of setPitch.
  /** What to do with gaps in the data; Bridge by default. */
  void setGapHandling(GapHandling gaps) { settings_.gaps = gaps; }
  GapHandling getGapHandling() const { return settings_.gaps; } ///< The value of setGapHandling.
  /** What to do with places that the ball does not reach; Ride by default. */
  void setTightHandling(TightHandling tight) { settings_.tight = tight; }
  TightHandling getTightHandling() const { return settings_.tight; } ///< The value of setTightHandling.
  /** How radial lines are found; Automatic by default. Published ignores it. */
  void setLineMethod(LineMethod method) { settings_.lines = method; }
  LineMethod getLineMethod() const { return settings_.lines; } ///< The value of setLineMethod.
  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

protected:
  SurfaceSettings& surfaceSettings() override { return settings_; }             ///< Its own.
  const SurfaceSettings& surfaceSettings() const override { return settings_; } ///< Its own.

  std::vector<std::shared_ptr<const PathModifier>> modifiers_; ///< of addModifier
  SpiralSettings settings_;                                    ///< all of them
  ProgressCallback progress_;                                  ///< of setProgressCallback
};

} // namespace pcl_spiral
