// SPDX-License-Identifier: BSD-3-Clause
#include "byte_file.h"

#include "common/shell_word.h"
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

namespace fs = std::filesystem;

namespace pcl_spiral {
namespace {

/** What is left in a stream. */
std::string
allBytes(std::FILE* stream)
{
  std::string bytes;
  std::array<char, 65536> piece{};
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), stream))
    bytes.append(piece.data(), got);
  return bytes;
}

/** \throw FileError if there are fewer than \p size */
std::string
sizedBytes(const std::string& file, std::FILE* stream, std::size_t size)
{
  std::string bytes(size, '\0');
  const std::size_t got = std::fread(bytes.data(), 1, size, stream);
  if (got != size)
    throw FileError(file, Diagnostic("cannot be read: ", std::string(std::strerror(errno)), " after byte ", got));
  return bytes;
}

} // namespace

ByteFile::ByteFile(std::string file) : file_(std::move(file)), stream_(std::fopen(file_.c_str(), "wb"))
{
  if (!stream_)
    throw FileError(file_, Diagnostic("cannot be written: ", std::string(std::strerror(errno))));
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
    throw FileError(file_, Diagnostic("cannot be written: ", std::string(std::strerror(errno))));
}

void
ByteFile::close()
{
  std::FILE* const stream = stream_;
  stream_ = nullptr;
  if (std::fclose(stream) != 0)
    throw FileError(file_, Diagnostic("cannot be written: ", std::string(std::strerror(errno))));
}

bool
isStream(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string
readBytes(const std::string& file)
{
  if (isStream(file))
    throw FileError(file, Diagnostic("is a pipe, and this file is read more than once; write it into a file first: cat ", shellFile(file),
                                     " > FILE, and give FILE"));
  return readStream(file);
}

std::string
readStream(const std::string& file)
{
  std::error_code error;
  if (!fs::exists(file, error))
    throw FileError(file, "there is no such file; check the name and the folder");
  if (fs::is_directory(file, error))
    throw FileError(file, "this is a folder; give a file in it");
  const bool stream = isStream(file);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!opened)
    throw FileError(file, Diagnostic("cannot be read: ", std::string(std::strerror(errno))));
  const std::uintmax_t size = stream ? 0 : fs::file_size(file, error);
  std::string bytes = stream ? allBytes(opened.get()) : sizedBytes(file, opened.get(), error ? 0 : static_cast<std::size_t>(size));
  if (std::ferror(opened.get()) != 0)
    throw FileError(file, Diagnostic("cannot be read: ", std::string(std::strerror(errno)), " after byte ", bytes.size()));
  if (bytes.empty())
    throw FileError(file, stream ? "is a pipe that gave nothing (0 bytes); look at the program that writes into it"
                                 : "is empty (0 bytes); export or make it again");
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
