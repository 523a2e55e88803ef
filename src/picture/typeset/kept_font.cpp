#include "typeset/kept_font.h"

#include <cmath>
#include <set>

#include "error/error.h"

namespace poinsot {
namespace {

constexpr std::string_view signature = "kept font 1\n";

// Whole numbers of any size, small ones in one byte: font units are whole numbers.
class Writer {
 public:
    void put(std::uint32_t number) {
        for (; number >= 0x80; number >>= 7) text.push_back(static_cast<char>(0x80 | number));
        text.push_back(static_cast<char>(number));
    }
    void put_signed(double number) {
        const auto whole = static_cast<std::int32_t>(std::lround(number));
        put(whole < 0 ? 2u * static_cast<std::uint32_t>(-(whole + 1)) + 1u
                      : 2u * static_cast<std::uint32_t>(whole));
    }
    std::string text;
};

class Reader {
 public:
    explicit Reader(std::string_view bytes) : rest(bytes) {}
    std::uint32_t take() {
        std::uint32_t number = 0;
        for (unsigned shift = 0; shift < 32; shift += 7) {
            if (rest.empty()) break;
            const auto byte = static_cast<unsigned char>(rest.front());
            rest.remove_prefix(1);
            number |= (byte & 0x7fu) << shift;
            if (byte < 0x80) return number;
        }
        throw EnvironmentError("a kept font ends too early; build the page again");
    }
    double take_signed() {
        const std::uint32_t number = take();
        const auto half = static_cast<double>(number >> 1u);
        return number % 2 == 1 ? -half - 1.0 : half;
    }
    std::string_view rest;
};

void put_outline(Writer& to, const GlyphOutline& outline) {
    to.put(static_cast<std::uint32_t>(outline.steps.size()));
    OutlinePoint at;
    const auto put_point = [&](const OutlinePoint& point) {
        to.put_signed(point.x - at.x);
        to.put_signed(point.y - at.y);
        at = point;
    };
    for (const OutlineStep& step : outline.steps) {
        to.put(static_cast<std::uint32_t>(step.kind));
        if (step.kind == OutlineStep::Kind::cubic) {
            put_point(step.control_1);
            put_point(step.control_2);
        }
        put_point(step.to);
    }
}

std::vector<OutlineStep> take_outline(Reader from) {
    std::vector<OutlineStep> steps(from.take());
    OutlinePoint at;
    const auto take_point = [&](OutlinePoint& point) {
        at.x += from.take_signed();
        at.y += from.take_signed();
        point = at;
    };
    for (OutlineStep& step : steps) {
        step.kind = static_cast<OutlineStep::Kind>(from.take());
        if (step.kind == OutlineStep::Kind::cubic) {
            take_point(step.control_1);
            take_point(step.control_2);
        }
        take_point(step.to);
    }
    return steps;
}

void put_metrics(Writer& to, const GlyphMetrics& m) {
    for (const double value :
         {m.advance, m.height, m.depth, m.left, m.right, m.italic_correction, m.accent_attachment})
        to.put_signed(value);
}

GlyphMetrics take_metrics(Reader& from) {
    GlyphMetrics m;
    for (double* value : {&m.advance, &m.height, &m.depth, &m.left, &m.right, &m.italic_correction,
                          &m.accent_attachment})
        *value = from.take_signed();
    return m;
}

// Ligatures and kerning of running text.
struct Neighbours {
    std::map<std::pair<GlyphId, GlyphId>, GlyphId> ligatures;
    std::vector<GlyphId> glyphs;
    std::map<std::pair<GlyphId, GlyphId>, double> kerning;
};

// Found by setting all pairs of characters; then all pairs with what ligatures are made of.
Neighbours neighbours_of(FontFile& font, std::span<const char32_t> running) {
    struct Item {
        std::u32string characters;
        GlyphId glyph;
    };
    Neighbours found;
    std::vector<Item> items;
    const auto add = [&](const std::u32string& characters, GlyphId glyph) {
        for (const Item& item : items)
            if (item.glyph == glyph) return;
        items.push_back({characters, glyph});
    };
    for (const char32_t character : running)
        if (const auto glyph = font.glyph(character)) add({character}, *glyph);
    const std::size_t n_single = items.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = 0; j < n_single; ++j) {
            // Copies: a new item moves the others.
            const Item left = items[i], right = items[j];
            const ShapedRun run = font.shape(left.characters + right.characters);
            if (run.glyphs.size() != 1) continue;
            found.ligatures[{left.glyph, right.glyph}] = run.glyphs.front().glyph;
            add(left.characters + right.characters, run.glyphs.front().glyph);
        }
    }
    for (const Item& left : items) {
        found.glyphs.push_back(left.glyph);
        for (const Item& right : items) {
            const ShapedRun run = font.shape(left.characters + right.characters);
            if (run.glyphs.size() != 2 || run.glyphs[0].glyph != left.glyph ||
                run.glyphs[1].glyph != right.glyph)
                continue;
            const double kern =
                run.advance - font.metrics(left.glyph).advance - font.metrics(right.glyph).advance;
            if (kern != 0.0) found.kerning[{left.glyph, right.glyph}] = kern;
        }
    }
    return found;
}

