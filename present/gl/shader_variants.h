#pragma once

#include <functional>
#include <map>
#include <utility>

#include "present/gl/shader_program.h"

namespace offing::present {

/// One shader compiled for what is drawn with it: renderers such as llvmpipe go through both sides of a
/// branch and once more through a loop whose length they do not know, so that what is not needed costs as
/// much as what is. Features are an ordered value.
template <class Features>
class ShaderVariants {
 public:
  explicit ShaderVariants(std::function<ShaderProgram(const Features&)> make) : make_(std::move(make)) {}

  /// Compiles it where it is the first with these features. Throws what ShaderProgram throws.
  const ShaderProgram& with(const Features& features) {
    const auto known = programs_.find(features);
    return known != programs_.end() ? known->second
                                    : programs_.emplace(features, make_(features)).first->second;
  }

 private:
  std::function<ShaderProgram(const Features&)> make_;
  std::map<Features, ShaderProgram> programs_;
};

}  // namespace offing::present
