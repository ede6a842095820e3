// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/surface_settings.h>

#include "choice_words.h"
#include <pcl_spiral/common/impl/thread_limit.h>

#include <limits>

namespace pcl_spiral {

std::vector<Setting>
settingTable(SurfaceSettings& s)
{
  return {
      Setting("view_point", "setViewPoint", "view point", "position of the scanner, in the scan's coordinates, mm; normals point to it",
              "0,0,3000", s.view_point)
          .zeroFor("the sensor in the file, else +z"),
      Setting("flip_normals", "setFlipNormals", "turned normals", "the cutter is on the other side of the scan or mesh", "",
              s.flip_normals),
      Setting("trust_normals", "setTrustNormals", "trust in normals", "refuse a scan whose normals have no common side", "",
              s.trust_normals)
          .onlyInCode(),
      Setting("largest", "setLargestPart", "largest part alone", "of several separate parts keep only the largest", "", s.largest_part),
      Setting("part_at", "setPartAt", "place of the part", "of several separate parts keep the one nearest to this place", "120,80,15",
              s.part_at)
          .writtenBy("part-at"),
      Setting(
          "clusters", "setClusterHandling", "clusters",
          "two or more points near each other that stand off the surface: refuse the scan, leave them out as outliers, or ride over them "
          "as things that stand on the part",
          "ride", s.clusters)
          .writtenBy("clusters"),
      Setting("thin", "setThinning", "thinning edge", "keep one point per cube of this edge, mm", "2", s.thinning)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("no thinning"),
      Setting("outlier_neighbours", "setOutlierRemoval", "number of neighbours of the outlier filter",
              "leave out points whose mean distance to so many neighbours is unusual", "16", s.outlier_neighbours)
          .in("", NumberRange::from(0.0))
          .zeroFor("no filter")
          .writtenBy("outliers"),
      Setting("outlier_deviations", "setOutlierRemoval", "threshold of the outlier filter",
              "unusual: more than so many standard deviations above the mean", "2", s.outlier_deviations)
          .in("", NumberRange::above(0.0))
          .writtenBy("outliers"),
      Setting("neighbours", "setKSearch", "number of neighbours", "neighbours of a point to start with", "48", s.neighbours)
          .in("", NumberRange::from(8.0))
          .onlyInCode(),
      Setting("alpha", "setAlpha", "largest empty circle", "radius of the largest circle without points that is still surface", "4",
              s.alpha)
          .in("spacings", NumberRange::from(1.0).upTo(std::numeric_limits<double>::infinity()))
          .onlyInCode(),
      threadsSetting(s.threads).writtenBy("threads"),
  };
}

Diagnostic
disagreement(SurfaceSettings asked, SurfaceSettings made)
{
  SurfaceSettings unset;
  asked.threads = made.threads = unset.threads;
  asked.trust_normals = made.trust_normals = unset.trust_normals;
  if (asked.outlier_neighbours == 0)
    asked.outlier_deviations = unset.outlier_deviations;
  const std::vector<Setting> a = settingTable(asked), b = settingTable(made), u = settingTable(unset);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (textOf(a[i]) != textOf(u[i]) && textOf(a[i]) != textOf(b[i]))
      return {("{" + a[i].setter + "}").c_str()};
  return {};
}

} // namespace pcl_spiral
