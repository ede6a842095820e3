// SPDX-License-Identifier: BSD-3-Clause
#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>

namespace {

volatile std::sig_atomic_t signal_received = 0;

void
remember(int signal)
{
  signal_received = signal;
}

} // namespace

void
catchSignals()
{
  struct sigaction action = {};
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) // ignored already, as under nohup
      sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr); // writing beyond the file size limit then fails like a full disk
}

bool
cancelled()
{
  return signal_received != 0;
}

ProgressBar::ProgressBar(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar()
{
  clear();
}

bool
ProgressBar::update(double share, const std::string& stage)
{
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  if (shown_ && (percent != last_percent_ || stage != last_stage_)) {
    constexpr int width = 30;
    const int filled = percent * width / 100;
    std::fprintf(stderr, "\r\033[K[%s%s] %3d %%  %s", std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(width - filled), '.').c_str(), percent, stage.c_str());
    std::fflush(stderr);
    last_percent_ = percent;
    last_stage_ = stage;
  }
  return !cancelled();
}

void
ProgressBar::clear()
{
  if (shown_ && last_percent_ >= 0)
    std::fprintf(stderr, "\r\033[K");
  last_percent_ = -1;
}

std::string
madeBy(const std::string& program)
{
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  ::gmtime_r(&now, &utc);
  char text[40];
  std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M UTC", &utc);
  return program + " " PCL_SPIRAL_VERSION ", " + text;
}
