// SPDX-License-Identifier: BSD-3-Clause
#include "file_names.h"
#include "terminal.h"

#include "common/shell_word.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace fs = std::filesystem;

std::string
extensionOf(const std::string& file)
{
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string
besideName(const std::string& file, const std::string& suffix)
{
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + suffix + path.extension().string())).string();
}

void
requireNoInput(const std::string& output, const std::vector<InputName>& inputs)
{
  std::error_code error;
  for (const auto& [what, file] : inputs)
    if (!file.empty() && fs::equivalent(output, file, error))
      throw UsageError(pcl_spiral::Diagnostic("-o ", output, ": this is ", what, " itself, an input; give the output another name"));
}

std::string
commandLine(int argc, const char* const* argv)
{
  std::string line = argc > 0 ? fs::path(argv[0]).filename().string() : std::string();
  for (int i = 1; i < argc; ++i)
    line += " " + pcl_spiral::shellWord(argv[i]);
  return line;
}
