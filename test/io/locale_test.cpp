// Files have points and no separators of thousands, whatever the user's language has.
#include "io/sample_result.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>

#include <clocale>
#include <locale>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

/** \brief Commas before decimals and points between thousands, as in much of Europe; no such locale need be installed. */
class CommaNumbers : public std::numpunct<char> {
protected:
  char
  do_decimal_point() const override
  {
    return ',';
  }

  char
  do_thousands_sep() const override
  {
    return '.';
  }

  std::string
  do_grouping() const override
  {
    return "\3";
  }
};

/** \brief While it lives numbers look so, in C as well where the machine knows how. */
class CommaScope {
public:
  CommaScope() : before_(std::locale::global(std::locale(std::locale::classic(), new CommaNumbers)))
  {
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  }
  ~CommaScope()
  {
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(before_);
  }
  CommaScope(const CommaScope&) = delete;
  CommaScope&
  operator=(const CommaScope&) = delete;
  CommaScope(CommaScope&&) = delete;
  CommaScope&
  operator=(CommaScope&&) = delete;

private:
  std::locale before_;
};

using Locale = TemporaryFolder;

TEST_F(Locale, TextIsReadTheSame)
{
  const std::vector<Vector3> points = {{0.5F, -1.25F, 1500.75F}, {1e-3F, 2.0F, 0.0F}, {1234.5F, 0.25F, 3.0F}};
  const std::string rows = "0.5 -1.25 1500.75\n1e-3 2 0\n1234.5 .25 3\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.xyz", rows},
      {"a.off", "OFF\n3 1 0\n" + rows + "3 0 1 2\n"},
      {"a.obj", "v 0.5 -1.25 1500.75\nv 1e-3 2 0\nv 1234.5 .25 3\nf 1 2 3\n"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "end_header\n" +
                    rows},
      {"a.pcd", "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"
                "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n" +
                    rows},
      {"a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n" + rows},
      {"a.stl",
       "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0.5 -1.25 1500.75\nvertex 1e-3 2 0\nvertex 1234.5 .25 3\n"
       "endloop\nendfacet\nendsolid x\n"}};
  const CommaScope commas;
  for (const auto& [name, content] : files) {
    EXPECT_EQ(readSurface(write(name, content)).points, points) << name;
  }
}

TEST_F(Locale, TextIsWrittenTheSame)
{
  const auto write_all = [this](const std::string& folder) {
    std::filesystem::create_directory(path(folder));
    SymmetryResult result = roofSymmetry();
    result.input.outliers = 1234567;
    writeMap(path(folder + "/map.csv"), result);
    writeCorrespondences(path(folder + "/matches.csv"), result);
    writeReport(path(folder + "/report.json"), "a.ply", {}, result);
    writeAxis(path(folder + "/axis.csv"), roof(), result);
    writeLabelledSurface(path(folder + "/labels.ply"), roof(), result);
  };
  write_all("plain");
  {
    const CommaScope commas;
    write_all("commas");
  }
  for (const char* name : {"map.csv", "matches.csv", "report.json", "axis.csv", "labels.ply"}) {
    EXPECT_EQ(read(path(std::string("commas/") + name)), read(path(std::string("plain/") + name))) << name;
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
