#include "vector/pdf.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numbers>
#include <utility>

#include "error/error.h"
#include "text/utf8.h"
#include "vector/font_face.h"
#include "vector/handle.h"

namespace poinsot::vector {

namespace {

using Surface = Handle<cairo_surface_t, cairo_surface_destroy>;
using Context = Handle<cairo_t, cairo_destroy>;
using Pattern = Handle<cairo_pattern_t, cairo_pattern_destroy>;
using Face = Handle<cairo_font_face_t, cairo_font_face_destroy>;
using Options = Handle<cairo_font_options_t, cairo_font_options_destroy>;

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw EnvironmentError(
            fmt::format("Cairo cannot make the PDF: {}", cairo_status_to_string(status)));
}

cairo_matrix_t matrix_of(const Eigen::Affine2d& map) {
    const auto& m = map.matrix();
    return {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)};
}

Surface image_of(const Raster& raster) {
    Surface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width, raster.height));
    check(cairo_surface_status(image.get()));
    unsigned char* data = cairo_image_surface_get_data(image.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
    const auto width = static_cast<std::size_t>(raster.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(raster.height); ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(data + y * stride);
        const std::uint8_t* from = raster.rgba.data() + 4 * width * y;
        for (std::size_t x = 0; x < width; ++x, from += 4) {
            const std::uint32_t alpha = from[3];
            const auto times = [alpha](std::uint32_t c) { return (c * alpha + 127) / 255; };
            row[x] = alpha << 24U | times(from[0]) << 16U | times(from[1]) << 8U | times(from[2]);
        }
    }
    cairo_surface_mark_dirty(image.get());
    return image;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

class PdfWriter {
 public:
    explicit PdfWriter(cairo_t* cairo) : cairo_(cairo) {
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_tolerance(cairo, 0.01);
    }

    void operator()(const Fill& fill) {
        if (const ShadedDisc* disc = std::get_if<ShadedDisc>(&fill.paint)) {
            shade(fill.path, *disc);
            return;
        }
        trace(fill.path);
        cairo_set_fill_rule(cairo_,
                            fill.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        set_paint(fill.paint);
        cairo_fill(cairo_);
    }

    void operator()(const Stroke& stroke) {
        trace(stroke.path);
        set_ink(stroke.ink);
        cairo_set_line_width(cairo_, stroke.width_pt);
        cairo_set_line_cap(cairo_, stroke.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
        cairo_set_dash(cairo_, stroke.dashes_pt.data(), static_cast<int>(stroke.dashes_pt.size()),
                       stroke.dash_offset_pt);
        cairo_stroke(cairo_);
    }

    void operator()(const Type& type) {
        if (type.halo.alpha > 0.0 && type.halo_pt > 0.0) draw_halo(type);
        // Runs of letters of one font, size and colour.
        for (std::size_t from = 0; from < type.letters.size();) {
            std::size_t to = from;
            while (to < type.letters.size() && is_one_run(type.letters[from], type.letters[to]))
                ++to;
            set_ink({type.letters[from].colour.value_or(type.ink.colour), type.ink.alpha});
            show(type, from, to);
            from = to;
        }
        if (type.rules.steps.empty()) return;
        set_ink(type.ink);
        trace(type.rules);
        cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
        cairo_fill(cairo_);
    }

    void operator()(const Picture& picture) {
        const Surface image = image_of(picture.raster);
        cairo_save(cairo_);
        cairo_translate(cairo_, picture.corner_pt.x(), picture.corner_pt.y());
        cairo_scale(cairo_, picture.size_pt.x() / picture.raster.width,
                    picture.size_pt.y() / picture.raster.height);
        cairo_set_source_surface(cairo_, image.get(), 0.0, 0.0);
        cairo_pattern_set_filter(cairo_get_source(cairo_), CAIRO_FILTER_GOOD);
        cairo_paint(cairo_);
        cairo_restore(cairo_);
    }

    void operator()(const ClipBegin& clip) {
        cairo_save(cairo_);
        trace(clip.path);
        cairo_set_fill_rule(cairo_,
                            clip.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        cairo_clip(cairo_);
    }
    void operator()(const ClipEnd&) { cairo_restore(cairo_); }
    // Groups are for programs that edit the file; PDF has none.
    void operator()(const GroupBegin&) {}
    void operator()(const GroupEnd&) {}

 private:
    static bool is_one_run(const PlacedLetter& a, const PlacedLetter& b) {
        return *a.font_file == *b.font_file && a.em_pt == b.em_pt && a.colour == b.colour;
    }

    void trace(const Path& path) {
        cairo_new_path(cairo_);
        for (const Step& step : path.steps) {
            switch (step.kind) {
                case Step::Kind::move:
                    cairo_move_to(cairo_, step.to.x(), step.to.y());
                    break;
                case Step::Kind::line:
                    cairo_line_to(cairo_, step.to.x(), step.to.y());
                    break;
                case Step::Kind::cubic:
                    cairo_curve_to(cairo_, step.control_1.x(), step.control_1.y(),
                                   step.control_2.x(), step.control_2.y(), step.to.x(),
                                   step.to.y());
                    break;
                case Step::Kind::close:
                    cairo_close_path(cairo_);
            }
        }
    }

    void set_ink(const PaperInk& ink) {
        cairo_set_source_rgba(cairo_, ink.colour.r, ink.colour.g, ink.colour.b, ink.alpha);
    }

    static void add_stops(const std::vector<Stop>& stops, cairo_pattern_t* pattern) {
        for (const Stop& stop : stops)
            cairo_pattern_add_color_stop_rgba(pattern, stop.at, stop.ink.colour.r,
                                              stop.ink.colour.g, stop.ink.colour.b, stop.ink.alpha);
    }

    void set_paint(const Paint& paint) {
        if (const PaperInk* ink = std::get_if<PaperInk>(&paint)) {
            set_ink(*ink);
        } else if (const LinearFade* linear = std::get_if<LinearFade>(&paint)) {
            const Pattern pattern(cairo_pattern_create_linear(linear->from.x(), linear->from.y(),
                                                              linear->to.x(), linear->to.y()));
            add_stops(linear->stops, pattern.get());
            cairo_set_source(cairo_, pattern.get());
        } else if (const RadialFade* radial = std::get_if<RadialFade>(&paint)) {
            const Pattern pattern(cairo_pattern_create_radial(radial->focus.x(), radial->focus.y(),
                                                              0.0, 0.0, 0.0, 1.0));
            const cairo_matrix_t matrix = matrix_of(radial->paper_from_circle.inverse());
            cairo_pattern_set_matrix(pattern.get(), &matrix);
            add_stops(radial->stops, pattern.get());
            cairo_set_source(cairo_, pattern.get());
        }
    }

    static Eigen::Vector2d on_rim(const ShadedDisc& disc, double spoke) {
        const double angle = 2.0 * std::numbers::pi * spoke / disc.n_spokes;
        return {std::cos(angle), std::sin(angle)};
    }

    // PDF viewers cut patches off at whole pixels. So sectors in the limb's colours draw the edge,
    // below patches that end just inside it; both form one sheet.
    void shade(const Path& path, const ShadedDisc& disc) {
        const auto clip_to = [this](const Path& outline) {
            cairo_save(cairo_);
            trace(outline);
            cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
            cairo_clip(cairo_);
        };
        cairo_push_group(cairo_);
        clip_to(path);
        for (int spoke = 0; spoke < disc.n_spokes; ++spoke) {
            // Each sector extends under the next one, and the last under the first.
            const double reach = spoke + 1 < disc.n_spokes ? 1.5 : 0.5;
            Path sector;
            // The far side of the sector is outside the disc.
            const double out = 1.1 / std::cos(std::numbers::pi * (0.5 + reach) / disc.n_spokes);
            sector.move(disc.paper_from_disc * Eigen::Vector2d::Zero());
            sector.line(disc.paper_from_disc * (out * on_rim(disc, spoke - 0.5)));
            sector.line(disc.paper_from_disc * (out * on_rim(disc, spoke + reach)));
            sector.close();
            set_ink({disc.at(disc.n_rings, spoke), 1.0});
            trace(sector);
            cairo_fill(cairo_);
        }
        cairo_restore(cairo_);
        const double size_pt = std::sqrt(std::abs(disc.paper_from_disc.linear().determinant()));
        const double inset = std::max(1.0 - 0.5 / std::max(size_pt, 1e-9), 0.5);
        Path inner;
        const Eigen::Vector2d middle = disc.paper_from_disc.translation();
        for (Step step : path.steps) {
            for (Eigen::Vector2d* p : {&step.control_1, &step.control_2, &step.to})
                *p = middle + inset * (*p - middle);
            inner.steps.push_back(step);
        }
        clip_to(inner);
        const Pattern mesh = mesh_of(disc);
        cairo_set_source(cairo_, mesh.get());
        cairo_paint(cairo_);
        cairo_restore(cairo_);
        cairo_pop_group_to_source(cairo_);
        cairo_paint_with_alpha(cairo_, disc.alpha);
    }

    // Patches between rings and spokes; the disc's path clips the outermost.
    static Pattern mesh_of(const ShadedDisc& disc) {
        Pattern mesh(cairo_pattern_create_mesh());
        const auto place = [&](int ring, int spoke, double ahead = 0.0) {
            const Eigen::Vector2d rim = on_rim(disc, spoke);
            const Eigen::Vector2d at = rim + ahead * Eigen::Vector2d(-rim.y(), rim.x());
            return (disc.paper_from_disc * (disc.radius(ring) * at)).eval();
        };
        // An arc along a ring to the next or previous spoke.
        const double handle = 4.0 / 3.0 * std::tan(0.5 * std::numbers::pi / disc.n_spokes);
        const auto arc_to = [&](int ring, int spoke, int step) {
            const Eigen::Vector2d a = place(ring, spoke, step * handle);
            const Eigen::Vector2d b = place(ring, spoke + step, -step * handle);
            const Eigen::Vector2d end = place(ring, spoke + step);
            cairo_mesh_pattern_curve_to(mesh.get(), a.x(), a.y(), b.x(), b.y(), end.x(), end.y());
        };
        const auto line_to = [&](int ring, int spoke) {
            const Eigen::Vector2d end = place(ring, spoke);
            cairo_mesh_pattern_line_to(mesh.get(), end.x(), end.y());
        };
        for (int ring = 0; ring < disc.n_rings; ++ring) {
            for (int spoke = 0; spoke < disc.n_spokes; ++spoke) {
                const std::array<std::pair<int, int>, 4> corners{
                    {{ring, spoke}, {ring, spoke + 1}, {ring + 1, spoke + 1}, {ring + 1, spoke}}};
                cairo_mesh_pattern_begin_patch(mesh.get());
                const Eigen::Vector2d first = place(ring, spoke);
                cairo_mesh_pattern_move_to(mesh.get(), first.x(), first.y());
                arc_to(ring, spoke, 1);
                line_to(ring + 1, spoke + 1);
                arc_to(ring + 1, spoke + 1, -1);
                line_to(ring, spoke);
                unsigned int k = 0;
                for (const auto& [r, s] : corners) {
                    const Colour& colour = disc.at(r, s);
                    cairo_mesh_pattern_set_corner_color_rgb(mesh.get(), k++, colour.r, colour.g,
                                                            colour.b);
                }
                cairo_mesh_pattern_end_patch(mesh.get());
            }
        }
        return mesh;
    }

    void set_font(const PlacedLetter& letter) {
        Face& face = faces_[*letter.font_file];
        if (!face) face = cairo_face(*letter.font_file);
        cairo_set_font_face(cairo_, face.get());
        cairo_set_font_size(cairo_, letter.em_pt);
        const Options options(cairo_font_options_create());
        cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        cairo_set_font_options(cairo_, options.get());
    }

    // Cairo keeps references to fonts: the font is released with Cairo's last reference.
    static Face cairo_face(const std::filesystem::path& file) {
        static const cairo_user_data_key_t key{};
        auto own = std::make_unique<FontFace>(file);
        constexpr int no_hinting = 2;  // FT_LOAD_NO_HINTING
        Face face(cairo_ft_font_face_create_for_ft_face(own->handle(), no_hinting));
        check(cairo_font_face_set_user_data(
            face.get(), &key, own.get(), [](void* font) { delete static_cast<FontFace*>(font); }));
        static_cast<void>(own.release());
        return face;
    }

    static std::vector<cairo_glyph_t> glyphs_of(const Type& type, std::size_t from,
                                                std::size_t to) {
        std::vector<cairo_glyph_t> glyphs;
        for (std::size_t k = from; k < to; ++k)
            glyphs.push_back({type.letters[k].glyph, type.letters[k].x_pt, type.letters[k].y_pt});
        return glyphs;
    }

    void show(const Type& type, std::size_t from, std::size_t to) {
        set_font(type.letters[from]);
        const FontFace& font = fonts_.of(*type.letters[from].font_file);
        const std::vector<cairo_glyph_t> glyphs = glyphs_of(type, from, to);
        std::string text;
        std::vector<cairo_text_cluster_t> clusters;
        for (const cairo_glyph_t& glyph : glyphs) {
            std::string says;
            for (const char32_t c : font.meaning(static_cast<std::uint32_t>(glyph.index)))
                says += utf8_of(c);
            clusters.push_back({static_cast<int>(says.size()), 1});
            text += says;
        }
        cairo_show_text_glyphs(cairo_, text.data(), static_cast<int>(text.size()), glyphs.data(),
                               static_cast<int>(glyphs.size()), clusters.data(),
                               static_cast<int>(clusters.size()), cairo_text_cluster_flags_t{});
    }

    void draw_halo(const Type& type) {
        set_ink(type.halo);
        cairo_new_path(cairo_);
        for (const PlacedLetter& letter : type.letters) {
            // A halo is wide: to a 32nd of a point its edge is exact enough, in fewer digits.
            const auto placed = [&letter](const Eigen::Vector2d& em) {
                constexpr double steps_a_pt = 32.0;
                const Eigen::Vector2d at =
                    Eigen::Vector2d(letter.x_pt, letter.y_pt) + letter.em_pt * em;
                return Eigen::Vector2d((steps_a_pt * at).array().round() / steps_a_pt);
            };
            Path outline = fonts_.of(*letter.font_file).outline(letter.glyph);
            for (Step& step : outline.steps) {
                step.control_1 = placed(step.control_1);
                step.control_2 = placed(step.control_2);
                step.to = placed(step.to);
            }
            add(outline);
        }
        add(type.rules);
        cairo_set_line_width(cairo_, 1.5 * type.halo_pt);
        cairo_set_dash(cairo_, nullptr, 0, 0.0);
        cairo_stroke(cairo_);
    }

    void add(const Path& path) {
        for (const Step& step : path.steps) {
            if (step.kind == Step::Kind::move)
                cairo_move_to(cairo_, step.to.x(), step.to.y());
            else if (step.kind == Step::Kind::line)
                cairo_line_to(cairo_, step.to.x(), step.to.y());
            else if (step.kind == Step::Kind::cubic)
                cairo_curve_to(cairo_, step.control_1.x(), step.control_1.y(), step.control_2.x(),
                               step.control_2.y(), step.to.x(), step.to.y());
            else
                cairo_close_path(cairo_);
        }
    }

    cairo_t* cairo_;
    FontFaces fonts_;
    std::map<std::filesystem::path, Face> faces_;
};

// A PDF text string in UTF-8 (ISO 32000-2, 7.9.2.2), in parentheses.
std::string pdf_string(std::string_view text) {
    std::string out = "(\xEF\xBB\xBF";
    for (const char c : text) {
        if (c == '(' || c == ')' || c == '\\') out += '\\';
        if (c == '\r')
            out += "\\r";
        else
            out += c;
    }
    return out + ")";
}

// A PDF 1.4 text string (ISO 32000-1, 7.9.2.2) in UTF-16, as hexadecimal digits; more programs can
// show it.
std::string pdf_title(std::string_view text) {
    std::string out = "<FEFF";
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        const char32_t code = character.valid ? character.code : 0xfffd;
        if (code < 0x10000)
            out += fmt::format("{:04X}", static_cast<std::uint32_t>(code));
        else
            out += fmt::format("{:04X}{:04X}",
                               0xd800 + (static_cast<std::uint32_t>(code - 0x10000) >> 10),
                               0xdc00 + (static_cast<std::uint32_t>(code - 0x10000) & 0x3ff));
        text.remove_prefix(character.size);
    }
    return out + ">";
}

// The number after the last occurrence of this word.
std::string_view last_after(std::string_view pdf, std::string_view word) {
    const std::size_t at = pdf.rfind(word);
    if (at == std::string_view::npos) return {};
    std::string_view rest = pdf.substr(at + word.size());
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\n')) rest.remove_prefix(1);
    return rest.substr(0, rest.find_first_not_of("0123456789"));
}

}  // namespace

std::string png_of(const Raster& raster) {
    std::string bytes;
    check(cairo_surface_write_to_png_stream(image_of(raster).get(), append, &bytes));
    return bytes;
}

std::string pdf_of(const SheetOfPaper& paper) {
    std::string bytes;
    const Surface surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, paper.width_pt, paper.height_pt));
    check(cairo_surface_status(surface.get()));
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
    // A fixed date, so that the same scene always gives the same bytes.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    {
        const Context cairo(cairo_create(surface.get()));
        PdfWriter writer(cairo.get());
        for (const Item& item : paper.items) std::visit(writer, item);
        check(cairo_status(cairo.get()));
        cairo_show_page(cairo.get());
    }
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

