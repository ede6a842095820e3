// SPDX-License-Identifier: BSD-3-Clause
#include "stage_call.h"

namespace pcl_spiral::python {

const std::map<std::string, std::set<std::string>> stage_settings{
    {"boundary_loops", {"hole_size"}},
    {"bridge_gaps", {"boundaries", "holes", "hole_size", "gaps"}},
    {"radial_lines", {"boundaries", "center", "start", "lines", "tool_radius", "scallop", "chord_error"}},
    {"step_over_field", {"tool_radius", "scallop"}},
    {"scallop_loops", {"threads"}},
    {"link_loops", {"direction", "sense", "start", "one_way"}},
    {"boundary_points", {"neighbours"}},
    {"project", {"neighbours"}},
    {"spiral_over", {}}};

StageCall::StageCall(const std::string& name)
: keywords(name,
           stage_settings.at(name).empty() ? cutterTable(settings) + turnTable(settings)
                                           : only(settingTable(settings), stage_settings.at(name)),
           (name == "spiral_over" ? own_stage_inputs : std::vector<Input>()) + progress_input)
{}

StageCall::StageCall(const std::string& name, const py::dict& given, const Eigen::Vector3d& shift) : StageCall(name)
{
  keywords.take(given);
  ReadOptions read;
  read.origin = shift;
  words = {keywords.vocabulary(), read};
  keywords.readPlaces(read);
  run.emplace(keywords["progress"]);
}

} // namespace pcl_spiral::python
