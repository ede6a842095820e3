// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutter locations without gouge on a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/swept_error.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/location_mesh.h>
#include <pcl_spiral/cutter/impl/location_surface.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <limits>
#include <memory>

namespace pcl_spiral {

class LocationGround;

/** How a cutter is placed; the setters of CutterLocation explain it. */
struct LocationOptions {
  LocationEvaluation evaluation = LocationEvaluation::FittedSurface;
  double tolerance = 0.01;                                      ///< mm along the axis: a contact touched within this counts as reached;
                                                                ///< also the depth in shank or holder that is not yet a collision
  std::vector<ToolSegment> holder;                              ///< the parts above the cutter, from the top of its flank upwards
  double holder_clearance = 0.0;                                ///< mm to keep between holder and scan
  double ceiling = std::numeric_limits<double>::infinity();     ///< mm above the drive point, from where the cutter comes down
  double tool_length = std::numeric_limits<double>::infinity(); ///< mm; above it nothing is known of the tool
  double max_retilt = 0.0;  ///< degrees the axis may turn if its contact is not reached otherwise; 0: none
  double retilt_step = 0.0; ///< degrees that the turn may change from one location of a pass to the next; 0: without limit
};

/** Sets ceiling and tool length of \p options, as CutterLocation::setCeiling explains it, from \p asked: the ceiling asked for, or 0. */
void setCeilingAndLength(const CutterProfile& profile, const DrivePoints& drive, double asked, LocationOptions& options);

/** Locates one cutter on one scan or mesh, any number of times. The surface or mesh must outlive it.
 *
 *  Source of the drop: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. */
class CutterLocationEngine {
public:
  CutterLocationEngine(const LocationSurface& surface, const CutterProfile& profile, const LocationOptions& options);
  /** On a mesh. The curved surface behind its faces is exact to a hundredth of the tolerance, and to 1e-4 mm. */
  CutterLocationEngine(const LocationMesh& mesh, const CutterProfile& profile, const LocationOptions& options);

  /** One location per drive point, in their order; the same for any number of threads. \p drive must be finite,
   *  and its axes must not be zero. Fails when cancelled, or if the surface is needed and there is none. */
  Status locate(const DrivePoints& drive, const ProgressCallback& progress, ToolLocations& locations) const;

  /** Turns the axes of one pass by up to max_retilt where that helps, with changes of at most retilt_step, see SmoothRetilt. \p drive are
   *  its drive points and \p locations what locate found. The holder is kept \p margin mm farther away, for what is between locations. */
  void retiltPass(const DrivePoint* drive, double margin, std::size_t count, ToolLocation* locations) const;

  /** Bound of how deep the cutter may cut on a straight move between two locations, mm along the normal: sweptError.
   *  On a mesh, for balls whose axis does not turn: the depth that ball and shank do cut, if that is less. Returns
   *  \p allowed if that depth is no more than \p allowed and the ball is nowhere farther off the mesh than that. */
  double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const;

  LocationReport figures(const ToolLocations& locations) const;

  const CutterProfile& profile() const { return profile_; }

private:
  HolderProfile holderWith(double margin) const;
  void retilt(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;

  LocationOptions options_;
  CutterProfile profile_;
  std::shared_ptr<const LocationGround> ground_;
};

} // namespace pcl_spiral
