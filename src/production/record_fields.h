// The lines of a record, one row each: written, read and shown as JSON from one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "production/record.h"

namespace poinsot {

struct RecordField {
    // How its text reads as JSON: "generic", 6.25, or the two numbers of "640x360" and "0-299".
    enum class Form { text, number, two_numbers };

    std::string_view key;  // "scene-sha256"; in JSON with low lines: "scene_sha256"
    bool is_required;      // in what is read
    Form form;
    // Nothing where the record does not say it.
    std::optional<std::string> (*text_of)(const Record&);
    // False for a text that it cannot have.
    bool (*read)(std::string_view text, Record&);
};

// In the order in which they are written.
std::span<const RecordField> record_fields();

// The name and the value of a field in JSON, of a text that it has.
std::string json_key_of(const RecordField& field);
std::string json_of(const RecordField& field, const std::string& text);

}  // namespace poinsot
