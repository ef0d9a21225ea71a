// Component symmetry: finds the symmetry of a body.
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
  std::printf("%s, confidence %.2f, %.1f %% of the partners right\n", toString(result.status), result.confidence,
              100.0 * right);
  return result.status == pcl::symmetry::SymmetryStatus::Symmetric && right > 0.95 ? 0 : 1;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "symmetric_body: %s\n", error.what());
  return 1;
}
