// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/common/impl/stage_clock.h>

#include "support/sanitizers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

namespace stage_clock_test {

using namespace pcl_spiral;

namespace {

constexpr std::size_t megabyte = 1000000;

/** Memory that was written to, and so is really in use. */
std::unique_ptr<char[]>
touched(std::size_t bytes)
{
  std::unique_ptr<char[]> memory(new char[bytes]);
  for (std::size_t i = 0; i < bytes; i += 512)
    reinterpret_cast<volatile char&>(memory[i]) = 1;
  return memory;
}

} // namespace

TEST(StageClock, TimesOneStageAfterTheOther)
{
  std::vector<StageCost> stages;
  const auto begin = std::chrono::steady_clock::now();
  StageClock clock(stages);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  clock.end("long");
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  clock.end("short");
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].name, "long");
  EXPECT_EQ(stages[1].name, "short");
  EXPECT_GE(stages[0].seconds, 0.030);
  EXPECT_GE(stages[1].seconds, 0.005);
  EXPECT_LE(stages[0].seconds + stages[1].seconds, all.count());
}

TEST(StageClock, MemoryOfAStageIsWhatItHoldsAndThePeakWhatItHeld)
{
  if (sanitized)
    GTEST_SKIP() << "what is freed is kept";
  std::vector<StageCost> stages;
  StageClock clock(stages);
  clock.end("before");
  auto held = touched(64 * megabyte);
  {
    const auto freed = touched(64 * megabyte);
  }
  clock.end("held");
  held.reset();
  clock.end("freed");
  const MemoryUse before = stages[0].memory, with = stages[1].memory, after = stages[2].memory;
  ASSERT_GT(before.resident, 0U) << "/proc/self/status tells";
  EXPECT_NEAR(static_cast<double>(with.resident - before.resident), 64e6, 4e6);
  EXPECT_NEAR(static_cast<double>(with.peak - before.resident), 128e6, 8e6);
  EXPECT_NEAR(static_cast<double>(after.resident), static_cast<double>(before.resident), 4e6);
  EXPECT_EQ(after.peak, with.peak);
  for (const StageCost& stage : stages)
    EXPECT_LE(stage.memory.resident, stage.memory.peak + megabyte);
}

} // namespace stage_clock_test
