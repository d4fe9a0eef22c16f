#include "io/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "io/table.hpp"
#include "io/temporary_folder.hpp"

namespace delone::io {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::message_of;
using test::TemporaryFolder;
using Names = std::vector<std::string>;

mode_t permissions(const std::string& path) {
  struct stat info {};
  EXPECT_EQ(stat(path.c_str(), &info), 0);
  return info.st_mode & 07777;
}

TEST(OutputFile, IsNotThereBeforeCommit) {
  const TemporaryFolder folder;
  OutputFile file(folder.path("out.txt"));
  file.write("hello");
  EXPECT_FALSE(fs::exists(folder.path("out.txt")));
  EXPECT_EQ(content_of(file.temporary_path()), "hello");
  file.commit();
  EXPECT_EQ(content_of(folder.path("out.txt")), "hello");
  EXPECT_EQ(folder.names(), Names{"out.txt"});
}

TEST(OutputFile, LeavesTheEarlierFileAloneWithoutCommit) {
  const TemporaryFolder folder;
  const std::string path = folder.put("out.txt", "earlier");
  {
    OutputFile file(path);
    file.write("half of the new o");
  }
  EXPECT_EQ(content_of(path), "earlier");
  EXPECT_EQ(folder.names(), Names{"out.txt"});
}

TEST(OutputFile, ReplacesTheEarlierFile) {
  const TemporaryFolder folder;
  const std::string path = folder.put("out.txt", "a longer earlier content");
  write_text(path, "new");
  EXPECT_EQ(content_of(path), "new");
}

TEST(OutputFile, TakesWhatIsWrittenThroughTheTemporaryPath) {
  const TemporaryFolder folder;
  OutputFile file(folder.path("out.txt"));
  std::ofstream(file.temporary_path()) << "by another library";
  file.commit();
  EXPECT_EQ(content_of(folder.path("out.txt")), "by another library");
}

TEST(OutputFile, NewFilesHaveThePermissionsOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t old_mask = umask(027);
  write_text(folder.path("out.txt"), "x");
  umask(old_mask);
  EXPECT_EQ(permissions(folder.path("out.txt")), 0640u);
}

TEST(OutputFile, ReplacedFilesKeepTheirPermissions) {
  const TemporaryFolder folder;
  const std::string path = folder.put("out.txt", "x");
  ASSERT_EQ(chmod(path.c_str(), 0604), 0);
  write_text(path, "y");
  EXPECT_EQ(permissions(path), 0604u);
}

TEST(OutputFile, FollowsSymbolicLinksAndKeepsThem) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("elsewhere"));
  folder.put("elsewhere/target.txt", "old");
  fs::create_symlink("elsewhere/target.txt", folder.path("link.txt"));
  write_text(folder.path("link.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.path("link.txt")));
  EXPECT_EQ(content_of(folder.path("elsewhere/target.txt")), "new");
}

TEST(OutputFile, FollowsASymbolicLinkToAFileThatDoesNotExistYet) {
  const TemporaryFolder folder;
  fs::create_symlink("target.txt", folder.path("link.txt"));
  write_text(folder.path("link.txt"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.path("link.txt")));
  EXPECT_EQ(content_of(folder.path("target.txt")), "new");
}

TEST(OutputFile, RefusesLinksThatGoRoundInACircle) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder.path("a"));
  fs::create_symlink("a", folder.path("b"));
  EXPECT_THROW(OutputFile(folder.path("a")), WriteError);
}

TEST(OutputFile, NamesTheFolderThatDoesNotExist) {
  const TemporaryFolder folder;
  const std::string message =
      message_of<WriteError>([&] { OutputFile file(folder.path("nowhere/out.nc")); });
  EXPECT_NE(message.find("the folder " + folder.path("nowhere") + " does not exist"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("mkdir -p"), std::string::npos) << message;
}

TEST(OutputFile, RefusesAFolderAsFile) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("results"));
  for (const std::string& path :
       {folder.path("results"), folder.path("results/"), folder.path("new/")}) {
    const std::string message = message_of<WriteError>([&] { OutputFile file(path); });
    EXPECT_NE(message.find("it is a folder"), std::string::npos) << message;
  }
}

