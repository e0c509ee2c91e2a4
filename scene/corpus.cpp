// SPDX-License-Identifier: MIT
#include "scene/corpus.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "scene/float_text.h"
#include "scene/input_error.h"
#include "scene/line_reader.h"

namespace gnomon::scene {

namespace {

/// True for the words of a set whose end is still to come.
bool is_open_set(std::string_view answer) {
  return answer.front() == '{' && answer.back() != '}';
}

CorpusLine parse_line(std::string_view text, std::string_view file, std::size_t line) {
  CorpusLine result;
  result.file = file;
  result.line = line;
  std::istringstream in{std::string(text)};
  std::string word;
  in >> result.question;
  bool arrow = false;
  while (in >> word) {
    if (word == "->") {
      if (arrow) result.fail("one \"->\"", "a second one");
      arrow = true;
    } else if (arrow && result.answer && is_open_set(*result.answer)) {
      *result.answer += ' ' + word;
    } else if (arrow) {
      if (result.answer) result.fail("one answer after \"->\"", in_quotes(word) + " after it");
      result.answer = word;
    } else {
      result.words.push_back(word);
    }
  }
  if (arrow && !result.answer) result.fail("an answer after \"->\"", "the end of the line");
  if (result.answer && is_open_set(*result.answer)) result.fail("a \"}\" after \"{\"", "the end of the line");
  if (result.words.empty()) result.fail("a question and its numbers", in_quotes(result.question) + " alone");
  return result;
}

}  // namespace

void CorpusLine::fail(std::string_view expected, std::string_view found) const {
  throw InputError(file, line, "expected " + std::string(expected) + ", found " + std::string(found));
}

std::vector<double> CorpusLine::numbers(std::size_t count) const {
  if (words.size() != count) {
    fail(std::to_string(count) + " numbers for " + question, std::to_string(words.size()));
  }
  std::vector<double> values;
  values.reserve(count);
  for (const std::string& word : words) {
    const std::optional<double> value = parse_float_text(word);
    if (!value) fail("a number", in_quotes(word));
    if (!std::isfinite(*value)) fail("a number within the range of a double", in_quotes(word));
    values.push_back(*value);
  }
  return values;
}

std::vector<CorpusLine> read_corpus(std::istream& in, std::string_view name) {
  LineReader reader(in, name);
  std::vector<CorpusLine> lines;
  while (const std::optional<std::string_view> text = reader.next_content()) {
    lines.push_back(parse_line(*text, name, reader.line()));
  }
  if (lines.empty()) throw InputError(name, 0, "expected at least one case, found none");
  return lines;
}

std::vector<CorpusLine> read_corpus(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path))
    throw InputError(path.string(), 0, "expected a text corpus, found a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string(), 0, "expected a text corpus, found no file that can be read");
  return read_corpus(in, path.string());
}

std::string corpus_text(std::string_view question, const std::vector<double>& numbers,
                        std::string_view answer) {
  std::string text(question);
  for (const double number : numbers) text += ' ' + hex_text(number);
  if (!answer.empty()) text += " -> " + std::string(answer);
  return text;
}

}  // namespace gnomon::scene
