/** \file
 * \brief Checks of the files that a program is asked to write, before it begins to work.
 */
#pragma once

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Refuses the name of a file whose ending nothing is written for; an empty name means that it is not wanted.
 * \throws UsageError naming the option */
void
checkEnding(const char* option, const std::string& file, const std::vector<std::string>& endings);

/** \brief Refuses a file that would overwrite another one or what is read; empty names are not wanted.
 * \throws UsageError naming the file */
void
checkDistinct(const std::vector<std::string>& outputs, std::vector<std::string> inputs);

/** \brief Makes sure that each file can be written; empty names are not wanted.
 * \throws pcl::IOException one cannot */
void
checkWritableFiles(const std::vector<std::string>& outputs);

} // namespace symmetry
} // namespace pcl
