#pragma once

#include <nlohmann/json.hpp>

#include "host/scene/schema/parameter.h"

namespace offing::cli {

/// The JSON Schema (draft-07) of scene files, made from the rows of the parameter table.
nlohmann::ordered_json scene_json_schema();

/// The value that a row has where a scene says nothing; null where it has none.
nlohmann::ordered_json default_json(const scene::Parameter& row);

/// A number as people write it: 16, not 16.0.
nlohmann::ordered_json number_json(double number);

}  // namespace offing::cli
