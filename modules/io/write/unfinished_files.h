/** \file
 * \brief Files that are being written, so that a signal leaves none of them behind.
 */
#pragma once

#include <atomic>
#include <cstddef>
#include <string>

namespace pcl {
namespace symmetry {

/** \brief Remembers the name of a file for as long as it is unfinished. */
class UnfinishedFile {
public:
  UnfinishedFile() = default;
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile&
  operator=(const UnfinishedFile&) = delete;
  UnfinishedFile(UnfinishedFile&&) = delete;
  UnfinishedFile&
  operator=(UnfinishedFile&&) = delete;
  ~UnfinishedFile()
  {
    forget();
  }

  /** \brief To be called before the file is made. Names that are too long, or more than there is room for, are not
   * remembered: such a file may stay behind. */
  void
  remember(const std::string& name);

  void
  forget();

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t place_ = none;
};

/** \brief Removes all files that are remembered. May be called from a signal handler. */
void
removePartFiles() noexcept;

} // namespace symmetry
} // namespace pcl
