// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/stage_reports.h>

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double least_efficiency = 0.8; // below it there is a warning

} // namespace

void
reportSpacing(const ToolpathReport& path, SpiralReport& report)
{
  const bool neighbours = path.closest.distance > 0.0 && path.closest.distance <= report.largest_step_over;
  if (neighbours) {
    report.smallest_step_over = path.closest.distance;
    report.closest_place = path.closest.place;
  }
  report.reversals = path.reversals.count;
  if (path.reversals.at_corners > 0)
    report.warnings.push_back(Diagnostic(reversalText(path.reversals),
                                         ": the outline has corners as sharp; constant scallop height ({setMethod}) "
                                         "goes into them with fewer turns"));
  if (!(report.least_length > 0.0) || !(report.path_length > 0.0))
    return;
  report.efficiency = report.least_length / report.path_length;
  if (report.efficiency >= least_efficiency)
    return;
  Diagnostic warning =
      Diagnostic("the path is ", 1.0 / report.efficiency, " times as long as the least at this scallop height over the whole surface");
  if (neighbours)
    warning += Diagnostic("; turns are closest at ", Place(path.closest.place), ": ", path.closest.distance, " {mm} apart, where up to ",
                          report.largest_step_over, " {mm} are allowed");
  if (report.method != SpiralMethod::ConstantScallop)
    warning += "; constant scallop height ({setMethod}) usually makes a shorter path";
  report.warnings.push_back(warning);
}

Diagnostic
whyNotRadial(const Status& status, const SpiralTurns& turns)
{
  if (status.code() == StatusCode::Failed)
    return status.diagnostic();
  const PathReversals reversals = status.ok() ? curveReversals(turns.curve) : PathReversals();
  return reversals.count > 0 ? reversalText(reversals) : Diagnostic();
}

Status
neitherMethod(const Status& scallop, const Status& radial)
{
  const std::vector<std::string> fields = scallop.diagnostic().fields();
  const bool is_narrow = std::find(fields.begin(), fields.end(), "scan more densely") != fields.end(); // and so are pieces
  return {StatusCode::Failed,
          Diagnostic("both methods fail here, so the other one is no remedy",
                     is_narrow ? "" : ": cut the part into pieces ({PartRegion}), or scan it more densely",
                     ". At constant scallop height: ", scallop.diagnostic(), ". With radial lines: ", radial.diagnostic())};
}

} // namespace pcl_spiral
