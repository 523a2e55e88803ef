// Reference motions to 40 digits, read from tests/mechanics/reference/: a reader of the JSON that
// those files use, and their cases as plain structs.
#pragma once

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "places.h"

namespace poinsot::reference {

// A JSON value: text for strings, numbers and words; else the items or the members.
struct Json {
    std::string text;
    std::vector<Json> items;
    std::map<std::string, Json> members;

    const Json& operator[](const std::string& key) const { return members.at(key); }
    bool has(const std::string& key) const { return members.contains(key); }
    double number() const { return std::strtod(text.c_str(), nullptr); }
};

// Recursive-descent reader. Escapes in strings are kept as they are written.
class JsonReader {
 public:
    explicit JsonReader(std::string source) : source_(std::move(source)) {}

    Json value() {
        const char first = peek();
        if (first == '{') return object();
        if (first == '[') return array();
        Json json;
        json.text = first == '"' ? quoted() : bare();
        return json;
    }

 private:
    char peek() {
        while (at_ < source_.size() && std::isspace(static_cast<unsigned char>(source_[at_])))
            ++at_;
        if (at_ == source_.size()) throw std::runtime_error("JSON ends early");
        return source_[at_];
    }
    void expect(char wanted) {
        if (peek() != wanted) throw std::runtime_error(std::string("JSON lacks ") + wanted);
        ++at_;
    }
    bool skip_comma() {
        if (peek() != ',') return false;
        ++at_;
        return true;
    }
    Json object() {
        Json json;
        expect('{');
        if (peek() != '}') {
            do {
                peek();
                const std::string key = quoted();
                expect(':');
                json.members.emplace(key, value());
            } while (skip_comma());
        }
        expect('}');
        return json;
    }
    Json array() {
        Json json;
        expect('[');
        if (peek() != ']') {
            do {
                json.items.push_back(value());
            } while (skip_comma());
        }
        expect(']');
        return json;
    }
    std::string quoted() {
        expect('"');
        std::string text;
        while (source_.at(at_) != '"') {
            if (source_[at_] == '\\') text += source_[at_++];
            text += source_.at(at_++);
        }
        ++at_;
        return text;
    }
    std::string bare() {
        std::string text;
        while (at_ < source_.size() &&
               std::string(",]} \n\t\r").find(source_[at_]) == std::string::npos) {
            text += source_[at_++];
        }
        return text;
    }

    std::string source_;
    std::size_t at_ = 0;
};

// A file of tests/mechanics/reference/.
inline Json read_reference(const std::string& file_name) {
    const std::string path =
        (poinsot::source_folder() / "tests/mechanics/reference" / file_name).string();
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return JsonReader(text.str()).value();
}

}  // namespace poinsot::reference
