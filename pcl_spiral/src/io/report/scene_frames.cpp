// SPDX-License-Identifier: BSD-3-Clause
#include "scene_frames.h"

#include "planning/way_times.h"
#include <pcl_spiral/core/impl/angles.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

Eigen::Vector3d
axisOf(const ToolpathPoint& point)
{
  const Eigen::Vector3d axis = point.getAxisVector3fMap().cast<double>();
  return axis.norm() > 0.5 ? axis.normalized() : point.getNormalVector3fMap().cast<double>().normalized();
}

/** From the contact with a surface of \p normal to the tip. */
Eigen::Vector3d
tipFromContact(const CutterShape& cutter, const Eigen::Vector3d& normal, const Eigen::Vector3d& axis)
{
  if (!(cutter.radius > 0.0))
    return Eigen::Vector3d::Zero();
  return CutterProfile(cutter).locate(Eigen::Vector3d::Zero(), normal, axis).tip;
}

SceneMove
moveOf(BlockSection section)
{
  return section == BlockSection::Cut ? SceneMove::Cut : section == BlockSection::Link ? SceneMove::Link : SceneMove::Air;
}

/** Time of a block without a model of the control, s. */
double
plainSeconds(const ProgramBlock& from, const ProgramBlock& block)
{
  if (block.minutes > 0.0)
    return 60.0 * block.minutes;
  constexpr double usual_rapid = 10000.0 / 60.0; // mm/s
  return (block.tip - from.tip).norm() / usual_rapid;
}

/** Of the contact where it cuts and the length of its path is known, else of the tip, mm/min. */
double
feedOf(const ProgramBlock& from, const ProgramBlock& block)
{
  if (!(block.minutes > 0.0))
    return 0.0;
  const double grown = block.arc_length - from.arc_length;
  return (block.section == BlockSection::Cut && grown > 0.0 ? grown : (block.tip - from.tip).norm()) / block.minutes;
}

/** The frame between \p a and \p b at the time of \p frame: how far its tip is from there, or as far as its axis leans, at \p arm mm. */
double
missOf(const SceneFrame& a, const SceneFrame& b, const SceneFrame& frame, double arm)
{
  const double span = b.time - a.time, share = span > 0.0 ? (frame.time - a.time) / span : 0.0;
  const double tip = (a.tip + share * (b.tip - a.tip) - frame.tip).norm();
  return std::max(tip, arm * (a.axis + share * (b.axis - a.axis) - frame.axis).norm());
}

/** The frames that remain if the moves may be \p tolerance off. */
std::vector<std::size_t>
keptFrames(const std::vector<SceneFrame>& frames, double tolerance, double arm)
{
  constexpr std::size_t longest = 64; // moves made one
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const std::size_t from = kept.back();
    const bool ends = i + 1 == frames.size() || frames[i + 1].move != frames[i].move || frames[from].move != frames[i].move ||
                      i - from >= longest || std::floor(frames[i].turn) != std::floor(frames[i + 1].turn);
    bool fits = !ends && frames[i + 1].time > frames[from].time;
    for (std::size_t k = from + 1; fits && k <= i; ++k)
      fits = missOf(frames[from], frames[i + 1], frames[k], arm) <= tolerance;
    if (!fits)
      kept.push_back(i);
  }
  return kept;
}

} // namespace

std::vector<SceneFrame>
framesOf(const ShownPath& path, const CutterShape& cutter)
{
  std::vector<SceneFrame> frames;
  frames.reserve(path.points->size());
  std::size_t pass = 0;
  for (std::size_t i = 0; i < path.points->size(); ++i) {
    const ToolpathPoint& point = (*path.points)[i];
    SceneFrame frame;
    frame.contact = point.getVector3fMap().cast<double>();
    frame.axis = axisOf(point);
    const Eigen::Vector3d normal = point.getNormalVector3fMap().cast<double>();
    frame.tip = path.tips.empty() ? Eigen::Vector3d(frame.contact + tipFromContact(cutter, normal, frame.axis)) : path.tips[i];
    frame.length = point.arc_length;
    frame.turn = point.turn;
    frame.feed = path.feeds.empty() ? path.feed : path.feeds[i];
    frame.deviation = path.deviation.empty() ? no_value : path.deviation[i];
    if (pass < path.begins.size() && path.begins[pass] == i) {
      ++pass;
      frame.move = SceneMove::Air;
    }
    const double cut = frames.empty() || frame.move == SceneMove::Air ? 0.0 : frame.length - frames.back().length;
    frame.time = (frames.empty() ? 0.0 : frames.back().time) + 60.0 * std::max(0.0, cut) / (frame.feed > 0.0 ? frame.feed : feed_if_none);
    frames.push_back(frame);
  }
  return frames;
}

