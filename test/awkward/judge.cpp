// SPDX-License-Identifier: BSD-3-Clause
#include "judge.h"

#include "support/move_tree.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace pcl_spiral::awkward {
namespace {

constexpr std::size_t samples = 20000; // of the part, in a round
constexpr std::size_t fewest_counted = samples / 50;
constexpr std::uint64_t most_rounds = 5; // a keep-out may leave little of a small part
constexpr double most_uncut = 1e-3;      // share of the samples

struct PathRow {
  Eigen::Vector3d contact, normal;
};

/** The rows of a path in CSV, in the frame of the part. */
std::vector<PathRow>
readRows(const Scene& scene, const std::string& file)
{
  std::ifstream in(file);
  std::string line, word;
  std::map<std::string, std::size_t> column;
  while (std::getline(in, line) && line.rfind('#', 0) == 0)
    ;
  std::istringstream head(line);
  for (std::size_t i = 0; std::getline(head, word, ','); ++i)
    column[word] = i;
  std::vector<PathRow> rows;
  const Eigen::Isometry3d back = scene.motion.inverse();
  std::vector<double> values;
  while (std::getline(in, line)) {
    std::istringstream text(line);
    values.clear();
    while (std::getline(text, word, ','))
      values.push_back(std::stod(word));
    const auto vector = [&](const std::string& name) {
      return Eigen::Vector3d(values.at(column.at(name + "_x")), values.at(column.at(name + "_y")), values.at(column.at(name + "_z")));
    };
    rows.push_back({back * vector("cc"), back.linear() * vector("normal")});
  }
  return rows;
}

std::string
text(const std::string& what, double value, const Eigen::Vector3d& x)
{
  std::ostringstream out;
  out << what << ' ' << value << " at (" << x.transpose() << ") of the part";
  return out.str();
}

/** Keeps the worst value and its place. */
struct Worst {
  double value = -1e300;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  void add(double v, const Eigen::Vector3d& x)
  {
    if (v > value) {
      value = v;
      place = x;
    }
  }
};

/** The ball's centres, a tree for each run without long moves. */
std::vector<test::MoveTree>
cuts(const std::vector<Eigen::Vector3d>& centres, double longest)
{
  std::vector<test::MoveTree> trees;
  std::vector<Eigen::Vector3d> run;
  for (const Eigen::Vector3d& c : centres) {
    if (!run.empty() && (c - run.back()).norm() > longest) {
      if (run.size() > 1)
        trees.emplace_back(run);
      run.clear();
    }
    run.push_back(c);
  }
  if (run.size() > 1)
    trees.emplace_back(run);
  return trees;
}

void
judgePlaces(const Scene& s, const std::vector<PathRow>& rows, double tolerance, std::vector<std::string>& faults)
{
  Worst wrong_side, gouge, off;
  for (const PathRow& row : rows) {
    const Eigen::Vector3d foot = s.part->closest(row.contact);
    wrong_side.add(-row.normal.dot(s.part->normal(foot)), row.contact);
    gouge.add(s.radius - s.part->signedDistance(row.contact + s.radius * row.normal), row.contact);
    if (!s.part->contains(foot))
      off.add(s.part->rimDistance(foot), row.contact);
  }
  if (wrong_side.value > -0.7)
    faults.push_back(text("cosine with the exact normal", -wrong_side.value, wrong_side.place));
  if (gouge.value > tolerance)
    faults.push_back(text("gouge", gouge.value, gouge.place));
  if (off.value > 3.0 * s.spacing)
    faults.push_back(text("beyond the rim by", off.value, off.place));
}

/** The deepest of \p points in the ball at the \p centres, with the centre. */
Worst
deepest(const Scene& s, const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& centres)
{
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(test::toCloud(points));
  std::vector<int> found(1);
  std::vector<float> squared(1);
  Worst entered;
  for (const Eigen::Vector3d& c : centres) {
    tree.nearestKSearch(pcl::PointXYZ(float(c.x()), float(c.y()), float(c.z())), 1, found, squared);
    entered.add(s.radius - std::sqrt(squared[0]), c);
  }
  return entered;
}

/** Samples find the far side of a valley, where the search for the nearest place on the surface may stay on the near side. */
void
judgeBodies(const Scene& s, const std::vector<Eigen::Vector3d>& centres, double tolerance, std::vector<std::string>& faults)
{
  const Worst gouge = deepest(s, test::sampleUniform(*s.part, 10 * samples, 98).points, centres);
  if (gouge.value > tolerance)
    faults.push_back(text("gouge of samples", gouge.value, gouge.place));
  if (s.bodies.empty())
    return;
  const Worst entered = deepest(s, s.bodies, centres);
  if (entered.value > tolerance)
    faults.push_back(text("the ball enters a body by", entered.value, entered.place));
}

void
judgeCover(const Scene& s, const std::vector<Eigen::Vector3d>& centres, double tolerance, bool kept_out, std::vector<std::string>& faults)
{
  const std::vector<test::MoveTree> trees = cuts(centres, 1.5 * s.radius);
  const double most = 2.0 * s.scallop + tolerance, band = 2.0 * s.spacing + std::sqrt(2.0 * s.radius * s.scallop);
  std::size_t counted = 0, uncut = 0;
  Worst left;
  for (std::uint64_t round = 0; counted < fewest_counted && round < most_rounds; ++round)
    for (const Eigen::Vector3d& x : test::sampleUniform(*s.part, samples, 99 + round).points) {
      if (s.exempt(x) || (kept_out && s.exempt_kept_out(x)) || s.part->rimDistance(x) < band)
        continue;
      double nearest = 1e300;
      for (const test::MoveTree& tree : trees)
        nearest = std::min(nearest, tree.nearest(x).first);
      ++counted;
      uncut += nearest - s.radius > most;
      left.add(nearest - s.radius, x);
    }
  if (counted < fewest_counted && !kept_out) // a keep-out may leave nothing but a band along rims
    faults.push_back("the oracle counts too few places of the part: " + std::to_string(counted));
  if (static_cast<double>(uncut) > most_uncut * static_cast<double>(counted))
    faults.push_back(
        text(std::to_string(uncut) + " of " + std::to_string(counted) + " places are not cut, stock left", left.value, left.place));
}

} // namespace

std::vector<std::string>
faultsOf(const Scene& scene, const std::string& file, bool kept_out)
{
  const std::vector<PathRow> rows = readRows(scene, file);
  if (rows.size() < 100)
    return {"only " + std::to_string(rows.size()) + " rows"};
  std::vector<Eigen::Vector3d> centres;
  for (const PathRow& row : rows)
    centres.push_back(row.contact + scene.radius * row.normal);
  std::vector<std::string> faults;
  const double tolerance = 0.05 + 4.0 * scene.noise;
  judgePlaces(scene, rows, tolerance, faults);
  judgeBodies(scene, centres, tolerance, faults);
  judgeCover(scene, centres, tolerance, kept_out, faults);
  return faults;
}

} // namespace pcl_spiral::awkward
