// SPDX-License-Identifier: BSD-3-Clause
#include "playback.h"

#include "terminal/vocabulary.h"

#include <pcl_spiral/io/machine_reader.h>

using namespace pcl_spiral;

PlaybackScene
playbackScene(const ViewJob& job, const ReferenceSurface& reference, const JudgedPath& judged, FiledPath filed)
{
  PlaybackScene scene;
  scene.cutter = job.settings.cutter;
  scene.holder = job.holder;
  scene.tips = judged.tips;
  scene.machine = job.machine_file.empty() ? xyzacTrunnion() : readMachine(job.machine_file);
  if (!filed.feed.empty() && filed.feed.front() > 0.0)
    scene.feed = filed.feed.front();
  if (filed.path.program) {
    const ProgramFileReport& figures = *judged.verification.program;
    scene.lines = figures.lines;
    scene.control = filed.path.program->control.value_or(scene.control);
    scene.program = std::move(filed.path.program);
    if (figures.leads.collided > 0)
      scene.stops.push_back({inWords(figures.faults.back()), 0, figures.leads.deepest.block});
  }
  constexpr std::size_t most_places = 250000; // more than a window has pixels to show
  scene.left = stockMesh(reference, judged.heights.stock, most_places);
  return scene;
}
