#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The element that a section has last, or would have first.
ElementIndex last_element(const Scene& scene, const RepeatedSection* section);
/// All elements of a section; of nullptr the only one.
std::vector<ElementIndex> elements_of(const Scene& scene, const RepeatedSection* section);

/// The last element of a row's section, which gets its first one if it has none.
ElementIndex last_element_or_first(Scene& scene, const Parameter& parameter, const Place& place);

/// Begins a new element of default values in the repeated section of this row, in the last element of its
/// parent; does nothing for others. Throws Error(bad_input) where the section has its most elements;
/// `place.subject` names the section.
void append_element(Scene& scene, const Parameter& parameter, const Place& place);

/// Takes an element away, with its keyframes and places; those behind it count one less.
void remove_element(Scene& scene, const RepeatedSection& section, ElementIndex element);

/// The numbers that a value is made of: one, three, or none where it has no value or is no number.
std::vector<double*> numbers_of(Scene& scene, const Parameter& parameter, ElementIndex element);

/// Makes a value that of another scene, which is only read; both have the elements. Keyframes stay as they
/// are.
void copy_value(Scene& from, ElementIndex from_element, const Parameter& parameter, Scene& to,
                ElementIndex to_element);

}  // namespace offing::scene
