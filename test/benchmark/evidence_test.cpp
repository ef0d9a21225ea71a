#include "base/vector_math.h"
#include "benchmark/evidence.h"
#include "model/articulated_body.h"
#include "model/write_model.h"
#include "support/boxes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
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
    EXPECT_EQ(std::count(names.begin(), names.end(), "misfit"), 1);
    EXPECT_GT(row.vertices.size(), 100U);
  }

  // What they explain alone gives no table at all.
  writeEvidence(path("none.csv"), collectEvidence({models_[0]}, options_, 1, errors));
  EXPECT_EQ(read(path("none.csv")), "");
  EXPECT_EQ(errors.str(), "");
}

float
measureOf(const EvidenceRow& row, const std::string& name)
{
  const auto measure =
      std::find_if(row.measures.begin(), row.measures.end(), [&name](const auto& m) { return m.first == name; });
  return measure == row.measures.end() ? std::numeric_limits<float>::quiet_NaN() : measure->second;
}

TEST_F(EvidenceTest, ContendersAreAllMapsAmongWhichOneIsChosen)
{
  std::ostringstream errors;
  const std::vector<EvidenceRow> chosen = collectEvidence(models_, options_, 1, errors);
  const std::vector<EvidenceRow> rows = collectContenders(models_, options_, 1, errors);
  EXPECT_EQ(errors.str(), "");
  ASSERT_FALSE(chosen.empty());
  ASSERT_FALSE(rows.empty());

  // The one that is taken comes first, as the first interpretation has it, and fits best.
  EXPECT_EQ(rows.front().confidence, chosen.front().confidence);
  EXPECT_EQ(rows.front().rate, chosen.front().rate);
  EXPECT_EQ(measureOf(rows.front(), "misfit"), measureOf(chosen.front(), "misfit"));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].model.name, "human") << "a mirror plane explains the chair";
    EXPECT_EQ(rows[k].number, k);
    EXPECT_GE(measureOf(rows[k], "misfit"), measureOf(rows.front(), "misfit"));
    EXPECT_EQ(namesOfMeasures(rows[k]), namesOfMeasures(rows.front()));
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
