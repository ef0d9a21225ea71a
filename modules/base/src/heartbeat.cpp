#include "base/heartbeat.h"

#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::chrono::milliseconds interval{50};

thread_local HeartbeatScope* innermost = nullptr;

} // namespace

HeartbeatScope::HeartbeatScope(std::function<void()> beat)
    : beat_(std::move(beat)), next_(std::chrono::steady_clock::now() + interval), outer_(innermost)
{
  innermost = this;
}

HeartbeatScope::~HeartbeatScope()
{
  innermost = outer_;
}

void
heartbeat()
{
  if (innermost == nullptr) {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now >= innermost->next_) {
    innermost->next_ = now + interval;
    innermost->beat_();
  }
}

} // namespace symmetry
} // namespace pcl
