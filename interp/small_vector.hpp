#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace delone::interp {

/// A list that needs no memory of its own up to `Inline` items: what a query collects.
/// Items that were not given a value have none.
template <class T, std::size_t Inline>
class SmallVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  // Not = default: that would clear all the items, which costs more than a query.
  SmallVector() noexcept {}  // NOLINT(modernize-use-equals-default)
  explicit SmallVector(std::size_t size) {
    if (size > Inline) grow(size);
    size_ = size;
  }
  SmallVector(std::size_t size, const T& value) : SmallVector(size) {
    std::fill(begin(), end(), value);
  }
  SmallVector(const SmallVector& other) : SmallVector(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }
  SmallVector(SmallVector&& other) noexcept { take(other); }
  SmallVector& operator=(const SmallVector& other) {
    if (this != &other) *this = SmallVector(other);
    return *this;
  }
  SmallVector& operator=(SmallVector&& other) noexcept {
    if (this != &other) take(other);
    return *this;
  }
  ~SmallVector() = default;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] T* data() noexcept { return items_; }
  [[nodiscard]] const T* data() const noexcept { return items_; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return items_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return items_[i]; }
  [[nodiscard]] T* begin() noexcept { return items_; }
  [[nodiscard]] T* end() noexcept { return items_ + size_; }
  [[nodiscard]] const T* begin() const noexcept { return items_; }
  [[nodiscard]] const T* end() const noexcept { return items_ + size_; }
  [[nodiscard]] T& back() noexcept { return items_[size_ - 1]; }

  void push_back(T item) {
    if (size_ == capacity_) grow(2 * capacity_);
    items_[size_++] = item;
  }
  void pop_back() noexcept { --size_; }
  void clear() noexcept { size_ = 0; }

 private:
  [[nodiscard]] T* own() noexcept { return reinterpret_cast<T*>(bytes_.data()); }
  void take(SmallVector& other) noexcept {
    more_ = std::move(other.more_);
    items_ = more_ ? more_.get() : own();
    capacity_ = more_ ? other.capacity_ : Inline;
    size_ = other.size_;
    if (!more_) std::copy(other.begin(), other.end(), items_);
    other.items_ = other.own();
    other.capacity_ = Inline;
    other.size_ = 0;
  }
  [[gnu::noinline]] void grow(std::size_t capacity) {
    auto larger = std::make_unique<T[]>(capacity);
    std::copy(begin(), end(), larger.get());
    more_ = std::move(larger);
    items_ = more_.get();
    capacity_ = capacity;
  }

  T* items_ = own();
  std::size_t size_ = 0, capacity_ = Inline;
  std::unique_ptr<T[]> more_;
  alignas(T) std::array<std::byte, Inline * sizeof(T)> bytes_;
};

}  // namespace delone::interp
