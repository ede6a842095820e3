// SPDX-License-Identifier: BSD-3-Clause
#include "measured_run.h"

#include "accuracy.h"

#include "support/pcl_pair.h"

#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pcl/io/pcd_io.h>

#include <boost/crc.hpp>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>

namespace pcl_spiral::benchmarks {

namespace {

constexpr double bytes_a_path_point = 160.0; // limit of the target

double
megabytes(std::size_t bytes)
{
  return 1e-6 * static_cast<double>(bytes);
}

/** Processor time of all threads of this process up to now. */
double
processorSeconds()
{
  timespec used{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/** Checksum of a file: the same for the same path, for any number of threads. */
std::string
checksum(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::vector<char> bytes(1u << 20);
  boost::crc_32_type crc;
  while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || in.gcount() > 0)
    crc.process_bytes(bytes.data(), static_cast<std::size_t>(in.gcount()));
  char text[16];
  std::snprintf(text, sizeof text, "%08x", crc.checksum());
  return text;
}

Json
stagesJson(const std::vector<StageCost>& stages)
{
  Json json = Json::array();
  for (const StageCost& stage : stages)
    json.push_back({{"name", stage.name},
                    {"seconds", stage.seconds},
                    {"resident_mb", megabytes(stage.memory.resident)},
                    {"peak_mb", megabytes(stage.memory.peak)}});
  return json;
}

Json
pathJson(const RunCase& run, const SpiralReport& report, const pcl::PointCloud<ToolpathPoint>& path)
{
  const Accuracy accuracy = accuracyOf(run, path);
  return {{"used_points", report.used_points},
          {"outlier_points", report.outlier_points},
          {"spacing", report.spacing},
          {"noise", report.noise},
          {"radial_lines", report.radial_lines.size()},
          {"turns", report.turns},
          {"path_points", path.size()},
          {"deviation_max", accuracy.deviation_max},
          {"deviation_rms", accuracy.deviation_rms},
          {"longest_move", accuracy.longest_move},
          {"largest_allowed_step", report.largest_allowed_step},
          {"length_ratio", accuracy.length_ratio > 0.0 ? Json(accuracy.length_ratio) : Json()},
          {"warnings", textsOf(report.warnings)}};
}

} // namespace

Json
measureOurs(const RunCase& run, const std::string& scan, const std::string& csv, int threads)
{
  const std::size_t before = memoryUse().resident;
  const double processor_before = processorSeconds();
  const ThreadLimit limit(threads);
  std::vector<StageCost> stages, whole;
  StageClock clock(stages), whole_clock(whole);
  const Scan read = readCloud(scan);
  clock.end("reading");
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(read.cloud);
  generator.setSettings(run.settings);
  generator.setNumberOfThreads(threads);
  pcl::PointCloud<ToolpathPoint> path;
  generator.compute(path);
  std::string walk;
  if (!generator.getStatus().ok() && run.settings.method == SpiralMethod::Published) {
    walk = generator.getStatus().message();
    BoundaryLoops<pcl::PointXYZ> boundaries;
    boundaries.setInputCloud(read.cloud);
    boundaries.setNumberOfThreads(threads);
    std::vector<BoundaryLoop> loops;
    boundaries.compute(loops);
    generator.setBoundaryLoops(loops);
    generator.compute(path);
  }
  if (!generator.getStatus().ok())
    throw std::runtime_error(run.name + ": " + generator.getStatus().message());
  const std::vector<StageCost>& computed = generator.getReport().stages;
  stages.insert(stages.end(), computed.begin(), computed.end());
  StageClock last(stages);
  writeToolpath(csv, path, {run.settings.tool_radius, run.settings.feed});
  last.end("writing");
  whole_clock.end("whole");
  const double processor = processorSeconds() - processor_before;

  const MemoryUse memory = whole.back().memory;
  const double own = static_cast<double>(memory.peak) - static_cast<double>(before) - bytes_a_path_point * static_cast<double>(path.size());
  Json json{{"seconds", whole.back().seconds},
            {"processor_seconds", processor},
            {"peak_mb", megabytes(memory.peak)},
            {"before_mb", megabytes(before)},
            {"bytes_a_cloud_point", own / static_cast<double>(read.cloud->size())},
            {"csv_crc", checksum(csv)},
            {"walk", walk.empty() ? Json() : Json(walk)},
            {"stages", stagesJson(stages)}};
  json.update(pathJson(run, generator.getReport(), path));
  return json;
}

Json
measurePcl(const std::string& scan, int threads)
{
  const Cloud::Ptr cloud(new Cloud);
  if (pcl::io::loadPCDFile(scan, *cloud) != 0)
    throw std::runtime_error("PCL cannot read " + scan);
  const double processor_before = processorSeconds();
  const test::PairSeconds pair = test::timePclPair(cloud, threads);
  return {{"seconds", pair.sum()},
          {"processor_seconds", processorSeconds() - processor_before},
          {"normals", pair.normals},
          {"boundary", pair.boundary},
          {"peak_mb", megabytes(memoryUse().peak)}};
}

} // namespace pcl_spiral::benchmarks
