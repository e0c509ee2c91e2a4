// SPDX-License-Identifier: GPL-3.0-or-later
// Merging: all shards are the whole run, seeds add up, and what can't be added is refused in words.
#include "reports/merge.h"

#include <algorithm>

#include "fuzz/statistics.h"
#include "reports/shard_set.h"
#include "scene/input_error.h"
#include "tests/result_files.h"

namespace gnomon::reports {
namespace {

namespace fs = std::filesystem;

class Merge : public ResultFiles {
 protected:
  fs::path run(const std::string& name, fuzz::CampaignOptions options) const {
    return write(name, result_of(options));
  }

  std::vector<fs::path> shards(fuzz::CampaignOptions options, unsigned n) const {
    std::vector<fs::path> files;
    options.shards = n;
    for (options.shard = 1; options.shard <= n; ++options.shard) {
      files.push_back(run("s" + std::to_string(options.shard) + ".json", options));
    }
    return files;
  }

  /// The complaint, which has to name the file.
  static std::string refusal(const std::vector<fs::path>& files, const fs::path& named) {
    try {
      (void)merge_results(files);
    } catch (const scene::InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind(named.string() + ":", 0), 0u) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what;
    }
    ADD_FAILURE() << "expected a refusal";
    return "";
  }

  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(Merge, ShardsAreTheWholeRunByteForByte) {
  for (const unsigned witnesses : {0u, 1u, 3u}) {
    fuzz::CampaignOptions options = few_hard_trials();
    options.witnesses_per_row = witnesses;
    const std::string whole = said(result_of(options));
    if (witnesses > 0) {
      ASSERT_TRUE(has(whole, "\"false cull\"") && has(whole, "\"false keep\"") &&
                  has(whole, "\"missed inside\""));
    }
    for (const unsigned n : {2u, 3u, 11u}) {  // seven blocks: with 11 shards some are empty
      std::vector<fs::path> files = shards(options, n);
      const MergedResult merged = merge_results(files);
      EXPECT_EQ(said(merged.json), whole) << n << " shards, " << witnesses << " witnesses";
      EXPECT_FALSE(has(merged.summary, "missing")) << merged.summary;
      std::reverse(files.begin(), files.end());
      EXPECT_EQ(merge_results(files).json, merged.json);
    }
  }
}

TEST_F(Merge, GoesOnWithAMergedPart) {
  const std::vector<fs::path> files = shards(few_hard_trials(), 5);
  const MergedResult part = merge_results({files[4], files[0], files[1]});
  const OrderedJson json = OrderedJson::parse(part.json);
  EXPECT_EQ(json["shard"], "1-2,5/5");
  EXPECT_EQ(json["command"], "gnomon fuzz shaft-box --trials 7000 --seed 1");
  EXPECT_TRUE(has(part.summary, "missing of 5 shards: 3-4")) << part.summary;
  const fs::path partial = write("part.json", part.json);
  EXPECT_EQ(said(merge_results({files[3], partial, files[2]}).json), said(result_of(few_hard_trials())));
  EXPECT_TRUE(has(refusal({partial, files[1]}, files[1]), "shard 2/5 of seed 1 again"));
}

TEST_F(Merge, AddsSeedsUp) {
  fuzz::CampaignOptions options = few_hard_trials();
  std::vector<fs::path> files;
  std::vector<OrderedJson> alone;
  for (const std::uint64_t seed : {3, 1, 2}) {
    options.seed = seed;
    options.trials = 2000 + 1000 * seed;  // runs of different length add up too
    files.push_back(run("seed" + std::to_string(seed) + ".json", options));
    alone.push_back(json_of(files.back()));
  }
  const MergedResult merged = merge_results(files);
  const OrderedJson json = OrderedJson::parse(merged.json);
  EXPECT_EQ(json["seeds"], (OrderedJson{1, 2, 3}));
  EXPECT_FALSE(json.contains("seed"));
  EXPECT_EQ(json["commands"].size(), 3u);
  EXPECT_EQ(json["commands"][2], "gnomon fuzz shaft-box --trials 5000 --seed 3");
  EXPECT_EQ(json["shard"], "1/1");
  std::size_t gaps_of_others = 0;
  for (std::size_t r = 0; r < json["rows"].size(); ++r) {
    const OrderedJson& row = json["rows"][r];
    std::uint64_t trials = 0, unsound = 0, hits = 0, of = 0;
    double worst = 0;
    std::uint64_t worst_seed = 0;
    for (const OrderedJson& one : alone) {
      const OrderedJson& other = one["rows"][r];
      ASSERT_EQ(other["method"], row["method"]);
      trials += other["trials"].get<std::uint64_t>();
      unsound += other["unsound"].get<std::uint64_t>();
      hits += other["unsound_rate"]["hits"].get<std::uint64_t>();
      of += other["unsound_rate"]["of"].get<std::uint64_t>();
      if (!other["worst_gap"].is_null() && std::abs(other["worst_gap"]["approx"].get<double>()) > worst) {
        worst = std::abs(other["worst_gap"]["approx"].get<double>());
        worst_seed = one["seed"];
      }
    }
    EXPECT_EQ(row["trials"], trials);
    EXPECT_EQ(trials, 12000u);
    EXPECT_EQ(row["unsound"], unsound);
    EXPECT_EQ(row["unsound_rate"]["high95"], fuzz::rate_of(hits, of).high95);
    EXPECT_EQ(row["unsound_rate"]["value"], fuzz::rate_of(hits, of).value);
    if (worst > 0) {
      EXPECT_EQ(std::abs(row["worst_gap"]["approx"].get<double>()), worst);
      EXPECT_EQ(row["worst_gap"]["seed"], worst_seed);
      gaps_of_others += worst_seed != 1;
    }
  }
  EXPECT_GT(gaps_of_others, 0u);
  // One witness a row and fault, of the lowest seed that has one.
  for (const OrderedJson& witness : json["witnesses"]) {
    for (const OrderedJson& one : alone) {
      const bool has_one =
          std::any_of(one["witnesses"].begin(), one["witnesses"].end(), [&](const OrderedJson& other) {
            return other["method"] == witness["method"] && other["verdict"] == witness["verdict"] &&
                   other["distribution"] == witness["distribution"] && other["scalar"] == witness["scalar"];
          });
      if (has_one) {
        EXPECT_LE(witness["seed"], one["seed"]);
      }
    }
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(merge_results(files).json, merged.json);
  // Seeds 1 and 3 first, then 2: the same again.
  const fs::path outer = write("outer.json", merge_results({files[0], files[2]}).json);
  EXPECT_EQ(said(merge_results({outer, files[1]}).json), said(merged.json));
  EXPECT_EQ(said(merge_results({files[1], outer}).json), said(merged.json));
  EXPECT_TRUE(has(refusal({outer, files[2]}, files[2]), "of seed 3 again"));
}

TEST_F(Merge, KeepsTheLowerTrialOfEqualGapsAndTheLargerOfOthers) {
  const std::vector<fs::path> files = shards(few_hard_trials(), 2);
  const auto with_gap = [&](std::size_t i, const char* rational, int trial) {
    return changed("gap" + std::to_string(i) + ".json", json_of(files[i]), [&](OrderedJson& json) {
      json["rows"][0]["worst_gap"] = {
          {"rational", rational}, {"approx", 1.0}, {"ulps", 1.0}, {"trial", trial}};
    });
  };
  const auto kept = [&](const char* one, int one_trial, const char* two, int two_trial) {
    const OrderedJson json =
        OrderedJson::parse(merge_results({with_gap(0, one, one_trial), with_gap(1, two, two_trial)}).json);
    return json["rows"][0]["worst_gap"]["trial"].get<int>();
  };
  EXPECT_EQ(kept("1/3", 7, "-1/3", 5), 5);
  EXPECT_EQ(kept("-1/3", 5, "2/6", 7), 5);
  // Apart by less than doubles can tell.
  EXPECT_EQ(kept("100000000000000000001/3", 7, "100000000000000000000/3", 5), 7);
  EXPECT_EQ(kept("100000000000000000000/3", 5, "-100000000000000000001/3", 7), 7);
  EXPECT_TRUE(has(refusal({with_gap(0, "1/0", 1), files[1]}, path("gap0.json")), "a rational p/q"));
  EXPECT_TRUE(has(refusal({with_gap(0, "one", 1), files[1]}, path("gap0.json")), "a rational p/q"));
}

TEST_F(Merge, KeepsAPromiseBrokenThatAnyFileSawBroken) {
  std::vector<fs::path> files = shards(few_hard_trials(), 3);
  EXPECT_TRUE(merge_results(files).broken.empty());
  for (const fs::path& file : std::vector(files)) {
    const auto at = std::find(files.begin(), files.end(), file);
    *at =
        changed("broken.json", json_of(file), [](OrderedJson& j) { j["rows"][3]["promise_broken"] = true; });
    EXPECT_EQ(merge_results(files).broken.size(), 1u) << file;
    *at = file;
  }
}

TEST_F(Merge, WeighsTimesByTrials) {
  const std::vector<fs::path> files = shards(few_hard_trials(), 2);
  const auto timed = [&](std::size_t i, double ns, const char* cpu) {
    return changed("timed" + std::to_string(i) + ".json", json_of(files[i]), [&](OrderedJson& json) {
      json["measured"]["ns_per_case"][0]["ns"] = ns;
      json["measured"]["seconds"] = 2.5;
      json["measured"]["environment"]["cpu"] = cpu;
    });
  };
  const double first = json_of(files[0])["rows"][0]["trials"],
               second = json_of(files[1])["rows"][0]["trials"];
  ASSERT_NE(first, second);
  const OrderedJson measured = OrderedJson::parse(
      merge_results({timed(0, 10, "fast one"), timed(1, 30, "slow one")}).json)["measured"];
  EXPECT_DOUBLE_EQ(measured["ns_per_case"][0]["ns"], (10 * first + 30 * second) / 7000);
  // Three files: the sum of two has the weight of both.
  const std::vector<fs::path> three = shards(few_hard_trials(), 3);
  double sum = 0, expected = 0;
  std::vector<fs::path> timed_files;
  for (const double ns : {10.0, 20.0, 60.0}) {
    const OrderedJson json = json_of(three[timed_files.size()]);
    const double trials = json["rows"][0]["trials"];
    timed_files.push_back(changed("three" + std::to_string(timed_files.size()) + ".json", json,
                                  [&](OrderedJson& j) { j["measured"]["ns_per_case"][0]["ns"] = ns; }));
    sum += trials;
    expected += trials * ns;
  }
  EXPECT_DOUBLE_EQ(OrderedJson::parse(merge_results(timed_files).json)["measured"]["ns_per_case"][0]["ns"],
                   expected / sum);
  EXPECT_EQ(measured["seconds"], 5);
  EXPECT_EQ(measured["environment"]["cpu"], "fast one; slow one");
  EXPECT_EQ(measured["environment"]["rounding"], "to nearest");
  EXPECT_EQ(measured["ns_per_case"].size(), json_of(files[0])["rows"].size());
}

TEST_F(Merge, RefusesWhatDoesNotBelongTogether) {
  const fuzz::CampaignOptions options = few_hard_trials();
  const std::vector<fs::path> files = shards(options, 3);
  const fs::path whole = run("whole.json", options);
  EXPECT_TRUE(has(refusal({files[0], files[0]}, files[0]), "shard 1/3 of seed 1 again"));
  EXPECT_TRUE(has(refusal({whole, whole}, whole), "shard 1/1 of seed 1 again"));
  EXPECT_TRUE(has(refusal({whole, files[1]}, files[1]), "found shard 2/3"));

  fuzz::CampaignOptions other = options;
  other.seed = 2;
  const fs::path seed2 = run("seed2.json", other);
  EXPECT_TRUE(has(refusal({seed2, files[0], files[2]}, files[0]), "expected all 3 shards of seed 1"));
  other.methods = {"exact"};
  const fs::path fewer = run("fewer.json", other);
  EXPECT_TRUE(has(refusal({whole, fewer}, fewer), "found no row shaft-box printed-f32 near-touch f32"));
  EXPECT_TRUE(has(refusal({fewer, whole}, fewer), "found no row")) << "whichever comes first";
  other.seed = 0;
  const fs::path lower = run("lower.json", other);
  EXPECT_TRUE(has(refusal({lower, whole}, whole), "expected the 4 rows of the other files, found 10"));

  const auto edit = [&](const char* name, const std::function<void(OrderedJson&)>& change) {
    return changed(name, json_of(files[1]), change);
  };
  const auto refused = [&](const std::function<void(OrderedJson&)>& change) {
    const fs::path file = edit("edited.json", change);
    return refusal({files[0], file}, file);
  };
  EXPECT_TRUE(has(refused([](OrderedJson& j) {
                    j["command"] = "gnomon fuzz shaft-box --trials 8000 --seed 1 --shard 2/3";
                  }),
                  "expected a shard of the command"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["kind"] = "replay"; }), "found one of kind \"replay\""));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["schema"] = 2; }), "expected schema 1"));
  EXPECT_TRUE(
      has(refused([](OrderedJson& j) { j["tool"] = "gnomon 7.0.0"; }), "found one of \"gnomon 7.0.0\""));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["shard"] = "4/3"; }), "expected shards such as"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j.erase("seed"); }), "expected a seed"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"].push_back(j["rows"][0]); }), "found twice"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"].erase(0); }), "found no row"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"] = OrderedJson::array(); }), "at least one row"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"][0]["promise"] = "all"; }),
                  "expected the same as in the other"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"][0]["spread"] = 0.5; }),
                  "the fields of the other files' rows"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"][0]["unsound_rate"]["hits"] = 99999; }),
                  "as many hits as cases"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["rows"][0]["waste"] = UINT64_MAX; }), "does not overflow"));
  EXPECT_TRUE(has(refused([](OrderedJson& j) { j["witnesses_per_row"] = 2; }), "expected the same as in"));
  const fs::path later = edit("later.json", [](OrderedJson& j) { j["later"] = 2; });
  EXPECT_TRUE(has(refusal({files[0], later}, files[0]), "expected field \"later\""));
  EXPECT_TRUE(
      has(refused([](OrderedJson& j) { j["witnesses"][0]["method"] = "nobody"; }), "a witness of a row"));
  EXPECT_NO_THROW((void)merge_results({files[0], edit("same.json", [](OrderedJson&) {})}));
}