// Glyphs that behave alike beside all others have one class on that side.
void put_kerning(Writer& to, const Neighbours& found) {
    const std::size_t n = found.glyphs.size();
    const auto kern = [&](std::size_t left, std::size_t right) {
        const auto at = found.kerning.find({found.glyphs[left], found.glyphs[right]});
        return at == found.kerning.end() ? 0.0 : at->second;
    };
    std::map<std::vector<double>, std::uint32_t> lefts, rights;
    std::vector<std::uint32_t> left_of(n), right_of(n);
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> row, column;
        for (std::size_t j = 0; j < n; ++j) {
            row.push_back(kern(i, j));
            column.push_back(kern(j, i));
        }
        left_of[i] = lefts.emplace(row, lefts.size()).first->second;
        right_of[i] = rights.emplace(column, rights.size()).first->second;
    }
    to.put(static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < n; ++i) {
        to.put(found.glyphs[i]);
        to.put(left_of[i]);
        to.put(right_of[i]);
    }
    std::vector<double> table(lefts.size() * rights.size());
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            table[left_of[i] * rights.size() + right_of[j]] = kern(i, j);
    to.put(static_cast<std::uint32_t>(lefts.size()));
    to.put(static_cast<std::uint32_t>(rights.size()));
    for (const double value : table) to.put_signed(value);
}

}  // namespace

std::string keep_font(FontFile& font, const KeptCharacters& characters) {
    Writer to;
    to.text = signature;
    to.put_signed(font.units_per_em());
    to.put(font.has_math() ? 1 : 0);
    if (font.has_math())
        for (std::size_t k = 0; k < KeptFont::n_constants; ++k)
            to.put_signed(font.constant(static_cast<hb_ot_math_constant_t>(k)));

    std::set<GlyphId> glyphs;
    std::map<char32_t, std::array<GlyphId, 3>> known;
    const std::set<char32_t> scripts(characters.scripts.begin(), characters.scripts.end());
    for (const char32_t character : characters.all) {
        std::array<GlyphId, 3> of_levels{};
        if (!font.glyph(character)) continue;
        for (int level = 0; level < 3; ++level)
            of_levels[static_cast<std::size_t>(level)] =
                *font.script_glyph(character, scripts.contains(character) ? level : 0);
        glyphs.insert(of_levels.begin(), of_levels.end());
        known[character] = of_levels;
    }
    to.put(static_cast<std::uint32_t>(known.size()));
    for (const auto& [character, of_levels] : known) {
        to.put(character);
        for (const GlyphId glyph : of_levels) to.put(glyph);
    }

    const Neighbours neighbours = neighbours_of(font, characters.running);
    glyphs.insert(neighbours.glyphs.begin(), neighbours.glyphs.end());
    std::map<GlyphId, TallForms> tall;
    if (font.has_math()) {
        for (const char32_t character : characters.tall) {
            if (!known.contains(character)) continue;
            const GlyphId glyph = known[character][0];
            TallForms forms = font.tall_forms(glyph);
            if (forms.variants.empty() && forms.pieces.empty()) continue;
            glyphs.insert(forms.variants.begin(), forms.variants.end());
            for (const GlyphPiece& piece : forms.pieces) glyphs.insert(piece.glyph);
            tall.emplace(glyph, std::move(forms));
        }
    }
    to.put(static_cast<std::uint32_t>(glyphs.size()));
    for (const GlyphId glyph : glyphs) {
        to.put(glyph);
        put_metrics(to, font.metrics(glyph));
        Writer outline;
        put_outline(outline, font.outline(glyph));
        to.put(static_cast<std::uint32_t>(outline.text.size()));
        to.text += outline.text;
    }
    to.put(static_cast<std::uint32_t>(tall.size()));
    for (const auto& [glyph, forms] : tall) {
        to.put(glyph);
        to.put_signed(forms.least_overlap);
        to.put(static_cast<std::uint32_t>(forms.variants.size()));
        for (const GlyphId variant : forms.variants) to.put(variant);
        to.put(static_cast<std::uint32_t>(forms.pieces.size()));
        for (const GlyphPiece& piece : forms.pieces) {
            to.put(piece.glyph);
            to.put(piece.repeats ? 1 : 0);
            for (const double value : {piece.advance, piece.start_connector, piece.end_connector})
                to.put_signed(value);
        }
    }
    to.put(static_cast<std::uint32_t>(neighbours.ligatures.size()));
    for (const auto& [pair, ligature] : neighbours.ligatures) {
        to.put(pair.first);
        to.put(pair.second);
        to.put(ligature);
    }
    put_kerning(to, neighbours);
    return to.text;
}

