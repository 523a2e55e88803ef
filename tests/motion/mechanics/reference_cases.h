// Reference motions to 40 digits, read from tests/motion/mechanics/reference/.
#pragma once

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "places.h"

namespace poinsot::reference {

using Json = nlohmann::json;

// The files contain numbers as strings, so that JSON readers do not round them.
inline long double long_number(const Json& json) {
    return std::strtold(json.get_ref<const std::string&>().c_str(), nullptr);
}
inline double number(const Json& json) {
    return std::strtod(json.get_ref<const std::string&>().c_str(), nullptr);
}

// A file of tests/motion/mechanics/reference/.
inline Json read_reference(const std::string& file_name) {
    const auto path = poinsot::source_folder() / "tests/motion/mechanics/reference" / file_name;
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return Json::parse(file);
}

}  // namespace poinsot::reference
