/** \file
 * \brief What the columns of a table of points hold, by their names or by their values.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Tells position, normal and colour apart; what else there is becomes a field.
 *
 * Without names the first three columns are the position. Of three further ones those are the normal whose vectors are
 * of length 1 in every row that has one, and those a colour whose values are whole and at most 255.
 */
class ColumnNames {
public:
  ColumnNames() = default;

  /** \param[in] line that may name the columns, in any case; does so only if there are as many, with x, y and z
   * \param[in] separator parts the names; blanks around them do not count
   * \param[in] count of columns */
  ColumnNames(std::string_view line, char separator, std::size_t count);

  std::size_t
  size() const
  {
    return axes_.size();
  }

  bool
  isNamed() const
  {
    return is_named_;
  }

  /** \brief Which coordinate a column holds, 0 to 2, or 3 for none. */
  std::size_t
  axisOf(std::size_t column) const
  {
    return axes_[column];
  }

  /** \brief Makes normals and fields of the other columns.
   * \param[in] values of these columns, row by row */
  void
  deliver(const std::vector<float>& values, Surface& surface) const;

private:
  std::vector<std::size_t> axes_;
  std::vector<std::string> names_; ///< of those that hold no coordinate, where they are known
  bool is_named_ = false;
};

} // namespace symmetry
} // namespace pcl
