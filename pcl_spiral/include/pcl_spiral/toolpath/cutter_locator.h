/** \file
 *  Gouge-free locations of a cutter on a scan.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/toolpath/drive_point.h>
#include <pcl_spiral/toolpath/fitted_drop.h>
#include <pcl_spiral/toolpath/tool_location.h>

namespace pcl_spiral {

struct AskedLocation;

/** How the height of a location is found. */
enum class LocationEvaluation {
  FittedSurface,  ///< on the surface fitted to the points; where there is none to trust, as PointsAndBound
  PointsAndBound, ///< on the points, raised by the bound of how far the cutter would sink between them, where
                  ///< there is one
  Points          ///< on the points alone, as published: sharp cutters sink between them
};

struct LocationOptions {
  LocationEvaluation evaluation = LocationEvaluation::FittedSurface;
  double tolerance = 0.01; ///< mm along the axis: a contact touched within this is reached; and the depth in
                           ///< shank or holder that is no collision
  std::vector<ToolSegment> holder; ///< what stands on the cutter, from its flank's top upwards
  double holder_clearance = 0.0;   ///< mm kept between holder and scan
  double max_retilt = 0.0; ///< degrees the axis may turn where its contact is not reached otherwise; 0: none
};

/** Locates one cutter on one scan, as often as asked. The surface must outlive it.
 *
 *  Source of the drop: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. */
class CutterLocator {
public:
  CutterLocator(const LocationSurface& surface, const CutterProfile& profile, const LocationOptions& options);

  /** One location a drive point, in their order; the same for any number of threads. \p drive must be finite,
   * with axes of some length. Fails when cancelled, or where the surface is needed and there is none. */
  Status locate(const DrivePoints& drive, const ProgressCallback& progress, ToolLocations& locations) const;

  LocationFigures figures(const ToolLocations& locations) const;

  const CutterProfile&
  profile() const
  {
    return profile_;
  }

private:
  void locateSome(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;
  ToolLocation resolve(const AskedLocation& asked, const DropContact& drop, const FittedContact& fitted,
                       const SurfaceFoot& foot) const;
  void settle(const AskedLocation& asked, double height, ToolLocation& location) const;
  /** Whether the contact asked for is steep, and no point is deeper in the cutter there than near(), along
   * the cutter's normal. */
  bool holds(const AskedLocation& asked) const;
  /** How near, along a normal, the scan is where it is touched. */
  double
  near() const
  {
    return options_.tolerance + surface_.noiseAllowance();
  }
  void standOn(const AskedLocation& asked, const SurfaceFoot& foot, ToolLocation& location) const;
  bool trusted(const FittedContact& fitted, const DropContact& drop) const;
  /** Whether the points let the cutter and what holds it stand at the contact asked for. */
  bool clears(const DrivePoint& drive) const;
  void retilt(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;

  const LocationSurface& surface_;
  LocationOptions options_;
  CutterProfile profile_;
  CutterDrop drop_, rim_drop_, inner_drop_; ///< the last with a cutter smaller by near() all round
  FittedDrop fitted_drop_;
  HolderProfile holder_;
};

} // namespace pcl_spiral
