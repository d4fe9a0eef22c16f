#include "cli/settings.hpp"

#include <algorithm>

namespace delone::cli {
namespace {

using interp::Duplicates;

template <class T>
std::string_view word_for(T meaning, const std::vector<Choice<T>>& choices) {
  return std::ranges::find(choices, meaning, &Choice<T>::second)->first;
}

}  // namespace

const std::vector<Choice<Domain>>& domain_choices() {
  static const std::vector<Choice<Domain>> choices{{"plane", Domain::plane},
                                                   {"sphere", Domain::sphere},
                                                   {"ellipsoid", Domain::ellipsoid}};
  return choices;
}

const std::vector<Choice<Duplicates>>& duplicates_choices() {
  static const std::vector<Choice<Duplicates>> choices{
      {"mean", Duplicates::mean},  {"first", Duplicates::first},
      {"last", Duplicates::last},  {"median", Duplicates::median},
      {"min", Duplicates::min},    {"max", Duplicates::max},
      {"error", Duplicates::error}};
  return choices;
}

std::string_view name_of(Domain domain) { return word_for(domain, domain_choices()); }

std::string_view name_of(Duplicates duplicates) {
  return word_for(duplicates, duplicates_choices());
}

}  // namespace delone::cli
