#include "host/scene/file/scene_edit.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_text.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {
namespace {

/// The text has a form that this file does not edit.
struct CannotEdit {};

/// Bytes of a text, without the last one.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// Which elements a list had before are still there, in order: (index before, index now).
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// More comparisons than this are not made for a list: its elements are then paired in order.
constexpr std::size_t most_comparisons = 1'000'000;

/// The longest common subsequence; what has changed between its elements is paired in order.
template <class IsSame>
Pairs aligned(std::size_t before, std::size_t now, const IsSame& is_same) {
  std::size_t front = 0, back = 0;
  while (front < std::min(before, now) && is_same(front, front)) ++front;
  while (back < std::min(before, now) - front && is_same(before - 1 - back, now - 1 - back)) ++back;
  const std::size_t rows = before - front - back, columns = now - front - back;
  Pairs pairs;
  for (std::size_t i = 0; i < front; ++i) pairs.emplace_back(i, i);
  std::size_t i = 0, j = 0;
  const auto pair_changed = [&](std::size_t end_i, std::size_t end_j) {
    for (; i < end_i && j < end_j; ++i, ++j) pairs.emplace_back(front + i, front + j);
    i = end_i;
    j = end_j;
  };
  if (rows * columns <= most_comparisons) {
    // common[i][j]: the length for the elements from i and j on.
    std::vector<std::size_t> common((rows + 1) * (columns + 1), 0);
    const auto at = [&](std::size_t r, std::size_t c) -> std::size_t& {
      return common[r * (columns + 1) + c];
    };
    for (std::size_t r = rows; r-- > 0;) {
      for (std::size_t c = columns; c-- > 0;) {
        at(r, c) =
            is_same(front + r, front + c) ? at(r + 1, c + 1) + 1 : std::max(at(r + 1, c), at(r, c + 1));
      }
    }
    for (std::size_t r = 0, c = 0; r < rows && c < columns;) {
      if (is_same(front + r, front + c)) {
        pair_changed(r, c);
        pairs.emplace_back(front + r, front + c);
        i = ++r;
        j = ++c;
      } else {
        ++(at(r + 1, c) >= at(r, c + 1) ? r : c);
      }
    }
  }
  pair_changed(rows, columns);
  for (std::size_t k = 0; k < back; ++k) pairs.emplace_back(before - back + k, now - back + k);
  return pairs;
}

/// Text with the places of its lines.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {
    for (std::size_t at = 0; at != std::string_view::npos;) {
      starts_.push_back(at);
      at = text.find('\n', at);
      if (at != std::string_view::npos) ++at;
    }
  }

  /// The byte of a place: toml++ counts code points from 1.
  std::size_t byte_of(const toml::source_position& place) const {
    if (place.line == 0 || place.line > starts_.size()) throw CannotEdit();
    std::size_t at = starts_[place.line - 1];
    const auto continues = [&] {
      return at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0) == 0x80;
    };
    for (toml::source_index column = 1; column < place.column && at < text_.size(); ++column) {
      ++at;
      while (continues()) ++at;
    }
    return at;
  }
  Span span_of(const toml::source_region& region) const {
    return {byte_of(region.begin), byte_of(region.end)};
  }

  std::size_t start_of_line(std::size_t at) const {
    return *std::prev(std::ranges::upper_bound(starts_, at));
  }
  std::size_t next_line(std::size_t at) const {
    const auto next = std::ranges::upper_bound(starts_, at);
    return next == starts_.end() ? text_.size() : *next;
  }
  /// The start of the comment right above a line, or of the line itself.
  std::size_t with_comment_above(std::size_t line) const {
    while (line > 0) {
      const std::size_t above = start_of_line(line - 1);
      const std::size_t first = text_.find_first_not_of(" \t", above);
      if (first == std::string_view::npos || text_[first] != '#') break;
      line = above;
    }
    return line;
  }

 private:
  std::string_view text_;
  std::vector<std::size_t> starts_;
};

/// Edits the text of `before` so that it says what `now` does.
class SceneEdit {
 public:
  SceneEdit(std::string_view text, const Scene& before, const Scene& now, const std::filesystem::path& folder,
            bool moves)
      : text_(text), lines_(text), before_(before), now_(now), writer_(now, folder), moves_(moves) {}

  std::string apply(const toml::table& root) {
    find_places(root, "", {}, 0);
    std::ranges::sort(headers_);
    std::set<std::string_view> seen;
    for (const Parameter& row : parameter_table()) {
      if (row.section->repeated_parent() || !seen.insert(section_of(row.key)).second) continue;
      edit_section(row, {}, {});
    }
    for (const auto& [name, is_given, was_given] :
         {std::tuple("terrain", now_.terrain.is_given, before_.terrain.is_given),
          std::tuple("ocean", now_.ocean.is_given, before_.ocean.is_given)}) {
      if (is_given && !was_given && !new_sections_.contains(name))
        insert_block(text_.size(), fmt::format("\n[{}]\n", name));
    }
    return joined();
  }

