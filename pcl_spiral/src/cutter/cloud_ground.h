// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Locates cutters on a scan. Private.
 */
#pragma once

#include "above_ceiling.h"
#include "asked_location.h"
#include "location_ground.h"

#include "fitted_drop.h"
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

namespace pcl_spiral {

/** The points of a scan and the surface fitted to them. */
class CloudGround : public LocationGround {
public:
  CloudGround(const LocationSurface& surface, const CutterProfile& profile, const LocationOptions& options);

  Status check() const override;
  void locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const override;
  bool clears(const DrivePoint& drive, double slack, const HolderProfile& holder) const override;
  double slackAt(const DrivePoint& drive) const override;
  /** The bound of sweptError, because nothing is known between points. */
  double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const override;
  void describe(const ToolLocations& locations, LocationReport& figures) const override;
  const char* name() const override { return "scan"; }
  const char* item() const override { return "point"; }

private:
  ToolLocation resolve(const AskedLocation& asked, const DropContact& drop, const FittedContact& fitted, const SurfaceFoot& foot) const;
  void settle(const AskedLocation& asked, double height, ToolLocation& location) const;
  /** Largest distance, along a normal, between the cutter and a scan that it touches. */
  double near() const { return options_.tolerance + surface_.noiseAllowance(); }
  void standOn(const AskedLocation& asked, const SurfaceFoot& foot, ToolLocation& location) const;
  bool trusted(const FittedContact& fitted, const DropContact& drop) const;
  /** Where the cutter rests on the edge of the surface if it would touch beyond it; not found if the points say otherwise. */
  DropContact onEdge(const AxisFrame& frame, const FittedContact& fitted, const DropContact& drop) const;

  const LocationSurface& surface_;
  LocationOptions options_;
  CutterProfile profile_;
  CutterDrop drop_, rim_drop_, inner_drop_; ///< inner_drop_ has a cutter smaller by near() all round
  FittedDrop fitted_drop_;
  HolderProfile holder_;
  AboveCeiling above_;
};

} // namespace pcl_spiral
