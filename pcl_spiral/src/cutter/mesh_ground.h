// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutters located on a mesh. Private.
 */
#pragma once

#include "asked_location.h"
#include "location_ground.h"
#include "mesh_sweep.h"

#include "mesh_drop.h"
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

namespace pcl_spiral {

/** The faces of a mesh, or the curved surface they stand for. */
class MeshGround : public LocationGround {
public:
  MeshGround(const LocationMesh& mesh, const CutterProfile& profile, const LocationOptions& options);

  Status check() const override;
  void locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const override;
  bool clears(const DrivePoint& drive) const override;
  /** Of balls whose axis does not turn what they cut into the mesh, where that is less than sweptError, if they
   * touch the mesh all the way. */
  double moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const override;
  void describe(const ToolLocations& locations, LocationFigures& figures) const override;
  const char* name() const override { return "mesh"; }
  const char* item() const override { return "face"; }

private:
  MeshContact highest(const AxisFrame& frame) const;
  ToolLocation resolve(const AskedLocation& asked) const;
  void settleContact(const AskedLocation& asked, double height, ToolLocation& location) const;
  void settle(const AskedLocation& asked, double height, ToolLocation& location) const;
  /** Set what the cutter touches. */
  void touch(std::uint32_t face, const Eigen::Vector3d& weights, const Eigen::Vector3d& contact, ToolLocation& location) const;
  /** The mesh where it passes the contact asked for within near(). */
  bool findAsked(const AskedLocation& asked, PatchPlace& place) const;
  /** Whether the contact asked for is steep, and nothing is deeper in the cutter there than near(), along the cutter's
   * normal. */
  bool holds(const AskedLocation& asked) const;
  double near() const { return options_.tolerance + mesh_.rounding(); }

  const LocationMesh& mesh_;
  LocationOptions options_;
  CutterProfile profile_;
  double sag_;
  MeshDrop drop_, rim_drop_, inner_drop_; ///< the last with a cutter smaller by near() all round
  MeshSweep sweep_;
  HolderProfile holder_;
};

} // namespace pcl_spiral
