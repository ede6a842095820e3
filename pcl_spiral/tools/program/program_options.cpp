// SPDX-License-Identifier: BSD-3-Clause
#include "program_options.h"

#include <pcl_spiral/core/impl/angles.h>

namespace {

/** An option for a tolerance of tip and axis: 0.01,0.1 */
Option
tolerance(const std::string& name, const std::string& help, pcl_spiral::BlockTolerance& target)
{
  return {name, "MM,DEG", help, [name, &target](const std::string& value) {
            const std::vector<std::string> words = listValue(value);
            if (words.size() != 2)
              throw UsageError("--" + name + " " + value + ": mm of the tip and degrees of the axis are needed, such as 0.01,0.1");
            target = {numberValue(name, words[0]), pcl_spiral::degree * numberValue(name, words[1])};
          }};
}

} // namespace

OptionGroup
programOptions(ProgramJob& program)
{
  pcl_spiral::ProgramSettings& settings = program.settings;
  return {"Program of a five-axis machine (.ngc .nc)",
          {textOption("machine", "FILE", "machine file in YAML: axes, limits, rates: --machine xyzac.yaml", program.machine_file),
           choiceOption("dialect", "language of a .nc; .ngc is LinuxCNC's: --dialect siemens", program.dialect),
           choiceOption("lead-in", "how the tool comes to the path and leaves it; normal: --lead-in arc", settings.lead),
           numberOption("lead-length", "L", "length of the lead, or radius of the arc; 2: --lead-length 5", settings.lead_length),
           numberOption("clearance", "L", "the feed begins so far along the tool axis off the lead; 5: --clearance 3", settings.clearance),
           numberOption("rapid-height", "L", "rapids cross so far above the highest tip; 50: --rapid-height 100", settings.rapid_height),
           switchOption("accept-collisions",
                        "write what is asked although the tool would touch the scan on its way to the path, or its holder would",
                        program.accept_collisions),
           numberOption("pole-cone", "A",
                        "axes are blended within this angle of the rotary axis's own direction, where it would turn too "
                        "fast; 5: --pole-cone 2",
                        settings.pole_cone),
           tolerance("block-tolerance",
                     "moves of the machine stay this near the path, tip and axis; 0.002,0.06: --block-tolerance 0.005,0.1", settings.block),
           tolerance("thin-blocks", "leave out blocks within this of tip and axis; none by default: --thin-blocks 0.005,0.1",
                     settings.thinning),
           numberOption("spindle", "S", "rev/min; the spindle is left alone by default: --spindle 12000", program.header.spindle_speed),
           wholeNumberOption("tool", "N", "tool that is called; none by default: --tool 3", program.header.tool),
           wholeNumberOption("decimals", "N", "of mm and degrees in programs, 3 to 6; 4: --decimals 3", program.header.decimals),
           textOption("pass-begin", "CODE",
                      "code on a line of its own where each row begins, such as one that switches a beam on; none by default: "
                      "--pass-begin \"M62 P0\"",
                      program.header.pass_begin),
           textOption("pass-end", "CODE",
                      "code on a line of its own where each row ends: the beam is off on leads, between rows and while a rotary "
                      "axis unwinds; none by default: --pass-end \"M63 P0\"",
                      program.header.pass_end)}};
}
