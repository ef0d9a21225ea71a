#include "support/bytes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using ReadStl = TemporaryFolder;
using Facet = std::array<Vector3, 3>;

const std::vector<Facet> tetrahedron = {{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                        {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                                        {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
                                        {{{1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 1}}}};
const std::vector<Vector3> corners = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}};

std::string
binaryStl(std::string header, const std::vector<Facet>& facets)
{
  header.resize(80, ' ');
  Bytes bytes;
  bytes.add(static_cast<std::uint32_t>(facets.size()));
  for (const Facet& facet : facets)
    bytes.add(Vector3{0, 0, 1}, facet[0], facet[1], facet[2], std::uint16_t{0});
  return header + bytes.str();
}

std::string
textStl(const std::vector<Facet>& facets)
{
  std::string text = "solid a name of several words\n";
  for (const Facet& facet : facets) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const Vector3& v : facet)
      text += "      vertex " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a name of several words\n";
}

TEST_F(ReadStl, EqualPositionsBecomeOnePoint)
{
  const std::string contents[] = {binaryStl("made by hand", tetrahedron), binaryStl("solid but binary", tetrahedron),
                                  binaryStl("solid padded", tetrahedron) + std::string(6, '\0'), textStl(tetrahedron)};
  for (const std::string& content : contents) {
    SCOPED_TRACE(content.substr(0, 16));
    const Surface surface = readSurface(write("tetrahedron.StL", content));
    EXPECT_EQ(surface.points, corners);
    EXPECT_EQ(surface.triangles, triangles);
  }
}

TEST_F(ReadStl, SeveralSolidsInCapitals)
{
  std::string text = textStl({tetrahedron[0]}) + textStl({tetrahedron[1]});
  for (char& c : text)
    c = static_cast<char>(std::toupper(c));
  const Surface surface = readSurface(write("two.stl", text));
  EXPECT_EQ(surface.points, corners);
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(ReadStl, ADegenerateFacetLeavesItsPoints)
{
  const Surface surface =
      readSurface(write("flat.stl", binaryStl("", {{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}}, tetrahedron[0]})));
  EXPECT_EQ(surface.points, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 2, 1}}));
}

TEST_F(ReadStl, ManyPointsKeepTheirNumbers)
{
  std::vector<Facet> facets;
  for (int i = 0; i < 5000; ++i) {
    const auto x = static_cast<float>(i);
    facets.push_back({{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}});
  }
  const Surface surface = readSurface(write("strip.stl", binaryStl("", facets)));
  ASSERT_EQ(surface.size(), 10001U);
  ASSERT_EQ(surface.triangles.size(), facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(surface.points[static_cast<std::size_t>(surface.triangles[i][k])], facets[i][k]);
}

TEST_F(ReadStl, TextWithComments)
{
  std::string text = textStl(tetrahedron);
  text.insert(text.find("    endloop"), "      // behind the corners\n");
  text.insert(text.find("    outer loop") + 14, " # of the first facet");
  for (const char* comment : {"# made by hand\n", "\n  // made by hand\n", "; made by hand\n#\n"}) {
    const Surface surface = readSurface(write("comments.stl", comment + text + comment));
    EXPECT_EQ(surface.points, corners);
    EXPECT_EQ(surface.triangles, triangles);
  }
}

/** \brief Positions that the multiplications of a hash without a secret would bring together: an inverse times a small
 * number. */
TEST_F(ReadStl, NoFileMakesTheMergingSlow)
{
  std::vector<Facet> facets;
  std::uint64_t inverse = 0x94D049BB133111EBULL; // Newton's method for the inverse modulo 2 to the 64
  for (int i = 0; i < 6; ++i)
    inverse *= 2 - 0x94D049BB133111EBULL * inverse;
  Facet facet = {};
  std::size_t corner = 0;
  for (std::uint32_t k = 0; facets.size() < 20000; ++k) {
    const float x = 1.0F + static_cast<float>(k) * 1e-4F;
    const float y = 1.0F;
    std::uint32_t bits[2];
    std::memcpy(&bits[0], &x, sizeof(x));
    std::memcpy(&bits[1], &y, sizeof(y));
    std::uint64_t hash = bits[0] * 0x9E3779B97F4A7C15ULL;
    hash = (hash ^ (hash >> 32) ^ bits[1]) * 0xBF58476D1CE4E5B9ULL;
    hash ^= hash >> 32;
    for (std::uint64_t slot = 0; slot < (1U << 20); ++slot) {
      const std::uint64_t value = (slot * inverse) ^ hash;
      const auto last = static_cast<std::uint32_t>(value);
      const std::uint32_t exponent = (last >> 23) & 255U;
      if (((value >> 32) & 1023U) != 0 || exponent > 130 || exponent < 90)
        continue;
      facet[corner][0] = x;
      facet[corner][1] = y;
      std::memcpy(&facet[corner][2], &last, sizeof(last));
      corner = (corner + 1) % 3;
      if (corner == 0)
        facets.push_back(facet);
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  const Surface surface = readSurface(write("collide.stl", binaryStl("", facets)));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 1.0);
  EXPECT_GT(surface.size(), 50000U);
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
