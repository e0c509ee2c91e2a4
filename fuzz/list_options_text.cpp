// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/list_options_text.h"

#include <charconv>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "fuzz/generator.h"
#include "scene/float_text.h"
#include "scene/parse_number.h"

namespace gnomon::fuzz {

namespace {

using fast::ListOptions;

constexpr std::string_view kStrategies[] = {"keep-closed", "always-open", "overlap-open", "ratio-open"};
constexpr std::string_view kSortings[] = {"none", "solid-angle", "nearest", "hits"};
constexpr std::string_view kArithmetics[] = {"naive", "certified"};
constexpr std::string_view kTrees[] = {"goldsmith-salmon", "sah"};
constexpr std::string_view kVolumes[] = {"boxes", "spheres"};

struct Switch {
  bool ListOptions::*member;
};
struct Number {
  std::uint32_t ListOptions::*member;
};
/// From 0 to `most`, which is `open` when it is no value itself.
struct Share {
  float ListOptions::*member;
  float most;
  bool open;
};
/// One of some words, whose places are the values of an enum.
struct Word {
  std::span<const std::string_view> words;
  std::size_t (*get)(const ListSetup&);
  void (*set)(ListSetup&, std::size_t);
};
struct Seed {};

struct Option {
  std::string_view name;
  std::variant<Switch, Number, Share, Word, Seed> value;
};

template <auto member>
constexpr Word option_word(std::span<const std::string_view> words) {
  return {words, [](const ListSetup& s) { return static_cast<std::size_t>(s.options.*member); },
          [](ListSetup& s, std::size_t place) {
            s.options.*member = static_cast<std::remove_reference_t<decltype(s.options.*member)>>(place);
          }};
}

template <auto member>
constexpr Word setup_word(std::span<const std::string_view> words) {
  return {words, [](const ListSetup& s) { return static_cast<std::size_t>(s.*member); },
          [](ListSetup& s, std::size_t place) {
            s.*member = static_cast<std::remove_reference_t<decltype(s.*member)>>(place);
          }};
}

const Option kOptions[] = {
    {"strategy", option_word<&ListOptions::strategy>(kStrategies)},
    {"ratio", Share{&ListOptions::ratio, 1, false}},
    {"discard-single", Switch{&ListOptions::discard_single}},
    {"enclosure", Switch{&ListOptions::enclosure}},
    {"emitter-list", Switch{&ListOptions::emitter_list}},
    {"emitter-overlap", Switch{&ListOptions::emitter_overlap}},
    {"behind-emitter", Switch{&ListOptions::behind_emitter}},
    {"back-faces", Switch{&ListOptions::back_faces}},
    {"mailbox", Switch{&ListOptions::mailbox}},
    {"shadow-cache", Switch{&ListOptions::shadow_cache}},
    {"wait-for-miss", Switch{&ListOptions::wait_for_miss}},
    {"min-rays", Number{&ListOptions::min_rays}},
    {"adjacency", Share{&ListOptions::adjacency, 0.5F, true}},
    {"clump", Number{&ListOptions::clump}},
    {"nested", Switch{&ListOptions::nested}},
    {"super-least", Number{&ListOptions::super_least}},
    {"super-most", Number{&ListOptions::super_most}},
    {"sorting", option_word<&ListOptions::sorting>(kSortings)},
    {"sort-planes", Switch{&ListOptions::sort_planes}},
    {"weak-planes", Share{&ListOptions::weak_planes, 0.5F, false}},
    {"open-from-rays", Number{&ListOptions::open_from_rays}},
    {"patch-planes", Switch{&ListOptions::patch_planes}},
    {"arithmetic", option_word<&ListOptions::arithmetic>(kArithmetics)},
    {"tree", setup_word<&ListSetup::tree>(kTrees)},
    {"volumes", setup_word<&ListSetup::volumes>(kVolumes)},
    {"seed", Seed{}},
};

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : "|") + std::string(word);
  return text;
}

/// What may be written for it, in words.
std::string known_values(const Option& option) {
  if (std::holds_alternative<Switch>(option.value)) return "on|off";
  if (const auto* word = std::get_if<Word>(&option.value)) return joined(word->words);
  if (const auto* share = std::get_if<Share>(&option.value)) {
    return "a number from 0 to " + std::string(share->open ? "below " : "") +
           scene::decimal_text(static_cast<double>(share->most));
  }
  return "a whole number from 0 to " + std::to_string(std::numeric_limits<std::uint32_t>::max());
}

