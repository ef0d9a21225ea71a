/** \file
 * \brief Fields of a file that no algorithm uses, kept for the labelled file.
 */
#pragma once

#include "io/read/scalar_type.h"

#include <pcl/symmetry/surface.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The fields of a file as they are read, each found by its number among all fields of a point. */
class FieldCollector {
public:
  /** \brief Keeps field \a number; those that are not added are passed over. */
  void
  add(std::size_t number, const std::string& name, ScalarType type, std::size_t count);

  /** \brief Makes room for that many points. */
  void
  resize(std::size_t points);

  bool
  keeps(std::size_t number) const
  {
    return number < slots_.size() && slots_[number] != none;
  }

  /** \brief Copies the field of all points; the values of one point follow each other. Nothing where it is not kept. */
  void
  copy(std::size_t number, const ScalarColumn& column);

  /** \brief Where value \a index of a point belongs; the field must be kept. */
  char*
  place(std::size_t number, std::size_t point, std::size_t index);

  /** \brief Hands over what was read, for Surface::fields; empty where nothing is kept.
   * \param[in] width of the raster, 0 for none */
  std::shared_ptr<const PointFields>
  take(std::size_t width, std::size_t height);

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  PointFields kept_;
  std::vector<std::size_t> slots_; ///< by number: index into the kept ones, or none
};

/** \brief A name that PLY and PCD take: what is no letter or digit becomes an underscore; one by \a number where there is
 * none. */
std::string
plainFieldName(std::string_view word, std::size_t number);

/** \brief Colours and texture coordinates of formats that have no names for their fields, as floats: red, green, blue and
 * perhaps alpha, where there are three or four \a colours for each point; u and v, where there are two numbers of
 * \a texture for each point.
 * \return nullptr where there is neither */
std::shared_ptr<const PointFields>
appearanceFields(const std::vector<float>& colours, const std::vector<float>& texture, std::size_t points);

} // namespace symmetry
} // namespace pcl
