// SPDX-License-Identifier: BSD-3-Clause
// The trials of remedies find what is wrong with a message: a remedy that does not help, goes round in circles, or is not tried.
#include "support/remedies.h"

#include <gtest/gtest.h>

namespace remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

/** A job with two settings: it is refused while either is on. */
struct Job {
  bool deep = true, wide = false;
  void setQuiet(bool) {}
};

Said
say(Job& job)
{
  if (job.deep)
    return {{StatusCode::Failed, "too deep: go up ({setDeep})"}, {}};
  if (job.wide)
    return {{StatusCode::Failed, "too wide: go down ({setWide})"}, {}};
  return {Status::success(), {"a warning ({setWide})"}};
}

std::vector<std::string>
faultsOf(const std::vector<Remedy<Job>>& remedies, const char* words = "too deep")
{
  const Change<Job> nothing = [](Job&) {};
  return test::faultsOf({remediedJob<Job>(words, say, nothing, remedies)});
}

const auto up = [](Job& job) { job.deep = false; };
const auto across = [](Job& job) { job.deep = false, job.wide = true; };
const auto nowhere = [](Job&) {};

} // namespace

TEST(RemediesOf, AJobThatARemedyHelpsHasNoFault)
{
  EXPECT_EQ(faultsOf({{"setDeep", up}}), std::vector<std::string>());
}

TEST(RemediesOf, WhatIsWrongIsFound)
{
  const auto fault = [](const std::vector<Remedy<Job>>& remedies, const char* words, const char* expected) {
    const std::vector<std::string> faults = faultsOf(remedies, words);
    ASSERT_FALSE(faults.empty()) << expected;
    EXPECT_NE(faults.front().find(expected), std::string::npos) << faults.front();
  };
  fault({{"setDeep", nowhere}}, "too deep", "does not help");
  fault({{"setDeep", across}}, "too deep", "does not help");
  fault({}, "too deep", "setDeep is named, but not tried");
  fault({{"setDeep", up}, {"setWide", up}}, "too deep", "setWide is tried, but not named");
  fault({{"setDeep", up}}, "too high", "does not come");
  EXPECT_EQ(faultsOf({{"setDeep", across, "too wide"}}), std::vector<std::string>()) << "a refusal that is meant to come";
  fault({{"setDeep", up, "too wide"}}, "too deep", "does not help");
}

TEST(RemediesOf, RemediesOfTwoCausesHaveAJobEach)
{
  const auto one = [](bool named) {
    return RemediedJob{"stuck",
                       [named] {
                         return Said{{StatusCode::Failed, named ? "stuck ({setA}, {setB})" : "stuck ({setB})"}, {}};
                       },
                       {}};
  };
  const auto done = [](const Diagnostic&) { return Said{Status::success(), {}}; };
  RemediedJob first = one(true), second = one(false);
  first.trials = {{"setA", done, ""}};
  EXPECT_EQ(test::faultsOf({first, second}).size(), 1U) << "setB";
  second.trials = {{"setB", done, ""}};
  EXPECT_EQ(test::faultsOf({first, second}), std::vector<std::string>());
}

} // namespace remedies_test
