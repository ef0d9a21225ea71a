// Any small surface with any parameters: a sound result, or an exception that says what was wrong.
#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fuzzer/FuzzedDataProvider.h>

using namespace pcl::symmetry;

namespace {

float
coordinate(FuzzedDataProvider& bytes, bool is_free)
{
  if (!is_free) // on a grid, so that many are equal, collinear or coplanar
    return 0.25F * static_cast<float>(bytes.ConsumeIntegral<std::int8_t>());
  const auto bits = bytes.ConsumeIntegral<std::uint32_t>();
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

Surface
makeSurface(FuzzedDataProvider& bytes)
{
  Surface surface;
  const bool is_free = bytes.ConsumeBool();
  const int points = bytes.ConsumeIntegralInRange(0, 150);
  const int faces = bytes.ConsumeBool() ? bytes.ConsumeIntegralInRange(0, 250) : 0;
  for (int i = 0; i < points; ++i) {
    const float x = coordinate(bytes, is_free);
    const float y = coordinate(bytes, is_free);
    surface.points.push_back({x, y, coordinate(bytes, is_free)});
  }
  // Now and then a corner that is not there.
  for (int i = 0; i < faces; ++i) {
    const Index a = bytes.ConsumeIntegralInRange(0, points);
    const Index b = bytes.ConsumeIntegralInRange(0, points);
    surface.triangles.push_back({a, b, bytes.ConsumeIntegralInRange(-1, points)});
  }
  return surface;
}

SymmetryParameters
makeParameters(FuzzedDataProvider& bytes)
{
  SymmetryParameters parameters;
  parameters.threads = 1;
  parameters.method = bytes.ConsumeBool() ? Method::Robust : Method::Staged;
  parameters.metric = static_cast<Metric>(bytes.ConsumeIntegralInRange(0, 2));
  parameters.staged.pairing = static_cast<PairingFeature>(bytes.ConsumeIntegralInRange(0, 3));
  parameters.components = bytes.ConsumeBool() ? ComponentUse::All : ComponentUse::Largest;
  parameters.k_search = bytes.ConsumeIntegralInRange(2, 40);
  parameters.robust.samples = bytes.ConsumeBool() ? 1500 : bytes.ConsumeIntegralInRange(29, 200);
  parameters.staged.samples = bytes.ConsumeIntegralInRange(19, 200);
  parameters.staged.landmarks = bytes.ConsumeIntegralInRange(9, 100);
  parameters.staged.embedding_dimensions = bytes.ConsumeIntegralInRange(1, 21);
  parameters.alternatives = bytes.ConsumeIntegralInRange(0, 5);
  parameters.sparse_only = bytes.ConsumeBool();
  parameters.staged.extremities = static_cast<ExtremePoints>(bytes.ConsumeIntegralInRange(0, 2));
  parameters.radius = bytes.ConsumeBool() ? 0.0F : coordinate(bytes, true);
  parameters.outlier_deviations = bytes.ConsumeBool() ? 0.0F : coordinate(bytes, true);
  return parameters;
}

bool
isShare(float value)
{
  return value >= 0.0F && value <= 1.0F;
}

void
check(const SymmetryResult& result, std::size_t points)
{
  bool is_sound = result.partners.size() == points && result.confidences.size() == points &&
                  result.sides.size() == points && result.regions.size() == points && isShare(result.confidence) &&
                  std::isfinite(result.diameter);
  for (std::size_t i = 0; is_sound && i < points; ++i)
    is_sound = result.partners[i] >= no_index && result.partners[i] < static_cast<Index>(points) &&
               isShare(result.confidences[i]);
  if (!is_sound)
    std::abort();
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const SymmetryParameters parameters = makeParameters(bytes);
  const Surface surface = makeSurface(bytes);
  try {
    check(estimateIntrinsicSymmetry(surface, parameters), surface.size());
  }
  catch (const pcl::BadArgumentException& /*refused*/) {
  }
  return 0;
}
