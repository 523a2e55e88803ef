#include "typeset/font_file.h"

#include <fmt/format.h>
#include <ft2build.h>
#include <hb.h>

#include <new>
#include <utility>

#include "error/error.h"
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace poinsot {
namespace {

template <auto Destroy>
struct Deleter {
    template <typename T>
    void operator()(T* handle) const {
        Destroy(handle);
    }
};
using Face = std::unique_ptr<hb_face_t, Deleter<hb_face_destroy>>;
using Font = std::unique_ptr<hb_font_t, Deleter<hb_font_destroy>>;
using Buffer = std::unique_ptr<hb_buffer_t, Deleter<hb_buffer_destroy>>;
using FreeType = std::unique_ptr<FT_LibraryRec_, Deleter<FT_Done_FreeType>>;
using FreeTypeFace = std::unique_ptr<FT_FaceRec_, Deleter<FT_Done_Face>>;

OutlinePoint point(const FT_Vector* v) {
    return {static_cast<double>(v->x), static_cast<double>(v->y)};
}

OutlinePoint towards(OutlinePoint from, OutlinePoint to, double part) {
    return {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part};
}

using Steps = std::vector<OutlineStep>;
int move_to(const FT_Vector* to, void* steps) {
    static_cast<Steps*>(steps)->push_back({OutlineStep::Kind::move, {}, {}, point(to)});
    return 0;
}
int line_to(const FT_Vector* to, void* steps) {
    static_cast<Steps*>(steps)->push_back({OutlineStep::Kind::line, {}, {}, point(to)});
    return 0;
}
// A quadratic curve equals the cubic whose control points are two thirds of the way to the
// quadratic control point.
int conic_to(const FT_Vector* control, const FT_Vector* to, void* steps) {
    auto& list = *static_cast<Steps*>(steps);
    const OutlinePoint from = list.back().to;
    list.push_back({OutlineStep::Kind::cubic, towards(from, point(control), 2.0 / 3.0),
                    towards(point(to), point(control), 2.0 / 3.0), point(to)});
    return 0;
}
int cubic_to(const FT_Vector* c1, const FT_Vector* c2, const FT_Vector* to, void* steps) {
    static_cast<Steps*>(steps)->push_back(
        {OutlineStep::Kind::cubic, point(c1), point(c2), point(to)});
    return 0;
}

}  // namespace

struct FontFile::Handles {
    FontBlob blob;
    Face face;
    Font font;
    Buffer buffer;
    FreeType library;
    FreeTypeFace outlines;
};

FontFile::FontFile(std::string_view bytes, const std::filesystem::path& file)
    : FontFile(FontBlob(hb_blob_create(bytes.data(), static_cast<unsigned>(bytes.size()),
                                       HB_MEMORY_MODE_READONLY, nullptr, nullptr)),
               file) {}

FontFile::FontFile(FontBlob blob, const std::filesystem::path& file)
    : handles_(std::make_unique<Handles>()), file_(file) {
    const auto unreadable = [&file] {
        return EnvironmentError(
            fmt::format("{}: not a font that can be read; reinstall the package "
                        "fonts-lmodern",
                        file.string()));
    };
    handles_->blob = std::move(blob);
    if (!handles_->blob || hb_face_count(handles_->blob.get()) == 0) throw unreadable();
    handles_->face.reset(hb_face_create(handles_->blob.get(), 0));
    handles_->font.reset(hb_font_create(handles_->face.get()));
    handles_->buffer.reset(hb_buffer_create());
    const unsigned units = hb_face_get_upem(handles_->face.get());
    hb_font_set_scale(handles_->font.get(), static_cast<int>(units), static_cast<int>(units));
    units_per_em_ = units;

    // FreeType reads the same bytes: the blob must outlive the FreeType face.
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw EnvironmentError("FreeType does not start");
    handles_->library.reset(library);
    unsigned length = 0;
    const char* bytes = hb_blob_get_data(handles_->blob.get(), &length);
    FT_Face face = nullptr;
    const FT_Error error = FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes),
                                              static_cast<FT_Long>(length), 0, &face);
    if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    if (error != 0) throw unreadable();
    handles_->outlines.reset(face);
}

FontFile::~FontFile() = default;
FontFile::FontFile(FontFile&&) noexcept = default;
FontFile& FontFile::operator=(FontFile&&) noexcept = default;

bool FontFile::has_math() const { return hb_ot_math_has_data(handles_->face.get()) != 0; }

std::optional<GlyphId> FontFile::glyph(char32_t character) { return script_glyph(character, 0); }

