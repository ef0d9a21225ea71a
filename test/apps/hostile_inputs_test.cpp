// A table of inputs made to hang, crash or deceive pcl_intrinsic_symmetry, each with the outcomes that are right, and a
// limit on time and memory that holds for all of them.
#include "apps/hostile_inputs.h"
#include "apps/run_program.h"
#include "model/write_model.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr unsigned most_seconds = 40; ///< on one core; 20 where nobody else takes a part of it
constexpr double most_megabytes = 1000.0;

class HostileInputs : public TemporaryFolder {
protected:
  void
  expectOutcome(const std::string& input, const std::string& statuses, std::vector<std::string> options) const
  {
    options.insert(options.begin(), {input, "--threads", "1", "--map", path("map.csv")});
    Streams streams;
#ifndef PCL_SYMMETRY_SANITIZED // sanitizers take many times as much of both
    streams.cpu_seconds = most_seconds;
#endif
    std::replace(options.begin(), options.end(), std::string("PICTURE"), path("picture.png"));
    const ProgramRun run = runProgram("pcl_intrinsic_symmetry", options, streams);
    ASSERT_NE(run.exit_status, -1) << "killed, after " << run.cpu_seconds << " s; " << run.errors;
    EXPECT_NE(statuses.find(std::to_string(run.exit_status)), std::string::npos)
        << "exit status " << run.exit_status << ", right is " << statuses << ": " << run.output << run.errors;
    const bool has_failed = run.exit_status == 1;
    EXPECT_EQ(run.output.empty(), has_failed) << run.output;
    EXPECT_TRUE(has_failed ? !run.errors.empty()
                           : run.errors.empty() || run.errors.find("warning") != std::string::npos)
        << run.errors;
    if (streams.cpu_seconds > 0) {
      EXPECT_LT(run.megabytes, most_megabytes);
    }
    RecordProperty("cpu_seconds", std::to_string(run.cpu_seconds));
  }
};

class HostileSurface : public HostileInputs, public testing::WithParamInterface<Hostile> {};

TEST_P(HostileSurface, EndsInTimeAndSaysWhatItIs)
{
  const Surface surface = GetParam().surface();
  const std::string file = path("input.ply");
  writePlainSurface(file, surface);
  expectOutcome(file, GetParam().statuses, GetParam().options);
}

class HostileBytes : public HostileInputs, public testing::WithParamInterface<HostileFile> {};

TEST_P(HostileBytes, AreRefusedByName)
{
  const std::string file = write(GetParam().file, GetParam().content());
  expectOutcome(file, "1", {});
}

template <typename Row>
std::string
nameOf(const testing::TestParamInfo<Row>& row)
{
  return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(Table, HostileSurface, testing::ValuesIn(hostileSurfaces()), nameOf<Hostile>);
INSTANTIATE_TEST_SUITE_P(Geometry, HostileSurface, testing::ValuesIn(hostileGeometry()), nameOf<Hostile>);
INSTANTIATE_TEST_SUITE_P(Table, HostileBytes, testing::ValuesIn(hostileFiles()), nameOf<HostileFile>);

} // namespace
