// How a module of WebAssembly and the page talk: numbers are arguments and results; texts and lists
// lie in memory that the module hands out. A function that fails returns 0 and leaves the message
// in the answer.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "error/error.h"
#include "scene/scene_error.h"

#define POINSOT_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace poinsot {

// What the last function that answered left for the page.
std::string& answer();
std::vector<double>& numbers();

std::string error_text(std::string_view kind, std::string_view message,
                       const SourceLocation& where);

inline std::string_view text_at(const char* text, std::uint32_t size) { return {text, size}; }

// Texts that are each followed by a NUL.
std::vector<std::string> texts_at(const char* texts, std::uint32_t size);

// Calls a function; keeps the message of what it throws.
template <typename Call>
int answered(Call call) {
    try {
        call();
        return 1;
    } catch (const SceneError& error) {
        std::string_view message = error.what();
        const std::string prefix = error.where().prefix();
        if (message.starts_with(prefix)) message.remove_prefix(prefix.size());
        answer() = error_text("scene", message, error.where());
    } catch (const InputError& error) {
        answer() = error_text("input", error.what(), {});
    } catch (const std::exception& error) {
        answer() = error_text("environment", error.what(), {});
    }
    return 0;
}

}  // namespace poinsot
