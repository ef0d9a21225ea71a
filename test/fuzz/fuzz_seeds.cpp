// Writes what the fuzz targets begin with: fuzz_seeds FOLDER makes FOLDER/read, headers, options and estimation.
#include "model/write_model.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

#include <iostream>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

void
write(const std::filesystem::path& file, const std::string& content)
{
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

/** A small surface as each format, behind the byte that names the format. */
void
writeFiles(const std::filesystem::path& folder)
{
  const std::string formats[] = {"pcd", "ply", "obj", "off"}; // in the order of fuzz_read.cpp
  const ScratchFolder scratch;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string file = scratch.file("a." + formats[i]);
    writePlainSurface(file, sphereMesh(0));
    write(folder / formats[i], static_cast<char>(i) + readBytes(file));
  }
  write(folder / "ascii.ply", "\x01ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                              "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                              "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write(folder / "ascii.pcd", std::string(1, '\0') + "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"
                                                     "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
                                                     "0 0 0 1\nnan 1 2 3\n");
  write(folder / "solid.stl", "\x04solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                              "endloop\nendfacet\nendsolid a\n");
  write(folder / "faces.stl", '\x04' + std::string(80, ' ') + std::string("\x01\0\0\0", 4) + std::string(50, '\x3F'));
  write(folder / "names.xyz", "\x05//X Y Z R G B Nx Ny Nz\n0 0 0 255 0 1 0 0 1\n1 0 0 255 0 1 0 1 0\n");
  write(folder / "count.pts", "\x05"
                              "2\n0 0 0 7\n1.5;0;nan;8\n");
  write(folder / "text.vtk", "\x06# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
                             "0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n");
  write(folder / "newer.vtk", "\x06# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                              "0 0 0 1 0 0 0 1 0\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n"
                              "0 1 2\n");
  // Binary: three points, one polygon, and what VTK writes with arrays.
  const std::string corners("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2", 16);
  write(folder / "binary.vtk", "\x06# vtk DataFile Version 4.2\nx\nBINARY\nDATASET POLYDATA\nFIELD FieldData 2\n"
                               "s 1 2 string\n\xC1z\xC0\nb 1 9 bit\nU@\nPOINTS 3 float\n" +
                                   std::string(36, '?') + "\nMETADATA\nCOMPONENT_NAMES\nx\n\nz\nINFORMATION 1\n" +
                                   "NAME R LOCATION V\nDATA 2 0 1 \n\nPOLYGONS 1 4\n" + corners + "\n");
  write(folder / "strings.vtk", "\x06# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\n"
                                "s 1 2 string\na%20b\n\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nMETADATA\n"
                                "INFORMATION 1\nNAME W LOCATION V\nDATA 2\na\n\n\nTRIANGLE_STRIPS 2 3\n"
                                "OFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n");
  write(folder / "binary.off", "\x03NOFF BINARY\n" + std::string("\0\0\0\3\0\0\0\1\0\0\0\0", 12) +
                                   std::string(72, '?') + corners + std::string(4, '\0'));
  write(folder / "prefixes.off", "\x03STCN4OFF\n1 1 0\n0 0 0 1 0 0 1 1 1 1 1 0.5 0.5\n3 0 0 0 1 0 0\n");
  write(folder / "quads.obj", "\x02v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf -4//1 -3//1 -2//1 -1//1\n");
}

void
writeOptions(const std::filesystem::path& folder)
{
  write(folder / "words", "input.ply\n--method\nstaged\n-k\n12\n--threads\n2\n-q\n--set\na\n--set\nb");
  write(folder / "wrong", "--radius=nan\n-k12x\n--no-such\n--\n-\n--output=");
  write(folder / "help", "-h");
}

void
writeNoise(const std::filesystem::path& folder)
{
  // Data providers take from any bytes what they need.
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::string bytes;
    unsigned state = seed;
    for (int i = 0; i < 2000; ++i) {
      state = state * 1664525U + 1013904223U;
      bytes += static_cast<char>(state >> 24U);
    }
    write(folder / std::to_string(seed), bytes);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  writeFiles(folder / "read");
  writeOptions(folder / "options");
  writeNoise(folder / "headers");
  writeNoise(folder / "estimation");
  return 0;
}
