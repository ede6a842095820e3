// SPDX-License-Identifier: BSD-3-Clause
#include "child.h"

#include "common/program_environment.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

extern char** environ;

namespace pcl_spiral::benchmarks {

namespace {

constexpr const char* mark = "--child";
constexpr int argument_count = 7;

std::string
resultIn(const std::string& folder)
{
  return folder + "/result.json";
}

Json
measure(const ChildTask& task)
{
  if (task.what == "pcl")
    return measurePcl(scanIn(task.folder), task.threads);
  return measureOurs(runCase(task.name, task.scallop), scanIn(task.folder), task.folder + "/path.csv", task.threads);
}

} // namespace

std::string
scanIn(const std::string& folder)
{
  return folder + "/scan.pcd";
}

Json
runChild(const ChildTask& task)
{
  std::filesystem::remove(resultIn(task.folder));
  std::vector<std::string> words{"pcl_spiral_benchmark_run",   mark,       task.what, task.name, std::to_string(task.scallop),
                                 std::to_string(task.threads), task.folder};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  setProgramEnvironment();
  pid_t process = 0;
  if (::posix_spawn(&process, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("no child process could be started");
  int status = 0;
  ::waitpid(process, &status, 0);
  std::ifstream in(resultIn(task.folder));
  if (!in)
    throw std::runtime_error("the measuring process ended without a result" +
                             (WIFSIGNALED(status) ? ": signal " + std::to_string(WTERMSIG(status)) : ""));
  Json result = Json::parse(in);
  if (result.contains("error"))
    throw std::runtime_error(result.at("error").get<std::string>());
  return result;
}

bool
isChild(int argc, char** argv)
{
  return argc == argument_count && std::strcmp(argv[1], mark) == 0;
}

int
childMain(int, char** argv)
{
  const ChildTask task{argv[2], argv[3], std::atof(argv[4]), std::atoi(argv[5]), argv[6]};
  Json result;
  try {
    result = measure(task);
  }
  catch (const std::exception& error) {
    result = {{"error", error.what()}};
  }
  std::ofstream(resultIn(task.folder)) << result.dump(2, ' ', false, Json::error_handler_t::replace);
  return result.contains("error") ? 1 : 0;
}

} // namespace pcl_spiral::benchmarks
