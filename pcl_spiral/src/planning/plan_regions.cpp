// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan_regions.h"

#include <pcl_spiral/common/impl/progress.h>

#include <algorithm>

namespace pcl_spiral {

std::vector<PlanRegion>
namedRegions(std::vector<PlanRegion> regions)
{
  if (regions.empty())
    regions.emplace_back();
  for (std::size_t i = 0; regions.size() > 1 && i < regions.size(); ++i)
    if (regions[i].name.empty())
      regions[i].name = "region " + std::to_string(i + 1);
  return regions;
}

PartChoice
choiceOf(PartChoice choice, const PlanRegion& region)
{
  if (region.polygon)
    choice.region = region.polygon;
  if (region.part_at)
    choice.part_at = region.part_at;
  return choice;
}

void
chooseOnly(std::vector<PlanRegion>& regions, PartChoice& choice)
{
  if (regions.size() != 1)
    return;
  choice = choiceOf(choice, regions.front());
  regions.front() = {{}, {}, regions.front().name};
}

ProgressCallback
progressOf(const ProgressCallback& whole, std::size_t i, std::size_t count)
{
  const auto share = [count](std::size_t k) { return static_cast<double>(k) / static_cast<double>(count); };
  return partOf(whole, share(i), share(i + 1));
}

Diagnostic
textOfRegion(const std::string& name, const Diagnostic& said)
{
  return name.empty() ? said : Diagnostic(name, ": ", said);
}

Diagnostics
ofRegion(const std::string& region, Diagnostics warnings)
{
  for (Diagnostic& warning : warnings)
    warning = textOfRegion(region, warning);
  return warnings;
}

Status
checkPartOfMesh(const PartChoice& choice, const std::vector<PlanRegion>& regions)
{
  const bool has_polygon =
      choice.region || std::any_of(regions.begin(), regions.end(), [](const PlanRegion& region) { return region.polygon.has_value(); });
  const char* const setter = choice.crop_box             ? "{setCropBox}"
                             : choice.crop               ? "{setCrop}"
                             : !choice.keep_outs.empty() ? "{addKeepOut}"
                             : has_polygon               ? "{addRegion}"
                                                         : nullptr;
  if (setter == nullptr)
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic(setter, " belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out")};
}

} // namespace pcl_spiral
