// Component io: labels a body, writes it and reads it back.
#include "../body.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <cstdio>
#include <exception>

int
main(int argc, char** argv)
try {
  if (argc != 2) {
    std::puts("usage: label_body OUTPUT.ply");
    return 2;
  }
  const pcl::symmetry::Surface body = consumer::makeBody();
  const pcl::symmetry::SymmetryResult result = pcl::symmetry::estimateIntrinsicSymmetry(body);
  pcl::symmetry::writeLabelledSurface(argv[1], body, result);
  const pcl::symmetry::Surface read = pcl::symmetry::readSurface(argv[1]);
  std::printf("%s: %zu points, %zu faces\n", argv[1], read.size(), read.triangles.size());
  return read.size() == body.size() && read.triangles == body.triangles ? 0 : 1;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "label_body: %s\n", error.what());
  return 1;
}
