// Values as TOML text that reads back exactly.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

std::string toml_text(bool value);
std::string toml_text(int value);
// Returns the shortest decimal that reads back as the same double; always a TOML float, so that −0
// keeps its sign.
std::string toml_text(double value);
std::string toml_text(std::string_view value);
std::string toml_text(const Eigen::Vector3d& value);
std::string toml_text(const Eigen::Vector4d& value);
std::string toml_text(const Eigen::Matrix3d& value);  // rows
std::string toml_text(std::span<const double> values);
std::string toml_text(std::span<const std::string> values);

}  // namespace poinsot
