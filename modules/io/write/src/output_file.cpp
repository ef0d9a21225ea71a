#include "io/write/output_file.h"

#include <pcl/exceptions.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Where the links of \a path lead to, whether or not there is something yet. */
std::string
followLinks(std::filesystem::path path)
{
  constexpr int most_links = 40; // as the system allows
  std::error_code none;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, none); ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, none);
    if (none)
      break;
    path = path.parent_path() / target; // an absolute target replaces the folder
  }
  return path.string();
}

/** \brief A name for a file beside \a target, short enough for any file system. */
std::string
nameBeside(const std::string& target, int attempt)
{
  const std::string name = ".pcl_symmetry-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
  return (std::filesystem::path(target).parent_path() / name).string();
}

} // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(followLinks(path))
{
  std::error_code unknown;
  if (std::filesystem::is_symlink(target_, unknown)) {
    errno = ELOOP;
    failWithSystemError();
  }
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
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
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = nameBeside(target_, attempt);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST)
      failWithSystemError();
  }
  if (exists)
    (void)::fchmod(descriptor_, status.st_mode & 07777); // a file keeps its rights; where it cannot, it gets new ones
}

OutputFile::~OutputFile()
{
  if (descriptor_ < 0)
    return;
  ::close(descriptor_);
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
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

void
OutputFile::commit()
{
  // Some file systems report only here that there is no room for what was written.
  const bool closed = ::close(descriptor_) == 0;
  descriptor_ = -1;
  if (closed && (temporary_.empty() || ::rename(temporary_.c_str(), target_.c_str()) == 0))
    return;
  const int error = errno;
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
  errno = error;
  failWithSystemError();
}

void
OutputFile::failWithSystemError() const
{
  throw IOException(path_ + ": cannot be written: " + std::strerror(errno));
}

void
checkOutputFile(const std::string& path)
{
  struct stat status = {};
  const bool is_special = ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  // Opening a pipe and closing it again would tell its reader that all is said.
  if (!is_special)
    OutputFile file(path);
  else if (::access(path.c_str(), W_OK) != 0)
    throw IOException(path + ": cannot be written: " + std::strerror(errno));
}

bool
areOneFile(const std::string& a, const std::string& b)
{
  if (a.empty() || b.empty())
    return false;
  std::error_code unknown;
  const std::filesystem::path one = followLinks(a);
  const std::filesystem::path other = followLinks(b);
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
