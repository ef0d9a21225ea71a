/** \file
 * \brief The running step, on a line of a terminal that it has for itself.
 */
#pragma once

namespace pcl {
namespace symmetry {

/** \brief Shows the running step on stderr where that is a terminal; the line is empty again at the end. */
class ProgressLine {
public:
  explicit ProgressLine(bool quiet);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine&
  operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine&
  operator=(ProgressLine&&) = delete;
  ~ProgressLine();

  /** \brief Replaces what is shown; \a fraction of the work is done. */
  void
  show(const char* step, double fraction) const;

private:
  bool is_shown_;
};

} // namespace symmetry
} // namespace pcl
