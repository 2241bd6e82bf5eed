// The tree of sections: where the structs of a section lie in the scene, erased.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace offing::scene {

/// Which element of a repeated section: of [[mesh]] the outer one; of [[mesh.highlight]], which each mesh has
/// its own of, the inner one too.
struct ElementIndex {
  std::size_t outer = 0, inner = 0;

  auto operator<=>(const ElementIndex&) const = default;
};

/// What generic code does with a vector of a section's structs.
struct ListAccess {
  std::size_t (*count)(const void* list);
  const void* (*at)(const void* list, std::size_t index);
  void (*append)(void* list);  ///< an element of default values
  void (*remove)(void* list, std::size_t index);
};

template <class Element>
inline constexpr ListAccess list_access{
    .count = [](const void* list) { return static_cast<const std::vector<Element>*>(list)->size(); },
    .at = [](const void* list, std::size_t index) -> const void* {
      return &(*static_cast<const std::vector<Element>*>(list))[index];
    },
    .append = [](void* list) { static_cast<std::vector<Element>*>(list)->emplace_back(); },
    .remove =
        [](void* list, std::size_t index) {
          auto& elements = *static_cast<std::vector<Element>*>(list);
          elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(index));
        }};

/// A section of a scene: the only one of its name, or one that may be repeated, such as [[ocean.swell]]; one
/// within a repeated one's elements, such as [[mesh.highlight]], counts anew in each of them.
struct Section {
  std::string name;                  ///< in a scene file: "ocean.swell"
  const Section* parent = nullptr;   ///< whose struct holds this one's; nullptr: the scene
  std::size_t offset = 0;            ///< of its struct, or of the list of them, in that struct
  const ListAccess* list = nullptr;  ///< nullptr: there is one struct
  std::size_t max_count = 1;         ///< of elements

  bool is_repeated() const { return list != nullptr; }
  /// The repeated section whose elements each have their own; nullptr if there is none.
  const Section* repeated_parent() const;
};

// `root` is the scene, or what else a schema is of.

/// The struct of an element.
const void* struct_at(const void* root, const Section& section, ElementIndex element);
void* struct_at(void* root, const Section& section, ElementIndex element);

/// How many elements a repeated section has within this element of its parent; others have one.
std::size_t count_of(const void* root, const Section& section, ElementIndex parent);
/// An element of default values, the last in this element of the parent.
void append_to(void* root, const Section& section, ElementIndex parent);
void remove_from(void* root, const Section& section, ElementIndex element);

/// All elements; of a section that is not repeated the only one.
std::vector<ElementIndex> elements_in(const void* root, const Section& section);

}  // namespace offing::scene
