// Longest time between two calls of the progress callback, on one thread.
//
// usage: pcl_symmetry_progress_gap SURFACE [--as-cloud]
#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

#include <ctime>
#include <iostream>
#include <string>

using namespace pcl::symmetry;

namespace {

/** \brief Seconds that this process has computed: what else the machine does is no gap. */
double
computedSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** \brief Told of every call; keeps the longest gap and what ran in it. */
class GapWatch {
public:
  void
  called(const std::string& step)
  {
    const double now = computedSeconds();
    ++calls_;
    if (now - last_ > longest_) {
      longest_ = now - last_;
      between_ = step_ + " to " + step;
    }
    last_ = now;
    step_ = step;
  }

  void
  print() const
  {
    std::cout << calls_ << " calls in " << last_ - start_ << " s, the longest gap " << longest_ << " s: " << between_
              << '\n';
  }

private:
  double start_ = computedSeconds();
  double last_ = start_;
  double longest_ = 0.0;
  std::size_t calls_ = 0;
  std::string step_ = "start";
  std::string between_;
};

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2) {
    std::cerr << "usage: pcl_symmetry_progress_gap SURFACE [--as-cloud]\n";
    return 2;
  }
  try {
    Surface surface = readSurface(argv[1]);
    if (argc > 2 && std::string(argv[2]) == "--as-cloud") {
      surface.triangles.clear();
    }
    SymmetryParameters parameters;
    parameters.threads = 1;
    GapWatch watch;
    const SymmetryResult result = estimateIntrinsicSymmetry(surface, parameters, [&watch](const char* step, double) {
      watch.called(step);
      return true;
    });
    watch.called("end");
    std::cout << surface.size() << " points, " << toString(result.status) << ": ";
    watch.print();
  }
  catch (const pcl::PCLException& error) {
    std::cerr << "pcl_symmetry_progress_gap: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
