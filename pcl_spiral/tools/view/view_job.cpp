// SPDX-License-Identifier: BSD-3-Clause
#include "view_job.h"

#include "terminal/command_line.h"
#include "terminal/vocabulary.h"

namespace {

OptionTable
optionTable(ViewJob& job)
{
  return {
      judgedFiles(job, "the scan, or with --mesh the mesh, then the path: .csv .pcd .ply .vtp; a scan alone, to choose the part"),
      judgedCutter(job, "radius at the upper end of the flank; without it the stock map and the histogram stay empty: --tool-radius 10"),
      runOptions(job, job.settings.threads)};
}

void
complete(ViewJob& job)
{
  completeJudging(job);
  require(job.files.size() == 1 || job.files.size() == 2,
          pcl_spiral::Diagnostic(job.files.size(), " files are given; give a scan, such as part.pcd, or the scan, or with --mesh the mesh, "
                                                   "and then one path, such as part.pcd part.csv"));
  job.scan = job.files.front();
  job.path = job.files.size() > 1 ? job.files.back() : "";
  require(!job.mesh || !job.path.empty(), "a mesh is shown with a path; give one, such as part.stl part.csv");
  require(!job.regions.several(), "--part-at and --region: the window shows one region; give one of them");
  require(!job.path.empty() || (job.regions.places.empty() && !isGiven(job, "tool-radius")),
          "--part-at and --tool-radius belong to a path; give one, such as part.pcd part.csv, or leave them out");
}

} // namespace

ViewJob
parseViewCommandLine(int argc, const char* const* argv)
{
  return parseJob<ViewJob>(argc, argv, optionTable, complete, {"file"});
}

std::vector<std::string>
ownOptions()
{
  ViewJob job;
  return namesOf(optionTable(job));
}

void
printViewHelp(std::ostream& out)
{
  ViewJob job;
  out << "Shows a toolpath on its scan or mesh: boundaries, path, deviation map, stock map, scallop histogram.\n\n"
         "  pcl_spiral_view PART PATH [options]\n"
         "  pcl_spiral_view SCAN [options]\n\n"
         "  pcl_spiral_view scan.pcd\n"
         "  pcl_spiral_view part.pcd part.csv --tool-radius 10 --scallop 0.05\n"
         "  pcl_spiral_view part.stl part.csv --mesh --tool-radius 10\n\n"
         "The window lists its keys. a prints the --part-at of the scanned point at the mouse, z looks along z, l and a drag with the\n"
         "left button draw a lasso, which becomes a polygon file for --crop, --region and --keep-out, extended along the\n"
         "direction of view. Files are PATH_view_1.png, PATH_view_lasso_1.txt and so on, in the current folder; without a path\n"
         "they have the name of the scan.\n"
         "Lengths are in millimetres. Exit code: 0 when the window is closed, 1 if the data or a file fails or "
         "there is\n"
         "no display, 2 if the command line is wrong, or an option does not fit the scan.\n";
  printOptions(out, optionTable(job));
}
