#include "vector/font_face.h"

#include <fmt/format.h>
#include <ft2build.h>
#include <hb-subset.h>

#include <array>
#include <new>

#include "error/error.h"
#include "text/printable.h"
#include "text/utf8.h"
#include "vector/handle.h"
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace poinsot::vector {

namespace {

struct OutlineWriter {
    Path path;
    double per_unit = 1.0;

    Eigen::Vector2d point(const FT_Vector* v) const {
        return {per_unit * static_cast<double>(v->x), -per_unit * static_cast<double>(v->y)};
    }
    static OutlineWriter& of(void* self) { return *static_cast<OutlineWriter*>(self); }
};

int move_to(const FT_Vector* to, void* self) {
    OutlineWriter& writer = OutlineWriter::of(self);
    if (!writer.path.steps.empty()) writer.path.close();
    writer.path.move(writer.point(to));
    return 0;
}
int line_to(const FT_Vector* to, void* self) {
    OutlineWriter& writer = OutlineWriter::of(self);
    writer.path.line(writer.point(to));
    return 0;
}
int cubic_to(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* self) {
    OutlineWriter& writer = OutlineWriter::of(self);
    writer.path.cubic(writer.point(a), writer.point(b), writer.point(to));
    return 0;
}
// A quadratic curve equals the cubic whose control points are two thirds of the way to the
// quadratic control point.
int conic_to(const FT_Vector* control, const FT_Vector* to, void* self) {
    OutlineWriter& writer = OutlineWriter::of(self);
    const Eigen::Vector2d from = writer.path.steps.back().to, end = writer.point(to);
    const Eigen::Vector2d middle = writer.point(control);
    writer.path.cubic(from + 2.0 / 3.0 * (middle - from), end + 2.0 / 3.0 * (middle - end), end);
    return 0;
}

}  // namespace

struct FontFace::Handles {
    Handle<FT_LibraryRec_, FT_Done_FreeType> library;
    Handle<FT_FaceRec_, FT_Done_Face> face;
    Handle<hb_blob_t, hb_blob_destroy> blob;
};

FontFace::FontFace(const std::filesystem::path& file) : handles_(std::make_unique<Handles>()) {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (FT_Init_FreeType(&library) == 0) handles_->library.reset(library);
    const FT_Error error =
        library == nullptr ? FT_Err_Ok : FT_New_Face(library, file.c_str(), 0, &face);
    if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    if (face == nullptr)
        throw EnvironmentError(
            fmt::format("{}: not a font that can be read; reinstall the package fonts-lmodern",
                        printable(file.string())));
    handles_->face.reset(face);
    handles_->blob.reset(hb_blob_create_from_file(file.c_str()));
    FT_UInt glyph = 0;
    // A control character or a noncharacter is no text of a document: readers refuse it.
    for (FT_ULong code = FT_Get_First_Char(face, &glyph); glyph != 0;
         code = FT_Get_Next_Char(face, code, &glyph))
        if (const auto c = static_cast<char32_t>(code); !is_control(c) && !is_noncharacter(c))
            characters_.emplace(glyph, c);
}

FontFace::~FontFace() = default;
FontFace::FontFace(FontFace&&) noexcept = default;

FT_FaceRec_* FontFace::handle() const { return handles_->face.get(); }

char32_t FontFace::character(std::uint32_t glyph) const {
    const auto found = characters_.find(glyph);
    return found == characters_.end() ? 0 : found->second;
}

std::u32string FontFace::meaning(std::uint32_t glyph) const {
    char32_t c = character(glyph);
    if (c == 0) {
        // "radical.v2" is a variant of "radical".
        std::array<char, 64> name{};
        FT_Get_Glyph_Name(handle(), glyph, name.data(), static_cast<FT_UInt>(name.size()));
        std::string base(name.data());
        base.resize(std::min(base.find('.'), base.size()));
        if (!base.empty()) c = character(FT_Get_Name_Index(handle(), base.data()));
    }
    if (c == 0) return {};
    switch (c) {
        case U'\ufb00':
            return U"ff";
        case U'\ufb01':
            return U"fi";
        case U'\ufb02':
            return U"fl";
        case U'\ufb03':
            return U"ffi";
        case U'\ufb04':
            return U"ffl";
        default:
            return {plain_letter(c)};
    }
}

Path FontFace::outline(std::uint32_t glyph) const {
    OutlineWriter writer;
    FT_Face face = handle();
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) != 0) return {};
    writer.per_unit = 1.0 / face->units_per_EM;
    FT_Outline_Funcs functions{};
    functions.move_to = move_to;
    functions.line_to = line_to;
    functions.conic_to = conic_to;
    functions.cubic_to = cubic_to;
    FT_Outline_Decompose(&face->glyph->outline, &functions, &writer);
    if (!writer.path.steps.empty()) writer.path.close();
    return std::move(writer.path);
}

