// SPDX-License-Identifier: BSD-3-Clause
// Earlier outputs after a run is killed, ended, or has no disk space: each file is complete, the old or the new one.
#include <pcl_spiral/io/toolpath_reader.h>

#include "cap_scan.h"
#include "run_program.h"
#include "support/sanitizers.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/mount.h>

#include <algorithm>
#include <map>
#include <random>

namespace interruption_test {

namespace fs = std::filesystem;

namespace {

const std::string program = PCL_SPIRAL_TOOLPATH_PROGRAM;
using Arguments = std::vector<std::string>;
using Contents = std::map<std::string, std::string>; ///< of files, by name

/** Every kind of output except those with pictures, which need a display. */
const Arguments plain{"a.csv", "a.pcd", "a.ply", "a.vtp", "a.json"};

Arguments
call(const Arguments& outputs, const std::string& scallop, const std::string& folder = "")
{
  Arguments words{"cap.xyz", "--tool-radius", "3", "--scallop", scallop};
  for (const std::string& output : outputs) {
    words.push_back("-o");
    words.push_back(folder + output);
  }
  return words;
}

class Interruption : public ::testing::Test {
protected:
  void SetUp() override { writeText(folder_.path("cap.xyz"), capScan(1000)); }

  RunResult run(const Arguments& arguments) { return endOf(startProgram(program, arguments, folder_), folder_); }

  /** The files of a folder that are not scans: visible files, or hidden files. */
  Contents contents(bool hidden = false, const std::string& below = "") const
  {
    Contents result;
    for (const auto& entry : fs::directory_iterator(folder_.root() / below)) {
      const std::string name = entry.path().filename().string();
      if (entry.is_regular_file() && name != "cap.xyz" && (name[0] == '.') == hidden && name != ".stdout" && name != ".stderr")
        result[name] = readText(entry.path().string());
    }
    return result;
  }

  /** Reports of two runs differ in their times: a report is complete if it can be read to its end. */
  void expectWhole(const std::string& name, const std::string& text) const
  {
    const std::string extension = fs::path(name).extension().string();
    if (extension == ".json")
      EXPECT_TRUE(nlohmann::json::accept(text)) << name;
    else if (extension == ".html")
      EXPECT_NE(text.find("</html>"), std::string::npos) << name;
    else if (extension == ".png")
      EXPECT_NE(text.find("IEND"), std::string::npos) << name;
    else
      FAIL() << name << " is neither the old nor the new one, " << text.size() << " bytes";
  }

