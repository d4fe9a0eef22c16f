#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "io/memory_file.hpp"
#include "io/mesh.hpp"
#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::test {

/// The mesh; nothing if the file is refused, which must take one line and name the file.
inline std::optional<io::Mesh> read_or_refuse(const MemoryFile& file,
                                              const std::string& format) {
  try {
    return io::read_mesh(file.path(), format);
  } catch (const io::ReadError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    EXPECT_TRUE(message.starts_with(file.path() + ": ")) << message;
    return std::nullopt;
  }
}

inline std::optional<io::Mesh> read_or_refuse(const std::string& content,
                                              const std::string& format) {
  const MemoryFile file;
  file.put(content);
  return read_or_refuse(file, format);
}

/// The message without the name of the file.
inline std::string complaint(const std::string& content, const std::string& format) {
  const MemoryFile file;
  file.put(content);
  const std::string message =
      message_of<io::ReadError>([&] { return io::read_mesh(file.path(), format); });
  return message.substr(std::min(message.size(), file.path().size() + 2));
}

}  // namespace delone::test
