// SPDX-License-Identifier: BSD-3-Clause
// Shows a toolpath on its scan or mesh in a window.
#include "judging/judged_scan.h"
#include "judging/judged_scene.h"
#include "terminal/failure.h"
#include "terminal/program_main.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"
#include "view/playback.h"
#include "view/view_job.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/spiral_viewer.h>

#include <pcl/console/print.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

using namespace pcl_spiral;

namespace {

void
requireWindow()
{
  const std::string fault = displayFault();
  if (!fault.empty())
    throw std::runtime_error("a window needs a display and " + fault +
                             "; run this on a computer with a screen or in a VNC session, or make pictures instead: "
                             "'xvfb-run -a pcl_spiral_verify SCAN PATH --tool-radius R -o verified.png'");
}

/** What the window shows. */
struct ShownPath {
  VerificationScene scene;
  std::optional<PlaybackScene> playback; ///< absent: no path, or no cutter
};

/** Reads the scan or mesh, and chooses its part. */
JudgedScan
readShown(const ViewJob& job, PathJudge& judge)
{
  JudgedScan scan = readJudged(job);
  require(job.scan, judge.prepare(scan.input, 0.0));
  Diagnostics warnings = scan.warnings;
  const Diagnostics& of_choice = judge.parts().front().chosen.warnings;
  warnings.insert(warnings.end(), of_choice.begin(), of_choice.end());
  if (!job.quiet)
    for (const Diagnostic& warning : warnings)
      std::cerr << "pcl_spiral_view: warning: " << inWords(warning) << '\n';
  return scan;
}

/** A scan without a path. */
VerificationScene
scanScene(const ViewJob& job)
{
  VerificationScene scene;
  PathJudge judge;
  readShown(job, judge);
  scene.part.title = titleWithShift(std::filesystem::path(job.scan).filename().string());
  scene.part.cloud = judge.parts().front().cloud;
  scene.part.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  return scene;
}

/** A path, judged. */
ShownPath
shownPath(const ViewJob& job)
{
  PathJudge judge;
  const JudgedScan scan = readShown(job, judge);
  FiledPath filed = readFiledPath(job.path, job);
  if (!filed.path.program && !filed.path.has_contacts)
    throw FileError(job.path, "holds tips and axes without contacts: write contacts with 'pcl_spiral_verify SCAN PATH --tool-radius R -o "
                              "PATH.vtp' and show that file");
  JudgedPath judged;
  judged.verification.path = job.path;
  ProgressBar bar(job.quiet);
  judge.setProgress([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  require(job.path, judge.judge(filed.path, 0, judged));
  const JudgedPart& part = judge.parts().front();
  ShownPath shown{judgedScene(part.cloud, judged.path, scan.input.settings, *part.reference, judged.verification, judged.heights), {}};
  if (job.settings.cutter.radius > 0.0)
    shown.playback = playbackScene(job, *part.reference, judged, std::move(filed));
  return shown;
}

/** The option that chooses this part; it is printed, too. */
std::string
optionOf(const PartSelection& part)
{
  const std::string text = part.place.empty() ? "wrote " + part.file + ", with " + std::to_string(part.points) +
                                                    " points inside, for --crop, --region or --keep-out"
                                              : "--part-at " + part.place;
  std::cout << text << std::endl;
  return text;
}

void
run(const ViewJob& job)
{
  requireWindow();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  ShownPath shown = job.path.empty() ? ShownPath{scanScene(job), {}} : shownPath(job);
  SpiralViewer viewer(std::move(shown.scene));
  if (shown.playback)
    viewer.setPlayback(std::move(*shown.playback));
  viewer.setFileCoordinates([&job](const Eigen::Vector3d& place) { return placeInFile(place, job.read); });
  viewer.setChoiceCallback(optionOf);
  viewer.setRemedy("Start again with the cutter's radius, such as --tool-radius 10 --scallop 0.05");
  viewer.setPictureStem(std::filesystem::path(job.path.empty() ? job.scan : job.path).stem().string() + "_view");
  viewer.setCloseRequest(cancelled);
  viewer.run();
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("pcl_spiral_view", argv, [&] {
    const ViewJob job = parseViewCommandLine(argc, argv);
    if (job.help)
      printViewHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_view " PCL_SPIRAL_VERSION "\n";
    else
      run(job);
    return 0;
  });
}
