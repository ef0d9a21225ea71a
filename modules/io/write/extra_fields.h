/** \file
 * \brief Fields of the input in the labelled file, beside those that the result adds.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The fields of a surface's file as they are written once more.
 *
 * A name that the labelled file needs for itself gets "input_" in front, as often as it takes to be the only one of that
 * name; all others stay as they were.
 */
class ExtraFields {
public:
  /** \param[in] taken names that the file has already */
  ExtraFields(const Surface& surface, std::vector<std::string> taken);

  /** \brief Properties of a PLY header. PLY has scalars only, and none of eight bytes but double: a field of several
   * values becomes name_0, name_1 and so on, and long integers become doubles. */
  std::string
  plyProperties() const;

  /** \brief What follows in the lines FIELDS, SIZE, TYPE and COUNT of a PCD header, each word with a blank before it. */
  std::string
  pcdNames() const;
  std::string
  pcdSizes() const;
  std::string
  pcdTypes() const;
  std::string
  pcdCounts() const;

  /** \brief Appends the values of a point as PLY has them. */
  void
  appendPly(std::string& bytes, std::size_t point) const;

  /** \brief Appends the values of a point as PCD has them. */
  void
  appendPcd(std::string& bytes, std::size_t point) const;

private:
  std::vector<const PointField*> fields_;
  std::vector<std::string> names_;
};

} // namespace symmetry
} // namespace pcl
