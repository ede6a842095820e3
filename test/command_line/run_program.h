// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Runs a program and keeps its output.
 */
#pragma once

#include "support/scratch_folder.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

/** The end of a run. */
struct RunResult {
  int code = -1; ///< exit code; -1 if a signal ended it
  std::string out, err;
  std::size_t peak_memory = 0; ///< bytes, counted by the system
};

/** Starts \p program in \p folder, with its output in hidden files there. Returns its process. */
inline pid_t
startProgram(const std::string& program, const std::vector<std::string>& arguments, const ScratchFolder& folder)
{
  const pid_t process = ::fork();
  if (process != 0)
    return process;
  if (::chdir(folder.root().c_str()) != 0 || !std::freopen(folder.path(".stdout").c_str(), "w", stdout) ||
      !std::freopen(folder.path(".stderr").c_str(), "w", stderr))
    ::_exit(126);
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  ::_exit(127);
}

/** Waits until the process catches \p signal (SigCgt in /proc), at most ten seconds. */
inline bool
waitUntilCaught(pid_t process, int signal)
{
  for (int i = 0; i < 1000; ++i) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string word; status >> word;)
      if (word == "SigCgt:" && status >> word && (std::stoull(word, nullptr, 16) >> (signal - 1) & 1U))
        return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/** Waits for a process of startProgram; removes its output files. */
inline RunResult
endOf(pid_t process, const ScratchFolder& folder)
{
  int status = 0;
  rusage use{};
  ::wait4(process, &status, 0, &use);
  RunResult result;
  result.peak_memory = 1024 * static_cast<std::size_t>(use.ru_maxrss);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.out = readText(folder.path(".stdout"));
  result.err = readText(folder.path(".stderr"));
  std::filesystem::remove(folder.path(".stdout"));
  std::filesystem::remove(folder.path(".stderr"));
  return result;
}
