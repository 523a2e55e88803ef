// Text from anywhere as part of a page or a document, whatever its bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// For HTML and XML 1.0, in contents and in quoted attributes. What is not UTF-8, and hidden
// characters (among them those that XML cannot hold), become U+FFFD.
std::string escaped_markup(std::string_view text);

// The text of a WebVTT cue (W3C, WebVTT §4.2.2): <, > and & alone, which is what every player
// knows.
std::string escaped_cue(std::string_view text);

// A JSON string that may stand within an HTML script element: nothing in it can close the element
// (RFC 8259 §7; HTML Living Standard §4.12.1.3).
std::string script_string(std::string_view text);

// Base64 (RFC 4648 §4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace poinsot
