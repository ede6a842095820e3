// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of whole runs, from the PCD to the written CSV, and of PCL's normals and boundary points of the same cloud.
#include "child.h"
#include "run_table.h"

#include <pcl/io/pcd_io.h>
#include <pcl/pcl_config.h>

#include <boost/program_options.hpp>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

using namespace pcl_spiral::benchmarks;

namespace {

/** The options; every combination of the lists is run. */
struct Plan {
  std::vector<std::string> cases{"dome"}, orders{"random"};
  std::vector<double> scallops{0.05};
  std::vector<int> threads;
  int repetitions = 3;
  bool without_pcl = false;
  std::string json, folder;
};

/** False if only help was asked for. */
bool
parse(int argc, char** argv, Plan& plan)
{
  namespace po = boost::program_options;
  po::options_description options("Times whole runs beside PCL's normals and boundary points. Options");
  const auto list = [&options](const char* name, auto* value, const char* text) {
    options.add_options()(name, po::value(value)->multitoken(), text);
  };
  list("case", &plan.cases, "dome, dome200k, freeform, dome12; dome by default");
  list("order", &plan.orders, "of the points in the file: random, sorted; random by default");
  list("scallop", &plan.scallops, "mm; 0.05 by default");
  list("threads", &plan.threads, "all of the machine's by default");
  options.add_options()("repetitions", po::value(&plan.repetitions), "by turns with PCL; the median counts; 3 by default")(
      "without-pcl", po::bool_switch(&plan.without_pcl), "time ours alone")("json", po::value(&plan.json),
                                                                            "file for all that was measured")(
      "folder", po::value(&plan.folder), "for the scan and the path; a temporary one by default")("help", "this text");
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  po::notify(given);
  if (given.count("help"))
    std::cout << options;
  if (plan.threads.empty())
    plan.threads = {static_cast<int>(std::thread::hardware_concurrency())};
  for (const std::string& order : plan.orders)
    if (order != "random" && order != "sorted")
      throw std::invalid_argument("--order " + order + ": it is random or sorted");
  if (plan.repetitions < 1)
    throw std::invalid_argument("--repetitions must be 1 or more");
  if (*std::min_element(plan.threads.begin(), plan.threads.end()) < 1)
    throw std::invalid_argument("--threads must be 1 or more");
  for (const std::string& name : plan.cases)
    runCase(name, plan.scallops.front());
  return !given.count("help");
}

/** The median measurement of several, with the seconds of all. */
Json
median(std::vector<Json> measured)
{
  Json all = Json::array();
  for (const Json& one : measured)
    all.push_back(one.at("seconds"));
  std::sort(measured.begin(), measured.end(), [](const Json& a, const Json& b) { return a["seconds"] < b["seconds"]; });
  Json chosen = measured[(measured.size() - 1) / 2];
  chosen["seconds_of_all"] = all;
  return chosen;
}

/** Runs pcl_spiral and PCL alternately. */
Json
measure(const Plan& plan, const ChildTask& ours)
{
  ChildTask pcl = ours;
  pcl.what = "pcl";
  std::vector<Json> our_runs, pcl_runs;
  for (int i = 0; i < plan.repetitions; ++i) {
    our_runs.push_back(runChild(ours));
    if (!plan.without_pcl)
      pcl_runs.push_back(runChild(pcl));
  }
  Json result{{"ours", median(our_runs)}};
  if (!pcl_runs.empty()) {
    result["pcl"] = median(pcl_runs);
    result["ratio"] = result["ours"]["seconds"].get<double>() / result["pcl"]["seconds"].get<double>();
  }
  return result;
}

void
writeScan(const RunCase& run, const std::string& order, const std::string& folder)
{
  const Points points = sampledPoints(run.cloud);
  pcl::io::savePCDFileBinary(scanIn(folder), *toCloud(order == "sorted" ? inSpatialOrder(points) : points));
}

Json
runAll(const Plan& plan)
{
  Json runs = Json::array();
  for (const std::string& name : plan.cases)
    for (const std::string& order : plan.orders) {
      writeScan(runCase(name, plan.scallops.front()), order, plan.folder);
      for (const double scallop : plan.scallops)
        for (const int threads : plan.threads) {
          Json run{{"case", name}, {"order", order}, {"scallop", scallop}, {"threads", threads}};
          try {
            run.update(measure(plan, {"ours", name, scallop, threads, plan.folder}));
            printRun(run);
          }
          catch (const std::exception& error) {
            run["error"] = error.what();
            std::cerr << error.what() << '\n';
          }
          runs.push_back(run);
        }
    }
  return runs;
}

} // namespace

int
main(int argc, char** argv)
{
  if (isChild(argc, argv))
    return childMain(argc, argv);
  try {
    Plan plan;
    if (!parse(argc, argv, plan))
      return 0;
    const bool own_folder = plan.folder.empty();
    if (own_folder)
      plan.folder = (std::filesystem::temp_directory_path() / ("pcl_spiral_run_" + std::to_string(::getpid()))).string();
    std::filesystem::create_directories(plan.folder);
    const Json runs = runAll(plan);
    printTable(runs);
    if (!plan.json.empty())
      std::ofstream(plan.json) << Json{{"cores", std::thread::hardware_concurrency()}, {"pcl", PCL_VERSION_PRETTY}, {"runs", runs}}.dump(
                                      2, ' ', false, Json::error_handler_t::replace)
                               << '\n';
    if (own_folder)
      std::filesystem::remove_all(plan.folder);
    return std::any_of(runs.begin(), runs.end(), [](const Json& run) { return run.contains("error"); }) ? 1 : 0;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_spiral_benchmark_run: " << error.what() << '\n';
    return 2;
  }
}
