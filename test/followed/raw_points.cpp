// SPDX-License-Identifier: BSD-3-Clause
#include "raw_points.h"

#include "support/sampling.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace pcl_spiral::followed {
namespace {

constexpr double least_allowed = 0.05; // mm: fit and chord error
constexpr double deviations = 4.0;     // of the noise
constexpr double near = 3.0;           // spacings
constexpr int fewest = 4;              // points that near, itself too: fewer are echoes

/** Centres of the ball along the path. */
std::vector<Eigen::Vector3d>
centresOf(double radius, const std::string& file)
{
  std::ifstream in(file);
  std::string line, word;
  while (std::getline(in, line) && line.rfind('#', 0) == 0)
    ;
  std::map<std::string, std::size_t> column;
  std::istringstream head(line);
  for (std::size_t i = 0; std::getline(head, word, ','); ++i)
    column[word] = i;
  std::vector<Eigen::Vector3d> centres;
  std::vector<double> values;
  while (std::getline(in, line)) {
    std::istringstream text(line);
    values.clear();
    while (std::getline(text, word, ','))
      values.push_back(std::stod(word));
    const auto vector = [&](const std::string& name) {
      return Eigen::Vector3d(values.at(column.at(name + "_x")), values.at(column.at(name + "_y")), values.at(column.at(name + "_z")));
    };
    centres.push_back(vector("cc") + radius * vector("normal"));
  }
  return centres;
}

/** The points of the scan with enough neighbours. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
withoutEchoes(const RefusedInput& input)
{
  const auto all = test::toCloud(input.points), kept = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(all);
  std::vector<int> found;
  std::vector<float> squared;
  for (const auto& p : *all)
    if (tree.nearestKSearch(p, fewest, found, squared) == fewest && squared.back() < near * near * input.spacing * input.spacing)
      kept->push_back(p);
  return kept;
}

} // namespace

std::string
faultOfPath(const RefusedInput& input, double radius, const std::string& file)
{
  const std::vector<Eigen::Vector3d> centres = centresOf(radius, file);
  if (centres.size() < 20)
    return "the path has " + std::to_string(centres.size()) + " points";
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(withoutEchoes(input));
  std::vector<int> found(1);
  std::vector<float> squared(1);
  double deepest = 0.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& c : centres) {
    tree.nearestKSearch(pcl::PointXYZ(float(c.x()), float(c.y()), float(c.z())), 1, found, squared);
    if (const double depth = radius - std::sqrt(squared[0]); depth > deepest) {
      deepest = depth;
      place = c;
    }
  }
  const double allowed = least_allowed + deviations * input.noise;
  if (deepest <= allowed)
    return "";
  std::ostringstream out;
  out << "the ball is " << deepest << " mm in the scan, where " << allowed << " mm are allowed, at " << place.transpose();
  return out.str();
}

} // namespace pcl_spiral::followed
