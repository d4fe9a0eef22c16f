#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "io/fields.hpp"
#include "io/table.hpp"

namespace delone::io {
namespace {

namespace fs = std::filesystem;

// The registry is a fixed array of characters, because a signal handler may neither
// allocate nor lock. A slot goes empty -> filling -> live -> empty; the handler looks at
// live ones only.
enum class SlotState : int { empty, filling, live };

struct Slot {
  std::atomic<SlotState> state{SlotState::empty};
  std::array<char, PATH_MAX> path{};
};

static_assert(std::atomic<SlotState>::is_always_lock_free);

constexpr std::size_t num_slots = 32;
std::array<Slot, num_slots> slots;

/// The slot's number, or -1 if the registry is full or the path too long for the system
/// anyway.
int register_temporary(const std::string& path) {
  if (path.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < num_slots; ++i) {
    auto expected = SlotState::empty;
    if (!slots[i].state.compare_exchange_strong(expected, SlotState::filling)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state.store(SlotState::live);
    return static_cast<int>(i);
  }
  return -1;
}

void unregister_temporary(int slot) noexcept {
  if (slot >= 0) slots[static_cast<std::size_t>(slot)].state.store(SlotState::empty);
}

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw WriteError(path + ": cannot be written: " + why);
}

/// The number of an open descriptor that `path` is another name of. Opening such a name
/// would start at the file's first byte again and so destroy what `>> file` was to keep.
std::optional<int> named_descriptor(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    int number = -1;
    const char* const end = path.data() + path.size();
    const auto parsed = std::from_chars(path.data() + folder.size(), end, number);
    if (parsed.ec == std::errc{} && parsed.ptr == end) return number;
  }
  return std::nullopt;
}

/// Follows symbolic links of the last part of `path`, also to files that do not exist
/// yet.
fs::path follow_links(const std::string& path) {
  std::error_code error;
  fs::path result = fs::absolute(path, error);
  for (int depth = 0; fs::is_symlink(fs::symlink_status(result, error)); ++depth) {
    if (depth == 40) fail(path, reason(ELOOP));
    result = result.parent_path() / fs::read_symlink(result, error);
  }
  return result;
}

void check_folder(const std::string& path, const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::is_directory(status)) return;
  if (status.type() == fs::file_type::none) fail(path, error.message());
  if (fs::exists(status)) fail(path, folder.string() + " is not a folder");
  fail(path, "the folder " + folder.string() + " does not exist; create it (mkdir -p)");
}

std::string temporary_name(const fs::path& final_path, int attempt) {
  // File names end at 255 bytes, so a long one is cut.
  const std::string stem = final_path.filename().string().substr(0, 180);
  return (final_path.parent_path() / ("." + stem + ".delone-" + std::to_string(getpid()) +
                                      "-" + std::to_string(attempt) + ".tmp"))
      .string();
}

/// Some file systems and all pipes know no fsync; that is not a failed write.
bool sync_failed(int descriptor) {
  return fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  if (path.empty()) throw WriteError("the output's name is empty; name a file");
  if (const auto number = named_descriptor(path)) {
    open_directly(fcntl(*number, F_DUPFD_CLOEXEC, 3));
    return;
  }
  const fs::path target = follow_links(path);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status) || !target.has_filename())
    fail(path, "it is a folder; name a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    open_directly(open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    return;
  }
  check_folder(path, target.parent_path());
  if (fs::exists(status) && access(target.c_str(), W_OK) != 0) fail(path, reason(errno));
  final_path_ = target.string();
  open_temporary();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!final_path_.empty()) unlink(temporary_path_.c_str());
  unregister_temporary(slot_);
}

void OutputFile::open_directly(int descriptor) {
  if (descriptor < 0) fail(path_, reason(errno));
  descriptor_ = descriptor;
  temporary_path_ = path_ == "-" ? "/dev/stdout" : path_;
}

void OutputFile::open_temporary() {
  // Not mkstemp: it makes files that only the owner can read, and the umask cannot be
  // asked for without changing it under other threads' feet.
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_path_ = temporary_name(final_path_, attempt);
    // Registered before it exists, so that no moment is left for a signal to miss it.
    slot_ = register_temporary(temporary_path_);
    descriptor_ =
        open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) break;
    const int error_number = errno;
    unregister_temporary(slot_);
    slot_ = -1;
    if (error_number == EEXIST && attempt < 1000) continue;
    final_path_.clear();
    fail(path_, reason(error_number));
  }
  struct stat earlier {};
  if (stat(final_path_.c_str(), &earlier) == 0)
    static_cast<void>(fchmod(descriptor_, earlier.st_mode & 07777));
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, reason(errno));
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  if (descriptor_ < 0) fail(path_, "it is closed already");
  if (sync_failed(descriptor_)) fail(path_, reason(errno));
  if (close(std::exchange(descriptor_, -1)) != 0) fail(path_, reason(errno));
  if (final_path_.empty()) return;
  if (rename(temporary_path_.c_str(), final_path_.c_str()) != 0)
    fail(path_, reason(errno));
  final_path_.clear();  // nothing is left to remove
}

void remove_temporary_files() noexcept {
  for (Slot& slot : slots)
    if (slot.state.load() == SlotState::live) unlink(slot.path.data());
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string file_format(const std::string& path, const std::string& format) {
  std::string result =
      to_lower(format.empty() ? fs::path(path).extension().string() : format);
  if (result.starts_with('.')) result.erase(0, 1);
  return result;
}

}  // namespace delone::io