std::optional<GlyphId> FontFile::script_glyph(char32_t character, int level) {
    auto& known = glyphs_.at(static_cast<std::size_t>(level));
    if (const auto found = known.find(character); found != known.end()) return found->second;
    std::optional<GlyphId> made;
    hb_codepoint_t nominal = 0;
    if (hb_font_get_nominal_glyph(handles_->font.get(), character, &nominal)) made = nominal;
    if (made && level > 0) {
        hb_buffer_t* buffer = handles_->buffer.get();
        hb_buffer_clear_contents(buffer);
        const std::uint32_t code = character;
        hb_buffer_add_utf32(buffer, &code, 1, 0, 1);
        hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
        hb_buffer_set_script(buffer, HB_SCRIPT_MATH);
        const hb_feature_t smaller{HB_TAG('s', 's', 't', 'y'), static_cast<std::uint32_t>(level),
                                   HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
        hb_shape(handles_->font.get(), buffer, &smaller, 1);
        unsigned n = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &n);
        if (n == 1 && infos[0].codepoint != 0) made = infos[0].codepoint;
    }
    return known.emplace(character, made).first->second;
}

const GlyphMetrics& FontFile::metrics(GlyphId glyph) {
    if (const auto found = metrics_.find(glyph); found != metrics_.end()) return found->second;
    hb_font_t* font = handles_->font.get();
    hb_glyph_extents_t box{};
    hb_font_get_glyph_extents(font, glyph, &box);
    GlyphMetrics made;
    made.advance = hb_font_get_glyph_h_advance(font, glyph);
    made.height = box.y_bearing;
    made.depth = -(box.y_bearing + box.height);
    made.left = box.x_bearing;
    made.right = box.x_bearing + box.width;
    made.italic_correction = hb_ot_math_get_glyph_italics_correction(font, glyph);
    made.accent_attachment = hb_ot_math_get_glyph_top_accent_attachment(font, glyph);
    return metrics_.emplace(glyph, made).first->second;
}

const GlyphOutline& FontFile::outline(GlyphId glyph) {
    if (const auto found = outlines_.find(glyph); found != outlines_.end()) return found->second;
    FT_Face face = handles_->outlines.get();
    Steps steps;
    const FT_Error error = FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING);
    if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    if (error != 0 || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
        throw EnvironmentError(
            fmt::format("{}: glyph {} has no outline; reinstall the package "
                        "fonts-lmodern",
                        face->family_name ? face->family_name : "font", glyph));
    }
    const FT_Outline_Funcs funcs{move_to, line_to, conic_to, cubic_to, 0, 0};
    FT_Outline_Decompose(&face->glyph->outline, &funcs, &steps);
    return outlines_.emplace(glyph, make_outline(std::move(steps))).first->second;
}

ShapedRun FontFile::shape(std::span<const char32_t> characters) {
    hb_buffer_t* buffer = handles_->buffer.get();
    hb_buffer_clear_contents(buffer);
    for (std::size_t i = 0; i < characters.size(); ++i) {
        hb_buffer_add(buffer, characters[i], static_cast<unsigned>(i));
    }
    hb_buffer_set_content_type(buffer, HB_BUFFER_CONTENT_TYPE_UNICODE);
    hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, HB_SCRIPT_LATIN);
    hb_shape(handles_->font.get(), buffer, nullptr, 0);
    unsigned n = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &n);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer, &n);
    ShapedRun run;
    run.glyphs.reserve(n);
    for (unsigned i = 0; i < n; ++i) {
        run.glyphs.push_back({infos[i].codepoint, run.advance + positions[i].x_offset,
                              static_cast<double>(positions[i].y_offset), infos[i].cluster});
        run.advance += positions[i].x_advance;
    }
    return run;
}

double FontFile::constant(hb_ot_math_constant_t which) const {
    return hb_ot_math_get_constant(handles_->font.get(), which);
}

TallForms FontFile::tall_forms(GlyphId glyph) const {
    hb_font_t* font = handles_->font.get();
    TallForms forms;
    std::array<hb_ot_math_glyph_variant_t, 32> variants{};
    auto n = static_cast<unsigned>(variants.size());
    hb_ot_math_get_glyph_variants(font, glyph, HB_DIRECTION_TTB, 0, &n, variants.data());
    for (unsigned i = 0; i < n; ++i) forms.variants.push_back(variants.at(i).glyph);
    std::array<hb_ot_math_glyph_part_t, 16> parts{};
    n = static_cast<unsigned>(parts.size());
    hb_position_t italic = 0;
    hb_ot_math_get_glyph_assembly(font, glyph, HB_DIRECTION_TTB, 0, &n, parts.data(), &italic);
    for (unsigned i = 0; i < n; ++i) {
        const hb_ot_math_glyph_part_t& part = parts.at(i);
        forms.pieces.push_back({part.glyph, static_cast<double>(part.full_advance),
                                static_cast<double>(part.start_connector_length),
                                static_cast<double>(part.end_connector_length),
                                (part.flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0});
    }
    forms.least_overlap = hb_ot_math_get_min_connector_overlap(font, HB_DIRECTION_TTB);
    return forms;
}

}  // namespace poinsot
