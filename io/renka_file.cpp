#include "io/renka_file.hpp"

#include <cstdlib>

#include "io/file_bytes.hpp"
#include "io/text_cursor.hpp"
#include "io/text_writer.hpp"

namespace delone::io {

void write_renka(const std::string& path, const delaunay::RenkaLists& lists) {
  const auto num_entries = static_cast<std::size_t>(lists.lnew - 1);
  TextWriter text(path);
  text << lists.lend.size() << ' ' << num_entries << '\n';
  for (std::size_t i = 0; i < num_entries; ++i)
    text << lists.list[i] << ' ' << lists.lptr[i] << '\n';
  for (const std::int32_t end : lists.lend) text << end << '\n';
  text.commit();
}

delaunay::RenkaLists read_renka(const std::string& path) {
  const std::string text = read_bytes(path);
  TextCursor cursor(path, text);
  const std::int64_t num_nodes = cursor.count("the number of nodes", 2);
  const std::int64_t num_entries = cursor.count("the number of entries", 4);
  delaunay::RenkaLists lists;
  for (std::int64_t i = 0; i < num_entries; ++i) {
    const std::int64_t neighbor = cursor.integer("a neighbour");
    if (neighbor == 0 || std::abs(neighbor) > num_nodes)
      cursor.fail("neighbour " + std::to_string(neighbor) + " with " +
                  std::to_string(num_nodes) + " nodes");
    lists.list.push_back(static_cast<std::int32_t>(neighbor));
    lists.lptr.push_back(cursor.index("a pointer", num_entries, 1) + 1);
  }
  // A node without neighbours has 0.
  for (std::int64_t i = 0; i < num_nodes; ++i)
    lists.lend.push_back(cursor.index("a list's end", num_entries + 1));
  lists.lnew = static_cast<std::int32_t>(num_entries + 1);
  if (!cursor.is_at_end()) cursor.fail("there is more than the lists of the header");
  return lists;
}

}  // namespace delone::io
