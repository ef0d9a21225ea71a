#include "bodies.h"
#include "symmetry/sides/axis_curve.h"
#include "symmetry/sides/axis_smoothing.h"
#include "symmetry/sides/sides.h"

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

/** Sides and axis of a body that stands in the plane x = 0 before it is posed: the sign is that of its partner. */
void
axis(benchmark::State& state)
{
  const Human& body = human(state.range(0));
  const SurfaceGraph& graph = body.surface.graph;
  std::vector<float> side_function(graph.size(), 0.0F);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const Index partner = body.partners[v];
    if (partner != no_index) {
      side_function[v] = body.surface.points[v][0] - body.surface.points[partner][0];
    }
  }
  for (auto _ : state) {
    const std::vector<float> values =
        absorbSpecks(graph, smoothedNearAxis(body.surface, absorbSpecks(graph, side_function)));
    std::vector<Side> sides = labelSides(values);
    markAxis(graph, values, body.partners, sides);
    benchmark::DoNotOptimize(sides);
    benchmark::DoNotOptimize(traceAxis(body.surface, values, {}));
  }
}
BENCHMARK(axis)->Apply(onAllSizes);

} // namespace