TEST_F(Merge, RefusesWhatIsNoResultFile) {
  const fs::path good = run("good.json", few_hard_trials());
  const std::string text = read(good);
  const auto complaint = [&](const std::string& name) { return refusal({path(name), good}, path(name)); };
  EXPECT_TRUE(has(complaint("absent.json"), "can't open it"));
  write("empty.json", "");
  EXPECT_TRUE(has(complaint("empty.json"), "found an empty one"));
  fs::create_directory(path("folder.json"));
  EXPECT_TRUE(has(complaint("folder.json"), "found a folder"));
  write("foreign.json", R"({"name": "something else", "rows": []})");
  EXPECT_TRUE(has(complaint("foreign.json"), "\"schema\""));
  write("list.json", "[1, 2]");
  EXPECT_TRUE(has(complaint("list.json"), "an object"));
  write("words.json", "shaft-box 0 0 0 1 1 1");
  EXPECT_TRUE(has(complaint("words.json"), "expected JSON, parsing stopped"));
  // One printable line, whatever the file holds: found by the fuzz target read_results.
  write("odd.json", "\"a\x7f\u00fc\"");
  EXPECT_TRUE(has(complaint("odd.json"), R"(found "a\u007f\u00fc")"));
  write("odd.json", R"({"kind": "\u0007\u00fc"})");
  EXPECT_TRUE(has(complaint("odd.json"), "expected"));
  // Cut anywhere: never a result, never a crash.
  for (std::size_t size = 1; size + 2 < text.size(); size += text.size() / 97) {
    write("cut.json", text.substr(0, size));
    EXPECT_TRUE(has(complaint("cut.json"), "expected JSON")) << size;
  }
}