ShownProgram
shownProgram(const MachineProgram& program, const MotionStudy* motion, const ShownPath& path)
{
  const std::vector<ProgramBlock>& blocks = program.blocks;
  const bool timed = motion && motion->status.ok() && motion->time.blocks.size() == blocks.size();
  ShownProgram shown{program, {}, {}, {}};
  for (std::size_t b = 0; b < blocks.size(); ++b)
    shown.ends.push_back((b > 0 ? shown.ends.back() : 0.0) + (timed   ? motion->time.blocks[b]
                                                              : b > 0 ? plainSeconds(blocks[b - 1], blocks[b])
                                                                      : 0.0));
  if (!blocks.empty())
    shown.reached = timesOnWay(*path.points, path.begins, blocks, shown.ends);
  return shown;
}

std::vector<SceneFrame>
framesOf(const ShownProgram& shown, const ShownPath& path)
{
  const std::vector<ProgramBlock>& blocks = shown.program.blocks;
  std::vector<SceneFrame> frames;
  frames.reserve(blocks.size());
  std::size_t at = 0; // of the path
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    while (at + 1 < shown.reached.size() && shown.reached[at + 1] <= shown.ends[b])
      ++at;
    const ToolpathPoint& point = (*path.points)[at];
    SceneFrame frame;
    frame.time = shown.ends[b];
    frame.tip = blocks[b].tip;
    frame.axis = blocks[b].axis;
    frame.angles = blocks[b].angles;
    frame.move = moveOf(blocks[b].section);
    frame.contact = frame.move == SceneMove::Cut ? Eigen::Vector3d(point.getVector3fMap().cast<double>()) : frame.tip;
    frame.length = point.arc_length;
    frame.turn = point.turn;
    frame.feed = feedOf(blocks[b > 0 ? b - 1 : 0], blocks[b]);
    frame.number = shown.numbers.empty() ? b + 1 : shown.numbers[b];
    frame.deviation = path.deviation.empty() || frame.move != SceneMove::Cut ? no_value : path.deviation[at];
    frames.push_back(frame);
  }
  return frames;
}

double
thinFrames(std::size_t most, std::vector<SceneFrame>& frames)
{
  if (frames.size() <= most)
    return 0.0;
  Eigen::AlignedBox3d box;
  for (const SceneFrame& frame : frames)
    box.extend(frame.tip);
  constexpr double first = 1e-5; // of the size of the path
  const double arm = 0.1 * box.diagonal().norm();
  for (double tolerance = first * box.diagonal().norm();; tolerance *= 2.0) {
    const std::vector<std::size_t> kept = keptFrames(frames, tolerance, arm);
    const bool no_fewer = tolerance > box.diagonal().norm();
    if (kept.size() > most && !no_fewer)
      continue;
    std::vector<SceneFrame> left;
    for (const std::size_t i : kept)
      left.push_back(frames[i]);
    frames = std::move(left);
    return tolerance;
  }
}

void
passPlaces(const std::vector<SceneFrame>& frames, double reach, ScenePart& part)
{
  const auto contacts = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<std::size_t> of_contact;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i].move == SceneMove::Cut) {
      const Eigen::Vector3f p = frames[i].contact.cast<float>();
      contacts->emplace_back(p.x(), p.y(), p.z());
      of_contact.push_back(i);
    }
  if (contacts->empty())
    return;
  const bool measured = std::any_of(frames.begin(), frames.end(), [](const SceneFrame& f) { return !std::isnan(f.deviation); });
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(contacts);
  pcl::Indices found(1);
  std::vector<float> squared(1);
  for (const Eigen::Vector3f& p : part.places) {
    tree.nearestKSearch(pcl::PointXYZ(p.x(), p.y(), p.z()), 1, found, squared);
    const bool passed = squared[0] <= reach * reach;
    const SceneFrame& frame = frames[of_contact[static_cast<std::size_t>(found[0])]];
    part.cut_at.push_back(passed ? static_cast<float>(frame.time) : std::numeric_limits<float>::infinity());
    if (measured)
      part.deviation.push_back(passed ? frame.deviation : no_value);
  }
}

} // namespace pcl_spiral