KeptFont::KeptFont(std::string_view bytes) {
    if (!bytes.starts_with(signature))
        throw EnvironmentError("this is no kept font; build the page again");
    Reader from(bytes.substr(signature.size()));
    units_per_em_ = from.take_signed();
    has_math_ = from.take() == 1;
    if (has_math_)
        for (double& value : constants_) value = from.take_signed();
    for (std::uint32_t n = from.take(); n > 0; --n) {
        std::array<GlyphId, 3>& of_levels = characters_[static_cast<char32_t>(from.take())];
        for (GlyphId& glyph : of_levels) glyph = from.take();
    }
    for (std::uint32_t n = from.take(); n > 0; --n) {
        Glyph& glyph = glyphs_[from.take()];
        glyph.metrics = take_metrics(from);
        const std::uint32_t size = from.take();
        glyph.outline = from.rest.substr(0, size);
        from.rest.remove_prefix(glyph.outline.size());
    }
    for (std::uint32_t n = from.take(); n > 0; --n) {
        TallForms& forms = tall_forms_[from.take()];
        forms.least_overlap = from.take_signed();
        for (std::uint32_t k = from.take(); k > 0; --k) forms.variants.push_back(from.take());
        for (std::uint32_t k = from.take(); k > 0; --k) {
            GlyphPiece& piece = forms.pieces.emplace_back();
            piece.glyph = from.take();
            piece.repeats = from.take() == 1;
            for (double* value : {&piece.advance, &piece.start_connector, &piece.end_connector})
                *value = from.take_signed();
        }
    }
    for (std::uint32_t n = from.take(); n > 0; --n) {
        const GlyphId left = from.take();
        const GlyphId right = from.take();
        ligatures_[{left, right}] = from.take();
    }
    for (std::uint32_t n = from.take(); n > 0; --n) {
        auto& [left, right] = classes_[from.take()];
        left = from.take();
        right = from.take();
    }
    const std::size_t n_left = from.take();
    n_right_ = from.take();
    for (std::size_t k = 0; k < n_left * n_right_; ++k) kerning_.push_back(from.take_signed());
}

std::optional<GlyphId> KeptFont::script_glyph(char32_t character, int level) const {
    const auto found = characters_.find(character);
    if (found == characters_.end()) return std::nullopt;
    return found->second.at(static_cast<std::size_t>(level));
}

GlyphMetrics KeptFont::metrics(GlyphId glyph) const {
    const auto found = glyphs_.find(glyph);
    return found == glyphs_.end() ? GlyphMetrics{} : found->second.metrics;
}

GlyphOutline KeptFont::outline(GlyphId glyph) const {
    const auto found = glyphs_.find(glyph);
    if (found == glyphs_.end()) return {};
    return make_outline(take_outline(Reader(found->second.outline)));
}

TallForms KeptFont::tall_forms(GlyphId glyph) const {
    const auto found = tall_forms_.find(glyph);
    return found == tall_forms_.end() ? TallForms{} : found->second;
}

ShapedRun KeptFont::shape(std::span<const char32_t> characters) const {
    std::vector<GlyphId> glyphs;
    std::vector<std::size_t> firsts;  // the first character of each
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const GlyphId glyph = script_glyph(characters[i], 0).value_or(0);
        const auto ligature =
            glyphs.empty() ? ligatures_.end() : ligatures_.find({glyphs.back(), glyph});
        if (ligature == ligatures_.end()) {
            glyphs.push_back(glyph);
            firsts.push_back(i);
        } else {
            glyphs.back() = ligature->second;
        }
    }
    ShapedRun run;
    run.glyphs.reserve(glyphs.size());
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        run.glyphs.push_back({glyphs[i], run.advance, 0.0, firsts[i]});
        run.advance += metrics(glyphs[i]).advance;
        if (i + 1 == glyphs.size()) break;
        const auto left = classes_.find(glyphs[i]), right = classes_.find(glyphs[i + 1]);
        if (left != classes_.end() && right != classes_.end())
            run.advance += kerning_[left->second.first * n_right_ + right->second.second];
    }
    return run;
}

}  // namespace poinsot