TEST_F(Merge, KeepsAWitnessOfEveryFaultOfEveryQuestion) {
  for (const std::string question :
       {"shaft-sphere", "shaft-slabs", "shaft-oriented-box", "shaft-ellipsoid"}) {
    const std::string fuzz = "fuzz " + question + " --trials 1100 --distribution offset --scalar f32 ";
    ASSERT_EQ(gnomon(fuzz + "--json " + path("whole.json").string()).status, 0);
    ASSERT_EQ(gnomon(fuzz + "--shard 1/2 --json " + path("a.json").string()).status, 0);
    ASSERT_EQ(gnomon(fuzz + "--shard 2/2 --json " + path("b.json").string()).status, 0);
    ASSERT_TRUE(has(read(path("whole.json")), "\"false keep\"")) << question;
    ASSERT_TRUE(has(read(path("whole.json")), "\"missed inside\"")) << question;
    const MergedResult merged = merge_results({path("b.json"), path("a.json")});
    EXPECT_EQ(said(merged.json), said(read(path("whole.json")))) << question;
  }
}

TEST_F(Merge, CommandLine) {
  const std::string fuzz = "fuzz shaft-box --trials 3000 --distribution near-touch --witnesses 2 ";
  ASSERT_EQ(gnomon(fuzz + "--json " + path("whole.json").string()).status, 0);
  std::string files;
  for (const char* const shard : {"2/3", "1/3", "3/3"}) {
    const fs::path file = path(std::string("s") + shard[0] + ".json");
    ASSERT_EQ(gnomon(fuzz + "--shard " + shard + " --json " + file.string()).status, 0);
    files += " " + file.string();
  }
  const fs::path out = path("new/merged.json");
  const Outcome merged = gnomon("merge" + files + " -o " + out.string());
  EXPECT_EQ(merged.status, 0) << merged.error;
  EXPECT_TRUE(has(merged.error, "3 files, 1 seed")) << merged.error;
  EXPECT_EQ(merged.out, "");
  EXPECT_EQ(said(read(out)), said(read(path("whole.json"))));

  const auto one_line = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = gnomon("merge " + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_TRUE(has(outcome.error, words)) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  };
  const std::string s1 = path("s1.json").string(), x = path("x.json").string();
  one_line(s1 + " " + s1 + " -o " + x, "s1.json: expected cases that no other file has");
  one_line("-o " + x, "files");
  one_line(s1, "--out");
  EXPECT_EQ(files_like("x.json"), 0);
  // Outputs that can't be: nothing new is left, not even under a temporary name.
  fs::create_directory(path("taken"));
  one_line(s1 + " -o " + path("taken").string(), "can't be written");
  EXPECT_EQ(files_like("taken"), 1);
  one_line(s1 + " -o " + (path("s1.json") / "inside.json").string(), "can't be written");
  EXPECT_EQ(files_like("s1.json"), 1);
  // A broken promise is one in the merged result too; the input may be the output.
  const fs::path broken =
      changed("broken.json", json_of(s1), [](OrderedJson& j) { j["rows"][0]["promise_broken"] = true; });
  const Outcome outcome =
      gnomon("merge " + broken.string() + " " + path("s2.json").string() + " -o " + broken.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(has(outcome.error, "trivial on near-touch f32 broke its promise")) << outcome.error;
  EXPECT_EQ(gnomon("merge " + broken.string() + " " + path("s3.json").string() + " -o " + x).status, 1);
  EXPECT_EQ(json_of(broken)["shard"], "1-2/3");
  EXPECT_TRUE(json_of(broken)["rows"][0]["promise_broken"]);
}

TEST(ShardSet, ReadsAndWrites) {
  const auto again = [](const char* text) {
    ShardSet set;
    return ShardSet::parse(text, set) ? set.text() + " missing " + set.missing() : "no";
  };
  EXPECT_EQ(again("1/1"), "1/1 missing ");
  EXPECT_EQ(again("2/3"), "2/3 missing 1,3");
  EXPECT_EQ(again("1-2,5,9-10/12"), "1-2,5,9-10/12 missing 3-4,6-8,11-12");
  EXPECT_EQ(again("1-3/3"), "1/1 missing ");
  for (const char* const bad : {"", "1", "/", "0/3", "1/0", "4/3", "2-1/3", "1,1/3", "2,1/3", "1-/3", "1/3 ",
                                "-1/3", "1,/3", "99999999999999999999/3", "1-4/3"}) {
    EXPECT_EQ(again(bad), "no") << bad;
  }
}

}  // namespace
}  // namespace gnomon::reports
