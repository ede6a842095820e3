// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lacking_points.h"
#include "core/median.h"

#include "graph/local_shape.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

/** What of a cloud is about a place. */
struct PlaceSpacing {
  double spacing = 0.0;   ///< mm, by the distance of the eighth point; 0 of fewer
  bool is_within = false; ///< the eight points are not all on one side
};

PlaceSpacing
aboutPlace(const pcl::PointCloud<pcl::PointXYZ>& cloud, const Eigen::Vector3d& place)
{
  constexpr std::size_t few = 8;
  constexpr double one_side = 0.9; // length of the mean direction: of directions within 50 degrees of one
  std::vector<std::pair<double, std::size_t>> squared;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isFinite(cloud[i]))
      squared.emplace_back((cloud[i].getVector3fMap().cast<double>() - place).squaredNorm(), i);
  if (squared.size() < few)
    return {};
  std::nth_element(squared.begin(), squared.begin() + (few - 1), squared.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < few; ++k)
    sum += (cloud[squared[k].second].getVector3fMap().cast<double>() - place).normalized();
  return {evenSpacing(std::sqrt(squared[few - 1].first), static_cast<int>(few)), sum.norm() < one_side * static_cast<double>(few)};
}

/** The usual distance between points of \p cloud, mm: the median over some of them. */
double
usualSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  constexpr std::size_t looked_at = 32;
  std::vector<double> spacings;
  for (std::size_t k = 0; k < looked_at; ++k)
    if (const pcl::PointXYZ& p = cloud[k * cloud.size() / looked_at]; pcl::isFinite(p))
      spacings.push_back(aboutPlace(cloud, p.getVector3fMap().cast<double>()).spacing);
  return spacings.empty() ? 0.0 : medianOf(std::move(spacings));
}

/** Whether \p said has the words of a remedy that is another scan. */
bool
asksForScan(const Diagnostic& said)
{
  const std::vector<std::string> fields = said.fields();
  return std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return field == "scan it again" || field == "scan it again, more densely" || field == "scan more densely";
  });
}

} // namespace

Diagnostic
lackOf(const PlanInput& input, const Diagnostic& said)
{
  constexpr double sparse = 2.0; // times the usual spacing: at a right corner of an even scan, with a quarter of the points about
  if (!asksForScan(said) || said.places().empty() || input.mesh || !input.cloud || input.cloud->empty())
    return {};
  const Eigen::Vector3d place = said.places().front();
  const PlaceSpacing there = aboutPlace(*input.cloud, place);
  const double usual = usualSpacing(*input.cloud);
  if (!(there.spacing > sparse * usual) || !there.is_within)
    return {};
  return Diagnostic(". What the {scan} lacks is at ", Place(place), ", where its points lie ", there.spacing, " {mm} apart, ", usual,
                    " {mm} elsewhere: {scan it again, more densely}, or from another side");
}

} // namespace pcl_spiral
