// Exit statuses and messages of a program, whatever it throws.
#include "cli/program.h"
#include "io/write/output_file.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <csignal>
#include <iostream>
#include <new>

using namespace pcl::symmetry;

namespace {

struct Outcome {
  int status;
  std::string errors;
};

Outcome
outcomeOf(const std::function<int()>& run)
{
  ::testing::internal::CaptureStderr();
  const int status = runProgram("program", run);
  return {status, ::testing::internal::GetCapturedStderr()};
}

template <typename Exception>
Outcome
outcomeOfThrowing(const Exception& exception)
{
  return outcomeOf([&exception]() -> int { throw exception; });
}

TEST(Program, HandsTheStatusOn)
{
  for (const int status : {exit_done, exit_failed, exit_no_symmetry}) {
    const Outcome outcome = outcomeOf([status] { return status; });
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.errors, "");
  }
}

TEST(Program, WordsEachErrorOnce)
{
  const Outcome usage = outcomeOfThrowing(UsageError("--threads is too large"));
  EXPECT_EQ(usage.status, 2);
  EXPECT_EQ(usage.errors, "program: --threads is too large\nTry 'program --help'.\n");
  const Outcome failure = outcomeOfThrowing(std::runtime_error("a.ply: cannot be read"));
  EXPECT_EQ(failure.status, 1);
  EXPECT_EQ(failure.errors, "program: a.ply: cannot be read\n");
  const Outcome pcl_failure = outcomeOfThrowing(pcl::IOException("a.ply: is empty"));
  EXPECT_EQ(pcl_failure.status, 1);
  EXPECT_EQ(pcl_failure.errors, "program: a.ply: is empty\n") << "without the colon of PCL's exceptions";
  const Outcome memory = outcomeOfThrowing(std::bad_alloc());
  EXPECT_EQ(memory.status, 1);
  EXPECT_EQ(memory.errors, "program: out of memory\n");
}

TEST(Program, FailsWhenItsOutputIsLost)
{
  std::cout.setstate(std::ios::badbit);
  const Outcome outcome = outcomeOf([] { return exit_done; });
  std::cout.clear();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.errors, "program: standard output: cannot be written\n");
}

class ProgramEndedBySignal : public test::TemporaryFolder, public testing::WithParamInterface<int> {};

TEST_P(ProgramEndedBySignal, LeavesNothingHalfWritten)
{
  const std::string file = write("map.csv", "old");
  const auto run = [&file]() -> int {
    OutputFile begun(file);
    begun.write("new");
    ::raise(GetParam());
    return exit_done;
  };
  EXPECT_EXIT(::_exit(runProgram("program", run)), testing::ExitedWithCode(128 + GetParam()), "");
  EXPECT_EQ(read(file), "old");
  EXPECT_EQ(countFiles(), 1U);
}

TEST_P(ProgramEndedBySignal, IsNotWhereItWasIgnoredBefore)
{
  const auto run = []() -> int {
    ::raise(GetParam());
    return exit_done;
  };
  EXPECT_EXIT((std::signal(GetParam(), SIG_IGN), ::_exit(runProgram("program", run))), testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(Signals, ProgramEndedBySignal, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGPIPE));

TEST(CheckUsage, MakesOneKindOfExceptionAMistakeOfUsage)
{
  const auto refuse = [] {
    throw pcl::BadArgumentException("noise is -1");
  };
  try {
    checkUsage<pcl::BadArgumentException>(refuse);
    FAIL();
  }
  catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "noise is -1");
  }
  EXPECT_THROW(checkUsage<std::invalid_argument>(refuse), pcl::BadArgumentException);
  EXPECT_NO_THROW(checkUsage<pcl::BadArgumentException>([] {}));
}

} // namespace
