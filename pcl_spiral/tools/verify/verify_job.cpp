// SPDX-License-Identifier: BSD-3-Clause
#include "verify_job.h"

#include "judged_program.h"
#include "judging/judge_options.h"
#include "judging/stock_option.h"
#include "terminal/file_names.h"
#include "terminal/option_values.h"
#include "terminal/read_options.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/io/program_writer.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <filesystem>

namespace po = boost::program_options;

using namespace pcl_spiral;

namespace {

po::options_description
allOptions()
{
  constexpr unsigned int width = 110;
  const auto value = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto values = [](const char* name) { return po::value<std::vector<std::string>>()->value_name(name); };
  po::options_description files("Files", width, width / 2),
      cutter("Cutter (tapered bull-nose and its special cases) and finish (mm, degrees)", width, width / 2),
      limits("Limits: if one is broken, the exit code is 1", width, width / 2), run("Run", width, width / 2);
  files.add_options()(
      "file", values("FILE"),
      "the scan, or with --mesh the mesh, then the paths: .csv .pcd .ply .vtp, or programs: .ngc .nc .mpf .h .apt .cls; --file itself can "
      "be left out")("machine", value("FILE"), "machine file of the programs, in YAML: --machine xyzac.yaml")(
      "dialect", value("WORD"),
      "language of a .nc; default found from its words; a .ngc is for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain: --dialect "
      "siemens")("output,o", values("FILE"),
                 "output file, its kind by extension; repeat it for each file: -o verified.json -o verified.html\n"
                 ".json  the figures\n"
                 ".html  report to read and print, with the pictures, in one file\n"
                 ".png  picture of the deviation, of a single path; also NAME_stock.png: stock map, and NAME_histogram.png: heights of "
                 "the scallops\n"
                 ".vtp  a single path with the point data Deviation and Scallop, mm")("stock", values("FILE"), stock_help);
  files.add_options()("raw-scan", value("FILE"), raw_scan_help);
  addScanOptions(files);
  addPartOptions(files);
  addMeshOptions(files);
  addCutterOptions(cutter, "radius at the upper end of the flank; required: --tool-radius 10");
  limits.add_options()("max-gouge", value("G"), "depth of gouges, mm: --max-gouge 0.01")(
      "max-scallop", value("S"), "height of ridges and of stock at the rim, mm: --max-scallop 0.06")(
      "max-deviation", value("D"), "distance of the contacts from the surface, mm: --max-deviation 0.02")(
      "max-uncut", value("P"), "points of the surface that are not cut, percent: --max-uncut 0");
  run.add_options()("threads", value("N"), "number of threads; default 0, all: --threads 4")("quiet", "print only errors")(
      "help,h", "print this text")("version", "print the version");
  po::options_description all;
  all.add(files).add(cutter).add(limits).add(run);
  return all;
}

/** An output must not replace what is read. */
void
refuseInputs(const VerifyJob& job)
{
  std::vector<std::string> inputs = job.paths;
  inputs.push_back(job.scan);
  if (!job.raw_scan.empty())
    inputs.push_back(job.raw_scan);
  if (!job.machine_file.empty())
    inputs.push_back(job.machine_file);
  std::error_code error;
  for (const std::string& file : filesOf(job))
    for (const std::string& input : inputs)
      require(!std::filesystem::equivalent(file, input, error),
              Diagnostic(file, ": this is ", input, ", which is read; give the output another name"));
}

/** Programs need their machine, and the machine needs a program. */
void
checkPrograms(const VerifyJob& job)
{
  const bool any = std::any_of(job.paths.begin(), job.paths.end(), isProgramFile);
  require(any || (job.machine_file.empty() && !job.dialect),
          "--machine and --dialect belong to programs; give a .ngc, .nc, .mpf, .h or .apt, or leave them out");
  require(!any || !job.mesh, "programs are judged by a scan; leave --mesh out, so that the vertices of the mesh are the scan");
  for (const std::string& path : job.paths) {
    require(!job.machine_file.empty() || !isProgramExtension(extensionOf(path)),
            Diagnostic(path, ": a program has the axes of a machine; give its machine file, such as --machine xyzac.yaml"));
    if (const std::optional<Dialect> own = dialectOfExtension(extensionOf(path)); own && job.dialect)
      require(*own == *job.dialect, Diagnostic(path, ": is always for ", std::string(entryOf(*own).word), "; leave --dialect out"));
  }
}

void
check(const VerifyJob& job, bool radius_given)
{
  require(!job.scan.empty(), "no scan is given; give the scan and then the paths, such as part.pcd part.csv");
  require(!job.paths.empty(), "no path is given after the scan; give at least one, such as part.csv");
  require(radius_given, "no --tool-radius is given; give the radius of the cutter in mm, such as --tool-radius 10");
  for (const std::string& output : job.outputs) {
    const std::string extension = extensionOf(output);
    const std::vector<std::string> known{".json", ".html", ".png", ".vtp"};
    require(std::find(known.begin(), known.end(), extension) != known.end(),
            Diagnostic("-o ", output, ": extension '", extension, "' is not known; use .json .html .png or .vtp"));
    require(
        job.paths.size() == 1 || extension == ".json" || extension == ".html",
        Diagnostic("-o ", output, ": shows one path, and ", job.paths.size(), " are given; give only one path, or write .json or .html"));
    require(
        !job.regions.several() || extension == ".json" || extension == ".html",
        Diagnostic("-o ", output, ": shows one region, and several are given (--part-at, --region); give one, or write .json or .html"));
  }
  checkStockFiles(job.stock);
  require(job.stock.empty() || job.paths.size() == 1,
          Diagnostic("--stock: shows what one path leaves, and ", job.paths.size(), " are given; give only one path"));
  require(job.raw_scan.empty() || !job.mesh, "--raw-scan belongs to scans, and --mesh is given: leave one of the two out");
  checkPrograms(job);
  refuseInputs(job);
}

VerifyJob
fromMap(const po::variables_map& given)
{
  VerifyJob job;
  job.help = given.count("help") > 0;
  job.version = given.count("version") > 0;
  job.quiet = given.count("quiet") > 0;
  if (job.help || job.version)
    return job;
  const auto limit = [&](const char* name, std::optional<double>& value) {
    if (given.count(name) == 0)
      return;
    value = numberValue(name, given[name].as<std::string>());
    require(*value >= 0.0, Diagnostic("--", std::string(name), " must not be below 0"));
  };
  if (given.count("file") > 0) {
    job.paths = given["file"].as<std::vector<std::string>>();
    job.scan = job.paths.front();
    job.paths.erase(job.paths.begin());
  }
  if (given.count("output") > 0)
    job.outputs = given["output"].as<std::vector<std::string>>();
  if (given.count("stock") > 0)
    job.stock = given["stock"].as<std::vector<std::string>>();
  if (given.count("machine") > 0)
    job.machine_file = given["machine"].as<std::string>();
  if (given.count("raw-scan") > 0)
    job.raw_scan = given["raw-scan"].as<std::string>();
  if (given.count("dialect") > 0)
    job.dialect = choiceValue<Dialect>("dialect", given["dialect"].as<std::string>());
  job.read = scanOptions(given);
  job.part = partOptions(given);
  job.regions = regionChoice(given);
  job.mesh = meshOptions(given);
  job.settings = cutterOptions(given);
  limit("max-gouge", job.limits.gouge);
  limit("max-scallop", job.limits.scallop);
  limit("max-deviation", job.limits.deviation);
  limit("max-uncut", job.limits.uncut);
  check(job, given.count("tool-radius") > 0);
  return job;
}

} // namespace

