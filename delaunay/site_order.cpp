#include "delaunay/site_order.hpp"

#include <algorithm>

namespace delone::delaunay {

BlockKeys BlockKeys::inside(Site begin, Site end) const noexcept {
  const auto before = [](const CellKeys& cell, std::pair<Site, Site> range) {
    return std::pair(cell.begin, cell.end) < range;
  };
  const auto cell = std::lower_bound(order_->cells.begin(), order_->cells.end(),
                                     std::pair(begin, end), before);
  BlockKeys result = *this;
  if (cell != order_->cells.end() && cell->begin == begin && cell->end == end)
    result.keys_ = cell->keys.data() - begin;
  return result;
}

OrderWriter::OrderWriter(std::span<const SettledPart> parts, std::size_t num_rows)
    : parts_(parts) {
  Site num_sites = 0;
  for (const SettledPart& part : parts) {
    begins_.push_back(num_sites);
    num_sites += part.num_sites;
  }
  order_.rows.resize(static_cast<std::size_t>(num_sites));
  order_.keys.resize(static_cast<std::size_t>(num_sites));
  order_.sites.resize(num_rows);
}

void OrderWriter::write(std::size_t k) {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  const SettledPart& part = parts_[k];
  for (Site i = 0; i < part.num_sites; ++i) {
    const KeyedRow item = part.items[at(i)];
    const auto row = static_cast<Node>(item & 0xffffffffu);
    const Site site = begins_[k] + i;
    order_.rows[at(site)] = row;
    order_.keys[at(site)] = static_cast<std::uint32_t>(item >> 32);
    order_.sites[at(row)] = site;
  }
  for (const Repeat repeat : part.repeats)
    order_.sites[at(repeat.row)] = begins_[k] + repeat.site;
}

SiteOrder OrderWriter::finish() && {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    for (const CellKeys& cell : parts_[k].cells) {
      order_.cells.push_back({begins_[k] + cell.begin, begins_[k] + cell.end, cell.keys});
    }
  }
  std::sort(order_.cells.begin(), order_.cells.end(),
            [](const CellKeys& a, const CellKeys& b) {
              return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
            });
  return std::move(order_);
}

std::vector<std::span<KeyedRow>> cut_between_keys(std::span<KeyedRow> items,
                                                  std::size_t num_parts) {
  std::vector<std::span<KeyedRow>> spans;
  std::size_t begin = 0;
  for (std::size_t k = 1; k <= num_parts; ++k) {
    std::size_t end = std::max(begin, items.size() * k / num_parts);
    while (end > begin && end < items.size() && items[end - 1] >> 32 == items[end] >> 32)
      ++end;
    if (end > begin) spans.push_back(items.subspan(begin, end - begin));
    begin = end;
  }
  return spans;
}

}  // namespace delone::delaunay
