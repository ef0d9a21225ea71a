// Where stderr is no terminal, progress does not end up in files; on a terminal, nothing of it stays.
#include "cli/progress_line.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

using namespace pcl::symmetry;

namespace {

TEST(ProgressLine, IsForTerminalsOnly)
{
  ::testing::internal::CaptureStderr();
  {
    const ProgressLine line(false);
    line.show("graph", 0.25);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/** What a program that has a terminal as its stderr writes to it. */
template <typename Print>
std::string
onTerminal(Print print)
{
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0)
    return "no terminal";
  const int screen = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
  const int errors = ::dup(STDERR_FILENO);
  ::dup2(screen, STDERR_FILENO);
  print();
  std::fputs("end", stderr); // so that there is something to read
  ::dup2(errors, STDERR_FILENO);
  std::array<char, 256> buffer{};
  const ssize_t size = ::read(terminal, buffer.data(), buffer.size());
  for (const int file : {terminal, screen, errors})
    ::close(file);
  return {buffer.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

TEST(ProgressLine, IsReplacedAndErased)
{
  const std::string text = onTerminal([] {
    const ProgressLine line(false);
    line.show("graph", 0.25);
    line.show("axis", 0.9);
  });
  if (text == "no terminal")
    GTEST_SKIP();
  EXPECT_EQ(text, "\r\033[K 25 %  graph\r\033[K 90 %  axis\r\033[Kend");
}

TEST(ProgressLine, IsNotShownWhereItIsNotWanted)
{
  const std::string text = onTerminal([] {
    const ProgressLine line(true);
    line.show("graph", 0.25);
  });
  if (text == "no terminal")
    GTEST_SKIP();
  EXPECT_EQ(text, "end");
}

} // namespace
