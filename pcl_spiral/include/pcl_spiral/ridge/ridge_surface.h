// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ridge: the surface that a generator sweeps along a rail, and the same as triangles.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/ridge_frame.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/ridge/impl/measured_line.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

#include <pcl/PolygonMesh.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Which normal the places of a ridge have. */
enum class RidgeNormals {
  True,          ///< normal to both directions of the surface, dS/du x dS/dv
  InNormalPlane, ///< as published, r x N: across the generator, in the normal plane of the rail; wrong where the frame twists
  Arc            ///< the published short-cut for short generators: from the circle through start, middle and end
};

/** Settings of a ridge. Lengths in mm. */
struct RidgeSettings {
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< normal of the reference plane; it also defines which side is up
  double measuring_error = 0.0;                         ///< standard deviation of a coordinate of the measured points; 0: found from them
  bool flip = false;                                    ///< the other side is up
};

/** All of them. */
std::vector<Setting> settingTable(RidgeSettings& settings);

/** What was found in the measured lines. Lengths in mm, angles in degrees. */
struct RidgeReport {
  std::size_t rail_points = 0;                              ///< used, without duplicates
  std::size_t generator_points = 0;                         ///< used, without duplicates
  bool closed = false;                                      ///< the rail is a ring
  double rail_length = 0.0;                                 ///< of the fitted curve
  double generator_length = 0.0;                            ///< of the fitted curve
  double rail_error = 0.0;                                  ///< standard deviation of a coordinate about the fitted curve
  double generator_error = 0.0;                             ///< the same of the generator
  double rail_direction = 0.0;                              ///< error of the direction of the curve, rms: from two halves of the points
  double generator_direction = 0.0;                         ///< the same of the generator
  double meeting = 0.0;                                     ///< arc length of the rail where it meets the generator
  Eigen::Vector3d meeting_place = Eigen::Vector3d::Zero();  ///< that place
  double meeting_distance = 0.0;                            ///< between both lines there
  double chord = 0.0;                                       ///< from start to end of the generator
  double chord_angle = 0.0;                                 ///< theta, with the reference plane
  double tilt = 0.0;                                        ///< angle between the plane of the generator and the normal plane of the rail
  double largest_slope = 0.0;                               ///< of the rail against the reference plane, and its place
  Eigen::Vector3d steepest_place = Eigen::Vector3d::Zero(); ///< where the slope is largest
  double slope_factor = 0.0;  ///< the largest: an error of the slope turns the chord by this many times as much
  double least_stretch = 1.0; ///< of the surface along the rail, 1 + omega2 c - omega3 b; 0 where it folds
  Diagnostics warnings;       ///< in full sentences, with the remedy
};

/** What RidgeLines found in a scan. Lengths in mm. */
struct ScanRidgeReport {
  std::size_t sections = 0;    ///< sections across the ridge that were aligned
  std::size_t points = 0;      ///< points of the scan in the band of the ridge
  int rounds = 0;              ///< until rail and generator did not move any more
  double last_move = 0.0;      ///< of the rail in the last round, rms, without the common part of all moves
  double noise = 0.0;          ///< of the scan: standard deviation of a point about its surface
  double reach_left = 0.0;     ///< length of the generator from the crest to its start
  double reach_right = 0.0;    ///< length of the generator from the crest to its end
  double crest_wander = 0.0;   ///< rms distance of the crest from the rail that was found, across it
  double misfit = 0.0;         ///< rms distance of the points from the swept surface, including the noise of the scan
  double largest_misfit = 0.0; ///< largest median of small cells of the surface, so that noise has little effect on it
  Eigen::Vector3d largest_place = Eigen::Vector3d::Zero(); ///< middle of that cell
  Polyline crest;                                          ///< where the larger curvature is largest; the search begins with it
  Diagnostics warnings;                                    ///< in full sentences, with the remedy
};

