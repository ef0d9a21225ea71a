/** \file
 * \brief Names, times and announces the steps of a run.
 */
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Thrown when the progress callback asks to stop; caught by the pipeline, never seen by a caller. */
struct Cancelled {};

/** \brief Wall time per step: starting a step ends the one before it, so steps do not overlap.
 *
 * A step that is started again adds to its earlier time.
 */
class StepTimer {
public:
  /** \brief Called with the name of a step as it starts and the share of the work done; return false to cancel. */
  using Callback = std::function<bool(const char* step, double fraction)>;

  StepTimer() = default;
  explicit StepTimer(Callback callback) : callback_(std::move(callback))
  {
  }

  /** \brief Starts a step.
   * \param[in] name as in the report
   * \param[in] fraction share of the whole work that is done, in [0, 1]; where a step is done again, what was reached
   * stands
   * \throws Cancelled the callback returned false */
  void
  start(const char* name, double fraction)
  {
    stop();
    reached_ = std::max(reached_, fraction);
    if (callback_ && !callback_(name, reached_)) {
      throw Cancelled{};
    }
    running_ = entry(name);
    begin_ = Clock::now();
  }

  /** \brief Announces the running step once more, so that the callback can cancel within it.
   * \throws Cancelled the callback returned false */
  void
  beat()
  {
    if (callback_ && running_ != none && !callback_(seconds_[running_].first.c_str(), reached_)) {
      throw Cancelled{};
    }
  }

  void
  stop()
  {
    if (running_ != none) {
      seconds_[running_].second += std::chrono::duration<double>(Clock::now() - begin_).count();
      running_ = none;
    }
  }

  const std::vector<std::pair<std::string, double>>&
  seconds() const
  {
    return seconds_;
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t
  entry(const char* name)
  {
    for (std::size_t i = 0; i < seconds_.size(); ++i) {
      if (seconds_[i].first == name) {
        return i;
      }
    }
    seconds_.emplace_back(name, 0.0);
    return seconds_.size() - 1;
  }

  double reached_ = 0.0;
  Callback callback_;
  std::vector<std::pair<std::string, double>> seconds_;
  std::size_t running_ = none;
  Clock::time_point begin_;
};

} // namespace symmetry
} // namespace pcl
