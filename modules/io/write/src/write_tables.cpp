#include "io/write/output_file.h"
#include "io/write/record_writer.h"
#include "io/write/result_check.h"

#include <pcl/symmetry/surface_io.h>

namespace pcl {
namespace symmetry {

void
writeMap(const std::string& path, const SymmetryResult& result)
{
  checkResult(result, result.partners.size());
  std::string text = "vertex,partner,confidence\n";
  text.reserve(24 * (result.partners.size() + 1));
  for (std::size_t i = 0; i < result.partners.size(); ++i) {
    appendNumber(text, i);
    text += ',';
    appendNumber(text, result.partners[i]);
    text += ',';
    appendNumber(text, result.confidences[i]);
    text += '\n';
  }
  writeWholeFile(path, text);
}

void
writeCorrespondences(const std::string& path, const SymmetryResult& result)
{
  std::string text = "source,target,midpoint,cost\n";
  for (const SymmetricMatch& match : result.matches) {
    for (const Index index : {match.source, match.target, match.midpoint}) {
      appendNumber(text, index);
      text += ',';
    }
    appendNumber(text, match.cost);
    text += '\n';
  }
  writeWholeFile(path, text);
}

} // namespace symmetry
} // namespace pcl
