#include "io/read/file_content.h"

#include "io/read/surface_builder.h"

#include <pcl/symmetry/impl/plain_exception.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <pcl/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief A file descriptor that closes itself. */
class Descriptor {
public:
  explicit Descriptor(int number) : number_(number)
  {
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor&
  operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor&
  operator=(Descriptor&&) = delete;
  ~Descriptor()
  {
    if (number_ >= 0)
      ::close(number_);
  }

  int
  number() const
  {
    return number_;
  }

private:
  int number_;
};

/** \brief A pipe does not say how much will come, and may never end. */
constexpr std::size_t stream_limit = std::size_t{4} << 30;

constexpr std::size_t first_capacity = std::size_t{1} << 16;

} // namespace

FileContent::FileContent(const std::string& path) : path_(path)
{
  if (path == "-") {
    path_ = "standard input";
    readStream(STDIN_FILENO);
    return;
  }
  // Without O_NONBLOCK, opening a named pipe would wait for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
    fail(std::string("cannot be opened: ") + std::strerror(errno));
  if (S_ISDIR(status.st_mode))
    fail("is a directory");
  if (!S_ISREG(status.st_mode))
    fail("is not a regular file");
  if (status.st_size == 0)
    fail("is empty");

  readRegular(file.number(), static_cast<std::size_t>(status.st_size));
}

void
FileContent::readRegular(int descriptor, std::size_t expected)
{
  bytes_.reset(new char[expected]); // not make_unique: zeroing first would cost as much as reading
  while (size_ < expected) {
    const ssize_t count = ::read(descriptor, bytes_.get() + size_, expected - size_);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0)
      fail("became shorter while it was read");
    size_ += static_cast<std::size_t>(count);
  }
}

void
FileContent::readStream(int descriptor)
{
  std::size_t capacity = first_capacity;
  grow(capacity);
  for (;;) {
    const ssize_t count = ::read(descriptor, bytes_.get() + size_, capacity - size_);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0)
      break;
    size_ += static_cast<std::size_t>(count);
    if (size_ == capacity && capacity >= stream_limit)
      fail("holds more than " + std::to_string(stream_limit) + " bytes: save it to a file first");
    if (size_ == capacity)
      grow(capacity *= 2);
  }
  if (size_ == 0)
    fail("is empty");
}

/** \brief Makes room for so many bytes; those that are there stay. */
void
FileContent::grow(std::size_t capacity)
{
  std::unique_ptr<char[]> larger(new char[capacity]);
  std::copy_n(bytes_.get(), size_, larger.get());
  bytes_ = std::move(larger);
}

void
FileContent::unpackGzip()
{
  namespace io = boost::iostreams;
  const std::uint64_t most = mostUnpacked(size_);
  std::size_t capacity = first_capacity;
  std::size_t unpacked = 0;
  std::unique_ptr<char[]> bytes(new char[capacity]);
  try {
    io::filtering_istreambuf stream;
    stream.push(io::gzip_decompressor());
    stream.push(io::array_source(bytes_.get(), size_));
    for (;;) {
      const std::streamsize room = static_cast<std::streamsize>(capacity - unpacked);
      const std::streamsize count = stream.sgetn(bytes.get() + unpacked, room);
      unpacked += static_cast<std::size_t>(std::max<std::streamsize>(count, 0));
      if (count < room)
        break;
      if (unpacked > most)
        fail("unpacks to more than " + std::to_string(most) + " bytes: unpack it first if it can be trusted");
      std::unique_ptr<char[]> larger(new char[2 * capacity]);
      std::copy_n(bytes.get(), unpacked, larger.get());
      bytes = std::move(larger);
      capacity *= 2;
    }
  }
  catch (const io::gzip_error&) {
    fail("is not compressed by gzip, or truncated or damaged");
  }
  if (unpacked == 0)
    fail("is empty once unpacked");
  bytes_ = std::move(bytes);
  size_ = unpacked;
}

void
FileContent::fail(const std::string& reason) const
{
  throw detail::PlainException<IOException>(path_ + ": " + reason);
}

void
FileContent::failAtLine(std::size_t line, const std::string& reason) const
{
  fail("line " + std::to_string(line) + ": " + reason);
}

void
FileContent::failAtByte(std::size_t byte, const std::string& reason) const
{
  fail("byte " + std::to_string(byte) + ": " + reason);
}

} // namespace symmetry
} // namespace pcl