double FontFace::advance(std::uint32_t glyph) const {
    FT_Face face = handle();
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) != 0) return 0.0;
    return static_cast<double>(face->glyph->advance.x) / face->units_per_EM;
}

std::string FontFace::family() const {
    const char* name = handle()->family_name;
    return name == nullptr ? "" : name;
}

std::string FontFace::subset(const std::set<char32_t>& characters) const {
    const Handle<hb_face_t, hb_face_destroy> whole(hb_face_create(handles_->blob.get(), 0));
    const Handle<hb_subset_input_t, hb_subset_input_destroy> input(
        hb_subset_input_create_or_fail());
    if (!input) return {};
    for (const char32_t c : characters)
        hb_set_add(hb_subset_input_unicode_set(input.get()), static_cast<hb_codepoint_t>(c));
    // Each letter has its own position, so tables that move or replace letters are dropped.
    hb_set_t* dropped = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
    for (const hb_tag_t table :
         {HB_TAG('G', 'S', 'U', 'B'), HB_TAG('G', 'P', 'O', 'S'), HB_TAG('M', 'A', 'T', 'H'),
          HB_TAG('G', 'D', 'E', 'F'), HB_TAG('k', 'e', 'r', 'n'), HB_TAG('D', 'S', 'I', 'G')})
        hb_set_add(dropped, table);
    hb_subset_input_set_flags(input.get(),
                              HB_SUBSET_FLAGS_NO_HINTING | HB_SUBSET_FLAGS_DESUBROUTINIZE);
    const Handle<hb_face_t, hb_face_destroy> cut(hb_subset_or_fail(whole.get(), input.get()));
    if (!cut) return {};
    const Handle<hb_blob_t, hb_blob_destroy> blob(hb_face_reference_blob(cut.get()));
    unsigned int length = 0;
    const char* data = hb_blob_get_data(blob.get(), &length);
    return {data, length};
}

char32_t plain_letter(char32_t c) {
    // Unicode Standard §22.2: consecutive alphabets of 52 Latin letters, of 58 Greek letters and
    // signs, and of 10 digits.
    if (c >= 0x1D400 && c < 0x1D6A4) {
        const char32_t k = (c - 0x1D400) % 52;
        return k < 26 ? U'A' + k : U'a' + (k - 26);
    }
    if (c >= 0x1D6A8 && c < 0x1D7CA) {
        const char32_t k = (c - 0x1D6A8) % 58;
        if (k == 17) return U'\u03f4';
        if (k < 25) return U'\u0391' + k;
        if (k == 25) return U'\u2207';
        if (k < 51) return U'\u03b1' + (k - 26);
        constexpr std::array<char32_t, 7> signs{U'\u2202', U'\u03f5', U'\u03d1', U'\u03f0',
                                                U'\u03d5', U'\u03f1', U'\u03d6'};
        return signs.at(k - 51);
    }
    if (c >= 0x1D7CE && c < 0x1D800) return U'0' + (c - 0x1D7CE) % 10;
    if (c == U'\u210e') return U'h';
    return c;
}

FontFace& FontFaces::of(const std::filesystem::path& file) {
    const auto found = faces_.find(file);
    if (found != faces_.end()) return found->second;
    return faces_.emplace(file, FontFace(file)).first->second;
}

}  // namespace poinsot::vector
