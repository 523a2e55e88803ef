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

// Letters, digits and signs of running text.
std::set<char32_t> running_text() {
    std::set<char32_t> characters;
    add(characters, U' ', U'~');
    add(characters, U'\u00A0', U'\u017F');
    add(characters, U'\u2010', U'\u2027');
    for (const char32_t c : U"\u2030\u2032\u2033\u2039\u203A\u20AC\u2212") characters.insert(c);
    characters.erase(U'\0');
    return characters;
}

// What formulas can contain, and the signs that running text borrows.
std::set<char32_t> mathematics() {
    std::set<char32_t> characters = running_text();
    add(characters, U'\u0391', U'\u03F6');
    add(characters, U'\u2010', U'\u2027');
    add(characters, U'\u2032', U'\u2037');
    add(characters, U'\u2070', U'\u2094');
    add(characters, U'\u2100', U'\u214F');
    add(characters, U'\u2190', U'\u21D5');
    add(characters, U'\u2200', U'\u22A5');
    for (const poinsot::LabelCommand& command : poinsot::label_commands())
        if (command.symbol != 0) characters.insert(command.symbol);
    for (char32_t c = U' '; c <= U'~'; ++c)
        characters.insert(poinsot::drawn_symbol({c, 0}).code);
    const std::set<char32_t> plain = characters;
    for (const MathAlphabet alphabet :
         {MathAlphabet::normal, MathAlphabet::upright, MathAlphabet::italic, MathAlphabet::bold,
          MathAlphabet::bold_symbol, MathAlphabet::calligraphic, MathAlphabet::double_struck})
        for (const char32_t c : plain) characters.insert(poinsot::in_alphabet(c, alphabet));
    return characters;
}

void write(const std::string& path) {
    const poinsot::FontSource source = poinsot::installed_fonts();
    const std::set<char32_t> text = running_text(), formulas = mathematics();
    const std::vector<char32_t> running(text.begin(), text.end());
    std::ofstream file(path, std::ios::binary);
    for (const std::string_view name : poinsot::font_names()) {
        poinsot::FontFile font = source.open(name);
        const std::set<char32_t>& all = font.has_math() ? formulas : text;
        const std::vector<char32_t> characters(all.begin(), all.end());
        const std::string table = poinsot::keep_font(font, characters, running);
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
