// SPDX-License-Identifier: BSD-3-Clause
#include "count_warnings.h"

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {

Diagnostics
countWarnings(const SurfaceReport& counts, double spacing)
{
  Diagnostics warnings;
  if (counts.surplus > 0)
    warnings.push_back(Diagnostic(counts.surplus,
                                  " surplus points were left out: they lie much closer to each other than to the next scan line, or than "
                                  "points in the sparser part beside them; the path follows the others, ",
                                  spacing, " {mm} apart"));
  if (const std::size_t off = counts.offSurface(); off > 0) {
    Diagnostic message = Diagnostic(off, off == 1 ? " outlier was" : " outliers were", " left out: ");
    if (counts.isolated > 0)
      message += Diagnostic(counts.isolated, " isolated");
    if (counts.clustered > 0)
      message += Diagnostic(counts.isolated > 0 ? ", " : "", counts.clustered, " in clusters apart from the surface");
    warnings.push_back(message);
  }
  return warnings;
}

} // namespace pcl_spiral
