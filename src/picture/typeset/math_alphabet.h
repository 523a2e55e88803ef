// The mathematical alphabets of Unicode: letters in italic, bold and other forms have separate code
// points.
#pragma once

namespace poinsot {

// Letter forms. `normal` is italic for Latin and small Greek letters, and upright for capital Greek
// letters and digits, as in TeX.
enum class MathAlphabet { normal, upright, italic, bold, bold_symbol, calligraphic, double_struck };

// Converts a character to a mathematical alphabet (Unicode Standard §22.2, "Mathematical
// Alphanumeric Symbols"); characters without such a form are returned unchanged.
char32_t in_alphabet(char32_t character, MathAlphabet alphabet);

}  // namespace poinsot
