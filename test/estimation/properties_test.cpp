// However a surface is written down, its symmetry is what it is: bodies keep their maps, other shapes their status.
#include "base/vector_math.h"
#include "support/changed_surface.h"
#include "support/known_body.h"
#include "support/same_result.h"
#include "support/shapes.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <tuple>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

struct Subject {
  const char* name;
  std::function<Surface()> make;
  bool has_one_map; ///< there is one symmetry, and it is found; else the status is all that is compared
  bool is_whole_or_not =
      false; ///< of which only whether it is whole: what else is found depends on where the samples lie
};

struct Change {
  const char* name;
  std::function<ChangedSurface(const Surface&)> apply;
};

void
PrintTo(const Subject& subject, std::ostream* out)
{
  *out << subject.name;
}

void
PrintTo(const Change& change, std::ostream* out)
{
  *out << change.name;
}

Surface
pointsOf(Surface surface)
{
  surface.triangles.clear();
  return surface;
}

Surface
bent(Body kind)
{
  return body(kind, 0.3).surface;
}

Surface
curveOf(int points, const std::function<Vector3(float)>& place)
{
  Surface curve;
  for (int i = 0; i < points; ++i) {
    curve.points.push_back(place(static_cast<float>(i)));
  }
  return curve;
}

const std::vector<Subject> subjects = {
    {"Human", [] { return bent(Body::Human); }, true},
    {"Quadruped", [] { return bent(Body::Quadruped); }, true},
    {"Bird", [] { return bent(Body::Bird); }, true},
    {"Spider", [] { return bent(Body::Spider); }, true},
    {"MissingArm", [] { return bent(Body::MissingArm); }, false},
    {"CloudOfAHuman", [] { return pointsOf(bent(Body::Human)); }, true},
    {"CloudOfAQuadruped", [] { return pointsOf(bent(Body::Quadruped)); }, true},
    {"CloudOfASpider", [] { return pointsOf(bent(Body::Spider)); }, true},
    {"CloudOfABird", [] { return pointsOf(bent(Body::Bird)); }, true},
    // A tube is its own mirror image along its length, but for its bumps: partly symmetric, or nothing is found.
    {"Helix", [] { return bent(Body::Helix); }, false, true},
    {"Hills", [] { return bent(Body::Terrain); }, false},
    {"Sphere", [] { return sphereMesh(4); }, false},
    {"Torus", [] { return torusMesh(40, 20, 2.0F, 0.7F); }, false},
    {"Rectangle", [] { return gridMesh(40, 25); }, false},
    {"CloudOfASphere", [] { return pointsOf(sphereMesh(4)); }, false},
    {"CloudOfARectangle", [] { return pointsOf(gridMesh(40, 25)); }, false},
    {"Box",
     [] {
       return scaled(sphereMesh(0), {1.0F, 2.0F, 3.0F});
     },
     false},
    {"Line", [] { return curveOf(800, [](float i) {
                    return Vector3{0.01F * i, 0.02F * i, 0.0F};
                  }); }, false},
    {"Circle", [] { return curveOf(800, [](float i) {
                      return Vector3{std::cos(i), std::sin(i), 0.0F};
                    }); }, false},
    {"OnePlace", [] { return curveOf(800, [](float) {
                        return Vector3{1.0F, 2.0F, 3.0F};
                      }); }, false},
    {"FewPoints", [] { return curveOf(8, [](float i) {
                         return Vector3{i, i * i, std::sin(i)};
                       }); }, false},
};

/** Of the shapes above some, for what is done to each with several numbers of threads. */
const std::vector<std::string> of_threads = {"Human", "CloudOfABird", "Hills", "CloudOfASphere", "Torus"};

const std::vector<Change> changes = {
    {"Permuted", permuted},
    {"TurnedAndMoved", turnedAndMoved},
    {"AThousandTimesSmaller",
     [](const Surface& s) {
       return scaledBy(s, 1e-3F);
     }},
    {"AThousandTimesLarger",
     [](const Surface& s) {
       return scaledBy(s, 1e3F);
     }},
    {"Mirrored", mirroredInSpace},
    {"WithDuplicates", withDuplicates},
};

/** A subject and what was found on it, once for all changes. */
struct Known {
  Surface surface;
  SymmetryResult result;
};

SymmetryResult
estimate(const Surface& surface, unsigned threads = 0)
{
  SymmetryParameters parameters;
  parameters.threads = threads;
  return estimateIntrinsicSymmetry(surface, parameters);
}

const Known&
known(const Subject& subject)
{
  static std::map<std::string, Known> all;
  const auto [entry, is_new] = all.try_emplace(subject.name);
  if (is_new) {
    entry->second.surface = subject.make();
    entry->second.result = estimate(entry->second.surface);
  }
  return entry->second;
}

/** Twice the distance of neighbouring points of a mesh, were they evenly spread: the bodies are about as large as each
 * other and have as many points. */
float
nearby(const Surface& mesh)
{
  return 2.0F * static_cast<float>(std::sqrt(surfaceArea(mesh) / static_cast<double>(mesh.size())));
}

/** Share of the points whose partners are where they were. */
double
shareKept(const Surface& surface,
          float near,
          const std::vector<Index>& before,
          const ChangedSurface& changed,
          const std::vector<Index>& after)
{
  std::size_t kept = 0;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Index partner = after[changed.number[v]];
    const bool is_kept = before[v] == no_index || partner == no_index
                             ? before[v] == partner
                             : distance(surface.points[before[v]], surface.points[changed.origin[partner]]) <= near;
    kept += is_kept ? 1U : 0U;
  }
  return static_cast<double>(kept) / static_cast<double>(surface.size());
}

class Properties : public testing::TestWithParam<std::tuple<Subject, Change>> {};

TEST_P(Properties, AreThoseOfTheShape)
{
  const auto& [subject, change] = GetParam();
  const auto& [surface, before] = known(subject);
  const ChangedSurface changed = change.apply(surface);
  const SymmetryResult after = estimate(changed.surface);
  if (subject.is_whole_or_not) {
    EXPECT_NE(before.status, SymmetryStatus::Symmetric);
    EXPECT_NE(after.status, SymmetryStatus::Symmetric);
    return;
  }
  EXPECT_EQ(after.status, before.status) << before.message << "; " << after.message;
  if (subject.has_one_map) {
    ASSERT_EQ(before.status, SymmetryStatus::Symmetric) << before.message;
    const double share = shareKept(surface, nearby(bentHuman().surface), before.partners, changed, after.partners);
    EXPECT_GE(share, 0.99);
  }
}

class ThreadProperties : public testing::TestWithParam<std::string> {};

TEST_P(ThreadProperties, AreNoneOfTheResult)
{
  const auto subject =
      std::find_if(subjects.begin(), subjects.end(), [](const Subject& s) { return s.name == GetParam(); });
  ASSERT_NE(subject, subjects.end());
  const Surface surface = subject->make();
  const SymmetryResult one = estimate(surface, 1);
  for (const unsigned threads : {2U, 3U, 64U}) {
    SCOPED_TRACE(threads);
    expectSameBytes(estimate(surface, threads), one);
  }
}

std::string
nameOfPair(const testing::TestParamInfo<std::tuple<Subject, Change>>& tested)
{
  return std::string(std::get<0>(tested.param).name) + std::get<1>(tested.param).name;
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         Properties,
                         testing::Combine(testing::ValuesIn(subjects), testing::ValuesIn(changes)),
                         nameOfPair);
INSTANTIATE_TEST_SUITE_P(Shapes, ThreadProperties, testing::ValuesIn(of_threads));

} // namespace
