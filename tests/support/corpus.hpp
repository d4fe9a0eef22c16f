#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/plane_sets.hpp"
#include "support/sphere_sets.hpp"

namespace delone::support {

/// One nasty case of tests/corpus. The first line of its file says what kind of points
/// follow, one a line, and what is special about them:
///   # plane: ...     x y
///   # lonlat: ...    degrees
///   # xyz: ...       vectors of any length
/// Numbers are decimal or hexadecimal. Further lines that begin with # are remarks.
struct CorpusCase {
  std::string name;   ///< of the file, without its ending
  std::string title;  ///< what is special
  bool is_plane = true;
  PlanePoints plane;
  SpherePoints sphere;
};

/// Throws std::invalid_argument if the text is not a case.
[[nodiscard]] CorpusCase parse_corpus_case(std::string_view text);

/// Every file of the corpus that holds points of the plane, or of the sphere, in order of
/// names. Throws std::invalid_argument naming a file that is not a case.
[[nodiscard]] std::vector<CorpusCase> plane_corpus(const std::string& folder);
[[nodiscard]] std::vector<CorpusCase> sphere_corpus(const std::string& folder);

}  // namespace delone::support
