// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A folder for one test, removed at its end.
 */
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/** Makes an empty folder, and removes it with its content. */
class ScratchFolder {
public:
  ScratchFolder()
  {
    static std::atomic<int> made{0};
    root_ = std::filesystem::temp_directory_path() / ("pcl_spiral_test_" + std::to_string(::getpid()) + "_" + std::to_string(made++));
    std::filesystem::create_directories(root_);
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& root() const { return root_; }
  std::string path(const std::string& name) const { return (root_ / name).string(); }
  /** Number of entries, with hidden ones. */
  std::size_t count() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(root_), std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path root_;
};

inline void
writeText(const std::string& file, const std::string& text)
{
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string
readText(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}
