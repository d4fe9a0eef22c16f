#include "delaunay/query_order.hpp"

#include <string>

namespace delone::delaunay {

void check_num_queries(std::size_t num_queries) {
  if (num_queries <= max_queries) return;
  throw Error(std::to_string(num_queries) + " queries are more than the limit of " +
              std::to_string(max_queries) + " a call; divide them");
}

}  // namespace delone::delaunay
