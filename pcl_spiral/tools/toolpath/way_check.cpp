// SPDX-License-Identifier: BSD-3-Clause
#include "way_check.h"

#include "judging/judged_part.h"

#include <pcl_spiral/collision/impl/way_check.h>

using namespace pcl_spiral;

Surroundings
surroundingsOf(const Result& result)
{
  Surroundings around;
  around.keep_outs = result.part.keep_outs;
  around.kept_out = result.part.kept_out;
  around.beside = result.part.beside;
  around.scan = result.whole_scan;
  around.of_mesh = result.mesh.has_value();
  return around;
}

void
requireFreeWay(const Job& job, const Status& status, const std::optional<BlockedWay>& blocked)
{
  if (!blocked)
    return;
  const Diagnostic reason = status.diagnostic();
  if (blocked->by == BlockedBy::KeepOut)
    throw EntersKeepOut(job.scan, reason, blocked->room, blocked->crosses);
  throw FileError(job.scan, blocked->by == BlockedBy::Beside && job.regions.several()
                                ? reason + ". A keep-out holds for all regions: if another region stands there, give each region a run "
                                           "of its own"
                                : reason);
}

void
checkRawScan(const Job& job, Result& result)
{
  if (job.raw_scan.empty())
    return;
  const RawScanFigures raw = rawScanFigures(job.raw_scan, job.read, *result.surface);
  result.report.warnings.push_back(smoothingText(raw, job.raw_scan));
  JudgeSettings settings;
  settings.cutter = CutterShape::ball(job.settings.tool_radius);
  const double allowed = job.limits.gouge.value_or(gougeTolerance(job.settings.chord_error, result.report.noise));
  const Diagnostic fault = faultInRaw(raw, result.path, settings, allowed);
  if (fault.empty())
    return;
  if (job.verify)
    throw FileError(job.scan, Diagnostic("the path was made, but ", fault));
  result.report.warnings.push_back(fault);
}
