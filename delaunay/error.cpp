#include "delaunay/error.hpp"

#include <utility>

namespace delone {

Error::Error(const std::string& message, std::vector<std::int64_t> rows)
    : std::runtime_error(message), rows_(std::move(rows)) {}

Cancelled::Cancelled() : Error("cancelled") {}

}  // namespace delone
