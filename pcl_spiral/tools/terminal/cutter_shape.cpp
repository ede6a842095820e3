// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_shape.h"

#include "terminal.h"

#include "planning/pass_defaults.h"

using namespace pcl_spiral;

std::vector<Option>
cutterShapeOptions(const std::string& radius_help, CutterShape& cutter)
{
  return {
      numberOption("tool-radius", "MM", radius_help, cutter.radius),
      numberOption("corner-radius", "MM", "corner radius; default the largest possible, a ball: --corner-radius 1", cutter.corner_radius),
      numberOption("flank-length", "MM",
                   "length of the cutting flank along its slant, without the tip: from the end of the corner to where the radius is "
                   "the tool radius; default 0: --flank-length 20",
                   cutter.flank_length),
      numberOption("flank-angle", "DEGREES", "angle between flank and axis; default 0: --flank-angle 5", cutter.flank_angle)};
}

void
completeCutter(bool corner_given, CutterShape& cutter)
{
  if (!corner_given)
    setLargestCorner(cutter);
  if (const Diagnostic fault = faultOf(cutter); !fault.empty())
    throw UsageError(Diagnostic("the cutter of --tool-radius, --corner-radius, --flank-length and --flank-angle: ", fault));
}