 private:
  /// A table of the file.
  struct Block {
    Span header;  ///< of an inline table the whole
    bool is_inline = false;
  };
  struct Written {
    std::size_t key;
    Span value;
    bool is_inline;
  };
  struct Edit {
    Span span;
    std::string text;
  };

  /// The name in a header at this place, "" where there is none: the table is an inline one, or is there
  /// because of one within it.
  std::string header_at(std::size_t at) const {
    const std::size_t start = text_.find_first_not_of('[', at);
    if (start == at || start == std::string_view::npos) return "";
    std::string name(text_.substr(start, text_.find(']', start) - start));
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
    return name;
  }

  void find_table(const toml::table& table, const std::string& name, ElementIndex element,
                  std::size_t depth) {
    const Span span = lines_.span_of(table.source());
    const std::string header = header_at(span.begin);
    if (!header.empty()) headers_.emplace_back(span.begin, header);
    if (table.is_inline() || header == name)
      blocks_.emplace(std::pair(name, element), Block{.header = span, .is_inline = table.is_inline()});
    find_places(table, name + '.', element, depth);
  }

  void find_places(const toml::table& table, const std::string& prefix, ElementIndex element,
                   std::size_t depth) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      const Parameter* row = find_parameter(name);
      if (!row) row = find_by_alias(name);
      const toml::array* array = node.as_array();
      if (row) {
        values_.emplace(ValueKey(row->key, element), Written{.key = lines_.byte_of(key.source().begin),
                                                             .value = lines_.span_of(node.source()),
                                                             .is_inline = table.is_inline()});
      } else if (array && array->is_array_of_tables()) {
        for (std::size_t i = 0; i < array->size(); ++i) {
          ElementIndex inner = element;
          (depth == 0 ? inner.outer : inner.inner) = i;
          find_table(*array->get(i)->as_table(), name, inner, depth + 1);
        }
      } else if (node.is_table()) {
        find_table(*node.as_table(), name, element, depth);
      }
    }
  }

  const Block* find_block(std::string_view section, ElementIndex element) const {
    const auto block = blocks_.find(std::pair(std::string(section), element));
    return block == blocks_.end() ? nullptr : &block->second;
  }

  /// A table from the comment above its header to the next one that is not within it.
  Span extent_of(std::string_view section, ElementIndex element) const {
    const Block* block = find_block(section, element);
    if (!block || block->is_inline) throw CannotEdit();
    const std::string inside = fmt::format("{}.", section);
    for (const auto& [at, name] : headers_) {
      if (at > block->header.begin && !name.starts_with(inside))
        return {start_of(block->header.begin), start_of(at)};
    }
    return {start_of(block->header.begin), text_.size()};
  }
  std::size_t start_of(std::size_t header) const {
    return lines_.with_comment_above(lines_.start_of_line(header));
  }

  // Comparison.

  bool has_same_value(const Parameter& row, ElementIndex before, ElementIndex now) const {
    if (!is_same_value(row, struct_at(&before_, *row.section, before), struct_at(&now_, *row.section, now)))
      return false;
    if (row.motion == ParameterMotion::constant) return true;
    for (std::size_t number = 0; number < 3; ++number) {
      const auto old_track = before_.tracks.find({row.key, before, number});
      const auto track = now_.tracks.find({row.key, now, number});
      const bool was_moving = old_track != before_.tracks.end(), is_moving = track != now_.tracks.end();
      if (was_moving != is_moving || (is_moving && !(old_track->second == track->second))) return false;
    }
    return true;
  }

  bool is_same_element(const Section& section, ElementIndex before, ElementIndex now) const {
    for (const Parameter& row : parameter_table()) {
      if (row.section == &section && !has_same_value(row, before, now)) return false;
      if (row.section->repeated_parent() != &section) continue;
      const std::size_t count = count_of(&before_, *row.section, before);
      if (count != count_of(&now_, *row.section, now)) return false;
      if (!row.section->is_repeated()) {
        if (!has_same_value(row, before, now)) return false;
        continue;
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (!has_same_value(row, {before.outer, i}, {now.outer, i})) return false;
      }
    }
    return true;
  }

  // Edits.

  /// All of the section of a row; of a repeated one the elements in these elements of its parent.
  void edit_section(const Parameter& row, ElementIndex before, ElementIndex now) {
    if (const auto* list = std::get_if<ValueAt<std::vector<double>>>(&row.storage)) {
      edit_list(row, list->in(struct_at(&before_, *row.section, {})),
                list->in(struct_at(&now_, *row.section, {})));
    } else if (row.section->is_repeated()) {
      edit_elements(row, before, now);
    } else {
      edit_values(row, before, now);
    }
  }

  void edit_elements(const Parameter& row, ElementIndex before, ElementIndex now) {
    const Section& section = *row.section;
    const bool is_inner = section.repeated_parent() != nullptr;
    const auto old_at = [&](std::size_t i) {
      return is_inner ? ElementIndex{before.outer, i} : ElementIndex{i, 0};
    };
    const auto at = [&](std::size_t i) { return is_inner ? ElementIndex{now.outer, i} : ElementIndex{i, 0}; };
    const Pairs pairs =
        aligned(count_of(&before_, section, before), count_of(&now_, section, now),
                [&](std::size_t i, std::size_t j) { return is_same_element(section, old_at(i), at(j)); });
    edit_repeated(
        row, pairs, count_of(&before_, section, before), count_of(&now_, section, now), before, old_at,
        [&](std::size_t j) { return writer_.element(row, at(j)); },
        [&](std::size_t i, std::size_t j) {
          edit_values(row, old_at(i), at(j));
          std::set<std::string_view> seen;
          for (const Parameter& inner : parameter_table()) {
            if (inner.section->repeated_parent() == &section && seen.insert(section_of(inner.key)).second)
              edit_section(inner, old_at(i), at(j));
          }
        });
  }

  /// A section for each number of a list.
  void edit_list(const Parameter& row, const std::vector<double>& before, const std::vector<double>& now) {
    const auto line = [&](std::size_t j) { return numbers_text(row, std::span(now).subspan(j, 1)); };
    const auto place = [](std::size_t i) { return ElementIndex{i, 0}; };
    edit_repeated(
        row,
        aligned(before.size(), now.size(), [&](std::size_t i, std::size_t j) { return before[i] == now[j]; }),
        before.size(), now.size(), {}, place,
        [&](std::size_t j) {
          return fmt::format("\n[[{}]]\n{} = {}\n", section_of(row.key), name_of(row.key), line(j));
        },
        [&](std::size_t i, std::size_t j) {
          const auto written = values_.find(ValueKey(row.key, place(i)));
          if (written == values_.end()) throw CannotEdit();
          if (before[i] != now[j]) replace(written->second.value, line(j));
        });
  }

  template <class At, class Text, class EditPair>
  void edit_repeated(const Parameter& row, const Pairs& pairs, std::size_t before, std::size_t now,
                     ElementIndex parent, const At& old_at, const Text& text_of, const EditPair& edit_pair) {
    const std::string_view section = section_of(row.key);
    std::size_t i = 0, j = 0;
    const auto change = [&](std::size_t end_i, std::size_t end_j) {
      for (; i < end_i; ++i) replace(extent_of(section, old_at(i)), "");
      for (; j < end_j; ++j) {
        const std::size_t place = i > 0        ? extent_of(section, old_at(i - 1)).end
                                  : before > 0 ? extent_of(section, old_at(0)).begin
                                               : end_within(row, parent);
        insert_block(place, text_of(j));
        new_sections_.insert(std::string(section.substr(0, section.find('.'))));
      }
    };
    for (const auto& [old_index, index] : pairs) {
      change(old_index, index);
      edit_pair(old_index, index);
      i = old_index + 1;
      j = index + 1;
    }
    change(before, now);
  }

  /// Where a section begins that the file lacks.
  std::size_t end_within(const Parameter& row, ElementIndex parent) const {
    const Section* above = row.section->repeated_parent();
    return above ? extent_of(above->name, parent).end : text_.size();
  }

  void edit_values(const Parameter& first, ElementIndex before, ElementIndex now) {
    const std::string_view section = section_of(first.key);
    const std::vector<ValueLine> lines = writer_.lines_of(section, now);
    const auto has = [&](std::string_view name) {
      return std::ranges::any_of(lines, [&](const ValueLine& line) { return line.name == name; });
    };
    std::vector<ValueLine> added;
    for (const Parameter& row : parameter_table()) {
      if (section_of(row.key) != section) continue;
      const bool is_line = has(name_of(row.key));
      const bool is_moved_file = moves_ && is_line && row.rule == ParameterRule::file_name;
      const bool is_excluded = !row.instead_of.empty() && has(name_of(row.instead_of));
      if (has_same_value(row, before, now) && !is_moved_file && !is_excluded) continue;
      const auto written = values_.find(ValueKey(row.key, before));
      const std::string value = is_excluded ? "" : writer_.value_of(row, now);
      if (written == values_.end()) {
        if (is_line) added.push_back({name_of(row.key), value});
      } else if (value.empty()) {
        remove_line(written->second);
      } else {
        replace(written->second.value, value);
      }
    }
    if (!added.empty()) add_lines(first, before, added);
  }

  /// Where the last value of a section's own ends; 0 without one.
  std::size_t end_of_values(std::string_view section, ElementIndex element) const {
    std::size_t last = 0;
    for (const Parameter& row : parameter_table()) {
      if (section_of(row.key) != section) continue;
      const auto written = values_.find(ValueKey(row.key, element));
      if (written != values_.end()) last = std::max(last, written->second.value.end);
    }
    return last;
  }

  void add_lines(const Parameter& first, ElementIndex element, const std::vector<ValueLine>& added) {
    const std::string_view section = section_of(first.key);
    const Block* block = find_block(section, element);
    const std::size_t end = end_of_values(section, element);
    std::string text;
    if (!block) {
      if (end != 0) throw CannotEdit();  // values without a header, such as `wind.speed_mps = 10`
      text = fmt::format("\n[{}]\n", section);
      for (const ValueLine& line : added) text += fmt::format("{} = {}\n", line.name, line.value);
      new_sections_.insert(std::string(section.substr(0, section.find('.'))));
      insert_block(end_within(first, element), text);
    } else if (block->is_inline) {
      for (const ValueLine& line : added)
        text += fmt::format("{}{} = {}", text.empty() && end == 0 ? "" : ", ", line.name, line.value);
      const std::size_t at = end == 0 ? block->header.end - 1 : end;
      replace({at, at}, text);
    } else {
      const std::size_t last = std::max(end, block->header.end) - 1;
      const std::size_t line_start = lines_.start_of_line(last);
      const std::size_t indent =
          std::min(text_.find_first_not_of(" \t", line_start), text_.size()) - line_start;
      const std::size_t at = lines_.next_line(last);
      for (const ValueLine& line : added)
        text += fmt::format("{}{} = {}\n", text_.substr(line_start, indent), line.name, line.value);
      if (at == text_.size() && !text_.ends_with('\n')) text = '\n' + text;
      replace({at, at}, text);
    }
  }

  void remove_line(const Written& written) {
    if (written.is_inline) throw CannotEdit();
    replace({lines_.start_of_line(written.key), lines_.next_line(written.value.end - 1)}, "");
  }

  /// A section with a blank line around it.
  void insert_block(std::size_t at, std::string block) {
    const std::string_view above = text_.substr(0, at);
    if (above.ends_with("\n\n") || above.ends_with("\n\r\n")) block.erase(0, 1);
    if (!above.ends_with('\n')) block = '\n' + block;
    if (at < text_.size()) block += '\n';
    replace({at, at}, std::move(block));
  }

  void replace(Span span, std::string text) { edits_.push_back({span, std::move(text)}); }

  std::string joined() {
    std::ranges::stable_sort(edits_, {}, [](const Edit& edit) { return edit.span.begin; });
    const bool has_returns = text_.find("\r\n") != std::string_view::npos;
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits_) {
      if (edit.span.begin < at) throw CannotEdit();
      result += text_.substr(at, edit.span.begin - at);
      for (const char c : edit.text) {
        if (c == '\n' && has_returns) result += '\r';
        result += c;
      }
      at = edit.span.end;
    }
    return result += text_.substr(at);
  }

  std::string_view text_;
  Lines lines_;
  const Scene& before_;
  const Scene& now_;
  SceneText writer_;
  bool moves_;
  std::map<std::pair<std::string, ElementIndex>, Block> blocks_;
  std::map<ValueKey, Written> values_;
  std::vector<std::pair<std::size_t, std::string>> headers_;
  std::set<std::string, std::less<>> new_sections_;
  std::vector<Edit> edits_;
};

bool is_same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code failure;
  return a == b || std::filesystem::equivalent(a.empty() ? "." : a, b.empty() ? "." : b, failure);
}

}  // namespace

std::optional<std::string> edited_scene_text(std::string_view text, const std::filesystem::path& text_folder,
                                             const Scene& scene, const std::filesystem::path& folder) {
  const std::string wanted = scene_text(scene, folder);
  try {
    const Scene before = parse_scene(text, "", text_folder, Trust::trusted, EarlierKeys::accept);
    std::string edited =
        SceneEdit(text, before, scene, folder, !is_same_folder(text_folder, folder)).apply(toml::parse(text));
    // What is saved reads back, whatever the text looked like.
    const Scene again = parse_scene(edited, "", folder, Trust::trusted, EarlierKeys::accept);
    if (scene_text(again, folder) == wanted) return edited;
  } catch (const CannotEdit&) {
  } catch (const Error&) {
  } catch (const toml::parse_error&) {
  }
  return std::nullopt;
}

}  // namespace offing::scene
