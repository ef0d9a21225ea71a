/** \file
 * \brief Memory for matrices that are written before they are read.
 */
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace pcl {
namespace symmetry {

/** \brief Asks the system to back memory that is not written yet by large pages; no more than a hint.
 *
 * The first touch of a page of 4 KB costs about a microsecond: as much as it takes to compute what is written there.
 * Less than a large page is left alone. */
void
preferLargePages(void* memory, std::size_t bytes);

/** \brief A block of floats that begins with a cache line, so that no vector register's load takes two of them. */
class FloatBlock {
public:
  /** \brief Makes room for \a count floats. What was there before is lost, what is there now is not initialised.
   * \return the first of them */
  float*
  reserve(std::size_t count);

  float*
  data() const
  {
    return floats_.get();
  }

private:
  struct Release {
    void
    operator()(float* floats) const
    {
      std::free(floats); // NOLINT(cppcoreguidelines-no-malloc): as aligned_alloc () wants it
    }
  };

  std::unique_ptr<float[], Release> floats_;
  std::size_t capacity_ = 0;
};

} // namespace symmetry
} // namespace pcl
