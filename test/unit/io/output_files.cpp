// SPDX-License-Identifier: BSD-3-Clause
// Outputs that are written all or none: content of the folder before, during and after.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace output_files_test {

namespace fs = std::filesystem;
using pcl_spiral::FileError;
using pcl_spiral::OutputFiles;

TEST(OutputFiles, AppearOnCommitAlone)
{
  const ScratchFolder folder;
  const std::string a = folder.path("a.csv"), b = folder.path("b.vtp");
  OutputFiles files({a, b});
  EXPECT_TRUE(fs::is_empty(folder.root())) << "checking leaves nothing behind";
  writeText(files.temporary(0), "new a");
  writeText(files.temporary(1), "new b");
  EXPECT_FALSE(fs::exists(a));
  files.commit();
  EXPECT_EQ(readText(a), "new a");
  EXPECT_EQ(readText(b), "new b");
  EXPECT_EQ(folder.count(), 2U);
}

TEST(OutputFiles, WithoutCommitLeaveTheFolderAsItWas)
{
  const ScratchFolder folder;
  const std::string a = folder.path("a.csv");
  writeText(a, "earlier");
  {
    OutputFiles files({a, folder.path("b.vtp")});
    writeText(files.temporary(0), "half");
  }
  EXPECT_EQ(readText(a), "earlier");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(OutputFiles, FailedCommitPutsEarlierFilesBack)
{
  const ScratchFolder folder;
  const std::string a = folder.path("a.csv"), b = folder.path("b.csv"), c = folder.path("c.csv");
  writeText(a, "earlier a");
  writeText(c, "earlier c");
  {
    OutputFiles files({a, b, c});
    writeText(files.temporary(0), "new a");
    writeText(files.temporary(1), "new b"); // the third is never written: its rename fails
    EXPECT_THROW(files.commit(), FileError);
  }
  EXPECT_EQ(readText(a), "earlier a");
  EXPECT_EQ(readText(c), "earlier c");
  EXPECT_FALSE(fs::exists(b));
  EXPECT_EQ(folder.count(), 2U);
}

TEST(OutputFiles, FollowLinksAndKeepThem)
{
  const ScratchFolder folder;
  writeText(folder.path("real.csv"), "earlier");
  fs::create_symlink(folder.path("real.csv"), folder.path("link.csv"));
  OutputFiles files({folder.path("link.csv")});
  writeText(files.temporary(0), "new");
  files.commit();
  EXPECT_TRUE(fs::is_symlink(folder.path("link.csv")));
  EXPECT_EQ(readText(folder.path("real.csv")), "new");
}

TEST(OutputFiles, RefusePathsThatCannotBeWritten)
{
  const ScratchFolder folder;
  fs::create_directory(folder.path("sub.csv"));
  writeText(folder.path("file"), "");
  EXPECT_THROW(OutputFiles({folder.path("nowhere/a.csv")}), FileError);
  EXPECT_THROW(OutputFiles({folder.path("sub.csv")}), FileError);
  EXPECT_THROW(OutputFiles({folder.path("file/a.csv")}), FileError);
  EXPECT_THROW(OutputFiles({"/proc/a.csv"}), FileError) << "a folder nobody may write to";
  EXPECT_THROW(OutputFiles({folder.path("a.csv"), folder.path("./a.csv")}), FileError);
}

} // namespace output_files_test
