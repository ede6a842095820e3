// SPDX-License-Identifier: BSD-3-Clause
#include "text_encoding.h"

#include "common/shell_word.h"
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <filesystem>

namespace pcl_spiral {
namespace {

constexpr std::size_t looked_at = 64; ///< bytes of a file without a byte order mark

/** Whether every second byte, from \p first, is zero and the others are ASCII: text in UTF-16 without a byte order mark. */
bool
hasZeroes(std::string_view bytes, std::size_t first)
{
  const std::size_t size = std::min(bytes.size(), looked_at) / 2 * 2;
  for (std::size_t i = 0; i < size; ++i)
    if (i % 2 == first ? bytes[i] != '\0' : bytes[i] <= '\0')
      return false;
  return size >= 8;
}

/** Name of the encoding for iconv; null for text of single bytes. */
const char*
wideEncoding(std::string_view bytes)
{
  const auto begins = [bytes](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
  if (begins(std::string_view("\xFF\xFE\0\0", 4)) || begins(std::string_view("\0\0\xFE\xFF", 4)))
    return "UTF-32";
  if (begins("\xFF\xFE") || begins("\xFE\xFF"))
    return "UTF-16";
  return hasZeroes(bytes, 1) ? "UTF-16LE" : hasZeroes(bytes, 0) ? "UTF-16BE" : nullptr;
}

} // namespace

void
refuseWideText(const std::string& file, std::string_view bytes)
{
  const char* const encoding = wideEncoding(bytes);
  if (!encoding)
    return;
  const std::filesystem::path path(file);
  const std::string converted = (path.parent_path() / (path.stem().string() + "_utf8" + path.extension().string())).string();
  throw FileError(file, Diagnostic("is text in ", encoding, ", and text in UTF-8 is needed; convert it: iconv -f ", encoding, " -t UTF-8 ",
                                   shellFile(file), " > ", shellFile(converted)));
}

} // namespace pcl_spiral
