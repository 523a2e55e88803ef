// The alphabets of mathematics: letters in italic, bold and other forms have code points of their
// own.
#pragma once

namespace poinsot {

// How letters look: `normal` is mathematical italic for Latin and small Greek letters, upright for
// capital Greek letters and digits, as TeX has it.
enum class MathAlphabet { normal, upright, italic, bold, bold_symbol, calligraphic, double_struck };

// The character of the Unicode mathematical alphabet (Unicode Standard §22.2, "Mathematical
// Alphanumeric Symbols"); characters without letter forms stay as they are.
char32_t in_alphabet(char32_t character, MathAlphabet alphabet);

}  // namespace poinsot
