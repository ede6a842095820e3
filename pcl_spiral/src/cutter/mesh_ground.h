// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Locates cutters on a mesh. Private.
 */
#pragma once

#include "above_ceiling.h"
#include "asked_location.h"
#include "location_ground.h"
#include "mesh_sweep.h"

#include "mesh_drop.h"
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

namespace pcl_spiral {

/** The faces of a mesh, or the curved surface behind them. */
class MeshGround : public LocationGround {
public:
  MeshGround(const LocationMesh& mesh, const CutterProfile& profile, const LocationOptions& options);

  Status check() const override;
  void locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const override;
  bool clears(const DrivePoint& drive, double slack, const HolderProfile& holder) const override;
  double slackAt(const DrivePoint& drive) const override;
  /** For balls whose axis does not turn, if they touch the mesh all the way: how deep they cut into the mesh, if that is
   *  less than sweptError. */
  double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const override;
  void describe(const ToolLocations& locations, LocationReport& figures) const override;
  const char* name() const override { return "mesh"; }
  const char* item() const override { return "face"; }

private:
  MeshContact highest(const AxisFrame& frame) const;
  ToolLocation resolve(const AskedLocation& asked) const;
  void settle(const AskedLocation& asked, double height, ToolLocation& location) const;
  /** Set the face and place that the cutter touches. */
  void touch(std::uint32_t face, const Eigen::Vector3d& weights, const Eigen::Vector3d& contact, ToolLocation& location) const;
  /** Find the place of the mesh within near() of the given contact. */
  bool findAsked(const AskedLocation& asked, PatchPlace& place) const;
  double near() const { return options_.tolerance + mesh_.rounding(); }

  const LocationMesh& mesh_;
  LocationOptions options_;
  CutterProfile profile_;
  double sag_;
  MeshDrop drop_, rim_drop_, inner_drop_; ///< inner_drop_ has a cutter smaller by near() all round
  MeshSweep sweep_;
  HolderProfile holder_;
  AboveCeiling above_;
};

} // namespace pcl_spiral