bool set_number(std::uint32_t& number, std::string_view value) {
  const auto parsed = scene::parse_integer(value);
  if (!parsed || *parsed < 0 || *parsed > std::int64_t{std::numeric_limits<std::uint32_t>::max()})
    return false;
  number = static_cast<std::uint32_t>(*parsed);
  return true;
}

/// False when the value is none of the option's.
bool set(const Option& option, std::string_view value, ListSetup& setup) {
  if (const auto* on_off = std::get_if<Switch>(&option.value)) {
    setup.options.*on_off->member = value == "on";
    return value == "on" || value == "off";
  }
  if (const auto* number = std::get_if<Number>(&option.value))
    return set_number(setup.options.*number->member, value);
  if (const auto* share = std::get_if<Share>(&option.value)) {
    const auto parsed = scene::parse_real<float>(value);
    if (!parsed || !(*parsed >= 0 && *parsed <= share->most) || (share->open && *parsed == share->most))
      return false;
    setup.options.*share->member = *parsed;
    return true;
  }
  if (const auto* word = std::get_if<Word>(&option.value)) {
    for (std::size_t k = 0; k < word->words.size(); ++k) {
      if (word->words[k] != value) continue;
      word->set(setup, k);
      return true;
    }
    return false;
  }
  return set_number(setup.seed, value);
}

/// The shortest decimal that reads back as the same float.
std::string float_text(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string value_text(const Option& option, const ListSetup& setup) {
  if (const auto* on_off = std::get_if<Switch>(&option.value))
    return setup.options.*on_off->member ? "on" : "off";
  if (const auto* number = std::get_if<Number>(&option.value))
    return std::to_string(setup.options.*number->member);
  if (const auto* share = std::get_if<Share>(&option.value)) return float_text(setup.options.*share->member);
  if (const auto* word = std::get_if<Word>(&option.value)) return std::string(word->words[word->get(setup)]);
  return std::to_string(setup.seed);
}

std::string names() {
  std::string text;
  for (const Option& option : kOptions) text += (text.empty() ? "" : ", ") + std::string(option.name);
  return text;
}

}  // namespace

ListSetup parse_list_setup(std::string_view text) {
  ListSetup setup;
  std::vector<std::string_view> seen;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(','));
    const bool more = part.size() < text.size();
    text.remove_prefix(part.size() + (more ? 1 : 0));
    const std::size_t equals = part.find('=');
    const std::string_view name = part.substr(0, equals);
    const Option* known = nullptr;
    for (const Option& option : kOptions) known = option.name == name ? &option : known;
    if (known == nullptr || equals == std::string_view::npos || (more && text.empty())) {
      throw UsageError("list options: expected NAME=VALUE,... with a name of " + names() + ", found \"" +
                       std::string(part) + (more && text.empty() ? "," : "") + "\"");
    }
    for (const std::string_view other : seen) {
      if (other == name)
        throw UsageError("list options: expected each name once, found \"" + std::string(name) + "\" twice");
    }
    seen.push_back(name);
    if (!set(*known, part.substr(equals + 1), setup)) {
      throw UsageError("list options: expected " + std::string(name) + "=" + known_values(*known) +
                       ", found \"" + std::string(part) + "\"");
    }
  }
  if (setup.options.super_most < setup.options.super_least)
    throw UsageError("list options: expected a super-most of at least super-least, found \"super-least=" +
                     std::to_string(setup.options.super_least) +
                     ",super-most=" + std::to_string(setup.options.super_most) + "\"");
  return setup;
}

std::string text_of(const ListSetup& setup) {
  std::string text;
  for (const Option& option : kOptions) {
    const std::string value = value_text(option, setup);
    if (value == value_text(option, {})) continue;
    text += (text.empty() ? "" : ",") + std::string(option.name) + "=" + value;
  }
  return text;
}

std::string known_list_options() {
  std::string text;
  for (const Option& option : kOptions) {
    text += std::string(option.name) + "=" + known_values(option) + " (" + value_text(option, {}) + ")\n";
  }
  return text;
}

}  // namespace gnomon::fuzz
