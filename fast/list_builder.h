// SPDX-License-Identifier: MIT
// Makes candidate lists (Haines, Wallace: "Creating the Candidate List", "Enhancements", "Future Work").
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fast/candidate_list.h"
#include "fast/cull_counters.h"
#include "fast/front_plane.h"
#include "fast/item_tree.h"
#include "fast/list_options.h"
#include "fast/shaft_cull.h"
#include "scene/category.h"

namespace gnomon::fast {

/// A reference item: what sends or receives.
struct Reference {
  scene::Box<float> box;  ///< around all its sample points; must be valid
  /// The polygon that it is, whose faces never block: not on lists, as far as they are opened. Or none.
  scene::FaceRun own{};
  /// Of a one-sided polygon: three of its corners, counterclockwise from the front. All its sample points
  /// must lie on the plane or in front of it, and all those of the other reference item in front of it, for
  /// planes to lose nothing (options behind_emitter and patch_planes).
  std::optional<FrontCorners> front;
};

/// Makes the lists of one tree. Not for several threads at once; allocates nothing once warm.
///
/// With certified arithmetic and no adjacency tolerance, a list's faces (append_faces()) hold every face that
/// meets the closed shaft between the two boxes; but for the own ones, those that the planes of `front` cut
/// off, and back faces of solids, none of which can change what rays between sample points find: whether
/// something blocks. With naive arithmetic lists may lack any face.
class ListBuilder {
 public:
  /// Keeps a reference to the tree. `convex`, one for each of the scene's objects, says which are convex
  /// exactly (exact::is_convex()), for back_faces: of these, closed one-sided bodies of triangles are solids.
  /// Then the tree's primitives must be flat, exactly, and of one object each, as exact::polygons_of() has
  /// them: the first triangle says for all of a primitive which way it faces.
  ListBuilder(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options,
              std::span<const std::uint8_t> convex = {});
  explicit ListBuilder(ItemTree&&, const scene::Scene&, const ListOptions&) = delete;

  /// Begins with another emitter: makes its list. All lists made before are void.
  void begin_emitter(const Reference& emitter);

  /// The root alone, without marks.
  [[nodiscard]] const CandidateList& root_list() const { return root_list_; }
  /// Where shafts of the emitter start: the emitter list, or the root (marks of back faces in either).
  [[nodiscard]] const CandidateList& emitter_list() const { return emitter_list_; }

  /// The list for rays between the emitter and the receiver, `rays` many (for open_from_rays), from the
  /// emitter list, or from a list of this emitter whose receiver's box holds this one's: `from` becomes its
  /// parent. `list` must not be `from`.
  void build(const Reference& receiver, std::uint64_t rays, const CandidateList& from, CandidateList& list);
  void build(const Reference& receiver, std::uint64_t rays, CandidateList& list) {
    build(receiver, rays, emitter_list_, list);
  }

  /// For Sorting::hits: a ray of this emitter was blocked by the item or something below it.
  void count_hit(std::uint32_t item) {
    if (options_.sorting == Sorting::hits) ++hits_[item];
  }

  [[nodiscard]] const CullCounters& counters() const { return counters_; }
  [[nodiscard]] const ListOptions& options() const { return options_; }
  [[nodiscard]] const ItemTree& tree() const { return tree_; }
  [[nodiscard]] const Reference& emitter() const { return emitter_; }

 private:
  /// An item whose category may be known already.
  struct Open {
    std::uint32_t item;
    bool meets_emitter;
    std::optional<scene::Category> category;
  };
  struct Solid {
    std::uint32_t first, count;  ///< its triangles
    scene::Box<float> box;
  };

  void collect_emitter_items(std::uint32_t start);
  void climb_from_emitter(std::uint32_t own);
  void mark_back_faces();
  [[nodiscard]] bool is_outside(const Solid& solid) const;
  [[nodiscard]] bool is_own(std::uint32_t item) const {
    return item == own_emitter_ || item == own_receiver_;
  }
  [[nodiscard]] bool encloses(std::uint32_t item, const scene::Box<float>& box);
  void walk(const Open& start, Strategy strategy, const scene::Box<float>& receiver, CandidateList& list);
  [[nodiscard]] bool keeps_by_ratio(const Item& item, CandidateList& list);
  void sort(const scene::Box<float>& receiver, CandidateList& list);

  const ItemTree& tree_;
  ListOptions options_;
  std::vector<Solid> solids_;
  Reference emitter_;
  std::uint32_t own_emitter_ = kNoItem, own_receiver_ = kNoItem;
  std::optional<FrontPlane> emitter_front_;
  CandidateList root_list_, emitter_list_;
  ShaftCull cull_;
  std::vector<Open> open_, children_;
  std::vector<std::uint32_t> hits_;
  std::vector<std::pair<double, std::uint32_t>> keys_;
  CullCounters counters_;
};

}  // namespace gnomon::fast
