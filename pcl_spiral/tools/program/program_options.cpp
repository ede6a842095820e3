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
              throw UsageError(
                  pcl_spiral::Diagnostic("--", name, " ", value, ": give mm for the tip and degrees for the axis, such as 0.01,0.1"));
            target = {numberValue(name, words[0]), pcl_spiral::degree * numberValue(name, words[1])};
          }};
}

} // namespace

OptionGroup
programOptions(ProgramJob& program)
{
  pcl_spiral::ProgramSettings& settings = program.settings;
  OptionGroup group{"Program for a machine with five or three axes (.ngc .nc .mpf .h)", {}};
  addSettings(group, settingTable(settings));
  addSettings(group, settingTable(program.header));
  addOptions(
      group,
      {textOption("machine", "FILE", "machine file in YAML: axes, limits, rates: --machine xyzac.yaml", program.machine_file),
       choiceOption("dialect",
                    "language of a .nc; a .ngc is always for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain: --dialect siemens",
                    program.dialect),
       choiceOption("robot-z",
                    "robot frames of a .yaml: at the tip with z along the tool axis, or at the contact with z along the surface's normal; "
                    "default axis: --robot-z normal",
                    program.robot_z),
       switchOption("accept-collisions",
                    "write the output even if the tool would touch the scan on its way to the path, or its shank or holder on the path",
                    program.accept_collisions),
       switchOption(
           "gains",
           "plan again to tell what twice the chord error, smoother tool axes and longer blocks would gain; takes up to three times "
           "as long",
           program.gains),
       tolerance("block-tolerance",
                 "largest distance of machine moves from the path, tip and axis; default 0.002,0.06: --block-tolerance 0.005,0.1",
                 settings.block),
       tolerance("thin-blocks",
                 "leave out blocks that change the path by less than this, tip and axis; default none: --thin-blocks 0.005,0.1",
                 settings.thinning),
       textOption("work-offset", "OFFSET",
                  "work offset in the words of the control; default G54, on Heidenhain the preset in use: --work-offset G55",
                  program.header.work_offset),
       {"smoothing", "MM",
        "tolerance of the control's own smoothing (G64 P, CYCLE832, CYCL DEF 32); default the chord error, 0: exact stop; path_tolerance "
        "of the machine file goes first: --smoothing 0.01",
        [&program](const std::string& value) { program.smoothing = numberValue("smoothing", value); }},
       textOption("pass-begin", "CODE",
                  "code on its own line at the start of each pass, such as to switch a beam on; default none: "
                  "--pass-begin \"M62 P0\"",
                  program.header.pass_begin),
       textOption("pass-end", "CODE",
                  "code on its own line at the end of each pass: the beam is off on leads, between passes and while a rotary "
                  "axis unwinds; default none: --pass-end \"M63 P0\"",
                  program.header.pass_end)});
  return group;
}
