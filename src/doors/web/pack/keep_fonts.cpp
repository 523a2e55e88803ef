// keep_fonts FILE: writes the fonts of pages: of each font of labels and captions the characters of
// European languages, and of mathematics what labels can name. The file holds each font as a line
// "NAME N_BYTES" and its table.
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "typeset/files/installed_fonts.h"
#include "typeset/kept_font.h"
#include "typeset/math_alphabet.h"
#include "typeset/symbols.h"

namespace {

using poinsot::MathAlphabet;

void add(std::set<char32_t>& characters, char32_t first, char32_t last) {
    for (char32_t c = first; c <= last; ++c) characters.insert(c);
}

// Letters, digits and signs of running text in the languages of western Europe.
std::set<char32_t> running_text() {
    std::set<char32_t> characters;
    add(characters, U' ', U'~');
    add(characters, U'\u00A1', U'\u00FF');
    add(characters, U'\u2010', U'\u2015');
    add(characters, U'\u2018', U'\u201E');
    for (const char32_t c : {U'\u0152', U'\u0153', U'\u0178', U'\u2022', U'\u2026', U'\u2030',
                             U'\u2039', U'\u203A', U'\u20AC', U'\u2212'})
        characters.insert(c);
    return characters;
}

// What formulas can contain, and the signs that running text borrows.
std::set<char32_t> mathematics() {
    std::set<char32_t> characters;
    add(characters, U' ', U'~');
    add(characters, U'\u0391', U'\u03A9');
    add(characters, U'\u03B1', U'\u03C9');
    for (const char32_t c : {U'ϵ', U'ϑ', U'ϕ', U'ϱ', U'ϖ', U'∂', U'∇', U'°', U'′', U'″', U'·',
                             U'½', U'²', U'³', U'µ', U'×', U'±', U'ℓ', U'−', U'√', U'∞', U'≈',
                             U'≠', U'≤', U'≥', U'→', U'∫', U'∑', U'∏', U'…', U'†'})
        characters.insert(c);
    const std::set<char32_t> plain = characters;
    for (const poinsot::LabelCommand& command : poinsot::label_commands())
        if (command.symbol != 0) characters.insert(command.symbol);
    for (char32_t c = U' '; c <= U'~'; ++c) characters.insert(poinsot::drawn_symbol({c, 0}).code);
    const auto add_alphabet = [&](MathAlphabet alphabet, char32_t first, char32_t last) {
        for (const char32_t c : plain)
            if (first <= c && c <= last) characters.insert(poinsot::in_alphabet(c, alphabet));
    };
    for (const MathAlphabet alphabet :
         {MathAlphabet::normal, MathAlphabet::upright, MathAlphabet::italic, MathAlphabet::bold,
          MathAlphabet::bold_symbol})
        add_alphabet(alphabet, U' ', U'\uFFFF');
    for (const MathAlphabet alphabet : {MathAlphabet::calligraphic, MathAlphabet::double_struck})
        add_alphabet(alphabet, U'A', U'Z');
    return characters;
}

std::vector<char32_t> list_of(const std::set<char32_t>& characters) {
    return {characters.begin(), characters.end()};
}

void write(const std::string& path) {
    const poinsot::FontSource source = poinsot::installed_fonts();
    const std::vector<char32_t> text = list_of(running_text()), formulas = list_of(mathematics());
    std::set<char32_t> letters;
    for (const char32_t c : formulas)
        if (c < 0x1D400 || (c >= 0x1D434 && c < 0x1D468) || (c >= 0x1D6FC && c < 0x1D71C))
            letters.insert(c);
    const std::vector<char32_t> scripts = list_of(letters);
    std::vector<char32_t> tall{U'√', U'∫', U'∑', U'∏'};
    for (char32_t c = U' '; c <= U'~'; ++c)
        if (!(c >= U'A' && c <= U'Z') && !(c >= U'a' && c <= U'z')) tall.push_back(c);
    for (const char32_t c : formulas)
        if (c >= 0x2016 && c < 0x2A00) tall.push_back(c);
    std::ofstream file(path, std::ios::binary);
    for (const std::string_view name : poinsot::font_names()) {
        poinsot::FontFile font = source.open(name);
        const std::string table = font.has_math()
                                      ? poinsot::keep_font(font, {formulas, {}, scripts, tall})
                                      : poinsot::keep_font(font, {text, text, {}, {}});
        file << name << ' ' << table.size() << '\n' << table;
    }
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        write(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