const std::vector<PictureName>&
verifyPictures()
{
  static const std::vector<PictureName> pictures{
      {PictureKind::Deviation, ""}, {PictureKind::Stock, "_stock"}, {PictureKind::Histogram, "_histogram"}};
  return pictures;
}

std::vector<std::string>
filesOf(const VerifyJob& job)
{
  std::vector<std::string> files;
  for (const std::string& output : job.outputs)
    if (extensionOf(output) == ".png")
      for (const PictureName& picture : verifyPictures())
        files.push_back(besideName(output, picture.suffix));
    else
      files.push_back(output);
  files.insert(files.end(), job.stock.begin(), job.stock.end());
  return files;
}

VerifyJob
parseVerifyCommandLine(int argc, const char* const* argv)
{
  const po::variables_map given = readArguments(argc, argv, allOptions());
  VerifyJob job = fromMap(given);
  job.command = commandLine(argc, argv);
  return job;
}

bool
hasOption(const std::string& name)
{
  return allOptions().find_nothrow(name, false) != nullptr;
}

void
printVerifyHelp(std::ostream& out)
{
  out << "Checks toolpaths and machine programs against the raw scan or a mesh: deviation, scallop, gouge, uncut places, efficiency.\n\n"
         "  pcl_spiral_verify SCAN PATH... --tool-radius R [options]\n\n"
         "  pcl_spiral_verify part.stl part.csv --mesh --tool-radius 10\n"
         "  pcl_spiral_verify part.pcd part.csv --tool-radius 10 --scallop 0.05 --max-gouge 0.01 -o "
         "verified.json\n"
         "  pcl_spiral_verify part.pcd part.ngc --machine xyzac.yaml --tool-radius 10 --max-gouge 0.01\n\n"
         "Lengths are in millimetres, angles in degrees. Exit code: 0 if every limit holds, 1 if a limit is broken\n"
         "or the data or a file fails, 2 if the command line is wrong.\n"
      << allOptions();
}
