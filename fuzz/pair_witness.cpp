// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_witness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "fuzz/method_failure.h"
#include "fuzz/shrink.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {

namespace {

constexpr double kLargest = std::numeric_limits<float>::max();
/// Numbers are made simpler while there are at most so many: a pass asks once or more for each pair of them.
constexpr std::size_t kMostNumbers = 400;

/// Faces are left out while the tries' faces, all together, are at most so many: structures take time.
constexpr std::uint64_t kMostFacesTried = 4'000'000;

/// A case without the order of a scene: faces may go, and numbers may change.
template <class Query>
struct Loose {
  struct Face {
    std::uint32_t number;  ///< in the scene that the case is from
    bool is_ball;
  };
  std::vector<Face> faces;      ///< triangles first
  std::vector<double> numbers;  ///< of the query, then of each face: nine, or four of a ball
};

void append(std::vector<double>& numbers, const std::array<double, 3>& p) {
  numbers.insert(numbers.end(), p.begin(), p.end());
}

std::vector<double> numbers_of(const BoxPair& pair) {
  std::vector<double> numbers;
  for (const scene::Box<float>* box : {&pair.a, &pair.b})
    numbers.insert(numbers.end(), box->c.begin(), box->c.end());
  return numbers;
}

std::vector<double> numbers_of(const scene::PatchPair& pair) {
  std::vector<double> numbers;
  for (const scene::Patch* patch : {&pair.a, &pair.b}) {
    for (const auto& corner : patch->corners) append(numbers, corner);
  }
  return numbers;
}

std::array<double, 3> point_at(const std::vector<double>& numbers, std::size_t i) {
  return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

/// The query of these numbers; false when they are none.
bool read_query(const std::vector<double>& numbers, BoxPair& pair) {
  for (std::size_t i = 0; i < 6; ++i) {
    pair.a.c[i] = static_cast<float>(numbers[i]);
    pair.b.c[i] = static_cast<float>(numbers[i + 6]);
  }
  return is_valid(pair.a) && is_valid(pair.b);
}

bool read_query(const std::vector<double>& numbers, scene::PatchPair& pair) {
  for (std::size_t k = 0; k < 3; ++k) {
    pair.a.corners[k] = point_at(numbers, 3 * k);
    pair.b.corners[k] = point_at(numbers, 9 + 3 * k);
  }
  return true;
}

constexpr std::size_t kQueryNumbers[] = {12, 18};

/// Where a patch's own face went: its place among the kept ones.
void move_own_faces(BoxPair& /*pair*/, const std::vector<Loose<BoxPair>::Face>& /*faces*/) {}
void move_own_faces(scene::PatchPair& pair, const std::vector<Loose<scene::PatchPair>::Face>& faces) {
  for (scene::Patch* patch : {&pair.a, &pair.b}) {
    const auto kept = std::find_if(faces.begin(), faces.end(),
                                   [&](const auto& face) { return face.number == patch->face; });
    patch->face = kept == faces.end() ? scene::kNoFace : static_cast<std::uint32_t>(kept - faces.begin());
  }
}

template <class Q>
class PairShrinker {
 public:
  using Query = typename Q::Query;
  using Case = Loose<Query>;
  static constexpr std::size_t kOfQuery = kQueryNumbers[std::is_same_v<Query, scene::PatchPair>];

  PairShrinker(const typename Q::Method& method, const Query& query, std::size_t fault)
      : method_(method), query_(query), fault_(fault) {}

  static Case loosen(const scene::Scene& scene, const Query& query) {
    Case c;
    c.numbers = numbers_of(query);
    for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
      const bool is_ball = face >= scene.triangles.size();
      c.faces.push_back({face, is_ball});
      if (is_ball) {
        const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
        append(c.numbers, ball.centre);
        c.numbers.push_back(ball.radius);
      } else {
        for (std::size_t k = 0; k < 3; ++k) append(c.numbers, scene.corner(face, k));
      }
    }
    return c;
  }

  /// False when the numbers are no case.
  bool tighten(const Case& c, PairCase<Query>& result) const {
    result.query = query_;
    if (!read_query(c.numbers, result.query)) return false;
    scene::SceneBuilder builder;
    std::size_t at = kOfQuery;
    for (const auto& face : c.faces) {
      if (face.is_ball) {
        const scene::Ball<double> ball{point_at(c.numbers, at), c.numbers[at + 3]};
        const bool too_far = std::any_of(ball.centre.begin(), ball.centre.end(),
                                         [&](double x) { return std::fabs(x) + ball.radius > kLargest; });
        if (ball.radius < 0 || too_far) return false;
        builder.add_ball(ball);
        at += 4;
      } else {
        builder.add_triangle(point_at(c.numbers, at), point_at(c.numbers, at + 3),
                             point_at(c.numbers, at + 6));
        at += 9;
      }
    }
    result.scene = builder.finish();
    if (result.scene.face_count() == 0) return false;  // no scene is empty
    move_own_faces(result.query, c.faces);
    return true;
  }

  bool fails(const Case& c) const {
    PairCase<Query> tight;
    faces_tried_ += c.faces.size();
    if (!tighten(c, tight)) return false;
    const PairJudgement judged = try_pair<Q>(method_, tight.scene, tight.query);
    return judged.answer < kTruths && words_of(Q::id).faults[judged.truth][judged.answer] == fault_;
  }

  /// Leaves out runs of faces, long ones first, until no single face can go. Begins with one of the given
  /// sets of faces, each rising, if the fault shows among them alone.
  Case without_faces(Case c, std::span<const std::vector<std::uint32_t>> suspects) const {
    for (const std::vector<std::uint32_t>& few : suspects) {
      if (few.empty() || few.size() >= c.faces.size()) continue;
      Case fewer = without(
          c, [&](std::size_t i) { return !std::binary_search(few.begin(), few.end(), c.faces[i].number); });
      if (!fails(fewer)) continue;
      c = std::move(fewer);
      break;
    }
    for (std::size_t run = std::max<std::size_t>(c.faces.size() / 2, 1);;
         run = std::max<std::size_t>(run / 2, 1)) {
      bool gone = false;
      for (std::size_t first = 0; first < c.faces.size();) {
        if (faces_tried_ > kMostFacesTried) return c;
        Case fewer = without(c, [&](std::size_t i) { return i >= first && i < first + run; });
        if (fails(fewer)) {
          c = std::move(fewer);
          gone = true;
        } else {
          first += run;
        }
      }
      if (run == 1 && !gone) return c;
    }
  }

  Case simpler(Case c) const {
    if (c.numbers.size() > kMostNumbers) return c;
    std::vector<int> axes(kOfQuery);
    for (std::size_t i = 0; i < kOfQuery; ++i) axes[i] = static_cast<int>(i % 3);
    for (const auto& face : c.faces) {
      for (int i = 0; i < (face.is_ball ? 4 : 9); ++i) axes.push_back(face.is_ball && i == 3 ? -1 : i % 3);
    }
    Case candidate = c;
    const StillFails still_fails = [&](const std::vector<double>& numbers) {
      candidate.numbers = numbers;
      return fails(candidate);
    };
    c.numbers = shrink(
        c.numbers, scene::Scalar::f32, [&](std::size_t i) { return axes[i]; }, still_fails);
    return c;
  }

 private:
  template <class Leaves>
  static Case without(const Case& c, const Leaves& leaves) {
    Case fewer;
    fewer.numbers.assign(c.numbers.begin(), c.numbers.begin() + kOfQuery);
    std::size_t at = kOfQuery;
    for (std::size_t i = 0; i < c.faces.size(); ++i) {
      const std::size_t size = c.faces[i].is_ball ? 4 : 9;
      if (!leaves(i)) {
        fewer.faces.push_back(c.faces[i]);
        const auto from = c.numbers.begin() + static_cast<std::ptrdiff_t>(at);
        fewer.numbers.insert(fewer.numbers.end(), from, from + static_cast<std::ptrdiff_t>(size));
      }
      at += size;
    }
    return fewer;
  }

  const typename Q::Method& method_;
  Query query_;
  std::size_t fault_;
  mutable std::uint64_t faces_tried_ = 0;
};

/// Sets of faces among which a wrong answer is likely to be one, too: small ones first.
std::vector<std::vector<std::uint32_t>> suspects_of(const CandidateMethod& method, const scene::Scene& scene,
                                                    const BoxPair& query) {
  std::vector<std::uint32_t> truth, reply, wrong, all;
  CandidateQuestion::refer(scene, query, truth);
  CandidateQuestion::ask(*method.make(scene), query, reply);
  std::sort(reply.begin(), reply.end());
  std::set_symmetric_difference(truth.begin(), truth.end(), reply.begin(), reply.end(),
                                std::back_inserter(wrong));
  std::set_union(truth.begin(), truth.end(), reply.begin(), reply.end(), std::back_inserter(all));
  std::vector<std::vector<std::uint32_t>> suspects;
  if (!wrong.empty()) suspects.push_back({wrong.front()});
  suspects.push_back(std::move(wrong));
  suspects.push_back(std::move(all));
  return suspects;
}

std::vector<std::vector<std::uint32_t>> suspects_of(const PairMethod& /*method*/, const scene::Scene& scene,
                                                    const scene::PatchPair& query) {
  std::vector<std::uint32_t> own, some;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
    const bool is_own = face == query.a.face || face == query.b.face;
    if (is_own) own.push_back(face);
    if (is_own || exact::can_block(scene, face, query)) some.push_back(face);
  }
  return {std::move(own), std::move(some)};
}

