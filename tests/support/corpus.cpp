#include "support/corpus.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace delone::support {

namespace {

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.c_str();
  for (;;) {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) break;
    numbers.push_back(value);
    at = end;
  }
  const std::string rest = at;
  if (rest.find_first_not_of(" \t\r") != std::string::npos) {
    throw std::invalid_argument("not a number: " + rest);
  }
  return numbers;
}

enum class Kind { plane, lonlat, xyz };

Kind kind_of(const std::string& word) {
  if (word == "plane") return Kind::plane;
  if (word == "lonlat") return Kind::lonlat;
  if (word == "xyz") return Kind::xyz;
  throw std::invalid_argument(
      "the first line must begin with # plane:, # lonlat: or # xyz:");
}

void add_point(CorpusCase& result, Kind kind, const std::vector<double>& row) {
  if (row.size() != (kind == Kind::xyz ? 3u : 2u))
    throw std::invalid_argument("ragged row");
  if (kind == Kind::plane) result.plane.push_back({row[0], row[1]});
  if (kind == Kind::lonlat) {
    result.sphere.push_back(stripack::Direction::from(stripack::LonLat{row[0], row[1]}));
  }
  if (kind == Kind::xyz) {
    result.sphere.push_back(stripack::Direction::from(row[0], row[1], row[2]));
  }
}

std::vector<CorpusCase> corpus(const std::string& folder) {
  std::vector<CorpusCase> cases;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".txt") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
      cases.push_back(parse_corpus_case(text));
    } catch (const std::exception& error) {
      throw std::invalid_argument(entry.path().string() + ": " + error.what());
    }
    cases.back().name = entry.path().stem().string();
  }
  std::sort(cases.begin(), cases.end(),
            [](const CorpusCase& a, const CorpusCase& b) { return a.name < b.name; });
  return cases;
}

}  // namespace

CorpusCase parse_corpus_case(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::string line;
  std::getline(lines, line);
  const std::size_t colon = line.find(':');
  if (line.rfind("# ", 0) != 0 || colon == std::string::npos) {
    throw std::invalid_argument("the first line must say what is special");
  }
  const Kind kind = kind_of(line.substr(2, colon - 2));
  CorpusCase result;
  result.is_plane = kind == Kind::plane;
  result.title = line.substr(std::min(line.size(), colon + 2));
  while (std::getline(lines, line)) {
    if (line.empty() || line[0] == '#') continue;
    add_point(result, kind, numbers_of(line));
  }
  return result;
}

std::vector<CorpusCase> plane_corpus(const std::string& folder) {
  auto cases = corpus(folder);
  std::erase_if(cases, [](const CorpusCase& c) { return !c.is_plane; });
  return cases;
}

std::vector<CorpusCase> sphere_corpus(const std::string& folder) {
  auto cases = corpus(folder);
  std::erase_if(cases, [](const CorpusCase& c) { return c.is_plane; });
  return cases;
}

}  // namespace delone::support
