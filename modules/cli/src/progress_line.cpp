#include "cli/progress_line.h"

#include <cstdio>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

constexpr const char* erase_line = "\r\033[K";

} // namespace

ProgressLine::ProgressLine(bool quiet) : is_shown_(!quiet && ::isatty(STDERR_FILENO) == 1)
{
}

ProgressLine::~ProgressLine()
{
  if (is_shown_)
    std::fputs(erase_line, stderr);
}

void
ProgressLine::show(const char* step, double fraction) const
{
  if (is_shown_)
    std::fprintf(stderr, "%s%3.0f %%  %s", erase_line, 100.0 * fraction, step);
}

} // namespace symmetry
} // namespace pcl
