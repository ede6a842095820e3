// SPDX-License-Identifier: BSD-3-Clause
#include "verify/limit_verdicts.h"

#include "verify/figure_text.h"
#include "verify/verification_figures.h"
#include <pcl_spiral/common/impl/message.h>

#include <iomanip>
#include <sstream>

namespace pcl_spiral {
namespace {

/** Why \p deviation's reference cannot show that a limit holds; empty if it can. */
std::string
notShown(const FigureLimit& limit, const DeviationFigures& deviation)
{
  const double least = leastShown(deviation);
  if (!limit.needs_proof || limit.most >= least)
    return {};
  std::ostringstream text;
  text << "lies below " << std::setprecision(2) << least
       << (deviation.by_mesh
               ? " mm, three times the distance between the mesh and the surface fitted to its samples: these cannot show that it holds; "
                 "sample more closely (setSampleSpacing)"
               : " mm, three times the noise of the scan's surface: this scan cannot show that it holds");
  return text.str();
}

/** "Limits::gouge 0.01 is broken: 0.02 mm at (1, 2, 3), path point 4" */
std::string
brokenText(const Figure& figure, const DeviationFigures& deviation)
{
  const FigureLimit& limit = *figure.limit;
  std::ostringstream text;
  text << limit.name << " " << limit.most << " is broken: " << limit.found
       << (figure.style.unit == FigureUnit::Percent ? " percent" : " mm") << limit.where << placeSuffix(figure);
  if (const std::string reason = notShown(limit, deviation); !reason.empty())
    text << "; the limit " << reason;
  return text.str();
}

/** Adds a reason why no limit can hold, if there are such points. */
void
addFault(std::vector<std::string>& broken, std::size_t count, std::size_t points, const std::string& what)
{
  if (count > 0)
    broken.push_back("no limit can hold: " + std::to_string(count) + " of " + std::to_string(points) + " path points " + what);
}

} // namespace

std::vector<std::string>
brokenLimits(const Limits& limits, const Verification& verification)
{
  std::vector<std::string> broken;
  if (verification.program)
    broken = verification.program->faults;
  if (!limits.any())
    return broken;
  const FigureTable table = figuresOf(verification, limits);
  for (const Figure& figure : table.figures())
    if (figure.limit && !figure.limit->holds())
      broken.push_back(brokenText(figure, verification.deviation));
  addFault(broken, verification.deviation.unmeasured, verification.deviation.points, "lie off the surface and were not judged");
  for (const std::string& fault : faultsOfPoses(verification))
    broken.push_back(fault);
  return broken;
}

std::vector<std::string>
faultsOfPoses(const Verification& verification)
{
  std::vector<std::string> faults;
  const FigureTable table = figuresOf(verification, Limits());
  const DeviationFigures& d = verification.deviation;
  addFault(faults, d.opposed, d.points, "have a normal that points into the material" + placeSuffix(table.at("deviation/opposed_normals")));
  addFault(faults, d.inward_axes, d.points,
           "have a tool axis that points into the material" + placeSuffix(table.at("deviation/inward_axes")));
  addFault(faults, verification.tips_off, d.points,
           "have a tool tip that is not this cutter's, the farthest" + placeSuffix(table.at("tip_error")));
  return faults;
}

std::vector<std::string>
unprovenLimits(const Limits& limits, const Verification& verification)
{
  std::vector<std::string> unproven;
  const FigureTable table = figuresOf(verification, limits);
  for (const Figure& figure : table.figures()) {
    if (!figure.limit || figure.limit->found > figure.limit->most)
      continue;
    if (const std::string reason = notShown(*figure.limit, verification.deviation); !reason.empty())
      unproven.push_back(textOf(figure.limit->name, " ", figure.limit->most, " mm ", reason));
  }
  if (limits.any() && verification.deviation.in_gaps > 0)
    unproven.push_back(std::to_string(verification.deviation.in_gaps) +
                       " path points lie in gaps of the scan: no limit is shown to hold there");
  return unproven;
}

double
leastShown(const DeviationFigures& deviation)
{
  return 3.0 * deviation.fit_noise;
}

Verdict
verdictOf(const Limits& limits, const Verification& verification)
{
  return !verification.broken.empty()     ? Verdict::Broken
         : !verification.unproven.empty() ? Verdict::Unproven
         : limits.any()                   ? Verdict::Kept
                                          : Verdict::NoLimits;
}

} // namespace pcl_spiral
