#include "typeset/math_alphabet.h"

#include <algorithm>
#include <array>

namespace poinsot {
namespace {

// Letters of the alphabets that older Unicode blocks already contain (Unicode Standard §22.2).
char32_t fill_hole(char32_t code) {
    switch (code) {
        case 0x1D455:
            return U'ℎ';
        case 0x1D49D:
            return U'ℬ';
        case 0x1D4A0:
            return U'ℰ';
        case 0x1D4A1:
            return U'ℱ';
        case 0x1D4A3:
            return U'ℋ';
        case 0x1D4A4:
            return U'ℐ';
        case 0x1D4A7:
            return U'ℒ';
        case 0x1D4A8:
            return U'ℳ';
        case 0x1D4AD:
            return U'ℛ';
        case 0x1D4BA:
            return U'ℯ';
        case 0x1D4BC:
            return U'ℊ';
        case 0x1D4C4:
            return U'ℴ';
        case 0x1D53A:
            return U'ℂ';
        case 0x1D53F:
            return U'ℍ';
        case 0x1D545:
            return U'ℕ';
        case 0x1D547:
            return U'ℙ';
        case 0x1D548:
            return U'ℚ';
        case 0x1D549:
            return U'ℝ';
        case 0x1D551:
            return U'ℤ';
        default:
            return code;
    }
}

// First letters of an alphabet: Latin capital, Latin small, Greek capital, Greek small, digit 0. 0:
// not in this alphabet.
struct AlphabetOrigin {
    char32_t capital = 0, small = 0, greek_capital = 0, greek_small = 0, digit = 0;
};

AlphabetOrigin origin_of(MathAlphabet alphabet) {
    switch (alphabet) {
        case MathAlphabet::normal:
            return {0x1D434, 0x1D44E, 0, 0x1D6FC, 0};
        case MathAlphabet::upright:
            return {};
        case MathAlphabet::italic:
            return {0x1D434, 0x1D44E, 0x1D6E2, 0x1D6FC, 0};
        case MathAlphabet::bold:
            return {0x1D400, 0x1D41A, 0x1D6A8, 0x1D6C2, 0x1D7CE};
        case MathAlphabet::bold_symbol:
            return {0x1D468, 0x1D482, 0x1D6A8, 0x1D736, 0x1D7CE};
        case MathAlphabet::calligraphic:
            return {0x1D49C, 0x1D4B6, 0, 0x1D6FC, 0};
        case MathAlphabet::double_struck:
            return {0x1D538, 0x1D552, 0, 0x1D6FC, 0x1D7D8};
    }
    return {};
}

// The variant letters after ω in each Greek alphabet, in Unicode order.
constexpr std::array<char32_t, 7> after_omega{U'∂', U'ϵ', U'ϑ', U'ϰ', U'ϕ', U'ϱ', U'ϖ'};

}  // namespace

char32_t in_alphabet(char32_t c, MathAlphabet alphabet) {
    const AlphabetOrigin origin = origin_of(alphabet);
    if (c >= U'A' && c <= U'Z') return origin.capital ? fill_hole(origin.capital + c - U'A') : c;
    if (c >= U'a' && c <= U'z') return origin.small ? fill_hole(origin.small + c - U'a') : c;
    if (c >= U'0' && c <= U'9') return origin.digit ? origin.digit + c - U'0' : c;
    if (c >= U'Α' && c <= U'Ω') {
        return origin.greek_capital ? origin.greek_capital + c - U'Α' : c;
    }
    if (!origin.greek_small) return c;
    if (c >= U'α' && c <= U'ω') return origin.greek_small + c - U'α';
    for (std::size_t k = 0; k < after_omega.size(); ++k)
        if (after_omega[k] == c) return origin.greek_small + 25 + static_cast<char32_t>(k);
    return c == U'∇' && origin.greek_capital && alphabet != MathAlphabet::italic
               ? origin.greek_capital + 25
               : c;
}

}  // namespace poinsot