std::string with_pdf_text(std::string pdf, std::string_view title, std::string_view name,
                          std::string_view text) {
    const std::string_view size = last_after(pdf, "/Size"), root = last_after(pdf, "/Root"),
                           before = last_after(pdf, "startxref");
    if (size.empty() || root.empty() || before.empty())
        throw EnvironmentError("Cairo has written a PDF without a trailer");
    const std::string n(size), root_number(root), previous(before);
    const std::string more = std::to_string(std::strtol(n.c_str(), nullptr, 10) + 1);
    if (pdf.back() != '\n') pdf += '\n';
    const std::size_t at = pdf.size();
    pdf += fmt::format("{} 0 obj\n<< /Creator (poinsot)\n/{} {}\n/Title {}\n>>\nendobj\n", n, name,
                       pdf_string(text), pdf_title(title));
    const std::size_t table = pdf.size();
    pdf += fmt::format(
        "xref\n{} 1\n{:010} 00000 n \ntrailer\n<< /Size {}\n/Root {} 0 R\n/Info {} 0 R\n/Prev "
        "{}\n>>\nstartxref\n{}\n%%EOF\n",
        n, at, more, root_number, n, previous, table);
    return pdf;
}

PdfText pdf_text(std::string_view pdf, std::string_view name) {
    const std::string opening =
        fmt::format(" 0 obj\n<< /Creator (poinsot)\n/{} (\xEF\xBB\xBF", name);
    const std::size_t at = pdf.rfind(opening);
    if (at == std::string_view::npos) return {};
    PdfText found;
    found.before = pdf.substr(0, pdf.rfind('\n', at) + 1);
    std::size_t k = at + opening.size();
    for (; k < pdf.size() && pdf[k] != ')'; ++k) {
        if (pdf[k] == '\\' && k + 1 < pdf.size()) {
            ++k;
            found.text += pdf[k] == 'r' ? '\r' : pdf[k];
        } else {
            found.text += pdf[k];
        }
    }
    constexpr std::string_view last_line = "%%EOF\n";
    const std::size_t end = pdf.find(last_line, k);
    found.is_last = end != std::string_view::npos && end + last_line.size() == pdf.size();
    return found;
}

}  // namespace poinsot::vector
