// SPDX-License-Identifier: GPL-3.0-or-later
// One block of trials of a question about pairs: made, referred, answered, judged. Each thread has one.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz/method_failure.h"
#include "fuzz/pair_question.h"
#include "fuzz/pair_source.h"
#include "fuzz/tally.h"
#include "fuzz/thread_time.h"

namespace gnomon::fuzz {

/// What is made once where all trials share a scene: the referee, and each method's structure.
template <class Q>
struct PairStage {
  const PairSource<typename Q::Query>* source = nullptr;
  std::vector<const typename Q::Method*> methods;
  std::unique_ptr<typename Q::Referee> referee;               // null where each trial has a scene
  std::vector<std::unique_ptr<typename Q::Maker>> answerers;  // empty there
};

template <class Q>
class PairBlock {
 public:
  static constexpr std::size_t kSize = 64;
  using Query = typename Q::Query;

  PairBlock(const PairStage<Q>& stage, std::uint64_t seed, std::uint32_t stream, std::size_t keep)
      : stage_(stage),
        seed_(seed),
        stream_(stream),
        keep_(keep),
        cases_(kSize),
        truths_(kSize),
        replies_(kSize) {}

  /// Makes and refers the trials first .. first + count - 1.
  void fill(std::uint64_t first, std::size_t count) {
    first_ = first;
    count_ = count;
    for (std::size_t i = 0; i < count; ++i) stage_.source->make({seed_, stream_, first + i}, cases_[i]);
    const double start = thread_ns();
    for (std::size_t i = 0; i < count; ++i) {
      if (stage_.referee) {
        Q::refer(*stage_.referee, cases_[i].query, truths_[i]);
      } else {
        Q::refer(cases_[i].scene, cases_[i].query, truths_[i]);
      }
    }
    reference_ns_ += thread_ns() - start;
  }

  /// Runs method `m` of the stage and adds what comes of it. Where each trial has a scene of its own, time
  /// includes making the method ready for it.
  void run(std::size_t m, Tally& tally) {
    const double start = thread_ns();
    for (std::size_t i = 0; i < count_; ++i) {
      if (stage_.referee) {
        Q::ask(*stage_.answerers[m], cases_[i].query, replies_[i]);
      } else {
        Q::ask(*stage_.methods[m]->make(cases_[i].scene), cases_[i].query, replies_[i]);
      }
    }
    tally.ns += thread_ns() - start;
    for (std::size_t i = 0; i < count_; ++i) judge(*stage_.methods[m], i, tally);
  }

  [[nodiscard]] double reference_ns() const { return reference_ns_; }

 private:
  void judge(const typename Q::Method& method, std::size_t i, Tally& tally) {
    const scene::Scene* const shared = stage_.source->scene_of_all();
    const scene::Scene& scene = shared != nullptr ? *shared : cases_[i].scene;
    PairJudgement judged;
    try {
      judged = Q::judge(scene, truths_[i], replies_[i], marks_);
    } catch (const std::runtime_error& error) {
      const std::string text = pair_text(scene, cases_[i].query, truths_[i]);
      throw MethodFailure(std::string(method.name) + " " + error.what() + " in trial " +
                              std::to_string(first_ + i) + " of seed " + std::to_string(seed_),
                          {text});
    }
    ++tally.trials;
    ++tally.matrix[judged.truth][judged.answer];
    tally.faces.add(judged.faces);
    if (judged.answer >= kTruths) return;
    const std::size_t fault = words_.faults[judged.truth][judged.answer];
    if (fault < kFaults) tally.faults[fault].offer(first_ + i, keep_);
  }

  const PairStage<Q>& stage_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::size_t keep_;
  const QuestionWords& words_ = words_of(Q::id);
  std::vector<PairCase<Query>> cases_;
  std::vector<typename Q::Reply> truths_, replies_;
  FaceMarks marks_;
  std::uint64_t first_ = 0;
  std::size_t count_ = 0;
  double reference_ns_ = 0;
};

}  // namespace gnomon::fuzz
