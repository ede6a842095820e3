// SPDX-License-Identifier: BSD-3-Clause
#include "holder_options.h"

#include "terminal/option_values.h"

namespace {

/** Segments as RADIUS,LENGTH or LOWER,UPPER,LENGTH, separated by slashes, from the flank upwards. */
std::vector<pcl_spiral::ToolSegment>
segmentsOf(const std::string& value)
{
  std::vector<pcl_spiral::ToolSegment> segments;
  for (const std::string& piece : piecesOf(value)) {
    const std::vector<std::string> words = listValue(piece);
    if (words.size() != 2 && words.size() != 3)
      throw UsageError(pcl_spiral::Diagnostic(
          "--holder ", value,
          ": give segments as radius,length or lower radius,upper radius,length, separated by slashes, from the flank "
          "upwards, such as 6,40/20,25,60"));
    const double lower = numberValue("holder", words[0]);
    const double upper = words.size() == 3 ? numberValue("holder", words[1]) : lower;
    segments.push_back(
        {lower, upper, numberValue("holder", words.back()), "segment " + std::to_string(segments.size() + 1) + " of the holder"});
  }
  return segments;
}

} // namespace

Option
holderOption(std::vector<pcl_spiral::ToolSegment>& holder)
{
  return {"holder", "SEGMENTS",
          "shank and holder above the flank, upwards, each part as radius,length or lower,upper,length: --holder 6,40/20,25,60",
          [&holder](const std::string& value) { holder = segmentsOf(value); }};
}

std::vector<Option>
holderOptions(std::vector<pcl_spiral::ToolSegment>& holder, double& clearance)
{
  return {holderOption(holder),
          numberOption("holder-clearance", "L", "least distance between holder and scan; default 0: --holder-clearance 1", clearance)};
}

void
checkHolder(const std::vector<pcl_spiral::ToolSegment>& holder, double clearance, double flank_length)
{
  if (const pcl_spiral::Diagnostic fault = pcl_spiral::faultOf(holder); !fault.empty())
    throw UsageError(pcl_spiral::Diagnostic("--holder: ", fault));
  requireOption(clearance >= 0.0, "holder-clearance", clearance, "must not be below 0 mm");
  if (!holder.empty() && !(flank_length > 0.0))
    throw UsageError("--holder: no --flank-length is given; give the length of the flank, the holder begins above it");
}