std::string answer_text(const std::vector<std::uint32_t>& faces) {
  std::string text = "{";
  std::vector<std::uint32_t> sorted = faces;
  std::sort(sorted.begin(), sorted.end());
  for (const std::uint32_t face : sorted) text += (text.size() > 1 ? " " : "") + std::to_string(face);
  return text + "}";
}

std::string answer_text(Answer answer) {
  return std::string(words_of(PatchQuestion::id).answer_name(answer));
}

}  // namespace

template <class Q>
PairJudgement try_pair(const typename Q::Method& method, const scene::Scene& scene,
                       const typename Q::Query& query) {
  typename Q::Reply truth{}, reply{};
  Q::refer(scene, query, truth);
  Q::ask(*method.make(scene), query, reply);
  FaceMarks marks;
  return Q::judge(scene, truth, reply, marks);
}

template <class Q>
Witness make_pair_witness(const typename Q::Method& method, const scene::Scene& scene,
                          const typename Q::Query& query, std::size_t fault) {
  using Shrinker = PairShrinker<Q>;
  const Shrinker shrinker(method, query, fault);
  const typename Shrinker::Case original = Shrinker::loosen(scene, query);
  if (!shrinker.fails(original)) {
    const std::string text = pair_text(scene, query, [&] {
      typename Q::Reply truth{};
      Q::refer(scene, query, truth);
      return truth;
    }());
    throw MethodFailure(std::string(method.name) + " answered otherwise when asked again, alone", {text});
  }
  const typename Shrinker::Case fewer = shrinker.without_faces(original, suspects_of(method, scene, query));
  PairCase<typename Q::Query> found, small;
  (void)shrinker.tighten(fewer, found);
  (void)shrinker.tighten(shrinker.simpler(fewer), small);
  typename Q::Reply truth_found{}, truth{}, reply{};
  Q::refer(found.scene, found.query, truth_found);
  Q::refer(small.scene, small.query, truth);
  Q::ask(*method.make(small.scene), small.query, reply);

  Witness witness;
  witness.question = Q::id;
  witness.method = method.name;
  witness.scalar = "f32";
  witness.verdict = words_of(Q::id).fault_names[fault];
  witness.answer = answer_text(reply);
  witness.reference = answer_text(truth);
  witness.case_text = pair_text(small.scene, small.query, truth);
  // Whole scenes are too long to read, and the trial's number tells them.
  witness.original_text = pair_text(found.scene, found.query, truth_found);
  witness.has_gap = false;
  return witness;
}

template PairJudgement try_pair<CandidateQuestion>(const CandidateMethod&, const scene::Scene&,
                                                   const BoxPair&);
template PairJudgement try_pair<PatchQuestion>(const PairMethod&, const scene::Scene&,
                                               const scene::PatchPair&);
template Witness make_pair_witness<CandidateQuestion>(const CandidateMethod&, const scene::Scene&,
                                                      const BoxPair&, std::size_t);
template Witness make_pair_witness<PatchQuestion>(const PairMethod&, const scene::Scene&,
                                                  const scene::PatchPair&, std::size_t);

}  // namespace gnomon::fuzz
