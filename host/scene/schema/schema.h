// The schema of a section: its rows, bound to the members of its struct, and the sections within it.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/scene/schema/parameter.h"
#include "host/scene/schema/section.h"
#include "host/scene/schema/value_storage.h"

namespace offing::scene {

/// A row as it is written: `{&LightScene::colour, {.key = "colour", ...}, unless_off}`. The key and
/// `instead_of` are names within the section; where the value lies comes from the member.
template <class Struct>
struct Row {
  Where<Struct> where;
  Parameter facts;
  /// Why the value has no effect, empty where it has one; nullptr: it always has.
  std::string (*unused)(const UseContext& context, const Struct& section) = nullptr;
};

/// Rows and sections in the order in which they were written, erased.
struct SchemaNode {
  /// A section in the section, or a list of such.
  struct Child {
    std::size_t offset;
    const ListAccess* list;  ///< nullptr: one struct
    std::size_t max_count;
    std::shared_ptr<const SchemaNode> node;
  };
  std::string name;
  std::vector<std::variant<Parameter, Child>> entries = {};
};

/// The rows and sections of a struct of the scene: names, units, ranges, help.
template <class Struct>
class Schema {
 public:
  /// The name in a scene file, within that of the section around it; none for the whole.
  explicit Schema(std::string name = {}) : node_{.name = std::move(name)} {}

  /// Rows that affect the same, but for those that say otherwise.
  Schema& rows(ParameterGroup group, Affects affects, std::vector<Row<Struct>> rows) {
    for (Row<Struct>& row : rows) add(group, affects, std::move(row), 0);
    return *this;
  }

  /// Rows of a struct that is a member of this one.
  template <class Part>
  Schema& rows(ParameterGroup group, Affects affects, Part Struct::*member, std::vector<Row<Part>> rows) {
    for (Row<Part>& row : rows) add(group, affects, std::move(row), path(member).offset);
    return *this;
  }

  /// A section whose values lie in this struct too.
  Schema& section(const Schema& schema) { return add_child(0, nullptr, 1, schema.node()); }

  template <class Child>
  Schema& section(Path<Struct, Child> at, const Schema<Child>& schema) {
    return add_child(at.offset, nullptr, 1, schema.node());
  }

  template <class Child>
  Schema& section(Child Struct::*member, const Schema<Child>& schema) {
    return section(path(member), schema);
  }

  /// A section that may be repeated.
  template <class Child>
  Schema& list(std::vector<Child> Struct::*member, std::size_t max_count, const Schema<Child>& schema) {
    return add_child(path(member).offset, &list_access<Child>, max_count, schema.node());
  }

  const SchemaNode& node() const { return node_; }

 private:
  template <class Part>
  void add(ParameterGroup group, Affects affects, Row<Part> row, std::size_t offset) {
    Parameter facts = std::move(row.facts);
    facts.group = group;
    if (facts.affects == Affects::nothing) facts.affects = affects;
    facts.storage = moved(std::move(row.where.storage), offset);
    if (row.unused != nullptr) {
      facts.unused = [unused = row.unused, offset](const UseContext& context, const void* section) {
        return unused(context, ValueAt<Part>(offset).in(section));
      };
    }
    node_.entries.emplace_back(std::move(facts));
  }

  Schema& add_child(std::size_t offset, const ListAccess* list, std::size_t max_count,
                    const SchemaNode& node) {
    node_.entries.emplace_back(
        SchemaNode::Child{offset, list, max_count, std::make_shared<const SchemaNode>(node)});
    return *this;
  }

  SchemaNode node_;
};

/// All rows of a schema and of the sections in it, with their whole keys, in the order in which they were
/// written. Rows point to sections, so it is not copied.
class SchemaTable {
 public:
  explicit SchemaTable(const SchemaNode& root) { add(root, nullptr, ""); }
  SchemaTable(const SchemaTable&) = delete;
  SchemaTable& operator=(const SchemaTable&) = delete;

  const std::vector<Parameter>& rows() const { return rows_; }
  const std::deque<Section>& sections() const { return sections_; }

 private:
  void add(const SchemaNode& node, const Section* section, const std::string& prefix);

  std::deque<Section> sections_;
  std::deque<std::string> keys_;
  std::vector<Parameter> rows_;
};

}  // namespace offing::scene
