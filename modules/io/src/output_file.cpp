#include "io/output_file.h"

#include <pcl/exceptions.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Where the links of \a path lead to; \a path itself where there is nothing yet. */
std::string
followLinks(const std::string& path)
{
  const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
  return resolved ? std::string(resolved.get()) : path;
}

} // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(followLinks(path))
{
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
  const std::string stem = target_ + ".part-" + std::to_string(::getpid()) + "-";
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = stem + std::to_string(attempt);
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
writeWholeFile(const std::string& path, std::string_view content)
{
  OutputFile file(path);
  file.write(content);
  file.commit();
}

} // namespace symmetry
} // namespace pcl
