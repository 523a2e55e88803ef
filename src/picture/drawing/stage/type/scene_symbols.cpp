#include "drawing/stage/type/scene_symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace poinsot {

namespace {

// Whether the L at a position of a formula is a complete symbol: the length of L.
bool is_length_of_L(std::string_view formula, std::size_t at) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    if (formula[at] != 'L') return false;
    if (at > 0 && (is_letter(formula[at - 1]) || formula[at - 1] == '\\')) return false;
    return at + 1 == formula.size() || !is_letter(formula[at + 1]);
}

// Whether an L in words is a separate word: between spaces, ends of the text, or characters of
// other scripts.
bool is_word_L(std::string_view words, std::size_t at) {
    const auto parts = [](char c) { return c == ' ' || static_cast<unsigned char>(c) >= 0x80; };
    return words[at] == 'L' && (at == 0 || parts(words[at - 1])) &&
           (at + 1 == words.size() || parts(words[at + 1]));
}

}  // namespace

std::string named_by_scene(const Scene& scene, std::string_view formula) {
    const SymbolsSpec& own = scene.symbols;
    struct Name {
        std::string_view symbol;
        const std::string& own;
        std::string by;
    };
    const Name names[] = {
        {"\\boldsymbol{\\omega}", own.omega, own.omega},
        {"\\mathbf{L}", own.momentum, own.momentum},
        {"\\boldsymbol{\\rho}", own.rho, own.rho},
        {"\\mathbf{e}_1", own.e1, own.e1},
        {"\\mathbf{e}_2", own.e2, own.e2},
        {"\\mathbf{e}_3", own.e3, own.e3},
        {"\\omega_", own.omega, fmt::format("{{{}}}_", own.omega)},
        {"L_", own.momentum, fmt::format("{{{}}}_", own.momentum)},
    };
    std::string named;
    // Inserted text is not searched again, since it may contain the symbol itself.
    for (std::size_t at = 0; at < formula.size();) {
        const auto* const name =
            std::find_if(std::begin(names), std::end(names), [&](const Name& each) {
                return !each.own.empty() && formula.substr(at).starts_with(each.symbol);
            });
        if (name != std::end(names)) {
            named += name->by;
            at += name->symbol.size();
        } else if (!own.momentum.empty() && is_length_of_L(formula, at)) {
            named += fmt::format("|{}|", own.momentum);
            ++at;
        } else {
            named += formula[at++];
        }
    }
    return named;
}

std::string title_named_by_scene(const Scene& scene, std::string_view title) {
    std::string named;
    while (!title.empty()) {
        const std::size_t end = std::min(title.find('$'), title.size());
        const std::string_view words = title.substr(0, end);
        for (std::size_t at = 0; at < words.size(); ++at)
            named += !scene.symbols.momentum.empty() && is_word_L(words, at)
                         ? fmt::format("${}$", scene.symbols.momentum)
                         : std::string(1, words[at]);
        title.remove_prefix(end);
        if (title.empty()) break;
        const std::size_t close = std::min(title.find('$', 1), title.size());
        named += fmt::format("${}$", named_by_scene(scene, title.substr(1, close - 1)));
        title.remove_prefix(std::min(close + 1, title.size()));
    }
    return named;
}

}  // namespace poinsot
