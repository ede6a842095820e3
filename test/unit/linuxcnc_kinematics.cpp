// SPDX-License-Identifier: BSD-3-Clause
// The kinematics against LinuxCNC's own modules for trunnion tables; the modules are loaded here with a replacement
// for their HAL.
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "support/test_machines.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdarg>
#include <cstdio>
#include <deque>
#include <map>
#include <random>
#include <vector>

namespace {

std::map<std::string, double*> pins;  ///< by name without the name of the module
std::deque<std::vector<double>> room; ///< memory given to the modules

void*
given(std::size_t bytes)
{
  room.emplace_back(bytes / sizeof(double) + 1, 0.0);
  return room.back().data();
}

} // namespace

// Functions that the modules need from the process that loads them.
extern "C" {
int
hal_init(const char*)
{
  return 1;
}
int
hal_exit(int)
{
  return 0;
}
int
hal_ready(int)
{
  return 0;
}
void*
hal_malloc(long size)
{
  return given(static_cast<std::size_t>(size));
}
int
hal_pin_bit_new(const char*, int, void** data, int)
{
  *data = given(sizeof(double));
  return 0;
}
int
hal_pin_s32_new(const char*, int, void** data, int)
{
  *data = given(sizeof(double));
  return 0;
}
int
hal_pin_float_newf(int, double** data, int, const char* format, ...)
{
  char name[256];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(name, sizeof name, format, arguments);
  va_end(arguments);
  *data = static_cast<double*>(given(sizeof(double)));
  const std::string all = name;
  pins[all.substr(all.find('.') + 1)] = *data;
  return 0;
}
void
rtapi_print(const char*, ...)
{}
void
rtapi_print_msg(int, const char*, ...)
{}
}

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

/** LinuxCNC's layout of a position. */
struct EmcPosition {
  double x, y, z, a, b, c, u, v, w;
};

/** One of LinuxCNC's modules; joints are X, Y, Z, tilt, C. */
class Module {
public:
  explicit Module(const std::string& name)
  {
    handle_ = dlopen(("/usr/lib/linuxcnc/modules/" + name + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr)
      return;
    pins.clear();
    reinterpret_cast<int (*)()>(dlsym(handle_, "rtapi_app_main"))();
  }
  ~Module()
  {
    if (handle_ != nullptr)
      dlclose(handle_);
  }
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  bool isThere() const { return handle_ != nullptr; }
  EmcPosition forward(const std::array<double, 5>& joints) const
  {
    double all[16] = {joints[0], joints[1], joints[2], joints[3], joints[4]};
    EmcPosition position{};
    unsigned long flags = 0, back = 0;
    reinterpret_cast<int (*)(const double*, EmcPosition*, const unsigned long*, unsigned long*)>(dlsym(handle_, "kinematicsForward"))(
        all, &position, &flags, &back);
    return position;
  }

private:
  void* handle_;
};

/** \p sense: of the module's angles, -1 if the machine counts them the other way. */
void
expectTheSame(const Machine& machine, const std::string& name, const Eigen::Vector3d& offset, double sense = 1.0)
{
  const Module module(name);
  ASSERT_TRUE(module.isThere()) << name << " of LinuxCNC is missing; run cmake/install_dependencies.sh test";
  const Eigen::Vector3d rot = machine.rotary[0].point;
  for (const auto& [pin, value] : std::map<std::string, double>{{"x-rot-point", rot.x()},
                                                                {"y-rot-point", rot.y()},
                                                                {"z-rot-point", rot.z()},
                                                                {"x-offset", offset.x()},
                                                                {"y-offset", offset.y()},
                                                                {"z-offset", offset.z()},
                                                                {"tool-offset", machine.tool_length}}) {
    ASSERT_EQ(pins.count(pin), 1U) << pin;
    *pins[pin] = value;
  }
  const Kinematics kinematics(machine);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-200.0, 200.0), tilt(-1.5, 1.5), turns(-300.0, 300.0);
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d tip(place(random), place(random), place(random));
    const RotaryAngles angles{turns(random), tilt(random)};
    const Eigen::Vector3d gauge = kinematics.gaugePoint(kinematics.programmed(tip, angles));
    const double degrees = sense * 180.0 / M_PI;
    const EmcPosition found = module.forward({gauge.x(), gauge.y(), gauge.z(), angles.second * degrees, angles.first * degrees});
    const Eigen::Vector3d back = Eigen::Vector3d(found.x, found.y, found.z - machine.tool_length) - machine.work_zero;
    largest = std::max(largest, (back - tip).norm());
  }
  EXPECT_LT(largest, 1e-9);
}

} // namespace

TEST(LinuxCNCKinematics, XyzacTrunnionTable)
{
  Machine machine = testMachines()[0];
  const Eigen::Vector3d offset(0.0, 20.0, 10.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzac-trt-kins", offset);
}

TEST(LinuxCNCKinematics, XyzbcTrunnionTable)
{
  Machine machine = testMachines()[1];
  const Eigen::Vector3d offset(15.0, 0.0, -8.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzbc-trt-kins", offset);
}

// Newer modules have a pin conventional-directions, which Debian 12's have not: where it is set, every sine of an angle has the other
// sign, and a positive angle turns the table left-handed (LinuxCNC's pull request 3482). That is these modules at the negative angles.
TEST(LinuxCNCKinematics, WithConventionalDirectionsTheTablesTurnTheOtherWay)
{
  Machine machine = testMachines()[5];
  EXPECT_EQ(machine.rotary[0].direction, -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(machine.rotary[1].direction, -Eigen::Vector3d::UnitX());
  Eigen::Vector3d offset(0.0, 20.0, 10.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzac-trt-kins", offset, -1.0);
  machine = testMachines()[1];
  for (RotaryAxis& axis : machine.rotary)
    axis.direction *= -1.0;
  offset = {15.0, 0.0, -8.0};
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzbc-trt-kins", offset, -1.0);
}
