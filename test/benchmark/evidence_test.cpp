#include "base/vector_math.h"
#include "benchmark/evidence.h"
#include "model/articulated_body.h"
#include "model/write_model.h"
#include "support/boxes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

/** A chair, which a mirror plane explains, and a body in a pose, which none does; each with its true partners. */
class EvidenceTest : public TemporaryFolder {
protected:
  EvidenceTest()
  {
    const Surface chair = chairOfBoxes();
    std::string truth;
    for (const Vector3& p : chair.points) {
      const auto isPartner = [&p](const Vector3& q) {
        return distance(q, {-p[0], p[1], p[2]}) < 1e-5F;
      };
      truth += std::to_string(1 + std::distance(chair.points.begin(),
                                                std::find_if(chair.points.begin(), chair.points.end(), isPartner))) +
               "\n";
    }
    write("Made/chair_sym.txt", truth);
    writePlainSurface(path("Made/chair.off"), chair);

    ModelParameters parameters;
    parameters.vertices = 2500;
    const Model human = makeModel(parameters);
    truth.clear();
    for (const Index partner : human.partners)
      truth += std::to_string(partner + 1) + "\n";
    write("Made/human_sym.txt", truth);
    writePlainSurface(path("Made/human.off"), human.surface);

    models_ = findModels(path("Made"));
    options_.parameters.threads = 1;
  }

  std::vector<BenchmarkModel> models_;
  RunOptions options_;
};

std::vector<std::string>
namesOfMeasures(const EvidenceRow& row)
{
  std::vector<std::string> names;
  for (const auto& measure : row.measures)
    names.push_back(measure.first);
  return names;
}

TEST_F(EvidenceTest, MapsByAMirrorPlaneAreLeftOut)
{
  ASSERT_EQ(models_.size(), 2U);
  const ModelRun chair = runModel(models_[0], options_);
  ASSERT_EQ(chair.model.name, "chair");
  ASSERT_EQ(chair.status, SymmetryStatus::Symmetric) << chair.message; // there is a map to leave out
  EXPECT_EQ(chair.correspondenceRate(), 1.0);

  std::ostringstream errors;
  const std::vector<EvidenceRow> rows = collectEvidence(models_, options_, 1, errors);
  EXPECT_EQ(errors.str(), "");
  ASSERT_FALSE(rows.empty());
  const std::vector<std::string> names = namesOfMeasures(rows.front());
  EXPECT_GT(names.size(), 10U);
  for (const EvidenceRow& row : rows) {
    EXPECT_EQ(row.model.name, "human");
    EXPECT_EQ(namesOfMeasures(row), names) << "one header serves all rows";
    EXPECT_GT(row.vertices.size(), 100U);
  }

  // What they explain alone gives no table at all.
  writeEvidence(path("none.csv"), collectEvidence({models_[0]}, options_, 1, errors));
  EXPECT_EQ(read(path("none.csv")), "");
  EXPECT_EQ(errors.str(), "");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