  /** Kills runs that overwrite \p outputs, from the share \p from of their time on. */
  void expectWholeAfterKills(const Arguments& outputs, int kills, double from)
  {
    ASSERT_EQ(run(call(outputs, "0.02")).code, 0);
    const Contents old = contents();
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run(call(outputs, "0.05")).code, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
    const Contents renewed = contents();
    for (const auto& [name, text] : old)
      writeText(folder_.path(name), text);

    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(from, 1.05);
    for (int i = 0; i < kills; ++i) {
      const pid_t process = startProgram(program, call(outputs, "0.05"), folder_);
      std::this_thread::sleep_for(share(random) * whole);
      ::kill(process, SIGKILL);
      endOf(process, folder_);
      const Contents now = contents();
      EXPECT_EQ(now.size(), old.size());
      for (const auto& [name, text] : now)
        if (text != old.at(name) && text != renewed.at(name))
          expectWhole(name, text);
    }
    EXPECT_EQ(run(call(outputs, "0.05")).code, 0);
    EXPECT_TRUE(contents(true).empty()) << contents(true).begin()->first << " stays after the next run";
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(Interruption, AKillAtAnyMomentLeavesWholeFiles)
{
  expectWholeAfterKills(plain, 20, 0.3);
}

TEST_F(Interruption, AKillWhilePicturesAreMadeLeavesWholeFiles)
{
  if (!std::getenv("DISPLAY"))
    GTEST_SKIP() << "no display here, and so no pictures";
  expectWholeAfterKills({"a.csv", "a.html", "a.png"}, 4, 0.7);
}

TEST_F(Interruption, WhatAKilledRunLeftIsTakenAwayByTheNext)
{
  pid_t gone = ::fork();
  if (gone == 0)
    ::_exit(0);
  ::waitpid(gone, nullptr, 0);
  const std::string number = std::to_string(gone), own = std::to_string(::getpid());
  const std::string stale = ".a.writing-" + number + ".csv", link = ".a.earlier-" + number + ".csv";
  const Arguments kept{".a.writing-" + own + ".csv", ".b.writing-" + number + ".csv", ".a.writing-" + number + ".ply", ".a.writing-.csv",
                       ".a.writing-12x.csv"};
  for (const std::string& name : kept)
    writeText(folder_.path(name), "not of a killed run of a.csv");
  writeText(folder_.path(stale), "half");
  writeText(folder_.path(link), "earlier");
  ASSERT_EQ(run(call({"a.csv"}, "0.05")).code, 0);
  EXPECT_FALSE(fs::exists(folder_.path(stale)));
  EXPECT_FALSE(fs::exists(folder_.path(link)));
  for (const std::string& name : kept)
    EXPECT_TRUE(fs::exists(folder_.path(name))) << name;
}

TEST_F(Interruption, AskedToEndItEndsSoonAndLeavesAllAsItWas)
{
  ASSERT_EQ(run(call(plain, "0.05")).code, 0);
  const Contents old = contents();
  writeText(folder_.path("cap.xyz"), capScan(60000));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t process = startProgram(program, call(plain, "0.00001"), folder_);
    ASSERT_TRUE(waitUntilCaught(process, signal));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ASSERT_EQ(::kill(process, signal), 0);
    EXPECT_EQ(endOf(process, folder_).code, 1);
    EXPECT_EQ(contents(), old);
    EXPECT_TRUE(contents(true).empty());
  }
}

TEST_F(Interruption, WithoutRoomNothingChanges)
{
  if (sanitized)
    GTEST_SKIP() << "clang's OpenMP holds shared memory in files, which the limit cuts short";
  ASSERT_EQ(run(call(plain, "0.05")).code, 0);
  const Contents old = contents();
  std::size_t largest = 0;
  for (const auto& [name, text] : old)
    largest = std::max(largest, text.size());
  for (const double share : {0.001, 0.3, 0.99}) {
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit{static_cast<rlim_t>(share * static_cast<double>(largest)), before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const pid_t process = startProgram(program, call(plain, "0.05"), folder_);
    ::setrlimit(RLIMIT_FSIZE, &before);
    const RunResult result = endOf(process, folder_);
    EXPECT_EQ(result.code, 1) << share << result.err;
    EXPECT_NE(result.err.find("cannot be written"), std::string::npos) << result.err;
    EXPECT_EQ(contents(), old);
    EXPECT_TRUE(contents(true).empty());
  }
}

TEST_F(Interruption, OnAFullDiskEveryKindSaysSoAndNothingChanges)
{
  const std::string disk = folder_.path("disk");
  fs::create_directory(disk);
  if (::mount("none", disk.c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "no small disk can be made here: that takes an administrator";
  for (const std::string& name : plain) {
    writeText(disk + "/" + name, "earlier");
    const RunResult result = run(call({name}, "0.0005", "disk/"));
    const bool small = fs::path(name).extension() == ".json";
    EXPECT_EQ(result.code, small ? 0 : 1) << name << result.err;
    if (small)
      continue;
    EXPECT_NE(result.err.find("disk/" + name), std::string::npos) << result.err;
    EXPECT_EQ(contents(false, "disk").at(name), "earlier");
    EXPECT_TRUE(contents(true, "disk").empty());
  }
  ::umount(disk.c_str());
}

TEST_F(Interruption, PlacesThatCannotBeWrittenAreRefusedBeforeAnyWork)
{
  fs::create_directory(folder_.path("folder.csv"));
  const auto refused = [this](const std::string& output, const std::string& words, int code) {
    const RunResult result = run(call({output}, "0.05"));
    EXPECT_EQ(result.code, code) << output;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  refused("missing/a.csv", "does not exist; create it first", 1);
  refused("folder.csv", "is not a file", 1);
  refused("cap.xyz/a.csv", "is not a folder", 1);
  fs::create_symlink("cap.xyz", folder_.path("link.csv"));
  refused("link.csv", "is the scan itself", 2);
  if (::getuid() != 0) { // root may write everywhere
    fs::create_directory(folder_.path("locked"));
    fs::permissions(folder_.path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
    refused("locked/a.csv", "choose a folder you may write to", 1);
  }
}

} // namespace interruption_test
