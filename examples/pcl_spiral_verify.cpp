// Toolpath files judged by the raw scan.
#include "terminal/terminal.h"
#include "verify/verify_job.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include <pcl/console/print.h>

#include <filesystem>
#include <iostream>

using namespace pcl_spiral;

namespace {

constexpr int failed = 1;
constexpr int bad_usage = 2;

VerificationScene
sceneOf(const VerifyJob& job, const Scan& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
        const Heights& heights, const Verification& verification)
{
  VerificationScene scene;
  scene.part.title = std::filesystem::path(verification.path).filename().string();
  scene.part.cloud = scan.cloud;
  scene.part.path = path;
  scene.part.settings.tool_radius = job.settings.tool_radius;
  scene.part.settings.scallop_height = job.settings.scallop_height;
  scene.part.settings.chord_error = job.settings.chord_error;
  scene.part.settings.view_point = job.settings.view_point;
  scene.part.settings.flip_normals = job.settings.flip_normals;
  scene.deviation = heights.deviation;
  scene.stock = heights.stock;
  scene.ridges = heights.ridges;
  scene.deviation_figures = verification.deviation;
  scene.removal_figures = verification.removal;
  return scene;
}

/** Judge every path. \return whether all limits hold */
bool
run(const VerifyJob& job)
{
  OutputFiles files(filesOf(job));
  for (const std::string& output : job.outputs)
    if (extensionOf(output) == ".png" && !displayProblem().empty())
      throw FileError(output, displayProblem());
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  const Scan scan = readCloud(job.scan, job.read);
  if (!job.quiet)
    for (const std::string& warning : scan.warnings)
      std::cerr << "pcl_spiral_verify: warning: " << warning << '\n';
  std::vector<Verification> verifications;
  std::shared_ptr<const ScannedReference> surface;
  bool all_hold = true;
  VerificationScene scene;
  for (const std::string& file : job.paths) {
    const auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(readToolpath(file).path);
    ProgressBar bar(job.quiet);
    Verification verification;
    Heights heights;
    verification.path = file;
    const Status status = judgePath(scan.cloud, path, job.settings,
                                    [&](double share, const std::string& stage) { return bar.update(share, stage); },
                                    surface, verification, heights);
    bar.clear();
    if (cancelled())
      throw std::runtime_error("cancelled; no report has been written");
    if (!status.ok())
      throw FileError(file, status.message());
    verification.broken = brokenLimits(job.limits, verification);
    all_hold = all_hold && verification.broken.empty();
    if (!job.quiet) {
      printFigures(verification);
      for (const std::string& warning : verification.removal.warnings)
        std::cerr << "pcl_spiral_verify: warning: " << warning << '\n';
    }
    scene = sceneOf(job, scan, path, heights, verification);
    verifications.push_back(std::move(verification));
  }
  const VerificationRun judged{job.scan, job.read.unit, job.settings.tool_radius, job.settings.scallop_height,
                               job.settings.chord_error, scan.warnings};
  for (std::size_t i = 0; i < files.size(); ++i)
    if (extensionOf(files.path(i)) == ".json")
      writeVerificationJSON(files.temporary(i), judged, verifications);
    else {
      const VerificationPictures pictures(scene);
      pictures.writeDeviation(files.temporary(i));
      pictures.writeStock(files.temporary(++i));
      pictures.writeHistogram(files.temporary(++i));
    }
  files.commit();
  return all_hold;
}

} // namespace

int
main(int argc, char** argv)
{
  catchSignals();
  try {
    const VerifyJob job = parseVerifyCommandLine(argc, argv);
    if (job.help)
      printVerifyHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_verify " PCL_SPIRAL_VERSION "\n";
    else
      return run(job) ? 0 : failed;
    return 0;
  }
  catch (const UsageError& error) {
    std::cerr << "pcl_spiral_verify: " << error.what() << "\npcl_spiral_verify --help lists the options\n";
    return bad_usage;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_spiral_verify: " << error.what() << '\n';
    return failed;
  }
}
