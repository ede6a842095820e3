// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Several regions of a scan in one run, each with its own path.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "part_options.h"

#include <pcl_spiral/io/file_error.h>

#include <string>
#include <vector>

/** The options as given; their coordinates are those of the file of the scan. */
struct RegionChoice {
  std::vector<Eigen::Vector3d> places; ///< on separate parts
  std::vector<std::string> polygons;   ///< files

  /** Whether there are several regions, whatever is in the polygons. */
  bool several() const { return places.size() > 1 || polygons.size() > 1; }
};

/** One region of a run. */
struct NamedRegion {
  PartOptions part;
  std::string name; ///< such as "region 2 (--part-at 120,80,15)"; empty if it is the only one
};

/** --part-at, several times, --region, --crop, --keep-out */
std::vector<Option> regionOptions(PartOptions& choice, RegionChoice& regions);

/** Help of --part-at and --region, also for the programs that judge. */
extern const char* const part_at_help;
extern const char* const region_help;

/** The files that are read for the choice. */
std::vector<InputName> polygonFiles(const PartOptions& choice, const RegionChoice& regions);

/** One region per polygon; of a polygon with places in it one per place, and without polygons one per place. All have the crop and the
 *  keep-outs of \p choice. \throw UsageError for a place in no polygon, pcl_spiral::FileError */
std::vector<NamedRegion> regionsOf(const PartOptions& choice, const RegionChoice& regions, const pcl_spiral::ReadOptions& read);

/** Calls \p work for one region; errors that it throws name the region. */
template <typename Work>
auto
inRegion(const std::string& name, Work work) -> decltype(work())
{
  if (name.empty())
    return work();
  try {
    return work();
  }
  catch (const UsageError& error) {
    throw UsageError(pcl_spiral::Diagnostic(name, ": ", error.diagnostic()));
  }
  catch (const pcl_spiral::FileError& error) {
    throw pcl_spiral::FileError(name, error.diagnostic());
  }
}

/** \p regions for a planner, in the coordinates of the scan that was read with \p asked. \throw pcl_spiral::FileError */
std::vector<pcl_spiral::PlanRegion> planRegions(const std::vector<NamedRegion>& regions, const pcl_spiral::ReadOptions& asked);

/** Sets crop, keep-outs, regions and place of the part. \throw UsageError, pcl_spiral::FileError */
template <typename Planner>
void
setPart(const PartOptions& options, const RegionChoice& regions, const pcl_spiral::ReadOptions& read, Planner& planner)
{
  const pcl_spiral::PartChoice choice = choiceOf(options, read);
  if (choice.crop_box)
    planner.setCropBox(*choice.crop_box);
  if (choice.crop)
    planner.setCrop(*choice.crop);
  for (const pcl_spiral::Prism& keep_out : choice.keep_outs)
    planner.addKeepOut(keep_out);
  for (const pcl_spiral::PlanRegion& region : planRegions(regionsOf(options, regions, read), read))
    planner.addRegion(region);
}
