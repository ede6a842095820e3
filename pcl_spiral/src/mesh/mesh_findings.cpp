// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_findings.h"

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {

std::vector<std::pair<const char*, MeshFinding>>
mendedFindings(const MeshReport& counts)
{
  return {{"vertices welded", counts.welded},
          {"faces without area left out", counts.without_area},
          {"repeated faces left out", counts.repeated},
          {"faces turned", counts.turned},
          {"edges of more than two faces cut open", counts.crowded_edges},
          {"edges of a one-sided surface cut open", counts.one_sided_edges}};
}

Diagnostic
findingsText(const MeshReport& counts)
{
  Diagnostic all;
  const auto add = [&all](const Diagnostic& words) { all += Diagnostic(all.empty() ? "" : ", ", words); };
  for (const auto& [words, finding] : mendedFindings(counts))
    if (finding.count > 0)
      add(Diagnostic(finding.count, " ", words, " (first at ", Place(finding.place), ")"));
  if (counts.parts > 1)
    add(Diagnostic(counts.parts, " separate parts"));
  return all;
}

} // namespace pcl_spiral
