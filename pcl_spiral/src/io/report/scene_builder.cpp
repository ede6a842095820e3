// SPDX-License-Identifier: BSD-3-Clause
#include "scene_builder.h"
#include "scene_stock.h"

#include "common/formatted_text.h"
#include "planning/playback.h"
#include "verify/least_gouge.h"
#include <pcl_spiral/core/impl/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_places = 60000, most_frames = 80000; // about 8 MB together
constexpr const char* feed_of_program = "Feed of the tip";      // its text has no contacts

void
widen(const SceneScale& by, SceneScale& scale)
{
  scale.low = std::min(scale.low, by.low);
  scale.high = std::max(scale.high, by.high);
}

/** Whether the turns of \p path are numbers of passes: they are whole but where passes are linked. */
bool
countsPasses(const pcl::PointCloud<ToolpathPoint>& path)
{
  std::size_t whole = 0, later = 0;
  for (const ToolpathPoint& point : path) {
    whole += point.turn == std::floor(point.turn);
    later += point.turn >= 1.0f;
  }
  return later > 0 && 2 * whole > path.size();
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
SceneBuilder::takeTurns(const pcl::PointCloud<ToolpathPoint>& path)
{
  if (countsPasses(path))
    setTurnWord("Pass");
}

void
SceneBuilder::addPath(const ShownPath& path, const std::vector<std::size_t>& lines)
{
  takeTurns(*path.points);
  if (!lines.empty())
    scene_.feed_word = feed_of_program;
  std::vector<SceneFrame> frames = framesOf(path, scene_.cutter);
  if (!frames.empty() && !(frames.back().feed > 0.0))
    scene_.notes = {formatted("No feed is known: the times of the scene are those at %g mm/min.", feed_if_none)};
  for (std::size_t i = 0; i < frames.size() && i < lines.size(); ++i)
    frames[i].number = lines[i];
  const SceneFrame last = scene_.frames.empty() ? SceneFrame() : scene_.frames.back();
  for (SceneFrame& frame : frames) {
    frame.time += last.time;
    frame.length += last.length;
    reached_.push_back(frame.time);
  }
  for (ToolpathPoint point : *path.points) {
    point.arc_length += last.length;
    path_->push_back(point);
  }
  tips_.insert(tips_.end(), path.tips.begin(), path.tips.end());
  if (!frames.empty() && !scene_.frames.empty())
    frames.front().move = SceneMove::Air;
  scene_.frames.insert(scene_.frames.end(), frames.begin(), frames.end());
}

void
SceneBuilder::setProgram(const ShownProgram& program, const ShownPath& path)
{
  takeTurns(*path.points);
  scene_.frames = framesOf(program, path);
  *path_ = *path.points;
  tips_ = path.tips;
  reached_ = program.reached;
  const Machine& machine = program.program.machine;
  scene_.number_word = program.numbers.empty() ? "Block" : "Line";
  if (!machine.three_axes)
    scene_.rotary_letters = {machine.rotary[0].letter, machine.rotary[1].letter};
}

void
SceneBuilder::addProgram(const ProgramFile& program, const ProgramFileReport& judged, const ShownPath& path)
{
  PlaybackInput input;
  input.path = path.points;
  input.tips = path.tips;
  input.cutter = scene_.cutter;
  input.lines = judged.lines;
  input.program = program;
  if (judged.motion)
    input.control = judged.motion->control;
  PlaybackTime time;
  if (!judged.motion || !judged.motion->status.ok() || !playbackTime(input, time).ok())
    return addPath(path, judged.lines);
  setProgram({time.track.program(), time.track.ends(), time.reached, time.lines}, path);
  scene_.feed_word = feed_of_program;
}

void
SceneBuilder::addFigures(const Verification& judged, double chord_error)
{
  const double known = fit_deviations * judged.deviation.fit_noise;
  const double shown = std::max(2.0 * judged.deviation.p99, known);
  widen({-shown, shown}, scene_.deviation);
  widen({-leastGouge(chord_error, judged.deviation.fit_noise), judged.removal.limit}, scene_.stock);
  judged_.limit = std::max(judged_.limit, judged.removal.limit);
  judged_.reach = std::max(judged_.reach, judged.removal.reach);
  scene_.uncut = judged_.reach;
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
  if (reached_.size() == path_->size())
    findFalls(path_, tips_, scene_.cutter, judged_, reached_, scene_.part);
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
