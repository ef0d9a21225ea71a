/** \file
 * \brief The table of inputs made to hang, crash or deceive: what they are and which outcomes are right.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief A row of the table. */
struct Hostile {
  const char* name;
  const char* statuses; ///< exit statuses that are right, a digit each
  std::function<Surface()> surface;
  std::vector<std::string> options;
};

/** \brief A row whose input is no surface at all. */
struct HostileFile {
  const char* name;
  const char* file;
  std::function<std::string()> content;
};

/** \brief For messages of the test framework. */
inline void
PrintTo(const Hostile& row, std::ostream* out)
{
  *out << row.name;
}

inline void
PrintTo(const HostileFile& row, std::ostream* out)
{
  *out << row.name;
}

/** \brief Of surfaces and options. */
const std::vector<Hostile>&
hostileSurfaces();

/** \brief More of them: faces that join anything, spacings and sizes that tell nothing. */
const std::vector<Hostile>&
hostileGeometry();

/** \brief Of files that are refused, all with exit status 1. */
const std::vector<HostileFile>&
hostileFiles();

} // namespace test
} // namespace symmetry
} // namespace pcl
