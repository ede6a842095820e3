#include "console.h"
#include "job_check.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>

namespace {

volatile std::sig_atomic_t signal_received = 0;

void
remember(int signal)
{
  signal_received = signal;
}

const char*
plural(std::size_t count)
{
  return count == 1 ? "" : "s";
}

std::string
duration(double seconds)
{
  char text[64];
  if (seconds < 60.0)
    std::snprintf(text, sizeof(text), "%.1f s", seconds);
  else if (seconds < 3600.0)
    std::snprintf(text, sizeof(text), "%.1f min", seconds / 60.0);
  else
    std::snprintf(text, sizeof(text), "%.0f h %.0f min", std::floor(seconds / 3600.0),
                  std::floor(std::fmod(seconds, 3600.0) / 60.0));
  return text;
}

void
printSurface(const Job& job, const pcl_spiral::SpiralReport& report)
{
  std::printf("scan            %s: %zu points", job.scan.c_str(), report.input_points);
  const auto dropped = [](std::size_t count, const char* why) {
    if (count > 0)
      std::printf(", %zu %s", count, why);
  };
  dropped(report.nonfinite_points, "not finite");
  dropped(report.duplicate_points, "duplicates");
  dropped(report.outlier_points, "outliers");
  std::printf(", %zu used\n", report.used_points);
  std::printf("surface         spacing %.4g mm, noise %.2g mm\n", report.spacing, report.noise);
  std::size_t gaps = 0;
  for (const pcl_spiral::BoundaryLoop& loop : report.loops) {
    gaps += loop.type == pcl_spiral::LoopType::ScanGap;
    if (loop.type != pcl_spiral::LoopType::ScanGap)
      std::printf("%s      %.1f mm long, %zu corner%s\n",
                  loop.type == pcl_spiral::LoopType::Outer ? "outer rim " : "inner loop", loop.length,
                  loop.corners.size(), plural(loop.corners.size()));
  }
  if (gaps > 0)
    std::printf("scan gaps       %zu, bridged\n", gaps);
  if (report.boundaries == 1)
    std::printf("centre          %.3f, %.3f, %.3f\n", report.centre.x(), report.centre.y(),
                report.centre.z());
}

void
printPath(const Job& job, const pcl_spiral::SpiralReport& report)
{
  std::printf("radial lines    %zu, %s\n", report.radial_lines.size(),
              report.harmonic_lines ? "harmonic" : "geodesic");
  std::printf("spiral          %zu turn%s, %zu points, step-over %.4g to %.4g mm\n", report.turns,
              plural(report.turns), report.path_points, report.smallest_step_over, report.largest_step_over);
  if (report.limited_points > 0)
    std::printf("tool axis       tilt eased at %zu point%s by up to %.3g degrees, to turn no faster than %g degrees a mm\n",
                report.limited_points, plural(report.limited_points), report.largest_tilt_reduction,
                job.settings.max_axis_rate);
  std::printf("path length     %.3f m\n", report.path_length / 1000.0);
  std::printf("machining time  %s at %g mm/min\n",
              duration(60.0 * report.path_length / job.settings.feed).c_str(), job.settings.feed);
}

} // namespace

void
catchSignals()
{
  struct sigaction action = {};
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
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
    std::fprintf(stderr, "\r\033[K[%s%s] %3d %%  %s",
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
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

void
printSummary(const Job& job, const pcl_spiral::SpiralReport& report, double seconds)
{
  printSurface(job, report);
  printPath(job, report);
  std::printf("time            %s\n", duration(seconds).c_str());
  if (job.verbose)
    for (const pcl_spiral::StageTime& stage : report.stages)
      std::printf("  %-32s %.2f s\n", stage.name.c_str(), stage.seconds);
  if (job.read.origin != Eigen::Vector3d::Zero())
    std::printf("origin          the path is relative to %.10g, %.10g, %.10g in the scan's unit\n",
                job.read.origin.x(), job.read.origin.y(), job.read.origin.z());
  std::printf("written        ");
  for (const std::string& file : filesOf(job))
    std::printf(" %s", file.c_str());
  std::printf("\n");
}
