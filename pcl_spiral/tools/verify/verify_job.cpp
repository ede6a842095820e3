// SPDX-License-Identifier: BSD-3-Clause
#include "verify_job.h"

#include "judging/stock_option.h"
#include "terminal/command_line.h"
#include "terminal/file_names.h"
#include "terminal/read_options.h"
#include "verify/scene_files.h"

#include <algorithm>
#include <filesystem>

using namespace pcl_spiral;

namespace {

OptionGroup
files(VerifyJob& job)
{
  OptionGroup group = judgedFiles(job, "the scan, or with --mesh the mesh, then the paths: .csv .pcd .ply .vtp, or programs: .ngc .nc .mpf "
                                       ".h .apt .cls");
  addOptions(group,
             {textOption("machine", "FILE", "machine file of the programs, in YAML: --machine xyzac.yaml", job.machine_file),
              dialectOption(job),
              {"output", "FILE",
               "output file, its kind by extension; repeat it for each file: -o verified.json -o verified.html\n"
               ".json  the figures\n"
               ".html  report to read and print, with the pictures, in one file\n"
               ".png  picture of the deviation, of a single path; also NAME_stock.png: stock map, and NAME_histogram.png: heights of the "
               "scallops\n"
               ".vtp  a single path with the point data Deviation and Scallop, mm\n"
               ".glb .gltf  scene of a single path: part, path, and the stock that is left, for programs that show glTF\n"
               ".pvd  a single path in time, for ParaView; also NAME_00.vtp to NAME_24.vtp: stock and tool at moments equally far apart",
               [&job](const std::string& value) { job.outputs.push_back(value); }, true},
              stockOption(job.stock),
              textOption("raw-scan", "FILE", raw_scan_help, job.raw_scan)});
  return group;
}

OptionTable
optionTable(VerifyJob& job)
{
  OptionGroup limits{"Limits: if one is broken, the exit code is 1", {}};
  addSettings(limits, settingTable(job.limits));
  return {files(job), judgedCutter(job, "radius at the upper end of the flank; required: --tool-radius 10"), limits,
          runOptions(job, job.settings.threads)};
}

/** An output must not replace what is read. */
void
refuseInputs(const VerifyJob& job)
{
  std::vector<std::string> inputs = job.paths;
  inputs.push_back(job.scan());
  if (!job.raw_scan.empty())
    inputs.push_back(job.raw_scan);
  for (const auto& [what, file] : polygonFiles(job.part, job.regions))
    inputs.push_back(file);
  for (const std::string& file : {job.machine_file, job.config_file})
    if (!file.empty())
      inputs.push_back(file);
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
  require(std::any_of(job.paths.begin(), job.paths.end(), isProgramFile) || (job.machine_file.empty() && !job.dialect),
          "--machine and --dialect belong to programs; give a .ngc, .nc, .mpf, .h or .apt, or leave them out");
  checkProgramFiles(job.paths, job, job.mesh);
}

void
complete(VerifyJob& job)
{
  completeJudging(job);
  require(!job.files.empty() && !job.scan().empty(), "no scan is given; give the scan and then the paths, such as part.pcd part.csv");
  require(job.files.size() > 1, "no path is given after the scan; give at least one, such as part.csv");
  require(isGiven(job, "tool-radius"), "no --tool-radius is given; give the radius of the cutter in mm, such as --tool-radius 10");
  job.paths.assign(job.files.begin() + 1, job.files.end());
  for (const std::string& output : job.outputs) {
    const std::string extension = extensionOf(output);
    const std::vector<std::string> known{".json", ".html", ".png", ".vtp", ".glb", ".gltf", ".pvd"};
    require(std::find(known.begin(), known.end(), extension) != known.end(),
            Diagnostic("-o ", output, ": extension '", extension, "' is not known; use .json .html .png .vtp .glb .gltf or .pvd"));
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

} // namespace

const std::vector<PictureName>&
verifyPictures()
{
  static const std::vector<PictureName> pictures{
      {PictureKind::Deviation, ""}, {PictureKind::Stock, "_stock"}, {PictureKind::Histogram, "_histogram"}};
  return pictures;
}

std::vector<std::string>
filesOf(const std::string& output)
{
  const std::string extension = extensionOf(output);
  if (extension == ".pvd")
    return seriesFiles(output);
  if (extension != ".png")
    return {output};
  std::vector<std::string> files;
  for (const PictureName& picture : verifyPictures())
    files.push_back(besideName(output, picture.suffix));
  return files;
}

std::vector<std::string>
filesOf(const VerifyJob& job)
{
  std::vector<std::string> files;
  for (const std::string& output : job.outputs)
    for (const std::string& file : filesOf(output))
      files.push_back(file);
  files.insert(files.end(), job.stock.begin(), job.stock.end());
  return files;
}

VerifyJob
parseVerifyCommandLine(int argc, const char* const* argv)
{
  return parseJob<VerifyJob>(argc, argv, optionTable, complete, {"file"});
}

std::vector<std::string>
ownOptions()
{
  VerifyJob job;
  return namesOf(optionTable(job));
}

void
printVerifyHelp(std::ostream& out)
{
  VerifyJob job;
  out << "Checks toolpaths and machine programs against the raw scan or a mesh: deviation, scallop, gouge, uncut places, efficiency.\n\n"
         "  pcl_spiral_verify SCAN PATH... --tool-radius R [options]\n\n"
         "  pcl_spiral_verify part.stl part.csv --mesh --tool-radius 10\n"
         "  pcl_spiral_verify part.pcd part.csv --tool-radius 10 --scallop 0.05 --max-gouge 0.01 -o "
         "verified.json\n"
         "  pcl_spiral_verify part.pcd part.ngc --machine xyzac.yaml --tool-radius 10 --max-gouge 0.01\n\n"
         "Lengths are in millimetres, angles in degrees. Exit code: 0 if every limit holds, 1 if a limit is broken\n"
         "or the data or a file fails, 2 if the command line is wrong, or an option does not fit the scan.\n";
  printOptions(out, optionTable(job));
}
