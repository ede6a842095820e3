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

TEST(ProgramEnvironment, KeepsWhatTheUserGaveTheLibraryOfC)
{
  const Variable policy("OMP_WAIT_POLICY", nullptr), count("GOMP_SPINCOUNT", nullptr),
      tunables("GLIBC_TUNABLES", "glibc.malloc.arena_max=1");
  EXPECT_FALSE(isWaitPolicyGiven());
  ASSERT_TRUE(setProgramEnvironment());
  EXPECT_TRUE(isWaitPolicyGiven());
  EXPECT_STREQ(std::getenv("OMP_WAIT_POLICY"), "passive");
  EXPECT_STREQ(std::getenv("GLIBC_TUNABLES"), "glibc.malloc.arena_max=1:glibc.malloc.hugetlb=1");
}

} // namespace
} // namespace pcl_spiral
