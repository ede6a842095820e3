// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/raw_scan.h>

#include "quantile.h"

#include "search/neighbour_search.h"
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double sigma_of_median = 1.4826; // of normally distributed values
constexpr double plain_fit_share = 1e-3;   // of the spacing: fits to points without noise are off by 2e-6 to 1.3e-4 on five parts

/** For each of \p points, in the order of their blocks, the mean of the \p offsets of its nearest ones. */
std::vector<double>
meansOf(const PointBlocks& points, const std::vector<double>& offsets)
{
  std::vector<double> means(points.size());
#pragma omp parallel
  {
    NeighbourSearch search(points, RawScanReport::mean_of);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < static_cast<std::int64_t>(points.blockCount()); ++b) {
      search.setRun(points.blockBox(static_cast<std::size_t>(b)));
      for (std::size_t i = points.blockBegin(static_cast<std::size_t>(b)); i < points.blockEnd(static_cast<std::size_t>(b)); ++i) {
        const Neighbourhood& near = search.find(points.position(i));
        double sum = 0.0;
        for (int k = 0; k < near.size; ++k)
          sum += offsets[points.originalIndex(near.index[k])];
        means[i] = sum / near.size;
      }
    }
  }
  return means;
}

void
raiseTo(PlacedValue& largest, double value, const Vector3d& place, std::size_t index)
{
  if (value > largest.value)
    largest = {value, place, index};
}

} // namespace

RawScanReport
compareWithRaw(const Surface& smoothed, const std::vector<Eigen::Vector3f>& raw)
{
  std::vector<Vector3d> queries;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < raw.size(); ++i)
    if (raw[i].allFinite()) {
      queries.push_back(raw[i].cast<double>());
      index.push_back(i);
    }
  std::vector<SurfaceFoot> feet;
  smoothed.fit().project(queries, feet);
  RawScanReport f;
  std::vector<Eigen::Vector3f> places;
  std::vector<std::size_t> kept;
  std::vector<double> offsets;
  std::vector<float> amounts;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (!feet[i].valid || feet[i].overhang > 0.0) {
      f.beside += !feet[i].valid;
      f.others.push_back(queries[i].cast<float>());
      continue;
    }
    offsets.push_back((queries[i] - feet[i].position).dot(feet[i].normal));
    amounts.push_back(static_cast<float>(std::abs(offsets.back())));
    places.push_back(queries[i].cast<float>());
    kept.push_back(i);
    raiseTo(f.largest, amounts.back(), queries[i], index[i]);
  }
  f.points = places.size();
  if (f.points == 0)
    return f;
  f.p99 = quantile(amounts, 0.99);
  f.fit_error = plain_fit_share * smoothed.spacing() + 4.0 * smoothed.fit().fitNoise();
  const PointBlocks blocks(std::move(places));
  const std::vector<double> means = meansOf(blocks, offsets);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    amounts[i] = static_cast<float>(std::abs(offsets[blocks.originalIndex(i)] - means[i]));
  f.noise = sigma_of_median * quantile(amounts, 0.5);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t at = kept[blocks.originalIndex(i)];
    const Vector3d place = feet[at].position + means[i] * feet[at].normal;
    f.means.push_back(place.cast<float>());
    raiseTo(f.mean, std::abs(means[i]), place, index[at]);
  }
  return f;
}

Diagnostic
smoothingText(const RawScanReport& f, const std::string& name)
{
  if (f.points == 0)
    return Diagnostic("no point of the raw scan ", name, " has the smoothed surface near it: is it another part, or another unit?");
  Diagnostic text = Diagnostic("smoothing moved 1 % of the points of ", name, " by more than ", f.p99, " {mm}, the farthest by ",
                               f.largest.value, " {mm} at ", Place(f.largest.position));
  if (f.mean.value > f.leastMean())
    text += Diagnostic("; the mean of ", RawScanReport::mean_of, " neighbouring points by up to ", f.mean.value, " {mm} at ",
                       Place(f.mean.position), ", which is not noise: the shape was changed there; smooth with a smaller radius");
  if (f.beside > 0)
    text += Diagnostic("; ", f.beside, f.beside == 1 ? " point has" : " points have", " no smoothed surface near");
  return text;
}

} // namespace pcl_spiral
