// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places in the coordinates of the scan file, for a run whose scan was shifted (see pcl_spiral::Scan::shift) or has another unit.
 *
 *  Everything between reading and writing is in shifted coordinates, mm. Places of options are shifted after reading (fromScan); places
 *  of summaries and reports are shifted back where they are shown (inScan), and those in messages too (shownPlace), which also has them
 *  as the file has them, if it has another unit or a given origin.
 */
#pragma once

#include "option_table.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/verify/verification.h>

#include <Eigen/Core>

#include <optional>
#include <string>

/** How the programs read a scan unless --origin is given: with a found origin. */
pcl_spiral::ReadOptions readFindingOrigin();

/** --origin X,Y,Z as \p value: it is subtracted, and none is found. \throw UsageError */
void setOrigin(const std::string& value, pcl_spiral::ReadOptions& read);

/** The option --origin. */
Option originOption(pcl_spiral::ReadOptions& read);

/** Help on --origin, --units and --view-point, for all programs. */
extern const char* const origin_help;
extern const char* const units_help;
extern const char* const view_point_help;

/** Sets the shift of the run, mm, and how its scan was read, as soon as it is. */
void setScanFrame(const Eigen::Vector3d& shift, const pcl_spiral::ReadOptions& asked);
/** Zero if nothing was shifted. */
const Eigen::Vector3d& scanShift();

/** Options that read another file of the run, in the same shifted coordinates. */
pcl_spiral::ReadOptions readAsScan(pcl_spiral::ReadOptions read);

/** A place in the coordinates of the scan, in shifted ones. */
Eigen::Vector3d fromScan(const Eigen::Vector3d& place);
std::optional<Eigen::Vector3d> fromScan(const std::optional<Eigen::Vector3d>& place);

/** The reverse. Of figures: every place; what they say has its places as fields, see programWords.
 *  @{ */
Eigen::Vector3d inScan(const Eigen::Vector3d& place);
pcl_spiral::SpiralReport inScan(pcl_spiral::SpiralReport report);
pcl_spiral::Verification inScan(pcl_spiral::Verification verification);
/** @} */

/** The text of a place: in the coordinates of the scan, and " (in the file 1,2,3)" behind it if the file has others than mm in the scan. */
std::string shownPlace(const Eigen::Vector3d& place);

/** The value as an option takes it: a place as 1,2,3 and a box as xmin,xmax,ymin,ymax, in the coordinates of the file. */
std::string optionValue(const pcl_spiral::Proposed::Value& value);

/** "393775000, 3689071000, 0 mm" */
std::string shiftText();

/** \p title, with the shift for pictures and for the comments of programs: they stay in shifted coordinates. */
std::string titleWithShift(const std::string& title);

/** The line of a summary, with its end; empty if nothing was shifted. */
std::string shiftLine();
