#include "cli/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace delone::test {

namespace fs = std::filesystem;

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "delone-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary folder: " + name);
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Folder::write(std::string_view name, std::string_view text) const {
  const std::string path = *this / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string Folder::read(std::string_view name) const { return read_file(*this / name); }

std::vector<std::string> Folder::names() const {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(path_))
    result.push_back(entry.path().filename());
  std::ranges::sort(result);
  return result;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

namespace {

/// What a shell lets a job in the background ignore (SIGINT) is not ignored by the
/// program.
class SignalsByDefault {
 public:
  SignalsByDefault() {
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  SignalsByDefault(const SignalsByDefault&) = delete;
  SignalsByDefault& operator=(const SignalsByDefault&) = delete;
  ~SignalsByDefault() { posix_spawnattr_destroy(&attributes_); }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const Streams& streams)
    : keeps_out_(streams.out_path.empty()) {
  const std::string in = folder_.write("in", streams.input), err = folder_ / "err";
  const std::string out = keeps_out_ ? folder_ / "out" : streams.out_path;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(),
                                   O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(),
                                   O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, streams.working_folder.c_str());
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), DELONE_PROGRAM);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const SignalsByDefault signals;
  const int error = posix_spawn(&pid_, DELONE_PROGRAM, &actions, signals.attributes(),
                                argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot run " DELONE_PROGRAM);
}

void Process::send(int signal) const { kill(pid_, signal); }

bool Process::is_running() {
  if (!has_ended_) has_ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return !has_ended_;
}

Outcome Process::wait() {
  if (!has_ended_) waitpid(pid_, &status_, 0);
  has_ended_ = true;
  Outcome outcome;
  if (WIFEXITED(status_)) outcome.exit_code = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) outcome.signal = WTERMSIG(status_);
  if (keeps_out_) outcome.out = folder_.read("out");
  outcome.err = folder_.read("err");
  return outcome;
}

Outcome run(const std::vector<std::string>& arguments, const Streams& streams) {
  return Process(arguments, streams).wait();
}

void expect_failure(const Outcome& outcome, int exit_code,
                    const std::vector<std::string>& words) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  const std::vector<std::string> said = lines(outcome.err);
  ASSERT_FALSE(said.empty());
  const auto is_error = [](const std::string& line) {
    return line.starts_with("delone: error: ");
  };
  EXPECT_EQ(std::ranges::count_if(said, is_error), 1) << outcome.err;
  EXPECT_TRUE(is_error(said.back())) << outcome.err;
  for (const std::string& word : words) {
    EXPECT_NE(said.back().find(word), std::string::npos)
        << "no '" << word << "' in " << said.back();
  }
}

void expect_success(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("delone: error: "), std::string::npos) << outcome.err;
}

std::string scattered_csv(int num_points, unsigned seed, std::string_view header) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&engine] {
    return static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  std::string text(header);
  text += '\n';
  for (int i = 0; i < num_points; ++i) {
    const double x = uniform(), y = uniform();
    char line[96];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", x, y, x * x + y);
    text += line;
  }
  return text;
}

}  // namespace delone::test
