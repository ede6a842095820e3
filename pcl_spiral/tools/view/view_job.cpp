// SPDX-License-Identifier: BSD-3-Clause
#include "view_job.h"

#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include <boost/program_options.hpp>

#include <vector>

namespace po = boost::program_options;

namespace {

using Files = std::vector<std::string>;

po::options_description
allOptions()
{
  constexpr unsigned int width = 110;
  po::options_description files("Files", width, width / 2), cutter("Cutter and finish (mm)", width, width / 2),
      run("Run", width, width / 2);
  files.add_options()(
      "file", po::value<Files>()->value_name("FILE"),
      "the scan, or with --mesh the mesh, then the path: .csv .pcd .ply .vtp; a scan alone, to choose the part; --file itself can be "
      "left out");
  addScanOptions(files);
  addPartOptions(files);
  addMeshOptions(files);
  addCutterOptions(cutter, "radius at the upper end of the flank; without it the stock map and the histogram stay empty: "
                           "--tool-radius 10");
  run.add_options()("threads", po::value<std::string>()->value_name("N"), "number of threads; default 0, all: --threads 4")(
      "quiet", "print only errors")("help,h", "print this text")("version", "print the version");
  po::options_description all;
  all.add(files).add(cutter).add(run);
  return all;
}

} // namespace

ViewJob
parseViewCommandLine(int argc, const char* const* argv)
{
  const po::variables_map given = readArguments(argc, argv, allOptions());
  ViewJob job;
  job.help = given.count("help") > 0;
  job.version = given.count("version") > 0;
  job.quiet = given.count("quiet") > 0;
  if (job.help || job.version)
    return job;
  const Files named = given.count("file") > 0 ? given["file"].as<Files>() : Files();
  require(named.size() == 1 || named.size() == 2,
          pcl_spiral::Diagnostic(named.size(), " files are given; give a scan, such as part.pcd, or the "
                                               "scan, or with --mesh the mesh, and then one path, such as part.pcd part.csv"));
  job.scan = named[0];
  job.path = named.size() > 1 ? named[1] : "";
  job.read = scanOptions(given);
  job.part = partOptions(given);
  job.regions = regionChoice(given);
  job.mesh = meshOptions(given);
  require(!job.mesh || !job.path.empty(), "a mesh is shown with a path; give one, such as part.stl part.csv");
  require(!job.regions.several(), "--part-at and --region: the window shows one region; give one of them");
  require(!job.path.empty() || (job.regions.places.empty() && given.count("tool-radius") == 0),
          "--part-at and --tool-radius belong to a path; give one, such as part.pcd part.csv, or leave them out");
  job.settings = cutterOptions(given);
  return job;
}

bool
hasOption(const std::string& name)
{
  return allOptions().find_nothrow(name, false) != nullptr;
}

void
printViewHelp(std::ostream& out)
{
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
         "no display, 2 if the command line is wrong.\n"
      << allOptions();
}
