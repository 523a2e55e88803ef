// A value that a scene gives for a key, converted to the type that the key needs.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_keys.h"
#include "scene/toml/toml_document.h"

namespace poinsot {

// Every function that reads the value throws SceneError at the value's own place for a value that
// the key's type does not accept: `film.fps is a boolean; it must be …`, `film.speed is 0; give a
// number greater than 0`. Numbers are finite; an integer is accepted as a number, and so is a
// string of a number with a unit of the key's quantity ("24 cm").
class GivenValue {
 public:
    // `name` is the path as the user writes it: "body.masses[2].mass_kg".
    GivenValue(const SceneKey& key, std::string name, std::size_t item, const TomlValue& value)
        : key_(key), name_(std::move(name)), item_(item), value_(value) {}

    double number() const { return number(value_, name_); }
    int integer() const;
    bool boolean() const;
    // Without control characters except line ends and tabs.
    std::string text() const;
    std::vector<double> numbers() const { return numbers(value_, name_); }
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
    // The items of a list, whose number the type accepts.
    const std::vector<TomlValue>& items(const TomlValue& value, const std::string& name) const;
    double number(const TomlValue& value, const std::string& name) const;
    double finite_number(const TomlValue& value, const std::string& name) const;
    double measured_number(const TomlValue& value, const std::string& name) const;
    std::string text(const TomlValue& value, const std::string& name) const;
    // Throws for an item that is not among the type's names.
    void check_names(const std::vector<std::string>& given) const;
    std::vector<double> numbers(const TomlValue& value, const std::string& name) const;

    const SceneKey& key_;
    std::string name_;
    std::size_t item_;
    const TomlValue& value_;
};

}  // namespace poinsot
