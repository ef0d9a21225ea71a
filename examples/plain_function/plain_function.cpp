// The function without any PCL type: reads a mesh or a cloud of any format, writes its map and the labelled surface.
#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <cstdio>
#include <exception>

using namespace pcl::symmetry;

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::fputs("usage: plain_function INPUT.{pcd,ply,obj,off,stl} MAP.csv LABELLED.{ply,pcd}\n", stderr);
    return 2;
  }
  const Surface surface = readSurface(argv[1]);
  std::printf("%zu points, %zu triangles\n", surface.size(), surface.triangles.size());

  SymmetryParameters parameters; // plain data with defaults
  parameters.alternatives = 2;   // list a second reflection, if there is one
  const auto progress = [](const char* step, double fraction) {
    std::fprintf(stderr, "%3.0f %% %s\n", 100.0 * fraction, step);
    return true; // false cancels
  };
  const SymmetryResult result = estimateIntrinsicSymmetry(surface, parameters, progress);
  std::printf("%s, confidence %.2f\n", toString(result.status), static_cast<double>(result.confidence));
  if (!hasMap(result.status)) {
    std::printf("%s\n", result.message.c_str());
    return 3;
  }

  std::printf("%zu points have a partner; of %.1f %% it is the partner of that one again\n", result.map.matched,
              100.0 * static_cast<double>(result.map.involution));
  std::printf("reflections: %zu\n", result.alternatives.size());
  for (const Index end : result.extremities) {
    std::printf("extremity %5d -> %5d, confidence %.2f\n", end, result.partners[static_cast<std::size_t>(end)],
                static_cast<double>(result.confidences[static_cast<std::size_t>(end)]));
  }

  writeMap(argv[2], result);
  writeLabelledSurface(argv[3], surface, result);
  return 0;
}
catch (const std::exception& error) { // the message names file and reason
  std::fprintf(stderr, "plain_function: %s\n", error.what());
  return 1;
}
