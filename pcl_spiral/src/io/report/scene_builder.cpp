// SPDX-License-Identifier: BSD-3-Clause
#include "scene_builder.h"

#include "common/formatted_text.h"
#include <pcl_spiral/core/impl/tolerances.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_places = 60000, most_frames = 80000; // about 8 MB together

/** The stock at each new place of \p part: that of the nearest sample of the mesh. */
void
takeStock(const Heights& judged, ScenePart& part)
{
  const auto samples = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<float> stock;
  for (std::size_t i = 0; i < judged.stock.size(); ++i)
    if (!std::isnan(judged.stock[i])) {
      samples->push_back((*judged.points)[i]);
      stock.push_back(judged.stock[i]);
    }
  constexpr float no_stock = std::numeric_limits<float>::quiet_NaN();
  part.stock.resize(part.places.size(), no_stock);
  if (samples->empty())
    return;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(samples);
  pcl::Indices found(2);
  std::vector<float> squared(2);
  tree.nearestKSearch(samples->front(), 2, found, squared);
  const float reach = 4.0f * std::sqrt(squared.back());
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    const Eigen::Vector3f& p = part.places[i];
    tree.nearestKSearch(pcl::PointXYZ(p.x(), p.y(), p.z()), 1, found, squared);
    part.stock[i] = squared[0] <= reach * reach ? stock[static_cast<std::size_t>(found[0])] : no_stock;
  }
}

void
widen(const SceneScale& by, SceneScale& scale)
{
  scale.low = std::min(scale.low, by.low);
  scale.high = std::max(scale.high, by.high);
}

} // namespace

SceneBuilder::SceneBuilder(const CutterShape& cutter, const std::vector<ToolSegment>& holder)
{
  scene_.cutter = cutter;
  scene_.holder = holder;
}

void
SceneBuilder::addScan(const Surface& surface, const Heights* judged)
{
  addSurface(surface, judged && judged->stock.size() == surface.inputSize() ? judged->stock : std::vector<float>(), scene_.part);
}

void
SceneBuilder::addFaces(const SurfaceMesh& mesh, const Heights* judged)
{
  addMesh(mesh, most_places, scene_.part);
  if (judged && judged->points)
    takeStock(*judged, scene_.part);
}

void
SceneBuilder::addPath(const ShownPath& path, const std::vector<std::size_t>& lines)
{
  std::vector<SceneFrame> frames = framesOf(path, scene_.cutter);
  if (!frames.empty() && !(frames.back().feed > 0.0))
    scene_.notes = {formatted("No feed is known: the times of the scene are those at %g mm/min.", feed_if_none)};
  for (std::size_t i = 0; i < frames.size() && i < lines.size(); ++i)
    frames[i].number = lines[i];
  if (!frames.empty() && !scene_.frames.empty()) {
    const SceneFrame last = scene_.frames.back();
    frames.front().move = SceneMove::Air;
    for (SceneFrame& frame : frames) {
      frame.time += last.time;
      frame.length += last.length;
    }
  }
  scene_.frames.insert(scene_.frames.end(), frames.begin(), frames.end());
}

void
SceneBuilder::setProgram(const MachineProgram& program, const MotionStudy* motion, const ShownPath& path)
{
  scene_.frames = framesOf(program, motion, path);
  scene_.number_word = "Block";
  if (!program.machine.three_axes)
    scene_.rotary_letters = {program.machine.rotary[0].letter, program.machine.rotary[1].letter};
}

void
SceneBuilder::addFigures(const Verification& judged, double chord_error)
{
  const double known = fit_deviations * judged.deviation.fit_noise;
  const double shown = std::max(2.0 * judged.deviation.p99, known);
  widen({-shown, shown}, scene_.deviation);
  widen({-std::max(chord_error, known), judged.removal.limit}, scene_.stock);
  scene_.uncut = std::max(scene_.uncut, judged.removal.reach);
}

void
SceneBuilder::findOutward()
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [a, b, c] : scene_.part.triangles)
    sum += (scene_.part.places[b] - scene_.part.places[a]).cross(scene_.part.places[c] - scene_.part.places[a]).cast<double>();
  if (sum.norm() > 0.0)
    scene_.outward = sum.normalized();
}

void
SceneBuilder::thin()
{
  const std::size_t places = scene_.part.places.size(), frames = scene_.frames.size();
  if (const double apart = thinPart(most_places, scene_.part); apart > 0.0)
    scene_.notes.push_back(formatted("The scene shows %zu of the %zu places of the part: those within %.2g mm of each other are one, with "
                                     "the worst stock of them.",
                                     scene_.part.places.size(), places, apart));
  passPlaces(scene_.frames, scene_.cutter.radius > 0.0 ? scene_.cutter.radius : std::numeric_limits<double>::infinity(), scene_.part);
  if (const double off = thinFrames(most_frames, scene_.frames); off > 0.0)
    scene_.notes.push_back(formatted("The scene shows %zu of the %zu moves: the tips of the others are at most %.2g mm off them.",
                                     scene_.frames.size(), frames, off));
}

std::shared_ptr<const ReportScene>
SceneBuilder::build()
{
  if (!scene_.part.stock.empty())
    scene_.part.stock.resize(scene_.part.places.size(), std::numeric_limits<float>::quiet_NaN());
  findOutward();
  thin();
  return std::make_shared<const ReportScene>(std::move(scene_));
}

} // namespace pcl_spiral
