// Escapes any text or bytes for use in a page or document.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// For contents and quoted attributes in HTML and XML 1.0. Invalid UTF-8 and hidden characters
// (including those that XML does not allow) become U+FFFD.
std::string escaped_markup(std::string_view text);

// The text of a WebVTT cue (W3C, WebVTT §4.2.2). Escapes only <, > and &, which every player
// supports.
std::string escaped_cue(std::string_view text);

// A JSON string for use inside an HTML script element: it cannot close the element (RFC 8259 §7;
// HTML Living Standard §4.12.1.3).
std::string script_string(std::string_view text);

// Base64 (RFC 4648 §4).
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace poinsot
