// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>

#include <csignal>
#include <functional>
#include <thread>
#include <vector>

#include "folder_lock.h"
#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
 protected:
  /// Many files, so that writers meet between the first name and the last.
  void write_all(const std::string& writer) const {
    std::vector<OutputFile> files;
    for (int i = 0; i < count; ++i) files.push_back({OutputPath(out) / std::to_string(i), writer});
    write_files(files, {OutputPath(out) / "last", writer});
  }

  void expect_all_of_one_writer() const {
    const std::string writer = test::content(out / "last");
    EXPECT_NE(writer, "");
    for (int i = 0; i < count; ++i) EXPECT_EQ(test::content(out / std::to_string(i)), writer) << i;
    EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), count + 1);
  }

  /// A process that does some work and ends.
  static pid_t start(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
      work();
      ::_exit(0);
    } catch (...) {
      ::_exit(1);
    }
  }

  static void expect_success(pid_t child) {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }

  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const int count = 8;
};

TEST_F(OutputFiles, OfThreadsAreNotMixed) {
  for (int round = 0; round < 10; ++round) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 16; ++i) threads.emplace_back([&, i] { write_all(std::to_string(i)); });
    threads.clear();
    expect_all_of_one_writer();
  }
}

TEST_F(OutputFiles, OfProcessesAreNotMixed) {
  for (int round = 0; round < 10; ++round) {
    const pid_t one = start([&] { write_all("one"); }), other = start([&] { write_all("other"); });
    expect_success(one);
    expect_success(other);
    expect_all_of_one_writer();
  }
}

TEST_F(OutputFiles, OfSeveralFoldersAreNotMixed) {
  const auto write = [&](const std::string& writer, bool forwards) {
    std::vector<OutputFile> files{{out / "a" / "x", writer}, {out / "b" / "x", writer}};
    if (!forwards) std::swap(files[0], files[1]);
    for (int i = 0; i < 50; ++i) write_files(files);
  };
  const std::jthread forwards([&] { write("forwards", true); });
  std::jthread backwards([&] { write("backwards", false); });
  backwards.join();
}

TEST_F(OutputFiles, NoNameBelowAFolderLeadsElsewhere) {
  using namespace std::string_literals;
  const fs::path elsewhere = folder.path() / "elsewhere";
  for (const fs::path& name : {elsewhere, fs::path("..") / "elsewhere", fs::path("a\0b"s)})
    EXPECT_THROW(write_files({{OutputPath(out) / name / "x", "x"}}), OutputError) << name;
  EXPECT_FALSE(fs::exists(elsewhere));
  EXPECT_FALSE(fs::exists(out / "a"));
  folder.write("elsewhere/.gestalt-0123456789abcdef.tmp", "x");
  remove_abandoned(OutputPath(out) / elsewhere);
  EXPECT_TRUE(fs::exists(elsewhere / ".gestalt-0123456789abcdef.tmp"));
}

TEST_F(OutputFiles, AnUpdateLosesNoOther) {
  constexpr int updates = 50;
  const auto append = [&](const std::string& text) {
    for (int i = 0; i < updates; ++i) update_file(out / "list", [&] { return test::content(out / "list") + text; });
  };
  const pid_t child = start([&] { append("a"); });
  append("b");
  expect_success(child);
  EXPECT_EQ(test::content(out / "list").size(), 2 * updates);
}

TEST_F(OutputFiles, ThoseOfALiveWriterAreNotAbandoned) {
  fs::create_directory(out);
  const fs::path mine = out / ".gestalt-0123456789abcdef.tmp", dead = out / ".gestalt-0123456789abcde0.tmp";
  std::vector<fs::path> of_others{out / "notes.tmp17", out / "labels.png.tmp999999999", out / ".gestalt-0.tmp",
                                  out / ".gestalt-0123456789abcdeX.tmp"};
  for (const fs::path& file : of_others) folder.write(file, "theirs");
  folder.write(mine, "half");
  folder.write(dead, "half");
  const int at_work = ::open(mine.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(at_work, LOCK_EX), 0);
  remove_abandoned(out);
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_FALSE(fs::exists(dead));
  for (const fs::path& file : of_others) EXPECT_TRUE(fs::exists(file)) << file;
  ::close(at_work);
  remove_abandoned(out);
  EXPECT_FALSE(fs::exists(mine));
}

TEST_F(OutputFiles, TheOneWhoWritesIsNamedAndItsDeathEndsTheLock) {
  using namespace std::chrono_literals;
  const int here = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  const pid_t child = start([&] {
    const FolderLock lock(here, folder.path());
    folder.write("locked", "yes");
    for (;;) ::pause();
  });
  while (!fs::exists(folder.path() / "locked")) std::this_thread::sleep_for(1ms);
  try {
    const FolderLock lock(here, folder.path(), 20ms);
    ADD_FAILURE() << "two have the lock";
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), folder.path().string() + ": process " + std::to_string(child) +
                                " is writing to it; wait for it to finish, or choose another --output");
  }
  ::kill(child, SIGKILL);
  const FolderLock lock(here, folder.path());
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  ::close(here);
}

}  // namespace
}  // namespace gestalt
