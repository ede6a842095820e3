// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which points of a scan are the part to be machined: the same options in all programs that read a scan.
 */
#pragma once

#include "file_names.h"
#include "option_table.h"
#include "scan_side.h"

#include "planning/part_selection.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/surface/surface.h>

#include <optional>
#include <string>
#include <vector>

/** The options as given; their coordinates are those of the file of the scan. */
struct PartOptions {
  std::optional<Eigen::Vector3d> part_at; ///< a place on the part
  std::string crop;                       ///< a box, or the file of a polygon
  std::string region;                     ///< the file of a polygon; empty: all that the crop leaves
  std::vector<std::string> keep_outs;     ///< boxes, or files of polygons
  pcl_spiral::ClusterHandling clusters = pcl_spiral::ClusterHandling::Refuse;

  bool cuts() const { return !crop.empty() || !region.empty() || !keep_outs.empty(); } ///< whether points are left out by their place
};

/** Clusters are false echoes if they are said to be; else a path is judged as one that must ride over them. */
inline pcl_spiral::ClusterHandling
judgedClusters(const PartOptions& choice)
{
  using pcl_spiral::ClusterHandling;
  return choice.clusters == ClusterHandling::LeaveOut ? ClusterHandling::LeaveOut : ClusterHandling::Ride;
}

/** --part-at, --crop, --keep-out */
std::vector<Option> placeOptions(PartOptions& choice);

/** --clusters, for a program that refuses clusters. */
Option clustersOption(PartOptions& choice);

/** The files that are read for the choice. */
std::vector<InputName> polygonFiles(const PartOptions& choice);

/** \p place, in the coordinates of the file, in those of the scan that was read: mm, without the origin. */
Eigen::Vector3d placeInScan(const Eigen::Vector3d& place, const pcl_spiral::ReadOptions& read);

/** The reverse. */
Eigen::Vector3d placeInFile(const Eigen::Vector3d& place, const pcl_spiral::ReadOptions& asked);

/** The choice in the coordinates of the scan that was read with \p asked. \throw pcl_spiral::FileError, UsageError */
pcl_spiral::PartChoice choiceOf(const PartOptions& options, const pcl_spiral::ReadOptions& asked);
