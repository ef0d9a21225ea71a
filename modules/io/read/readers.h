/** \file
 * \brief One reader per file format; readSurface() picks among them by the ending of the name.
 *
 * Each throws pcl::IOException, naming file, line or byte, and reason, unless the whole content is as its format says,
 * or as one of the dialects of doc/formats.md.
 */
#pragma once

#include "io/read/file_content.h"

#include <pcl/symmetry/surface.h>

#include <array>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What a reader is told, and what it tells beside the surface. */
struct Reading {
  std::array<double, 3> origin = {0.0, 0.0, 0.0}; ///< in: is subtracted from each position before it is rounded
  bool single_precision = false;                  ///< out: the file holds the positions as binary floats
  std::vector<std::string> notes;                 ///< out: see Surface::notes
};

/** \brief Polygon File Format 1.0: ascii and binary of both byte orders, any scalar types, faces and triangle strips.
 */
Surface
readPly(const FileContent& file, Reading& reading);

/** \brief Point Cloud Data: ascii, binary and binary_compressed, any field types. */
Surface
readPcd(const FileContent& file, Reading& reading);

/** \brief Wavefront OBJ: v, vn, f and fo; all other keywords are passed over. */
Surface
readObj(const FileContent& file, Reading& reading);

/** \brief Object File Format, text or binary: OFF with the prefixes ST, C, N, 4 and n. */
Surface
readOff(const FileContent& file, Reading& reading);

/** \brief Stereolithography, ascii or binary; equal positions become one point, in the order of their first appearance.
 */
Surface
readStl(const FileContent& file, Reading& reading);

/** \brief Rows of numbers: x y z, and perhaps normal, colour and other values; see ColumnNames. */
Surface
readXyz(const FileContent& file, Reading& reading);

/** \brief VTK's legacy files, text or binary, of both layouts: points, polygons, strips, and cells that are such. */
Surface
readVtk(const FileContent& file, Reading& reading);

/** \brief Scenes that assimp reads, with their nodes' places: .glb, .gltf, .3mf. Points keep the numbers of the file: mesh
 * after mesh in the order of the nodes. Only where built with PCL_SYMMETRY_WITH_ASSIMP. */
Surface
readScene(const FileContent& file, const std::string& ending, Reading& reading);

} // namespace symmetry
} // namespace pcl
