#include "program_options.h"
#include "terminal/option_values.h"

using pcl_spiral::ProgramSettings;

namespace {

constexpr double radians = 3.14159265358979323846 / 180.0;

Option
length(const std::string& name, const std::string& argument, const std::string& help,
       double ProgramSettings::*member)
{
  return {name, argument, help, [name, member](Job& job, const std::string& value) {
            job.program.settings.*member = numberValue(name, value);
          }};
}

/** An option for a tolerance of tip and axis: 0.01,0.1 */
Option
tolerance(const std::string& name, const std::string& help,
          pcl_spiral::BlockTolerance ProgramSettings::*member)
{
  return {
      name, "MM,DEG", help, [name, member](Job& job, const std::string& value) {
        const std::vector<std::string> words = listValue(value);
        if (words.size() != 2)
          throw UsageError("--" + name + " " + value +
                           ": mm of the tip and degrees of the axis are needed, such as 0.01,0.1");
        job.program.settings.*member = {numberValue(name, words[0]), radians * numberValue(name, words[1])};
      }};
}

} // namespace

OptionGroup
programOptions()
{
  using pcl_spiral::Dialect;
  using pcl_spiral::LeadKind;
  return {
      "Program of a five-axis machine (.ngc .nc)",
      {{"machine", "FILE", "machine file in YAML: axes, limits, rates: --machine xyzac.yaml",
        [](Job& job, const std::string& value) { job.program.machine_file = value; }},
       {"dialect", pcl_spiral::choiceList<Dialect>(),
        "language of a .nc; .ngc is LinuxCNC's: --dialect siemens",
        [](Job& job, const std::string& value) {
          job.program.dialect = choiceValue<Dialect>("dialect", value);
        }},
       {"lead-in", pcl_spiral::choiceList<LeadKind>(),
        "how the tool comes to the path and leaves it; normal: --lead-in arc",
        [](Job& job, const std::string& value) {
          job.program.settings.lead = choiceValue<LeadKind>("lead-in", value);
        }},
       length("lead-length", "L", "length of the lead, or radius of the arc; 2: --lead-length 5",
              &ProgramSettings::lead_length),
       length("clearance", "L", "the feed begins so far along the tool axis off the lead; 5: --clearance 3",
              &ProgramSettings::clearance),
       length("rapid-height", "L", "rapids cross so far above the highest tip; 50: --rapid-height 100",
              &ProgramSettings::rapid_height),
       length("pole-cone", "A",
              "axes are blended within this angle of the rotary axis's own direction, where it would turn "
              "too fast; 5: "
              "--pole-cone 2",
              &ProgramSettings::pole_cone),
       tolerance("block-tolerance",
                 "moves of the machine stay this near the path, tip and axis; 0.002,0.06: --block-tolerance "
                 "0.005,0.1",
                 &ProgramSettings::block),
       tolerance("thin-blocks",
                 "leave out blocks within this of tip and axis; none by default: --thin-blocks 0.005,0.1",
                 &ProgramSettings::thinning),
       {"spindle", "S", "rev/min; the spindle is left alone by default: --spindle 12000",
        [](Job& job, const std::string& value) {
          job.program.header.spindle_speed = numberValue("spindle", value);
        }},
       {"tool", "N", "tool that is called; none by default: --tool 3",
        [](Job& job, const std::string& value) {
          job.program.header.tool = wholeNumberValue("tool", value);
        }},
       {"decimals", "N", "of mm and degrees in programs, 3 to 6; 4: --decimals 3",
        [](Job& job, const std::string& value) {
          job.program.header.decimals = wholeNumberValue("decimals", value);
        }}}};
}
