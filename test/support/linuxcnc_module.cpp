// SPDX-License-Identifier: BSD-3-Clause
#include "support/linuxcnc_module.h"

#include <dlfcn.h>

#include <cstdarg>
#include <cstdio>
#include <deque>
#include <map>
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

namespace pcl_spiral::test {
namespace {

/** LinuxCNC's layout of a position. */
struct EmcPosition {
  double x, y, z, a, b, c, u, v, w;
};

template <typename Function>
Function
functionOf(void* handle, const char* name)
{
  return reinterpret_cast<Function>(dlsym(handle, name));
}

} // namespace

LinuxCNCModule::LinuxCNCModule(const std::string& name)
: handle_(dlopen(("/usr/lib/linuxcnc/modules/" + name + ".so").c_str(), RTLD_NOW | RTLD_LOCAL))
{
  if (handle_ == nullptr)
    return;
  pins.clear();
  functionOf<int (*)()>(handle_, "rtapi_app_main")();
}

LinuxCNCModule::~LinuxCNCModule()
{
  if (handle_ != nullptr)
    dlclose(handle_);
}

std::string
LinuxCNCModule::set(const Eigen::Vector3d& point, const Eigen::Vector3d& offset, double tool_length) const
{
  for (const auto& [pin, value] : std::map<std::string, double>{{"x-rot-point", point.x()},
                                                                {"y-rot-point", point.y()},
                                                                {"z-rot-point", point.z()},
                                                                {"x-offset", offset.x()},
                                                                {"y-offset", offset.y()},
                                                                {"z-offset", offset.z()},
                                                                {"tool-offset", tool_length}}) {
    if (pins.count(pin) == 0)
      return pin;
    *pins[pin] = value;
  }
  return {};
}

Eigen::Vector3d
LinuxCNCModule::forward(const std::array<double, 5>& joints) const
{
  double all[16] = {joints[0], joints[1], joints[2], joints[3], joints[4]};
  EmcPosition position{};
  unsigned long flags = 0, back = 0;
  functionOf<int (*)(const double*, EmcPosition*, const unsigned long*, unsigned long*)>(handle_, "kinematicsForward")(all, &position,
                                                                                                                       &flags, &back);
  return {position.x, position.y, position.z};
}

std::array<double, 5>
LinuxCNCModule::inverse(const Eigen::Vector3d& xyz, char letter, double tilt, double c) const
{
  double all[16] = {};
  const EmcPosition position{xyz.x(), xyz.y(), xyz.z(), letter == 'A' ? tilt : 0.0, letter == 'B' ? tilt : 0.0, c, 0.0, 0.0, 0.0};
  unsigned long flags = 0, back = 0;
  functionOf<int (*)(const EmcPosition*, double*, const unsigned long*, unsigned long*)>(handle_, "kinematicsInverse")(&position, all,
                                                                                                                       &flags, &back);
  return {all[0], all[1], all[2], all[3], all[4]};
}

} // namespace pcl_spiral::test
