// SPDX-License-Identifier: BSD-3-Clause
#include "view_job.h"

#include "program/holder_options.h"
#include "terminal/command_line.h"
#include "terminal/vocabulary.h"

namespace {

OptionTable
optionTable(ViewJob& job)
{
  OptionGroup files = judgedFiles(job, "the scan, or with --mesh the mesh, then the path: .csv .pcd .ply .vtp, or a program: .ngc .nc .mpf "
                                       ".h .apt .cls; a scan alone, to choose the part");
  addOptions(files,
             {textOption("machine", "FILE",
                         "machine file, in YAML: of a program, or the machine that the playback of a path shows: --machine xyzac.yaml",
                         job.machine_file),
              dialectOption(job)});
  OptionGroup cutter = judgedCutter(job, "radius at the upper end of the flank; without it there is no stock map, histogram or playback: "
                                         "--tool-radius 10");
  addOptions(cutter, {holderOption(job.holder)});
  return {files, cutter, runOptions(job, job.settings.threads)};
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
  require(!job.path.empty() || (job.machine_file.empty() && !job.dialect && job.holder.empty()),
          "--machine, --dialect and --holder belong to a path; give one, such as part.pcd part.csv, or leave them out");
  const bool program = isProgramFile(job.path);
  require(program || !job.dialect, "--dialect belongs to programs; give a .ngc, .nc, .mpf, .h or .apt, or leave it out");
  require(!program || isGiven(job, "tool-radius"),
          Diagnostic(job.path, ": the contacts of a program are those of its cutter; give its radius in mm, such as --tool-radius 10"));
  if (!job.path.empty())
    checkProgramFiles({job.path}, job, job.mesh);
  checkHolder(job.holder, 0.0, job.settings.cutter.flank_length);
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
  out << "Shows a toolpath on its scan or mesh: boundaries, path, deviation map, stock map, scallop\n"
         "histogram, and plays it or its machine program.\n\n"
         "  pcl_spiral_view PART PATH [options]\n"
         "  pcl_spiral_view SCAN [options]\n\n"
         "  pcl_spiral_view scan.pcd\n"
         "  pcl_spiral_view part.pcd part.csv --tool-radius 10 --scallop 0.05\n"
         "  pcl_spiral_view part.stl part.csv --mesh --tool-radius 10\n"
         "  pcl_spiral_view part.pcd part.ngc --machine xyzac.yaml --tool-radius 10 --scallop 0.05\n\n"
         "The window lists its keys. a prints the --part-at of the scanned point at the mouse, z looks along z, l and a drag with the\n"
         "left button draw a lasso, which becomes a polygon file for --crop, --region and --keep-out, extended along the\n"
         "direction of view. Files are PATH_view_1.png, PATH_view_lasso_1.txt and so on, in the current folder; without a path\n"
         "they have the name of the scan.\n"
         "Lengths are in millimetres. Exit code: 0 when the window is closed, 1 if the data or a file fails or "
         "there is\n"
         "no display, 2 if the command line is wrong, or an option does not fit the scan.\n";
  printOptions(out, optionTable(job));
}
