// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A judged toolpath, and the limits that it must keep.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/graph/outer_side.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/verify/figures.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What a path must keep. Absent: no limit. */
struct Limits {
  std::optional<double> gouge;     ///< mm
  std::optional<double> scallop;   ///< mm
  std::optional<double> deviation; ///< mm
  std::optional<double> uncut;     ///< percent of the reference points

  bool any() const { return gouge || scallop || deviation || uncut; } ///< Whether there is a limit.
};

/** All of them. */
std::vector<Setting> settingTable(Limits& limits);

/** What is known of a machine program apart from its path. */
struct ProgramFileReport {
  std::string language;              ///< see ProgramFile
  std::size_t blocks = 0;            ///< moves
  std::size_t passes = 0;            ///< that cut
  LeadReport leads;                  ///< of the moves that do not cut
  std::vector<std::size_t> lines;    ///< line of each path point
  Diagnostics warnings;              ///< in full sentences, with the remedy
  Diagnostics faults;                ///< collisions and axes beyond their limits, in words
  std::optional<MotionStudy> motion; ///< of the whole program, for the first region; absent if its control is not known
};

/** \deprecated Use ProgramFileReport. */
using ProgramFigures [[deprecated("use ProgramFileReport")]] = ProgramFileReport;

/** A toolpath's figures. */
struct Verification {
  std::string path;                         ///< file name; empty for one that has just been made
  std::string region;                       ///< of the scan, to which these passes belong; empty: it has only one
  DeviationReport deviation;                ///< of the contacts from the surface
  RemovalReport removal;                    ///< of what the cutter leaves and cuts
  std::size_t tips_off = 0;                 ///< points whose tool tip in the file is not that of the cutter at their contact
  PlacedValue tip_error;                    ///< the farthest of them, mm
  Diagnostics broken;                       ///< limits that do not hold, in words; see Limits
  OuterSide side;                           ///< of the reference: what decided it
  std::optional<ProgramFileReport> program; ///< absent: a path
  double seconds = 0.0;                     ///< of judging, and of making the reference surface if this path was the first
  Diagnostics unproven;                     ///< limits that the noise is too large for, in words
};

/** File and region. */
std::string nameOf(const Verification& verification);

/** Reference points that the cutter leaves untouched, those of the rim band too; percent of all. */
double uncutPercent(const RemovalReport& removal);

/** The first of them. */
const PlacedValue& firstUncut(const RemovalReport& removal);

/** The figure that the limit on the scallop is compared with: the highest ridge, or the most stock if no ridge was measured. */
const PlacedValue& highestScallop(const RemovalReport& removal);

/** Warnings of both measurements, each once, after those of a program. */
Diagnostics warningsOf(const Verification& verification);

} // namespace pcl_spiral
