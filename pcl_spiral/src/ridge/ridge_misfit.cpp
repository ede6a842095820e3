// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_misfit.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

void
findMisfit(SectionRounds& rounds, double half_width, ScanRidgeReport& report)
{
  constexpr std::uint32_t fewest = 4;     // points in a cell whose median counts
  constexpr double much = 1.5, far = 4.0; // times the noise: limit for all points, limit for one cell
  constexpr double smallest = 1e-3;       // of the half width; less does not count as a misfit on a scan without noise
  const std::vector<SectionShift> sections = rounds.unmoved();
  const Profile& profile = rounds.profile();
  double squares = 0.0;
  std::size_t worst_section = 0, worst_cell = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    squares += sections[i].squares;
    report.points += sections[i].points;
    for (std::size_t k = 0; k < sections[i].count.size(); ++k) {
      const double s = profile.line.s(k), off = std::abs(static_cast<double>(sections[i].median[k]));
      if (sections[i].count[k] < fewest || s < 0.0 || s > profile.length || off <= report.largest_misfit)
        continue;
      report.largest_misfit = off;
      worst_section = i;
      worst_cell = k;
    }
  }
  report.misfit = report.points > 0 ? std::sqrt(squares / static_cast<double>(report.points)) : 0.0;
  const double u = rounds.stationOf(worst_section);
  if (const auto frame = ridgeFrame(rounds.rail().tangent(u), rounds.chord()))
    report.largest_place = rounds.rail().position(u) + frame->turned(profile.line.position(worst_cell));
  if (report.misfit > std::max(much * report.noise, smallest * half_width) ||
      report.largest_misfit > std::max(far * report.noise, smallest * half_width))
    report.warnings.push_back(Diagnostic("the part differs from the surface that the generator sweeps by ", report.misfit,
                                         " {mm} rms, and by ", report.largest_misfit, " {mm} at ", Place(report.largest_place),
                                         "; the noise of the scan is ", report.noise,
                                         " {mm}: its profile changes shape along the ridge; make the ridge in pieces, or set a "
                                         "smaller half width ({setHalfWidth})"));
}

} // namespace pcl_spiral