TEST(OutputFile, RefusesAFileAsFolder) {
  const TemporaryFolder folder;
  folder.put("file", "x");
  EXPECT_THROW(OutputFile(folder.path("file/out.txt")), WriteError);
}

TEST(OutputFile, RefusesAnEmptyName) { EXPECT_THROW(OutputFile(""), WriteError); }

TEST(OutputFile, RefusesWhatTheUserMayNotWrite) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  const std::string path = folder.put("out.txt", "precious");
  chmod(path.c_str(), 0444);
  EXPECT_THROW(OutputFile{path}, WriteError);
  chmod(folder.path("").c_str(), 0555);
  EXPECT_THROW(OutputFile(folder.path("new.txt")), WriteError);
  chmod(folder.path("").c_str(), 0755);
}

TEST(OutputFile, SaysThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const std::string message =
      message_of<WriteError>([] { write_text("/dev/full", "x"); });
  EXPECT_EQ(message, "/dev/full: cannot be written: No space left on device");
}

TEST(OutputFile, WritesToDevicesDirectly) {
  write_text("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, WritesToPipesDirectly) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content_of(pipe); });
  write_text(pipe, "through the pipe");
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(OutputFile, AppendsToAnOpenDescriptorWhereItStands) {
  const TemporaryFolder folder;
  const std::string path = folder.put("log", "");
  std::FILE* const log = std::fopen(path.c_str(), "w");
  std::fputs("before ", log);
  std::fflush(log);
  write_text("/dev/fd/" + std::to_string(fileno(log)), "written");
  std::fputs(" after", log);
  std::fclose(log);
  EXPECT_EQ(content_of(path), "before written after");
}

TEST(OutputFile, CannotBeCommittedTwice) {
  const TemporaryFolder folder;
  OutputFile file(folder.path("out.txt"));
  file.commit();
  EXPECT_THROW(file.commit(), WriteError);
}

TEST(OutputFile, AllowsNamesOfTheGreatestLength) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string(255, 'n'));
  write_text(path, "x");
  EXPECT_EQ(content_of(path), "x");
  EXPECT_THROW(OutputFile(folder.path(std::string(256, 'n'))).commit(), WriteError);
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, TwoWritersOfOneFileDoNotDisturbEachOther) {
  const TemporaryFolder folder;
  OutputFile first(folder.path("out.txt")), second(folder.path("out.txt"));
  first.write("first");
  second.write("second");
  first.commit();
  EXPECT_EQ(content_of(folder.path("out.txt")), "first");
  second.commit();
  EXPECT_EQ(content_of(folder.path("out.txt")), "second");
}

TEST(OutputFile, AreAllRemovedByTheSignalHandler) {
  const TemporaryFolder folder;
  const std::string earlier = folder.put("b", "earlier");
  OutputFile a(folder.path("a")), b(folder.path("b"));
  a.write("partial");
  remove_temporary_files();
  EXPECT_EQ(folder.names(), Names{"b"});
  EXPECT_EQ(content_of(earlier), "earlier");
  EXPECT_THROW(a.commit(), WriteError);
}

TEST(OutputFile, LeavesTheRegistryWhenDone) {
  const TemporaryFolder folder;
  // More files one after the other than the registry has room for: the last must still be
  // registered.
  for (int i = 0; i < 40; ++i) write_text(folder.path("done"), "x");
  OutputFile file(folder.path("open"));
  remove_temporary_files();
  EXPECT_EQ(folder.names(), Names{"done"});
}

TEST(FileFormat, IsTheExtensionUnlessGiven) {
  EXPECT_EQ(file_format("a/b.NC"), "nc");
  EXPECT_EQ(file_format("a/b.nc", "csv"), "csv");
  EXPECT_EQ(file_format("a/b.nc", ".PNG"), "png");
  EXPECT_EQ(file_format("a.b/c"), "");
}

}  // namespace
}  // namespace delone::io
