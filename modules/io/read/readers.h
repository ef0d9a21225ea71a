/** \file
 * \brief One reader per file format; readSurface() picks among them by the ending of the name.
 *
 * Each throws pcl::IOException, naming file, line or byte, and reason, unless the whole content is as its format says.
 */
#pragma once

#include "io/read/file_content.h"

#include <pcl/symmetry/surface.h>

namespace pcl {
namespace symmetry {

/** \brief Polygon File Format 1.0: ascii and binary of both byte orders, any scalar types, faces and triangle strips.
 */
Surface
readPly(const FileContent& file);

/** \brief Point Cloud Data: ascii, binary and binary_compressed, any field types. */
Surface
readPcd(const FileContent& file);

/** \brief Wavefront OBJ: v, vn and f; all other keywords are passed over. */
Surface
readObj(const FileContent& file);

/** \brief Object File Format in text: OFF with the prefixes ST, C and N. */
Surface
readOff(const FileContent& file);

/** \brief Stereolithography, ascii or binary; equal positions become one point, in the order of their first appearance.
 */
Surface
readStl(const FileContent& file);

} // namespace symmetry
} // namespace pcl
