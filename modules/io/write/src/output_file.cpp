#include "io/write/output_file.h"

#include <pcl/symmetry/impl/plain_exception.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

constexpr int no_descriptor = -1;

/** \brief The descriptor that a name such as /dev/fd/3 stands for in this process. */
int
descriptorNamed(const std::filesystem::path& path)
{
  const std::string number = path.filename().string();
  std::error_code unknown;
  if (number.empty() || number.size() > 6 || number.find_first_not_of("0123456789") != std::string::npos ||
      !std::filesystem::equivalent(path.parent_path(), "/proc/self/fd", unknown))
    return no_descriptor;
  return std::stoi(number);
}

/** \brief Where the links of a path lead to, whether or not there is something yet. */
struct Place {
  std::string path;
  int descriptor = no_descriptor; ///< that the process has open already; then there is no path
};

Place
followLinks(const std::string& path)
{
  constexpr int link_limit = 40; // as the system allows
  if (path == standard_stream)
    return {"", STDOUT_FILENO};
  std::filesystem::path place = path;
  std::error_code none;
  for (int i = 0; i < link_limit && std::filesystem::is_symlink(place, none); ++i) {
    const int descriptor = descriptorNamed(place);
    if (descriptor != no_descriptor)
      return {"", descriptor};
    const std::filesystem::path target = std::filesystem::read_symlink(place, none);
    if (none)
      break;
    place = place.parent_path() / target; // an absolute target replaces the folder
  }
  return {place.string(), no_descriptor};
}

std::string
folderOf(const std::string& file)
{
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

/** \brief A name for a file beside \a target, the same each time, short enough for any file system. */
std::string
nameBeside(const std::string& target, int attempt)
{
  // FNV-1a: has to agree between runs, as std::hash need not.
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : std::filesystem::path(target).filename().string())
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  char digits[17] = {};
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  const std::string name = std::string(".pcl_symmetry-") + digits + "-" + std::to_string(attempt) + ".part";
  return (std::filesystem::path(target).parent_path() / name).string();
}

/** \brief Whether an open file still has this name. */
bool
hasName(int descriptor, const std::string& name)
{
  struct stat open = {};
  struct stat named = {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

/** \brief Removes what a process that is no more has left under this name. Who writes such a file holds a lock on it. */
void
removeLeftover(const std::string& name)
{
  const int file = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
    return;
  struct stat status = {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
      ::flock(file, LOCK_EX | LOCK_NB) == 0 && hasName(file, name))
    ::unlink(name.c_str());
  ::close(file);
}

/** \brief Brings what has been written to the disk. Not every file system can. */
bool
synchronize(int descriptor)
{
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

void
synchronizeFolder(const std::string& folder)
{
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return; // a folder that may be written to but not read
  (void)synchronize(descriptor);
  ::close(descriptor);
}

} // namespace

OutputFile::OutputFile(const std::string& path) : path_(path)
{
  const Place place = followLinks(path);
  target_ = place.path;
  if (place.descriptor != no_descriptor) {
    descriptor_ = ::fcntl(place.descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (descriptor_ < 0)
      failWithSystemError();
    return;
  }
  std::error_code unknown;
  if (std::filesystem::is_symlink(target_, unknown)) {
    errno = ELOOP;
    failWithSystemError();
  }
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) // such as a name that is too long: found out now, not when all is computed
    failWithSystemError();
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    failWithSystemError();
  }
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0)
      failWithSystemError();
    return;
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0)
    failWithSystemError();
  createBeside(status.st_mode & 07777U, exists);
}

/** \brief Opens the temporary file, locked for as long as it is written. \param[in] mode of the file that it replaces */
void
OutputFile::createBeside(unsigned mode, bool exists)
{
  constexpr int attempt_limit = 1000; // that many others write the same file
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = nameBeside(target_, attempt);
    removeLeftover(temporary_);
    unfinished_.remember(temporary_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      const int error = errno;
      unfinished_.forget();
      if (error != EEXIST || attempt == attempt_limit) {
        temporary_.clear();
        errno = error;
        failWithSystemError();
      }
      continue;
    }
    // Another process may take it for a leftover before it is locked. Where there are no locks, nobody does.
    const bool is_ours = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (!is_ours || !hasName(descriptor_, temporary_)) {
      ::close(descriptor_);
      descriptor_ = no_descriptor;
    }
  }
  if (exists)
    (void)::fchmod(descriptor_, mode); // a file keeps its rights; where it cannot, it gets new ones
}

OutputFile::~OutputFile()
{
  if (descriptor_ < 0)
    return;
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
  ::close(descriptor_);
}

void
OutputFile::write(std::string_view bytes)
{
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      failWithSystemError();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

bool
OutputFile::moveIntoPlace()
{
  if (temporary_.empty())
    return true;
  // Still open, and so locked: nobody takes it for a leftover meanwhile.
  return synchronize(descriptor_) && ::rename(temporary_.c_str(), target_.c_str()) == 0;
}

void
OutputFile::commit()
{
  bool is_done = moveIntoPlace();
  int error = errno;
  if (!is_done)
    ::unlink(temporary_.c_str());
  // Some file systems report only here that there is no room for what was written.
  if (::close(descriptor_) != 0 && is_done) {
    error = errno;
    is_done = false;
  }
  descriptor_ = no_descriptor;
  unfinished_.forget();
  if (!is_done) {
    errno = error;
    failWithSystemError();
  }
  if (!temporary_.empty())
    synchronizeFolder(folderOf(target_));
}

void
OutputFile::failWithSystemError() const
{
  throw detail::PlainException<IOException>((path_ == standard_stream ? "standard output" : path_) +
                                            ": cannot be written: " + std::strerror(errno));
}

void
checkOutputFile(const std::string& path)
{
  const Place place = followLinks(path);
  const auto fail = [&path] {
    throw detail::PlainException<IOException>(path + ": cannot be written: " + std::strerror(errno));
  };
  if (place.descriptor != no_descriptor) {
    const int flags = ::fcntl(place.descriptor, F_GETFL);
    if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY)
      errno = EBADF;
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
      fail();
    return;
  }
  struct stat status = {};
  const bool is_special =
      ::stat(place.path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  // Opening a pipe and closing it again would tell its reader that all is said.
  if (!is_special)
    OutputFile file(path);
  else if (::access(place.path.c_str(), W_OK) != 0)
    fail();
}

bool
areOneFile(const std::string& a, const std::string& b)
{
  if (a.empty() || b.empty())
    return false;
  std::error_code unknown;
  const Place first = followLinks(a);
  const Place second = followLinks(b);
  if (first.descriptor != no_descriptor || second.descriptor != no_descriptor)
    return first.descriptor == second.descriptor;
  const std::filesystem::path one = first.path;
  const std::filesystem::path other = second.path;
  if (std::filesystem::exists(one, unknown) && std::filesystem::exists(other, unknown))
    return std::filesystem::is_regular_file(one, unknown) && std::filesystem::equivalent(one, other, unknown);
  const std::filesystem::path one_place = std::filesystem::weakly_canonical(std::filesystem::absolute(one), unknown);
  const std::filesystem::path other_place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(other), unknown);
  return !one_place.empty() && one_place == other_place;
}

void
writeWholeFile(const std::string& path, std::string_view content)
{
  OutputFile file(path);
  file.write(content);
  file.commit();
}

} // namespace symmetry
} // namespace pcl
