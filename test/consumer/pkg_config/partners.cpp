// The free function, without any PCL type: prints the partner of every 500th point.
#include "../body.h"

#include <pcl/symmetry/symmetry.h>

#include <cstdio>
#include <exception>

int
main()
try {
  const pcl::symmetry::Surface body = consumer::makeBody();
  const pcl::symmetry::SymmetryResult result = pcl::symmetry::estimateIntrinsicSymmetry(body);
  const double right = consumer::shareOfRightPartners(body, result.partners);
  std::printf("%s, %.1f %% of the partners right\n", toString(result.status), 100.0 * right);
  for (std::size_t i = 0; i < result.partners.size(); i += 500)
    std::printf("%5zu -> %5d\n", i, result.partners[i]);
  return result.status == pcl::symmetry::SymmetryStatus::Symmetric && right > 0.95 ? 0 : 1;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "partners: %s\n", error.what());
  return 1;
}
