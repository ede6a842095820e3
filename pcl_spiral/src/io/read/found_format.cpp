// SPDX-License-Identifier: BSD-3-Clause
#include "found_format.h"

#include "io/byte_file.h"
#include "point_table.h"
#include "text_encoding.h"
#include "text_scan.h"

#include "common/shell_word.h"
#include <pcl_spiral/io/file_error.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t looked_at = 64; ///< lines

/** ".obj" if one of the first lines is a vertex, ".xyz" for other text; empty if it is none. */
std::string
formatOfText(std::string_view bytes)
{
  if (bytes.substr(0, 1024).find('\0') != std::string_view::npos)
    return {};
  LineScanner lines(bytes);
  for (std::string_view line; lines.number() < looked_at && lines.next(line);)
    if (line.substr(0, 2) == "v " || line.substr(0, 2) == "v\t")
      return ".obj";
  return ".xyz";
}

/** Empty if it is none that is known. */
std::string
formatOfContent(std::string_view bytes)
{
  const std::string_view text = bytes.substr(utf8Mark(bytes));
  const auto begins = [](std::string_view in, std::string_view with) { return in.substr(0, with.size()) == with; };
  if (begins(text, "ply\n") || begins(text, "ply\r") || begins(text, "ply "))
    return ".ply";
  if (begins(bytes, "LASF"))
    return ".las";
  if (begins(text, "# .PCD") || begins(text, "VERSION") || begins(text, "FIELDS"))
    return ".pcd";
  return isStl(bytes) ? ".stl" : formatOfText(bytes);
}

} // namespace

bool
isNameless(const std::string& file)
{
  return isStream(file) || file.rfind("/dev/", 0) == 0 || file.rfind("/proc/", 0) == 0;
}

std::string
formatOf(const std::string& file, std::string_view bytes, const std::vector<std::string>& known)
{
  const auto isKnown = [&known](const std::string& extension) { return std::find(known.begin(), known.end(), extension) != known.end(); };
  if (const std::string extension = lowerExtension(file); isKnown(extension))
    return extension;
  refuseWideText(file, bytes);
  const std::string found = formatOfContent(bytes);
  if (isKnown(found))
    return found;
  std::string list;
  for (const std::string& extension : known)
    list += (list.empty() ? "" : " ") + extension;
  throw FileError(file, Diagnostic("has no name with an extension, and its content is none of ", list,
                                   "; write it into a file with its extension: cat ", shellFile(file), " > part", known.front()));
}

} // namespace pcl_spiral
