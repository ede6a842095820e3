// SPDX-License-Identifier: BSD-3-Clause
#include "case_series.h"

#include "support/sanitizers.h"

#include <pcl/console/print.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>

namespace pcl_spiral::acceptance {

namespace {

/** The signals of a time limit, among those that end a process. */
bool
isHang(int signal)
{
  return signal == SIGALRM || signal == SIGXCPU || signal == SIGKILL;
}

} // namespace

Outcome
isolated(unsigned int longest, const std::function<Outcome()>& judge)
{
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0)
    return {"path", "no pipe"};
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pipe[0]);
    const rlimit seconds{longest, longest};
    ::setrlimit(RLIMIT_CPU, &seconds);
    ::alarm(20 * longest); // if it sleeps for ever
    std::string told;
    try {
      const Outcome outcome = judge();
      told = outcome.kind + '\n' + outcome.faults;
    }
    catch (const std::exception& error) {
      told = std::string("exception\n") + error.what();
    }
    ::_exit(::write(pipe[1], told.data(), told.size()) == static_cast<ssize_t>(told.size()) ? 0 : 3);
  }
  ::close(pipe[1]);
  std::string told;
  std::array<char, 4096> piece{};
  for (ssize_t n; (n = ::read(pipe[0], piece.data(), piece.size())) > 0;)
    told.append(piece.data(), static_cast<std::size_t>(n));
  ::close(pipe[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return {isHang(WTERMSIG(status)) ? "hang" : "crash", std::string(::strsignal(WTERMSIG(status)))};
  const std::size_t end = told.find('\n');
  return {told.substr(0, end), end == std::string::npos ? "nothing told" : told.substr(end + 1)};
}

/** The first clause without numbers, so that refusals of one kind are counted together. */
std::string
reasonOf(const std::string& message)
{
  std::string reason;
  for (const char c : message.substr(0, message.find_first_of(";:"))) {
    const bool in_number = !reason.empty() && reason.back() == '#';
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '-')
      reason += in_number ? "" : "#";
    else if (!in_number || c != '.')
      reason += c;
  }
  return "refused: " + reason.substr(0, 90);
}

int
judgeSeries(const std::string& name, const Options& options, unsigned int longest, const std::function<Outcome(const RandomCase&)>& judge)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  if (sanitized)
    longest *= 30;
  std::map<std::string, int> kinds;
  int faulty = 0;
  const auto from = std::chrono::steady_clock::now();
  for (std::uint64_t i = options.first; i < options.first + options.count; ++i) {
    const Outcome outcome = isolated(longest, [&] { return judge(randomCase(options.seed, i)); });
    ++kinds[outcome.kind];
    if (outcome.faults.empty())
      continue;
    ++faulty;
    std::printf("  case %llu: %s\n    %s: %s\n", static_cast<unsigned long long>(i), randomCase(options.seed, i).name.c_str(),
                outcome.kind.c_str(), outcome.faults.c_str());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
  std::printf("%s, seed %llu: %llu cases in %.1f s\n", name.c_str(), static_cast<unsigned long long>(options.seed),
              static_cast<unsigned long long>(options.count), took.count());
  for (const auto& [kind, count] : kinds)
    std::printf("  %5d  %s\n", count, kind.c_str());
  return faulty;
}

} // namespace pcl_spiral::acceptance
