// SPDX-License-Identifier: BSD-3-Clause
#include "program_main.h"

#include "terminal.h"
#include "vocabulary.h"

#include "common/program_environment.h"
#include <pcl_spiral/io/file_error.h>

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace {

constexpr int failed_on_data = 1;

/** Starts the program \p name again in the environment of the programs, as far as the user chose no other. Not with the rights of another
 *  user, for which the system takes variables away, and not under tools that run it in their own way, as valgrind, which loads a library
 *  before it, or a loader that is called with its name. */
void
startAgain(const std::string& name, char* const* argv)
{
  std::error_code unread;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unread);
  if (program.filename() == name && !std::getenv("LD_PRELOAD") && !getauxval(AT_SECURE) && pcl_spiral::setProgramEnvironment())
    execv(program.c_str(), argv); // returns where this fails: slower, and nothing else
}

/** The exit code of \p body. */
int
codeOf(const std::string& name, const std::function<int()>& body)
{
  constexpr int bad_usage = 2;
  try {
    return body();
  }
  catch (const UsageError& error) {
    std::cerr << name << ": " << inWords(error.diagnostic()) << '\n' << name << " --help lists the options\n";
    return bad_usage;
  }
  catch (const pcl_spiral::FileError& error) {
    std::cerr << name << ": " << inWords(error.diagnostic()) << '\n';
    return failed_on_data;
  }
  catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return failed_on_data;
  }
}

} // namespace

int
runProgram(const std::string& name, char* const* argv, const std::function<int()>& body)
{
  startAgain(name, argv);
  catchSignals();
  const int code = codeOf(name, body);
  const bool told = std::cout.flush() && std::fflush(stdout) == 0;
  if (!told)
    std::cerr << name << ": the standard output cannot be written\n";
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // these look for leaks in the end
  // Static objects of VTK need tens of milliseconds to free what the system frees anyway.
  std::quick_exit(told ? code : std::max(code, failed_on_data));
#endif
  return told ? code : std::max(code, failed_on_data);
}
