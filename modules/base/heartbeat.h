/** \file
 * \brief How long computations let their caller look in every now and then.
 */
#pragma once

#include <chrono>
#include <functional>

namespace pcl {
namespace symmetry {

/** \brief While it lives, heartbeat () in the thread that made it calls a function, at most twenty times a second.
 *
 * The function may throw to end the computation. Scopes may be nested: the innermost counts. */
class HeartbeatScope {
public:
  explicit HeartbeatScope(std::function<void()> beat);
  HeartbeatScope(const HeartbeatScope&) = delete;
  HeartbeatScope&
  operator=(const HeartbeatScope&) = delete;
  HeartbeatScope(HeartbeatScope&&) = delete;
  HeartbeatScope&
  operator=(HeartbeatScope&&) = delete;
  ~HeartbeatScope();

private:
  friend void
  heartbeat();

  std::function<void()> beat_;
  std::chrono::steady_clock::time_point next_;
  HeartbeatScope* outer_;
};

/** \brief To be called in every loop that may run for longer than a tenth of a second and is not a parallelFor, which
 * does so itself. Takes some 30 ns; does nothing in threads without a scope.
 * \throws whatever the function of the scope throws */
void
heartbeat();

} // namespace symmetry
} // namespace pcl
