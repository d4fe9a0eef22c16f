#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace delone::test {

/// An empty folder that goes away with the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The path of a file in the folder, which need not exist.
  [[nodiscard]] std::string operator/(std::string_view name) const {
    return (path_ / name).string();
  }
  /// Writes a file and returns its path.
  std::string write(std::string_view name, std::string_view text) const;
  [[nodiscard]] std::string read(std::string_view name) const;
  /// What lies in the folder, sorted, hidden files too.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_file(const std::string& path);
[[nodiscard]] std::vector<std::string> lines(const std::string& text);

/// How a run of the program ended.
struct Outcome {
  int exit_code = -1;  ///< -1: died of `signal`
  int signal = 0;
  std::string out, err;
};

/// Where a run's standard streams are connected.
struct Streams {
  std::string input{};              ///< text on standard input
  std::string out_path{};           ///< empty: Outcome::out
  std::string working_folder{"."};  ///< where relative names start
};

/// A run of the program that has begun.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments,
                   const Streams& streams = {});
  void send(int signal) const;
  [[nodiscard]] bool is_running();
  [[nodiscard]] Outcome wait();

 private:
  Folder folder_;  // of the streams
  bool keeps_out_ = true;
  pid_t pid_ = -1;
  int status_ = 0;
  bool has_ended_ = false;
};

/// Runs the program to its end.
[[nodiscard]] Outcome run(const std::vector<std::string>& arguments,
                          const Streams& streams = {});

/// Checks what is promised for every failure: the exit code, and one line on standard
/// error that begins with `delone: error: `, is the last one and holds `words`.
void expect_failure(const Outcome& outcome, int exit_code,
                    const std::vector<std::string>& words);

/// Checks for success and returns the outcome, so that a test stops making sense of what
/// failed.
void expect_success(const Outcome& outcome);

/// A CSV `x,y,value` (or the columns of `header`) of points that look random, the same
/// for the same seed, with coordinates in 0..1 and values of a smooth function.
[[nodiscard]] std::string scattered_csv(int num_points, unsigned seed = 1,
                                        std::string_view header = "x,y,value");

}  // namespace delone::test
