// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which points of a scan are the part to be machined: the same options in all programs that read a scan.
 */
#pragma once

#include "file_names.h"
#include "option_table.h"
#include "scan_side.h"
#include "uncut_strips.h"

#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/surface/surface.h>

#include <optional>
#include <string>
#include <vector>

/** The options as given; their coordinates are those of the file of the scan. */
struct PartChoice {
  std::optional<Eigen::Vector3d> part_at; ///< a place on the part
  std::string crop;                       ///< a box, or the file of a polygon
  std::string region;                     ///< the file of a polygon; empty: all that the crop leaves
  std::vector<std::string> keep_outs;     ///< files of polygons
  double margin = 0.0;                    ///< how much farther from the keep-outs than one spacing the ball stays, mm
  pcl_spiral::ClusterHandling clusters = pcl_spiral::ClusterHandling::Refuse;

  bool cuts() const { return !crop.empty() || !region.empty() || !keep_outs.empty(); } ///< whether points are left out by their place
};

/** Clusters are false echoes if they are said to be; else a path is judged as one that must ride over them. */
inline pcl_spiral::ClusterHandling
judgedClusters(const PartChoice& choice)
{
  using pcl_spiral::ClusterHandling;
  return choice.clusters == ClusterHandling::LeaveOut ? ClusterHandling::LeaveOut : ClusterHandling::Ride;
}

/** --part-at, --crop, --keep-out */
std::vector<Option> placeOptions(PartChoice& choice);

/** --clusters, for a program that refuses clusters. */
Option clustersOption(PartChoice& choice);

/** The files that are read for the choice. */
std::vector<InputName> polygonFiles(const PartChoice& choice);

/** \p place, in the coordinates of the file, in those of the scan that was read: mm, without the origin. */
Eigen::Vector3d placeInScan(const Eigen::Vector3d& place, const pcl_spiral::ReadOptions& read);

/** The reverse. */
Eigen::Vector3d placeInFile(const Eigen::Vector3d& place, const pcl_spiral::ReadOptions& asked);

/** What is left of a scan when the part is chosen. */
struct ChosenPart {
  std::vector<pcl_spiral::Prism> keep_outs; ///< in the coordinates of the scan that was read
  std::vector<Eigen::Vector3f> beside;      ///< points left out by their place, without those in a keep-out
  std::vector<Eigen::Vector3f> kept_out;    ///< points in a keep-out
  std::optional<Eigen::Vector3d> part_at;   ///< in the coordinates of the scan that was read
  std::vector<UncutStrip> strips;           ///< that are left uncut
};

/** The tool that goes over a scan. */
struct PartTool {
  double radius = 0.0; ///< of the ball, mm; 0: any cutter, looked at later
  double lean = 0.0;   ///< of its axis from the normal, degrees
};

/** How the part of a scan and its side are found, to know where the ball stands. */
struct PartSide {
  const ScanSide& side;
  bool flip_normals = false;
  unsigned int threads = 0;
  bool largest_part = false; ///< of several parts without a place the largest is cut
};

/** Removes from \p scan, which was read from \p file, the points outside the crop and those that \p tool cannot touch without entering
 *  a keep-out, its shank (see ball_way.h) without touching what was scanned there (radius 0: those in a keep-out); adds to its warnings
 *  how many. The narrow \p strips beside keep-outs are removed, too; no warning is added for them.
 *  \throw pcl_spiral::FileError, UsageError */
ChosenPart choosePart(const PartChoice& choice, const std::string& file, const pcl_spiral::ReadOptions& read, const PartTool& tool,
                      const PartSide& side, pcl_spiral::Scan& scan, const StripChoice& strips = {});
