// SPDX-License-Identifier: BSD-3-Clause
#include "common/program_environment.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace pcl_spiral {
namespace {

/** A variable of the environment for as long as this lives, and after it as it was. */
class Variable {
public:
  Variable(const char* name, const char* value) : name_(name), was_(std::getenv(name) ? std::getenv(name) : ""), was_set_(std::getenv(name))
  {
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { was_set_ ? setenv(name_, was_.c_str(), 1) : unsetenv(name_); }

private:
  const char* name_;
  std::string was_;
  bool was_set_;
};

TEST(ProgramEnvironment, KeepsWhatTheUserChose)
{
  const Variable policy("OMP_WAIT_POLICY", nullptr), count("GOMP_SPINCOUNT", nullptr),
      tunables("GLIBC_TUNABLES", "glibc.malloc.arena_max=1");
  EXPECT_TRUE(setProgramEnvironment());
  EXPECT_STREQ(std::getenv("OMP_WAIT_POLICY"), "passive");
  EXPECT_STREQ(std::getenv("GLIBC_TUNABLES"), "glibc.malloc.hugetlb=1:glibc.malloc.arena_max=1");
  EXPECT_FALSE(setProgramEnvironment()) << "a program would start again without end";
  setenv("OMP_WAIT_POLICY", "active", 1);
  for (const char* pages : {"glibc.malloc.hugetlb=0", "glibc.malloc.arena_max=1:glibc.malloc.hugetlb=2"}) {
    setenv("GLIBC_TUNABLES", pages, 1);
    EXPECT_FALSE(setProgramEnvironment());
    EXPECT_STREQ(std::getenv("GLIBC_TUNABLES"), pages);
  }
  unsetenv("GLIBC_TUNABLES");
  EXPECT_TRUE(setProgramEnvironment()) << "a choice of how threads wait is none of pages";
  EXPECT_STREQ(std::getenv("OMP_WAIT_POLICY"), "active");
  EXPECT_STREQ(std::getenv("GLIBC_TUNABLES"), "glibc.malloc.hugetlb=1");
}

} // namespace
} // namespace pcl_spiral
