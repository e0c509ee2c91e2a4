// SPDX-License-Identifier: GPL-3.0-or-later
// Plug-ins that misbehave: one clear line, exit status 2, and every other result as if they had not been
// there. Then campaigns that are killed.
#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "scene/corpus.h"
#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

using nlohmann::ordered_json;

std::string module(const std::string& name) {
  return std::string(GNOMON_TEST_PLUGINS) + "/" + name + ".so";
}

ordered_json results_of(const std::string& file) {
  ordered_json json = ordered_json::parse(contents_of(file));
  json.erase("measured");
  return json;
}

struct Flaw {
  const char *module, *says;
};

class UnloadablePlugin : public testing::TestWithParam<Flaw> {};

TEST_P(UnloadablePlugin, IsSaidInOneLine) {
  const std::string library = module(GetParam().module);
  const Folder folder;
  const Outcome outcome = run_gnomon({"fuzz", "shaft-box", "--plugin", library, "--plugin-timeout", "0.5",
                                      "--trials", "1000", "--out", folder / "out"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  ASSERT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("gnomon: --plugin " + library + ": ")) << outcome.err;
  EXPECT_NE(outcome.err.find(GetParam().says), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.entries().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Flaws, UnloadablePlugin,
    testing::Values(Flaw{"other_version",
                         "speaks version 2 of gnomon/plugin.h, this gnomon speaks version 1"},
                    Flaw{"crashes", "crashed (SIGSEGV, a null pointer) while it was loaded"},
                    Flaw{"hangs", "took longer than 0.5 s while it was loaded"},
                    Flaw{"no_methods", "expected 1 to 64 methods, found 0"}, Flaw{"small", "states sizes"},
                    Flaw{"bad_name", "expected a name of 1 to 31 characters"},
                    Flaw{"unknown_question", "question 9 is not known to this gnomon"},
                    Flaw{"no_form", "has neither run_f32 nor run_f64"},
                    Flaw{"twins", "two methods named flawed:same"}, Flaw{"is_null", "can't run here"},
                    Flaw{"no_entry", "exports no gnomon_plugin_entry()"},
                    Flaw{"bad_pointer", "crashed (SIGSEGV, a null pointer) while it was loaded"},
                    Flaw{"not_there", "can't be loaded"}),
    [](const auto& flaw) { return std::string(flaw.param.module); });

TEST(PluginLoading, RefusesWhatIsNoLibrary) {
  const Folder folder;
  const Outcome outcome = run_gnomon({"list", "--plugin", folder.write("text.so", "no library")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
}

/// What the campaigns below run next to a bad method.
const std::vector<std::string> kCampaign{"fuzz",
                                         "shaft-box",
                                         "--distribution",
                                         "integer-grid",
                                         "--trials",
                                         "6000",
                                         "--method",
                                         "naive-f32",
                                         "--method",
                                         "bad:fine",
                                         "--scalar",
                                         "f32",
                                         "--plugin-timeout",
                                         "1"};

Outcome run_with(const std::string& method, const std::string& out, const std::string& jobs = "2") {
  std::vector<std::string> arguments = kCampaign;
  arguments.insert(arguments.end(), {"--plugin", module("misbehaving"), "--method", "bad:" + method, "--out",
                                     out, "--jobs", jobs});
  return run_gnomon(arguments);
}

class MisbehavingPlugin : public testing::TestWithParam<Flaw> {};

TEST_P(MisbehavingPlugin, FailsAloneAndSaysOnWhichCase) {
  if (std::string(GetParam().module) == "greedy" && *GNOMON_SANITIZED != '\0')
    GTEST_SKIP() << "sanitizers need more memory than the limit";
  const Folder folder;
  const std::string method = std::string("bad:") + GetParam().module;
  const Outcome outcome = run_with(GetParam().module, folder / "out");
  EXPECT_EQ(outcome.status, 2);
  ASSERT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("gnomon: " + method + " " + GetParam().says + " on shaft-box 0x"))
      << outcome.err;

  // The case to blame is one of the chosen ones, and does it again.
  const std::string file =
      folder / ("out/failures/shaft-box.bad-" + std::string(GetParam().module) + ".integer-grid.f32.txt");
  const std::vector<scene::CorpusLine> blamed = scene::read_corpus(file);
  ASSERT_EQ(blamed.size(), 1u);
  EXPECT_EQ(blamed[0].words.at(0), "0x1.8p+1");
  EXPECT_EQ(blamed[0].words.at(7), "0x1p+1");
  const Outcome again = run_gnomon({"replay", file, "--plugin", module("misbehaving"), "--plugin-timeout",
                                    "1", "--method", method, "--method", "exact"});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find(GetParam().says), std::string::npos) << again.err;
  EXPECT_NE(again.out.find("exact"), std::string::npos);

  // All else is as it is without it.
  const Outcome without = run_with("fine", folder / "without");
  EXPECT_EQ(without.status, 0) << without.err;
  ordered_json json = results_of(folder / "out/shaft-box-1.json");
  ASSERT_EQ(json["failures"].size(), 1u);
  EXPECT_EQ(json["failures"][0]["method"], method);
  EXPECT_EQ(json["rows"].dump(), results_of(folder / "without/shaft-box-1.json")["rows"].dump());

  // The line and the files are the same for any number of threads.
  const Outcome alone = run_with(GetParam().module, folder / "alone", "1");
  EXPECT_EQ(alone.err, outcome.err);
  json["command"] = results_of(folder / "alone/shaft-box-1.json")["command"];
  EXPECT_EQ(json.dump(), results_of(folder / "alone/shaft-box-1.json").dump());
}

INSTANTIATE_TEST_SUITE_P(
    Deeds, MisbehavingPlugin,
    testing::Values(Flaw{"crash", "crashed (SIGSEGV, a null pointer)"}, Flaw{"hang", "took longer than 1 s"},
                    Flaw{"abort", "crashed (SIGABRT)"}, Flaw{"exit", "ended its process (exit status 3)"},
                    Flaw{"write-past", "crashed (SIGSEGV, beyond its answers)"},
                    Flaw{"write-before", "wrote before its answers"},
                    Flaw{"write-cases", "crashed (SIGSEGV, beyond its cases or writing to them)"},
                    Flaw{"read-past", "crashed (SIGSEGV, beyond its cases or writing to them)"},
                    Flaw{"nonsense", "answered 77, which is no answer (0 to 4)"},
                    Flaw{"unwritten", "left an answer unwritten"},
                    Flaw{"modes", "left the floating-point modes changed (rounding or denormals)"},
                    Flaw{"greedy", "crashed (SIGABRT)"}),
    [](const auto& flaw) {
      std::string name = flaw.param.module;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(PluginManners, MayPrint) {
  const Folder folder;
  const Outcome outcome = run_with("prints", folder / "out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("own words"), std::string::npos);
  EXPECT_NE(outcome.err.find("own words"), std::string::npos);
}

TEST(PluginManners, IsAskedAgainBeforeItIsBelieved) {
  const Folder folder;
  const Outcome outcome = run_with("fickle", folder / "out");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("bad:fickle answered otherwise when asked again, alone, on shaft-box"),
            std::string::npos)
      << outcome.err;
}

// What kills a process from outside may hit the next one, too: two deaths in a row are not the case's fault.
TEST(PluginManners, BlamesNoCaseThatDoesNotFailAgain) {
  const Folder folder;
  const std::string kills = folder.write("kills", "xx");
  ::setenv("GNOMON_TEST_KILLS", kills.c_str(), 1);
  const Outcome outcome = run_with("unlucky", folder / "out", "1");
  ::unsetenv("GNOMON_TEST_KILLS");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(contents_of(kills), "");
  EXPECT_NE(
      outcome.err.find("bad:unlucky was killed (SIGKILL) on a batch of 1024 cases, on no single one of them"),
      std::string::npos)
      << outcome.err;
}

TEST(PluginManners, ThrowsInCxx) {
  const Outcome outcome = run_gnomon({"fuzz", "shaft-box", "--plugin", module("throws"), "--method",
                                      "cxx:throws", "--trials", "2000", "--distribution", "uniform"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(outcome.err.starts_with("gnomon: cxx:throws threw an exception on shaft-box")) << outcome.err;
  const Outcome other = run_gnomon({"fuzz", "shaft-sphere", "--plugin", module("throws"), "--method",
                                    "cxx:overlap", "--trials", "2000", "--distribution", "uniform"});
  EXPECT_EQ(other.status, 0) << other.err;
}

/// A gnomon that runs while the test does something to it. Ends with the test.
class Running {
 public:
  Running(std::vector<std::string> words, const Folder& folder) : err_(folder / "err") {
    words.insert(words.begin(), GNOMON_BINARY);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) {
      const int err = ::open(err_.c_str(), O_WRONLY | O_CREAT, 0600), null = ::open("/dev/null", O_WRONLY);
      ::dup2(err, STDERR_FILENO);
      ::dup2(null, STDOUT_FILENO);
      ::execv(argv[0], argv.data());
      ::_exit(126);
    }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running() {
    if (pid_ > 0) (void)end(SIGKILL);
  }

  int end(int signal) {
    int state = 0;
    if (signal != 0) ::kill(pid_, signal);
    ::waitpid(std::exchange(pid_, -1), &state, 0);
    return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
  }
  [[nodiscard]] std::string err() const { return contents_of(err_); }

 private:
  std::string err_;
  pid_t pid_ = -1;
};

bool eventually(const std::function<bool()>& holds) {
  for (int i = 0; i < 3000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// Processes that have a library loaded: those of a plug-in that has a file of its own.
std::vector<pid_t> processes_with(const std::string& library) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream maps(entry.path() / "maps");
    std::stringstream text;
    if (maps) text << maps.rdbuf();
    if (text.str().find(library) != std::string::npos) found.push_back(static_cast<pid_t>(std::stol(name)));
  }
  return found;
}

/// A copy of the misbehaving plug-in in the folder, so that its processes are the test's own.
std::string own_copy(const Folder& folder) {
  const std::string copy = folder / "own.so";
  std::filesystem::copy_file(module("misbehaving"), copy);
  return copy;
}

TEST(PluginProcess, KilledInMidCampaignTakesNothingWithIt) {
  const Folder folder;
  const std::string library = own_copy(folder);
  Running running({"fuzz",
                   "shaft-box",
                   "--distribution",
                   "integer-grid",
                   "--distribution",
                   "uniform",
                   "--scalar",
                   "f32",
                   "--trials",
                   "200000",
                   "--witnesses",
                   "0",
                   "--plugin-timeout",
                   "3",
                   "--method",
                   "normalised-f32",
                   "--method",
                   "bad:slow",
                   "--plugin",
                   library,
                   "--jobs",
                   "2",
                   "--out",
                   folder / "out"},
                  folder);
  const std::string file = folder / "out/shaft-box-1.json";
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file); }));
  EXPECT_EQ(results_of(file)["complete"], false);
  const std::vector<pid_t> workers = processes_with(library);
  ASSERT_FALSE(workers.empty());
  for (const pid_t worker : workers) ::kill(worker, SIGKILL);
  EXPECT_EQ(running.end(0), 2);
  EXPECT_NE(running.err().find("bad:slow was killed (SIGKILL) on a batch of 1024 cases, on no single one"),
            std::string::npos)
      << running.err();
  const ordered_json json = results_of(file);
  EXPECT_FALSE(json.contains("complete"));
  ASSERT_EQ(json["rows"].size(), 3u) << json["rows"].dump(1);  // both on the grid, ours on uniform
  for (const ordered_json& row : json["rows"]) EXPECT_EQ(row["trials"], 200000);
}

TEST(PluginProcess, EndsWithGnomonHoweverThatEnds) {
  const Folder folder;
  const std::string library = own_copy(folder);
  Running running({"fuzz", "shaft-box", "--distribution", "integer-grid", "--method", "bad:hang", "--plugin",
                   library, "--plugin-timeout", "1000", "--jobs", "2"},
                  folder);
  ASSERT_TRUE(eventually([&] { return processes_with(library).size() >= 2; }));
  running.end(SIGKILL);
  EXPECT_TRUE(eventually([&] { return processes_with(library).empty(); }));
}

TEST(Campaign, KilledLeavesWholeFilesOnly) {
  for (const int milliseconds : {0, 40, 90, 170}) {
    const Folder folder;
    Running running({"fuzz", "shaft-box", "--trials", "3000", "--witnesses", "2", "--out", folder / "out",
                     "--json", folder / "also.json", "--plugin", module("misbehaving"), "--method",
                     "bad:fine", "--method", "normalised-f32", "--method", "naive-f64"},
                    folder);
    const std::string file = folder / "out/shaft-box-1.json";
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    running.end(SIGKILL);
    const ordered_json json = results_of(file);
    EXPECT_FALSE(json["rows"].empty());
    std::size_t named = 0;
    for (const ordered_json& row : json["rows"]) {
      for (const ordered_json& name : row["witnesses"]) {
        ++named;
        EXPECT_EQ(scene::read_corpus(folder / ("out/witnesses/" + name.get<std::string>())).size(), 1u);
      }
    }
    for (const std::string& name : folder.entries()) {
      if (name.ends_with(".json")) {
        EXPECT_TRUE(results_of(folder / name).contains("rows")) << name;
      }
      if (name.ends_with(".txt")) {
        EXPECT_EQ(scene::read_corpus(folder / name).size(), 1u) << name;
      }
    }
    if (milliseconds > 100) {
      EXPECT_GT(named, 0u);
    }
  }
}

}  // namespace
}  // namespace gnomon::tests
