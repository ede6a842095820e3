#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl_spiral {
namespace {

/** The file a path stands for: absolute, links followed, so that a rename replaces the file and not the link.
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

void
checkWritable(const std::string& path, const fs::path& target, const fs::path& temporary)
{
  std::error_code error;
  const fs::path folder = target.parent_path();
  if (!fs::exists(folder, error))
    throw FileError(path,
                    "cannot be written: the folder " + folder.string() + " does not exist; create it first");
  if (!fs::is_directory(folder, error))
    throw FileError(path, "cannot be written: " + folder.string() + " is not a folder");
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    throw FileError(path, "cannot be written: it exists and is not a file; give another name");
  const int handle = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
  if (handle < 0)
    throw FileError(path, "cannot be written: " + std::string(std::strerror(errno)) + " in " +
                              folder.string() + "; choose a folder you may write to");
  ::close(handle);
  ::unlink(temporary.c_str());
}

} // namespace

OutputFiles::OutputFiles(std::vector<std::string> paths) : paths_(std::move(paths))
{
  for (const std::string& path : paths_) {
    const fs::path target = resolved(path);
    if (std::find(targets_.begin(), targets_.end(), target.string()) != targets_.end())
      throw FileError(path, "is given twice as an output");
    const fs::path temporary = hiddenName(target, "writing");
    checkWritable(path, target, temporary);
    targets_.push_back(target.string());
    temporaries_.push_back(temporary.string());
  }
}

OutputFiles::~OutputFiles()
{
  for (const std::string& temporary : temporaries_)
    ::unlink(temporary.c_str());
}

void
OutputFiles::commit()
{
  std::vector<std::string> kept(targets_.size()); // earlier files under a second name, until all are replaced
  std::size_t done = 0;
  std::error_code error;
  for (; done < targets_.size(); ++done) {
    if (fs::exists(targets_[done])) {
      kept[done] = hiddenName(targets_[done], "earlier").string();
      fs::remove(kept[done], error);
      fs::create_hard_link(targets_[done], kept[done], error);
      if (error) // a file system without links
        fs::rename(targets_[done], kept[done], error);
      if (error)
        break;
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
        fs::remove(kept[i], ignored); // rename leaves two names of one file as they are
      }
      else if (i < done)
        fs::remove(targets_[i], ignored);
    throw FileError(paths_[done], "cannot be written: " + error.message() + "; no output has been changed");
  }
  for (const std::string& earlier : kept)
    if (!earlier.empty())
      fs::remove(earlier, error);
}

} // namespace pcl_spiral
