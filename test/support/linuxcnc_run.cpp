// SPDX-License-Identifier: BSD-3-Clause
#include "support/linuxcnc_run.h"

#include "support/linuxcnc_planner_calls.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace pcl_spiral::test {
namespace {

constexpr long most_cycles = 100000000; // 28 hours of the machine
constexpr const char* module_file = "/usr/lib/linuxcnc/modules/tpmod.so";
constexpr double cycle = 1e-3; ///< s, of the servo thread
constexpr int most_queued = 1000;
constexpr std::size_t most_joined = 100;

using AxisPlace = std::array<double, 6>;

/** The slowest axis of a way decides: way of X Y Z, or of the rotary axes alone, over the longest time. */
double
alongWay(const AxisPlace& from, const AxisPlace& to, const std::array<double, 6>& limits)
{
  double linear = 0.0, rotary = 0.0, longest = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double way = std::abs(to[i] - from[i]);
    (i < 3 ? linear : rotary) += way * way;
    if (way > 0.0)
      longest = std::max(longest, way / limits[i]);
  }
  return longest > 0.0 ? std::sqrt(linear > 0.0 ? linear : rotary) / longest : 0.0;
}

/** Moves as LinuxCNC's task gives them to the planner: straight runs of X Y Z joined by the naive CAM detector. */
class Feeder {
public:
  Feeder(const std::vector<CanonicalMotion>& motions, const LinuxCNCAxes& axes, double tolerance)
  : motions_(motions), axes_(axes), tolerance_(tolerance)
  {}

  bool isEmpty() const { return next_ >= motions_.size(); }

  linuxcnc_line take()
  {
    std::size_t last = next_;
    while (last + 1 < motions_.size() && last - next_ < most_joined && joins(last + 1))
      ++last;
    const AxisPlace &from = motions_[next_ - 1].xyzabc, &to = motions_[last].xyzabc;
    linuxcnc_line line{};
    line.id = static_cast<int>(last);
    line.rapid = motions_[last].rapid ? 1 : 0;
    std::copy(to.begin(), to.end(), line.to);
    line.largest_velocity = alongWay(from, to, axes_.velocity);
    line.velocity = line.rapid ? line.largest_velocity : std::min(line.largest_velocity, motions_[last].feed / 60.0);
    line.acceleration = alongWay(from, to, axes_.acceleration);
    line.tolerance = tolerance_;
    next_ = last + 1;
    return line;
  }

private:
  /** Motions from the next on up to \p last are one line within the tolerance. */
  bool joins(std::size_t last) const
  {
    const AxisPlace &from = motions_[next_ - 1].xyzabc, &to = motions_[last].xyzabc;
    if (!(tolerance_ > 0.0) || motions_[last].rapid || motions_[next_].rapid || motions_[last].feed != motions_[next_].feed ||
        !std::equal(from.begin() + 3, from.end(), to.begin() + 3) ||
        !std::equal(from.begin() + 3, from.end(), motions_[next_].xyzabc.begin() + 3))
      return false;
    const Eigen::Vector3d a(from[0], from[1], from[2]), way = Eigen::Vector3d(to[0], to[1], to[2]) - a;
    const double square = way.squaredNorm();
    for (std::size_t i = next_; square > 0.0 && i < last; ++i) {
      const Eigen::Vector3d off = Eigen::Vector3d(motions_[i].xyzabc[0], motions_[i].xyzabc[1], motions_[i].xyzabc[2]) - a;
      const double share = off.dot(way) / square;
      if (share < 0.0 || share > 1.0 || (off - share * way).norm() > tolerance_)
        return false;
    }
    return square > 0.0;
  }

  const std::vector<CanonicalMotion>& motions_;
  const LinuxCNCAxes& axes_;
  double tolerance_;
  std::size_t next_ = 1;
};

} // namespace

bool
hasLinuxCNCPlanner()
{
  return linuxcnc_planner_built() != 0 && std::filesystem::exists(module_file);
}

LinuxCNCTime
runLinuxCNC(const std::vector<CanonicalMotion>& motions, const LinuxCNCAxes& axes, double tolerance)
{
  LinuxCNCTime time;
  time.ends.assign(motions.size(), 0.0);
  linuxcnc_setup setup{};
  setup.cycle = cycle;
  std::copy(axes.velocity.begin(), axes.velocity.end(), setup.velocity);
  std::copy(axes.acceleration.begin(), axes.acceleration.end(), setup.acceleration);
  setup.largest_velocity = setup.largest_acceleration = 1e9;
  const std::unique_ptr<linuxcnc_planner, void (*)(linuxcnc_planner*)> planner(
      linuxcnc_planner_new(module_file, &setup, motions.front().xyzabc.data()), linuxcnc_planner_delete);
  if (!planner) {
    time.fault = "LinuxCNC's planner cannot be loaded";
    return time;
  }
  Feeder feeder(motions, axes, tolerance);
  std::size_t reached = 1; // motions that have begun
  AxisPlace place{};
  for (long cycles = 1; time.fault.empty(); ++cycles) {
    if (cycles > most_cycles)
      time.fault = "it does not end";
    while (!feeder.isEmpty() && linuxcnc_planner_queued(planner.get()) < most_queued) {
      const linuxcnc_line line = feeder.take();
      if (linuxcnc_planner_add(planner.get(), &line) < 0)
        time.fault = "motion " + std::to_string(line.id) + " is refused";
    }
    const int running = linuxcnc_planner_cycle(planner.get(), place.data());
    const double now = static_cast<double>(cycles) * cycle;
    for (const std::size_t begun = running < 0 ? motions.size() : static_cast<std::size_t>(running); reached < begun; ++reached)
      time.ends[reached] = now;
    if (running < 0) {
      time.seconds = now;
      break;
    }
  }
  for (std::size_t i = 0; i < 6 && time.fault.empty(); ++i)
    if (std::abs(place[i] - motions.back().xyzabc[i]) > 1e-6)
      time.fault = "the last place is not reached";
  return time;
}

} // namespace pcl_spiral::test
