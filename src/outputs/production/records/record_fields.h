// The fields of a record, one row each: writing, reading and JSON use one table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "production/records/record.h"

namespace poinsot {

struct RecordField {
    // The JSON form of a field's text: "generic", 6.25, or the two numbers of "640x360" and
    // "0-299".
    enum class Form { text, number, two_numbers };

    std::string_view key;      // "scene-sha256"; in JSON with underscores: "scene_sha256"
    bool is_required = false;  // when a record is read
    Form form = Form::text;
    // Empty if the record does not have the field.
    std::optional<std::string> (*text_of)(const Record&);
    // False for an invalid text.
    bool (*read)(std::string_view text, Record&);
};

// In the order of writing.
std::span<const RecordField> record_fields();

// The JSON name and value of a field, from its text.
std::string json_key_of(const RecordField& field);
std::string json_of(const RecordField& field, const std::string& text);

}  // namespace poinsot
