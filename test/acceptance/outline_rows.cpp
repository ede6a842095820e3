// SPDX-License-Identifier: BSD-3-Clause
#include "outline_rows.h"

#include "support/outlines.h"
#include "support/sampling.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::acceptance {

namespace {

constexpr double gap_radius = 7.0;
constexpr double lines_ratio = 10.0; ///< distance between lines over distance along them

/** Rows with the same limit of length. */
void
addRows(double length, const std::vector<std::string>& names, std::vector<OutlineRow>& rows)
{
  for (const std::string& name : names) {
    OutlineRow row;
    row.name = row.outline = name;
    row.length = length;
    rows.push_back(row);
  }
}

/** More difficult scans of an existing outline. The share above 1.05 h follows from the limit of
 * p99.9. */
void
addHarderScans(const std::string& name, std::vector<OutlineRow>& rows)
{
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const OutlineRow& r) { return r.name == name; });
  OutlineRow row = *found;
  row.length += 0.005;
  const auto add = [&](const std::string& suffix, Scan scan, double noise, double p999, double over) {
    row.name = name + suffix;
    row.scan = scan;
    row.noise = noise;
    row.p999 = p999;
    row.over = over;
    rows.push_back(row);
  };
  add("_noise_2", Scan::Noisy, 0.2, 1.05, 0.001);
  add("_noise_4", Scan::Noisy, 0.4, 1.1, 1.0);
  add("_lines", Scan::Lines, 0.0, 1.05, 0.001);
  add("_gap", Scan::Gap, 0.0, 1.05, 0.001);
}

/** Makes a round gap in the scan round the point nearest to three gap radii from the rim. */
void
cutGap(double size, OutlineCloud& cloud)
{
  const double radius = gap_radius * size;
  const auto off = [&](const Eigen::Vector3d& x) { return std::abs(cloud.part->rimDistance(x) - 3.0 * radius); };
  const auto last = cloud.points.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2000, cloud.points.size()));
  const Eigen::Vector3d at =
      *std::min_element(cloud.points.begin(), last, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return off(a) < off(b); });
  cloud.gap = test::circle(cloud.part->chart(at), radius, 720);
  const test::Region region({cloud.gap});
  cloud.points.erase(std::remove_if(cloud.points.begin(), cloud.points.end(),
                                    [&](const Eigen::Vector3d& x) { return region.contains(cloud.part->chart(x)); }),
                     cloud.points.end());
}

} // namespace

std::vector<OutlineRow>
outlineRows()
{
  std::vector<OutlineRow> rows;
  addRows(1.015, {"disc"}, rows);
  addRows(1.025, {"square", "square_sparse", "ellipse_2"}, rows);
  rows[2].outline = "square";
  rows[2].scan = Scan::Sparse;
  addRows(1.035, {"ellipse_3", "strip_8", "kidney", "blade", "oval_saddle", "ring_off_centre", "ring", "dumbbell"}, rows);
  addRows(1.045, {"L", "cross", "star_smooth"}, rows);
  addRows(1.06, {"star_pointed", "holes_2", "holes_3", "holes_6"}, rows);
  addRows(1.075, {"U", "boomerang", "slit_disc"}, rows);
  addHarderScans("kidney", rows);
  addHarderScans("L", rows);
  return rows;
}

OutlineCloud
outlineCloud(const OutlineRow& row, const Options& options, double pitch)
{
  OutlineCloud cloud;
  cloud.part = test::outlinedPart(row.outline, options.variation, options.size);
  const double area = cloud.part->area();
  auto count = options.points > 0 ? options.points : static_cast<std::size_t>(std::clamp(area / (pitch * pitch), 8000.0, 14000.0));
  if (row.scan == Scan::Sparse)
    count = static_cast<std::size_t>(area / (9.0 * pitch * pitch));
  cloud.spacing = std::sqrt(area / static_cast<double>(count));
  test::Sampled sampled;
  if (row.scan == Scan::Lines) {
    const double along = cloud.spacing / std::sqrt(lines_ratio);
    cloud.spacing = along * lines_ratio;
    sampled = test::sampleScanLines(*cloud.part, along, cloud.spacing, options.seed);
  }
  else
    sampled = test::sampleUniform(*cloud.part, count, options.seed);
  if (row.noise > 0.0)
    test::addNoise(sampled, row.noise * options.scallop, options.seed + 1000);
  cloud.points = sampled.points;
  if (row.scan == Scan::Gap)
    cutGap(options.size, cloud);
  return cloud;
}

} // namespace pcl_spiral::acceptance