/** The surface S(u, v) = L(u) + a(v) m1 + b(v) m2 + c(v) m3: rail L, frame m1, m2, m3 of equation (1) (\see
 *  ridgeFrame), local coordinates a, b, c of the measured generator. u and v are the arc lengths of both
 *  lines in mm. Source: the feature-line method for ridges in 3-D laser surface hardening (China Mechanical
 *  Engineering), equations (1) to (3); a is small and is kept. Immutable; any number of threads may use it.
 *
 *  The rail runs from the end nearer to the generator. A ring runs counter-clockwise about the reference normal, from the place
 *  where it meets the generator. The generator runs so that up, m3, is on the side of the reference normal. So points may come
 *  in any order. Exception: if the generator is exactly at the middle of the rail, the direction of the rail is not fixed. */
class RidgeSurface {
public:
  using ConstPtr = std::shared_ptr<const RidgeSurface>; ///< A shared pointer to a constant one.

  /** Makes the surface from the points of both lines. \p result is null on failure.
   *
   *  InvalidInput, with place and value: what orderLine refuses; a corner of the rail of more than 30 degrees;
   *  start and end of the generator nearer than a twentieth of its length; the generator far from the rail, or
   *  beyond its ends; its plane tilted by more than 15 degrees against the normal plane of the rail; the rail
   *  too steep for the angle of the chord, or along the reference normal, where the frame would turn over; a
   *  fold of the surface. InvalidArgument: a reference normal without direction, a measuring error below 0. */
  static Status make(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings, ConstPtr& result);

  const RidgeSettings& settings() const { return settings_; } ///< The settings it was made with.
  const RidgeReport& report() const { return report_; }       ///< What was found in the measured lines.
  const SmoothLine& rail() const { return rail_; }            ///< The fitted rail L.
  /** In local coordinates. */
  const SmoothLine& generator() const { return generator_; }
  const RidgeChord& chord() const { return chord_; } ///< What the chord keeps constant.

  RidgeFrame frame(double u) const;                   ///< The frame m1, m2, m3 at the rail's arc length \p u.
  Eigen::Vector3d position(double u, double v) const; ///< S(u, v).
  /** Unit, up. */
  Eigen::Vector3d normal(double u, double v, RidgeNormals normals = RidgeNormals::True) const;
  /** dS/du. */
  Eigen::Vector3d alongRail(double u, double v) const;
  Eigen::Vector3d alongGenerator(double u, double v) const; ///< dS/dv.

private:
  Status fit(const Polyline& rail, const Polyline& generator);
  Status place(const MeasuredLine& generator, bool may_turn, bool& turned);
  void warnOfMeeting(const MeasuredLine& rail, const MeasuredLine& generator);
  void warnOfDirections();
  Status checkRail();
  void warnOfSlope(const Eigen::Vector3d& sensitive);
  Status checkFolds();

  RidgeSettings settings_;
  RidgeReport report_;
  SmoothLine rail_, generator_;
  RidgeChord chord_;
  Eigen::Vector3d arc_centre_ = Eigen::Vector3d::Zero(); ///< of the circle through start, middle and end, in local coordinates
};

/** A ridge as triangles between equal stations of its rail and of its generator. Lengths in mm. */
struct RidgeMesh {
  Polyline vertices;                               ///< on the ridge: station by station along the rail; at each station along the generator
  std::vector<std::array<std::uint32_t, 3>> faces; ///< counter-clockwise seen from above
  std::size_t along = 0;                           ///< cells along the rail; each cell is two faces
  std::size_t across = 0;                          ///< cells along the generator

  /** The same in single precision, as a mesh of PCL. */
  pcl::PolygonMesh polygons() const;
};

/** Cells so small that no face is farther than \p chord_error from the ridge; no cell is more than four times as long as wide. On
 *  a closed rail, the last cells join the first. InvalidArgument: a chord error not above 0, or so small that it needs more than a
 *  million faces; the message gives one that works. InvalidInput: a ridge so slender that any chord error needs that many faces. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, RidgeMesh& mesh);

/** The same as a surface, to locate cutters on (CutterLocation::setInputMesh) and to draw. Its faces are curved, so
 *  the surface is nearer to the ridge than the chord error, up to single precision. \p mesh is null on failure. */
Status ridgeMesh(const RidgeSurface& surface, double chord_error, SurfaceMesh::ConstPtr& mesh);

} // namespace pcl_spiral
