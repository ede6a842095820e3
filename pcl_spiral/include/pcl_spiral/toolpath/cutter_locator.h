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

/** How the height of a location is found. */
enum class LocationEvaluation {
  FittedSurface,  ///< on the surface fitted to the points; where there is none to trust, as PointsAndBound
  PointsAndBound, ///< on the points, raised by the bound of how far the cutter would sink between them, where
                  ///< there is one
  Points          ///< on the points alone, as published: sharp cutters sink between them
};

struct LocationOptions {
  LocationEvaluation evaluation = LocationEvaluation::FittedSurface;
  double tolerance = 0.01; ///< mm along the axis: a contact touched within this is reached
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

private:
  struct Asked;
  void locateSome(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;
  ToolLocation resolve(const Asked& asked, const DropContact& drop, const FittedContact& fitted,
                       const SurfaceFoot& foot) const;
  void settle(const Asked& asked, double height, ToolLocation& location) const;
  bool trusted(const FittedContact& fitted, const DropContact& drop) const;

  const LocationSurface& surface_;
  LocationOptions options_;
  CutterProfile profile_;
  CutterDrop drop_, rim_drop_;
  FittedDrop fitted_drop_;
};

} // namespace pcl_spiral
