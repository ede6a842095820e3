// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>

#include <fcntl.h>
#include <signal.h> // NOLINT(modernize-deprecated-headers): POSIX, for kill
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl_spiral {
namespace {

/** The file of a path: absolute, with links followed, so that a rename replaces the file and not the link.
 */
fs::path
resolved(const std::string& path)
{
  std::error_code error;
  const fs::path result = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::path(path) : result;
}

fs::path
hiddenName(const fs::path& target, const std::string& purpose)
{
  const std::string stem = "." + target.stem().string() + "." + purpose + "-" + std::to_string(::getpid());
  return target.parent_path() / (stem + target.extension().string());
}

/** Whether \p name is hiddenName(target, purpose) of a run that has ended. */
bool
isStale(const fs::path& target, const std::string& purpose, const std::string& name)
{
  const std::string before = "." + target.stem().string() + "." + purpose + "-", after = target.extension().string();
  if (name.size() <= before.size() + after.size() || name.compare(0, before.size(), before) != 0 ||
      name.compare(name.size() - after.size(), after.size(), after) != 0)
    return false;
  const std::string number = name.substr(before.size(), name.size() - before.size() - after.size());
  if (number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos)
    return false;
  return ::kill(static_cast<pid_t>(std::stol(number)), 0) != 0 && errno == ESRCH;
}

/** Removes the temporary files of killed runs beside this file. */
void
removeStale(const fs::path& target)
{
  std::error_code error;
  for (fs::directory_iterator entry(target.parent_path(), error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (isStale(target, "writing", name) || isStale(target, "earlier", name))
      ::unlink(entry->path().c_str());
  }
}

/** Forces the bytes to the disk, so that even a power failure leaves no new name on an unwritten file. */
void
sync(const std::string& path, const std::string& temporary)
{
  const int handle = ::open(temporary.c_str(), O_RDONLY);
  const bool failed = handle < 0 || (::fsync(handle) != 0 && errno != EINVAL && errno != EROFS);
  const int reason = errno;
  if (handle >= 0)
    ::close(handle);
  if (failed)
    throw FileError(path, Diagnostic("cannot be written: ", std::string(std::strerror(reason))));
}

void
checkWritable(const std::string& path, const fs::path& target, const fs::path& temporary)
{
  std::error_code error;
  const fs::path folder = target.parent_path();
  if (!fs::exists(folder, error))
    throw FileError(path, Diagnostic("cannot be written: the folder ", folder.string(), " does not exist; create it first"));
  if (!fs::is_directory(folder, error))
    throw FileError(path, Diagnostic("cannot be written: ", folder.string(), " is not a folder"));
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    throw FileError(path, "cannot be written: this name exists and is not a file; give another name");
  const int handle = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
  if (handle < 0)
    throw FileError(path, Diagnostic("cannot be written: ", std::string(std::strerror(errno)), " in ", folder.string(),
                                     "; choose a folder you may write to"));
  ::close(handle);
  ::unlink(temporary.c_str());
}

} // namespace

OutputFiles::OutputFiles(std::vector<std::string> paths) : paths_(std::move(paths))
{
  for (const std::string& path : paths_) {
    const fs::path target = resolved(path);
    if (std::find(targets_.begin(), targets_.end(), target.string()) != targets_.end())
      throw FileError(path, "is given twice as an output; give another name");
    const fs::path temporary = hiddenName(target, "writing");
    checkWritable(path, target, temporary);
    removeStale(target);
    targets_.push_back(target.string());
    temporaries_.push_back(temporary.string());
  }
}

OutputFiles::~OutputFiles()
{
  for (const std::string& temporary : temporaries_)
    ::unlink(temporary.c_str());
}

Diagnostic
OutputFiles::asGiven(Diagnostic message) const
{
  for (std::size_t i = 0; i < temporaries_.size(); ++i)
    message = message.renamed(temporaries_[i], paths_[i]);
  return message;
}

void
OutputFiles::commit()
{
  for (std::size_t i = 0; i < targets_.size(); ++i)
    sync(paths_[i], temporaries_[i]);
  std::vector<std::string> kept(targets_.size()); // second names of the earlier files, until all are replaced
  std::size_t done = 0;
  std::error_code error;
  for (; done < targets_.size(); ++done) {
    if (fs::exists(targets_[done], error)) {
      kept[done] = hiddenName(targets_[done], "earlier").string();
      fs::remove(kept[done], error);
      fs::create_hard_link(targets_[done], kept[done], error);
      if (error) // a file system without links
        fs::copy_file(targets_[done], kept[done], error);
      if (error) {
        std::error_code ignored;
        fs::remove(kept[done], ignored); // possibly an incomplete copy: the original is still there
        kept[done].clear();
        break;
      }
    }
    fs::rename(temporaries_[done], targets_[done], error);
    if (error)
      break;
  }
  if (error) {
    std::error_code ignored;
    for (std::size_t i = 0; i <= done; ++i)
      if (!kept[i].empty() && fs::exists(kept[i], ignored)) {
        fs::rename(kept[i], targets_[i], ignored);
        fs::remove(kept[i], ignored); // rename does nothing to two names of one file
      }
      else if (i < done)
        fs::remove(targets_[i], ignored);
    throw FileError(paths_[done], Diagnostic("cannot be written: ", error.message()));
  }
  for (const std::string& earlier : kept)
    if (!earlier.empty())
      fs::remove(earlier, error);
}

} // namespace pcl_spiral
