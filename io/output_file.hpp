#pragma once

#include <string>
#include <string_view>

namespace delone::io {

/// A file written beside its final name and renamed into place by commit(), so that an
/// interrupted or failed run leaves no partial output and no damaged earlier file.
///
/// The temporary file is called `.NAME.delone-PID-N.tmp`. A file that existed before
/// keeps its permissions, a new one gets those of the process's umask. A symbolic link is
/// followed: the file it points to is replaced, the link stays. Devices, pipes,
/// `/dev/stdout`, `/dev/fd/N` and "-" (standard output) cannot be renamed into and are
/// written directly.
///
/// Every function throws WriteError naming the file, the reason and, where there is one,
/// the mend.
class OutputFile {
 public:
  /// Opens the temporary file. WriteError if the folder does not exist or is not
  /// writable, if `path` is a folder, or if the file there is write-protected.
  explicit OutputFile(const std::string& path);
  /// Without commit() the temporary file is removed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends `bytes`; all of them are with the system when this returns.
  void write(std::string_view bytes);

  /// Where the bytes go until commit(), for libraries that insist on a file name. Whoever
  /// writes through it checks his own errors. The path itself for what is written
  /// directly.
  [[nodiscard]] const std::string& temporary_path() const noexcept {
    return temporary_path_;
  }

  /// Forces the bytes to the disk and renames the file to its final name.
  void commit();

 private:
  void open_directly(int descriptor);
  void open_temporary();

  std::string path_;        // as the caller named it, for messages
  std::string final_path_;  // absolute, links followed; empty if written directly
  std::string temporary_path_;
  int descriptor_ = -1;
  int slot_ = -1;  // in the registry of temporary files
};

/// Removes the temporary files of all writers that are open. Async-signal-safe: for the
/// program's signal handler. Their commit() fails afterwards.
void remove_temporary_files() noexcept;

/// Writes `text` to `path` as OutputFile does.
void write_text(const std::string& path, std::string_view text);

/// The format that an output is asked for: `format` if given, else the extension of
/// `path`; lower case, without the dot.
[[nodiscard]] std::string file_format(const std::string& path,
                                      const std::string& format = "");

}  // namespace delone::io
