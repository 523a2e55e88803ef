// A value that a scene gives for a key, converted to the type that the key needs.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_keys.h"
#include "scene/toml_document.h"

namespace poinsot {

// Every function that reads the value throws SceneError at the value's own place: `film.fps is a
// string; it must be …`. Numbers are finite; an integer is accepted as a number, and so is a string
// of a number with a unit of the key's quantity ("24 cm").
class GivenValue {
 public:
    // `name` is the path as the user writes it: "body.masses[2].mass_kg".
    GivenValue(const SceneKey& key, std::string name, std::size_t item, const TomlValue& value)
        : key_(key), name_(std::move(name)), item_(item), value_(value) {}

    double number() const { return number(value_, name_); }
    double positive() const { return positive(value_, name_); }
    // In [least, most].
    double number_between(double least, double most) const;
    int integer_between(int least, int most) const;
    bool boolean() const;
    // Without control characters except line ends and tabs.
    std::string text() const { return text(value_, name_); }
    std::string one_of(std::span<const std::string_view> names) const;
    std::vector<double> positive_numbers() const;  // any number of them
    Eigen::Vector3d vector() const { return vector(value_, name_); }
    Eigen::Vector3d positive_vector() const;
    Eigen::Vector4d four_numbers() const;
    Eigen::Matrix3d matrix() const;  // rows
    // From the command line, "a,b" also stands for ["a", "b"].
    std::vector<std::string> texts() const;

    const TomlValue& value() const { return value_; }
    // The path as the user writes it.
    const std::string& name() const { return name_; }
    // Index in the array of tables that the key belongs to.
    std::size_t item() const { return item_; }

    // "film.fps is 0; give a number greater than 0"
    [[noreturn]] void refuse(std::string_view is, std::string_view remedy) const;
    [[noreturn]] void refuse_type() const { refuse_type(value_, name_); }

 private:
    [[noreturn]] void refuse_type(const TomlValue& value, const std::string& name) const;
    const std::vector<TomlValue>& items(const TomlValue& value, const std::string& name,
                                        std::size_t n) const;
    double number(const TomlValue& value, const std::string& name) const;
    double measured_number(const TomlValue& value, const std::string& name) const;
    double positive(const TomlValue& value, const std::string& name) const;
    std::string text(const TomlValue& value, const std::string& name) const;
    Eigen::Vector3d vector(const TomlValue& value, const std::string& name) const;

    const SceneKey& key_;
    std::string name_;
    std::size_t item_;
    const TomlValue& value_;
};

}  // namespace poinsot
