// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Passes of any cutter over the chosen part of a scan or of a mesh, with all that they were made from.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/cutter/tool_location.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/led_tool.h>
#include <pcl_spiral/planning/part_choice.h>
#include <pcl_spiral/surface/surface.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Least tolerance between locations, mm: the single precision of a scan resolves no less. */
constexpr double least_tolerance = 1e-4;

/** The tool of passes, and how its locations are found; see CutterLocation. Lengths in mm, angles in degrees. */
struct PassSettings {
  CutterShape cutter;              ///< radius 0: none, a beam
  std::vector<ToolSegment> holder; ///< above the cutter
  double holder_clearance = 0.0;   ///< that the holder keeps
  double ceiling = 0.0;            ///< above the drive point, from where the cutter comes; 0: the length of the tool
  double max_retilt = 0.0;         ///< 0: axes are not turned
  double retilt_step = 3.0;        ///< from one location to the next
  double tolerance = 0.01;         ///< between locations, least_tolerance or more
  double axis_smoothing = 0.0;     ///< along the path; 0: none
  double max_axis_rate = 0.0;      ///< degrees per mm; 0: no limit
  bool accept_collisions = false;  ///< of shank and holder: they are warnings
  unsigned int threads = 0;        ///< 0: all; the passes do not depend on it
};

/** All of them but cutter and holder. */
std::vector<Setting> settingTable(PassSettings& settings);

/** Locations left out because of what is not to be cut. Depths in mm. */
struct LeftOutLocations {
  std::size_t entering = 0;                               ///< the cutter would enter a keep-out
  std::size_t touching = 0;                               ///< the tool would touch what stands in a keep-out
  std::size_t beside = 0;                                 ///< the tool would touch the scan beside the part
  double deepest = 0.0;                                   ///< of touching
  double deepest_beside = 0.0;                            ///< of beside
  Eigen::Vector3d first = Eigen::Vector3d::Zero();        ///< place touched, of touching
  Eigen::Vector3d first_beside = Eigen::Vector3d::Zero(); ///< place touched, of beside
  std::vector<Eigen::Vector3d> contacts;                  ///< of all locations left out

  std::size_t count() const { return entering + touching + beside; } ///< All of them.
};

/** The passes of one of several regions. */
struct PlannedRegion {
  std::string name;          ///< of the region
  std::size_t passes = 0;    ///< their number
  std::size_t locations = 0; ///< their number
  Surface::ConstPtr surface; ///< of the region
  OuterSide side;            ///< what decided it
};

/** Passes and their figures. Lengths in mm. */
struct PassPlan {
  std::string region;                 ///< its name; empty: the only one, or all together
  std::vector<PlannedRegion> regions; ///< if there are several, in the order of their passes

  std::vector<ToolPoses> passes; ///< in travel order, without locations off the part
  double length = 0.0;           ///< of the tip's path along all passes
  std::size_t off_scan = 0;      ///< locations left out: no part of the surface below the cutter, and those of left_out
  LeftOutLocations left_out;     ///< because of what is not to be cut
  DriveReport drive;             ///< of the drive path; its warnings are in warnings
  LocationReport locations;      ///< of the cutter; its warnings are in warnings
  BisectionReport bisection;     ///< of the moves between locations
  LedTool tool;                  ///< as used
  bool gouges_checked = true;    ///< false: the cutter stands at the contacts of a mesh
  bool covers_scan = true;       ///< false: the passes run over a band of the scan, as a ridge or a curve
  std::vector<StageCost> stages; ///< time and memory
  Diagnostics warnings;          ///< of all but choosing the part; of several regions of that, too, each with the name of its region

  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole; ///< the scan with all that was left out; of a mesh its samples, if they were made
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the points of the part; of several regions the whole scan
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of these points, as given; null: none, or several regions
  ChosenPart chosen;          ///< how the part was chosen, and what is beside it; of several regions the keep-outs alone
  Surface::ConstPtr surface;  ///< of the part; null for a mesh, and for points that form none
  OuterSide side;             ///< what decided the side of the scan; of several regions that of the first
  SurfaceMesh::ConstPtr mesh; ///< the part if it is a mesh; null for a scan

  /** The box of what stands in the scan, without false echoes, for ProgramSettings::clear_box: rapids cross above it. Empty if the passes
   *  cover the whole scan, and for a mesh. */
  Eigen::AlignedBox3d clearBox() const;

  /** Locations of all passes. */
  std::size_t poseCount() const
  {
    std::size_t count = 0;
    for (const ToolPoses& pass : passes)
      count += pass.size();
    return count;
  }
};

/** Passes as one path, for writeToolpath. */
struct PassPath {
  pcl::PointCloud<ToolpathPoint> path; ///< all passes; ToolpathPoint::turn is the number of the pass
  Polyline tips;                       ///< one for each point
  std::vector<std::size_t> begins;     ///< where the second pass and each further one begin
};

/** \p passes as one path. */
PassPath joinedPasses(const std::vector<ToolPoses>& passes);

/** A beam on \p rows, the tool \p stand_off mm from the surface along its normal, see RidgeToolpath: contacts are where the spot
 *  meets the surface. A closed row ends where it begins. */
std::vector<ToolPoses> beamPasses(const DrivePasses& rows, double stand_off);

} // namespace pcl_spiral
