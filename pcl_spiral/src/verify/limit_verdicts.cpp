// SPDX-License-Identifier: BSD-3-Clause
#include "verify/limit_verdicts.h"

#include "verify/figure_text.h"
#include "verify/verification_figures.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/tolerances.h>

namespace pcl_spiral {
namespace {

/** " at (1, 2, 3), path point 4", or ", first at ..." for a count; empty without a place. */
Diagnostic
placeOf(const Figure& figure)
{
  if (!figure.place)
    return {};
  return Diagnostic(figure.kind == FigureKind::Placed ? " at " : ", first at ", Place(figure.place->position),
                    figure.by_line ? ", line " : ", path point ", figure.place->index);
}

/** Why \p deviation's reference cannot show that a limit holds; empty if it can. */
Diagnostic
notShown(const FigureLimit& limit, const DeviationReport& deviation)
{
  const double least = leastShown(deviation);
  if (!limit.needs_proof || limit.most >= least)
    return {};
  return Diagnostic(
      "lies below ", least,
      deviation.by_mesh
          ? " {mm}, three times the distance between the mesh and the surface fitted to its samples: these cannot show that it holds; "
            "sample more closely ({setSampleSpacing})"
          : " {mm}, three times the noise of the scan's surface: this scan cannot show that it holds");
}

/** "Limits::gouge 0.01 is broken: 0.02 mm at (1, 2, 3), path point 4" */
Diagnostic
brokenText(const Figure& figure, const DeviationReport& deviation)
{
  const FigureLimit& limit = *figure.limit;
  Diagnostic text(limit.name, " ", SixDigits(limit.most), " is broken: ", SixDigits(limit.found),
                  figure.style.unit == FigureUnit::Percent ? " percent" : " {mm}", limit.where, placeOf(figure));
  if (const Diagnostic reason = notShown(limit, deviation); !reason.empty())
    text += Diagnostic("; the limit ", reason);
  return text;
}

/** Adds a reason why no limit can hold, if there are such points. */
void
addFault(Diagnostics& broken, std::size_t count, std::size_t points, const Diagnostic& what)
{
  if (count > 0)
    broken.push_back(Diagnostic("no limit can hold: ", count, " of ", points, " path points ", what));
}

} // namespace

Diagnostics
brokenLimits(const Limits& limits, const Verification& verification)
{
  Diagnostics broken;
  if (verification.program)
    broken = verification.program->faults;
  if (!limits.any())
    return broken;
  const FigureTable table = figuresOf(verification, limits);
  for (const Figure& figure : table.figures())
    if (figure.limit && !figure.limit->holds())
      broken.push_back(brokenText(figure, verification.deviation));
  addFault(broken, verification.deviation.unmeasured, verification.deviation.points, "lie off the surface and were not judged");
  for (const Diagnostic& fault : faultsOfPoses(verification))
    broken.push_back(fault);
  return broken;
}

Diagnostics
faultsOfPoses(const Verification& verification)
{
  Diagnostics faults;
  const FigureTable table = figuresOf(verification, Limits());
  const DeviationReport& d = verification.deviation;
  addFault(faults, d.opposed, d.points,
           Diagnostic("have a normal that points into the material", placeOf(table.at("deviation/opposed_normals"))));
  addFault(faults, d.inward_axes, d.points,
           Diagnostic("have a tool axis that points into the material", placeOf(table.at("deviation/inward_axes"))));
  addFault(faults, verification.tips_off, d.points,
           Diagnostic("have a tool tip that is not this cutter's, the farthest", placeOf(table.at("tip_error"))));
  return faults;
}

Diagnostics
unprovenLimits(const Limits& limits, const Verification& verification)
{
  Diagnostics unproven;
  const FigureTable table = figuresOf(verification, limits);
  for (const Figure& figure : table.figures()) {
    if (!figure.limit || figure.limit->found > figure.limit->most)
      continue;
    if (const Diagnostic reason = notShown(*figure.limit, verification.deviation); !reason.empty())
      unproven.push_back(Diagnostic(figure.limit->name, " ", SixDigits(figure.limit->most), " {mm} ", reason));
  }
  if (limits.any() && verification.deviation.in_gaps > 0)
    unproven.push_back(Diagnostic(verification.deviation.in_gaps, " path points lie in gaps of the scan: no limit is shown to hold there"));
  return unproven;
}

double
leastShown(const DeviationReport& deviation)
{
  return fit_deviations * deviation.fit_noise;
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
