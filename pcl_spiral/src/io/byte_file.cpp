// SPDX-License-Identifier: BSD-3-Clause
#include "byte_file.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl_spiral {

ByteFile::ByteFile(std::string file) : file_(std::move(file)), stream_(std::fopen(file_.c_str(), "wb"))
{
  if (!stream_)
    throw FileError(file_, std::string("cannot be written: ") + std::strerror(errno));
}

ByteFile::~ByteFile()
{
  if (stream_)
    std::fclose(stream_);
}

void
ByteFile::write(std::string_view bytes)
{
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size())
    throw FileError(file_, std::string("cannot be written: ") + std::strerror(errno));
}

void
ByteFile::close()
{
  std::FILE* const stream = stream_;
  stream_ = nullptr;
  if (std::fclose(stream) != 0)
    throw FileError(file_, std::string("cannot be written: ") + std::strerror(errno));
}

std::string
readBytes(const std::string& file)
{
  std::error_code error;
  if (!fs::exists(file, error))
    throw FileError(file, "there is no such file; check the name and the folder");
  if (fs::is_directory(file, error))
    throw FileError(file, "this is a folder; give a file in it");
  std::FILE* const stream = std::fopen(file.c_str(), "rb");
  if (!stream)
    throw FileError(file, std::string("cannot be read: ") + std::strerror(errno));
  std::string bytes;
  const auto expected = fs::file_size(file, error);
  bytes.resize(error ? 0 : static_cast<std::size_t>(expected));
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), stream);
  const bool failed = std::ferror(stream) != 0;
  std::fclose(stream);
  if (failed || got != bytes.size())
    throw FileError(file, std::string("cannot be read: ") + std::strerror(errno) + " after byte " + std::to_string(got));
  if (bytes.empty())
    throw FileError(file, "is empty (0 bytes); export or make it again");
  return bytes;
}

std::string
lowerExtension(const std::string& file)
{
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

} // namespace pcl_spiral
