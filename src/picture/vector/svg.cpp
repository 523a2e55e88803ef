#include "vector/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "text/utf8.h"
#include "vector/canvas.h"
#include "vector/font_face.h"
#include "vector/gradients.h"
#include "vector/pdf.h"
#include "vector/svg_data.h"

namespace poinsot::vector {

namespace {

constexpr std::string_view metadata_opening = "<metadata id=\"poinsot\">";
constexpr std::string_view metadata_end = "</metadata>";

using svg::base64;
using svg::data_of;
using svg::escaped;
using svg::matrix;
using svg::number;
using svg::PathData;
using svg::rounded;
using svg::share;
using svg::unescaped;

constexpr std::string_view group_end = "</g>\n";

class SvgWriter {
 public:
    void operator()(const Fill& fill) {
        if (const ShadedDisc* disc = std::get_if<ShadedDisc>(&fill.paint)) {
            shade(fill.path, *disc);
            return;
        }
        const std::string rule = fill.even_odd ? " fill-rule=\"evenodd\"" : "";
        body() +=
            fmt::format("<path d=\"{}\"{}{}/>\n", data_of(fill.path), paint_of(fill.paint), rule);
    }

    void operator()(const Stroke& stroke) {
        std::string look = fmt::format(" stroke=\"{}\"", hex_text(stroke.ink.colour));
        if (rounded(stroke.width_pt) != rounded(least_line_pt))
            look += fmt::format(" stroke-width=\"{}\"", number(stroke.width_pt));
        if (stroke.ink.alpha < 1.0)
            look += fmt::format(" stroke-opacity=\"{}\"", share(stroke.ink.alpha));
        if (stroke.round) look += " stroke-linecap=\"round\"";
        if (!stroke.dashes_pt.empty()) {
            std::string dashes;
            for (const double dash : stroke.dashes_pt)
                dashes += (dashes.empty() ? "" : " ") + number(dash);
            look += fmt::format(" stroke-dasharray=\"{}\"", dashes);
            if (stroke.dash_offset_pt != 0.0)
                look += fmt::format(" stroke-dashoffset=\"{}\"", number(stroke.dash_offset_pt));
        }
        body("<g class=\"l\">\n") +=
            fmt::format("<path d=\"{}\"{}/>\n", data_of(stroke.path), look);
    }

    void operator()(const Type& type) {
        std::string look = fmt::format(" fill=\"{}\"", hex_text(type.ink.colour));
        if (type.ink.alpha < 1.0)
            look += fmt::format(" fill-opacity=\"{}\"", share(type.ink.alpha));
        if (type.halo.alpha > 0.0 && type.halo_pt > 0.0)
            look += fmt::format(
                " paint-order=\"stroke\" stroke=\"{}\" stroke-opacity=\"{:.3g}\" "
                "stroke-width=\"{}\" stroke-linejoin=\"round\"",
                hex_text(type.halo.colour), type.halo.alpha, number(1.5 * type.halo_pt));
        body() += fmt::format("<g{}>\n", look);
        PathData shapes;
        bool any_shape = !type.rules.steps.empty();
        shapes.add(type.rules);
        for (std::size_t from = 0; from < type.letters.size();) {
            const PlacedLetter& letter = type.letters[from];
            FontFace& font = fonts_.of(*letter.font_file);
            if (font.character(letter.glyph) == 0) {
                // A glyph without a character is drawn as a path.
                Eigen::Affine2d map = Eigen::Affine2d::Identity();
                map.translation() = Eigen::Vector2d(letter.x_pt, letter.y_pt);
                map.linear() *= letter.em_pt;
                if (letter.colour) {
                    PathData own;
                    own.add(font.outline(letter.glyph), map);
                    body() += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n",
                                          hex_text(*letter.colour), own.take());
                } else {
                    any_shape = true;
                    shapes.add(font.outline(letter.glyph), map);
                }
                ++from;
                continue;
            }
            from = add_run(type, from, font);
        }
        if (any_shape) body() += fmt::format("<path d=\"{}\"/>\n", shapes.take());
        body() += "</g>\n";
    }

    void operator()(const Picture& picture) {
        body() += fmt::format(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
            "href=\"data:image/png;base64,{}\"/>\n",
            number(picture.corner_pt.x()), number(picture.corner_pt.y()),
            number(picture.size_pt.x()), number(picture.size_pt.y()),
            base64(png_of(picture.raster)));
    }

    void operator()(const ClipBegin& clip) {
        body() += fmt::format("<g clip-path=\"url(#{})\">\n", clip_id(clip.path, clip.even_odd));
    }
    void operator()(const ClipEnd&) { body() += group_end; }
    // Inkscape shows groups of this kind in its list of layers.
    void operator()(const GroupBegin& group) {
        body() += fmt::format(
            "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", group.id);
    }
    void operator()(const GroupEnd&) { body() += group_end; }

    std::string take_body() { return std::move(body()); }
    std::string defs() { return std::move(defs_); }

    // The fonts of the text, each reduced to the characters used.
    std::string style() {
        std::string style = fmt::format(".l{{fill:none;stroke-linejoin:round;stroke-width:{}}}\n",
                                        number(least_line_pt));
        for (const auto& [file, used] : used_) {
            const std::string font = fonts_.of(file).subset(used.characters);
            if (!font.empty())
                style +=
                    fmt::format("@font-face{{font-family:{};src:url(data:font/otf;base64,{})}}\n",
                                used.name, base64(font));
            style += fmt::format(
                ".{0}{{font-family:{0},\"{1}\";font-variant-ligatures:none;white-space:pre}}\n",
                used.name, fonts_.of(file).family());
        }
        return style;
    }

 private:
    struct UsedFont {
        std::string name;
        std::set<char32_t> characters;
    };
    // Ordered by the fonts' file names, so that the bytes do not depend on their folders.
    struct ByName {
        bool operator()(const std::filesystem::path& a, const std::filesystem::path& b) const {
            const auto order = a.filename().compare(b.filename());
            return order != 0 ? order < 0 : a < b;
        }
    };

    // The id of a clip; equal clips share one id.
    const std::string& clip_id(const Path& path, bool even_odd) {
        const std::string shape = fmt::format("<path d=\"{}\"{}/>", data_of(path),
                                              even_odd ? " clip-rule=\"evenodd\"" : "");
        std::string& id = clips_[shape];
        if (id.empty()) {
            id = next_id();
            defs_ += fmt::format("<clipPath id=\"{}\">{}</clipPath>\n", id, shape);
        }
        return id;
    }

    // The output buffer, inside a group of this kind; the group stays open as long as the kind does
    // not change.
    std::string& body(const std::string& group = "") {
        if (group != group_) {
            if (!group_.empty()) body_ += group_end;
            body_ += group;
            group_ = group;
        }
        return body_;
    }

    std::string next_id() { return fmt::format("p{}", ++n_ids_); }

    std::string stops_of(const std::vector<Stop>& stops) {
        std::string text;
        for (const Stop& stop : stops) {
            text += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"", share(stop.at),
                                hex_text(stop.ink.colour));
            if (stop.ink.alpha < 1.0)
                text += fmt::format(" stop-opacity=\"{}\"", share(stop.ink.alpha));
            text += "/>";
        }
        return text;
    }

    std::string paint_of(const Paint& paint) {
        if (const PaperInk* ink = std::get_if<PaperInk>(&paint)) {
            std::string text = fmt::format(" fill=\"{}\"", hex_text(ink->colour));
            if (ink->alpha < 1.0) text += fmt::format(" fill-opacity=\"{}\"", share(ink->alpha));
            return text;
        }
        const std::string id = next_id();
        if (const LinearFade* linear = std::get_if<LinearFade>(&paint)) {
            defs_ += fmt::format(
                "<linearGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" x1=\"{}\" y1=\"{}\" "
                "x2=\"{}\" y2=\"{}\">{}</linearGradient>\n",
                id, number(linear->from.x()), number(linear->from.y()), number(linear->to.x()),
                number(linear->to.y()), stops_of(linear->stops));
        } else if (const RadialFade* radial = std::get_if<RadialFade>(&paint)) {
            defs_ += fmt::format(
                "<radialGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" "
                "r=\"1\" fx=\"{:.5g}\" fy=\"{:.5g}\" "
                "gradientTransform=\"{}\">{}</radialGradient>\n",
                id, radial->focus.x(), radial->focus.y(), matrix(radial->paper_from_circle),
                stops_of(radial->stops));
        }
        return fmt::format(" fill=\"url(#{})\"", id);
    }

    // SVG has no gradients over meshes. Between two spokes of the disc, triangles' sides are
    // chords, which cut off the steep tones at the limb: more spokes.
    void shade(const Path& path, const ShadedDisc& disc) {
        constexpr int finer = 3;
        const int n_spokes = finer * disc.n_spokes;
        std::vector<ShadedTriangle> triangles;
        const auto add = [&](const std::array<std::pair<int, int>, 3>& corners) {
            ShadedTriangle& triangle = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& [ring, spoke] = corners[k];
                const double angle = 2.0 * std::numbers::pi * spoke / n_spokes;
                const Eigen::Vector2d place =
                    disc.radius(ring) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
                triangle.corners[k] = disc.paper_from_disc * place;
                triangle.colours[k] = disc.at(place);
            }
        };
        for (int ring = 0; ring < disc.n_rings; ++ring)
            for (int spoke = 0; spoke < n_spokes; ++spoke) {
                // The same places for the last spoke and the first.
                const int next = (spoke + 1) % n_spokes;
                add({{{ring, spoke}, {ring + 1, spoke}, {ring + 1, next}}});
                if (ring > 0) add({{{ring, spoke}, {ring + 1, next}, {ring, next}}});
            }
        body() += fmt::format("<g clip-path=\"url(#{})\" opacity=\"{:.3g}\">\n",
                              clip_id(path, false), disc.alpha);
        constexpr std::size_t most_fills = 100;
        for (const Fill& fill : gradient_fills(triangles, least_shade, most_fills)) (*this)(fill);
        body() += group_end;
    }

    // Adds letters of one font, size and baseline, each with its position; returns the index after
    // the last. A letter beyond the first 65,536 characters gets its own element, since viewers
    // count positions differently there.
    std::size_t add_run(const Type& type, std::size_t from, FontFace& font) {
        const PlacedLetter& first = type.letters[from];
        UsedFont& used = used_[*first.font_file];
        if (used.name.empty()) used.name = fmt::format("f{}", used_.size());
        std::string places, letters;
        std::size_t to = from;
        double pen_pt = 0.0;  // where the previous letter ends
        for (; to < type.letters.size(); ++to) {
            const PlacedLetter& letter = type.letters[to];
            if (*letter.font_file != *first.font_file || letter.em_pt != first.em_pt ||
                letter.colour != first.colour || rounded(letter.y_pt) != rounded(first.y_pt))
                break;
            const char32_t c = font.character(letter.glyph);
            if (c == 0 || (c > 0xffff && to > from)) break;
            // Viewers drop spaces at the beginning of a text, and some then use their positions for
            // the following letters.
            if (c == U' ' && letters.empty()) continue;
            // A gap between words becomes a space, so that words can be searched.
            constexpr double word_gap = 0.15;  // ems
            if (!letters.empty() && letter.x_pt - pen_pt > word_gap * letter.em_pt) {
                used.characters.insert(U' ');
                letters += ' ';
                places += " " + number(pen_pt);
            }
            pen_pt = letter.x_pt + letter.em_pt * font.advance(letter.glyph);
            used.characters.insert(c);
            letters += utf8_of(c);
            places += (places.empty() ? "" : " ") + number(letter.x_pt);
            if (c > 0xffff) {
                ++to;
                break;
            }
        }
        if (letters.empty()) return to;
        const std::string fill =
            first.colour ? fmt::format(" fill=\"{}\"", hex_text(*first.colour)) : "";
        body() += fmt::format("<text class=\"{}\"{} font-size=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n",
                              used.name, fill, number(first.em_pt), places, number(first.y_pt),
                              escaped(letters));
        return to;
    }

    std::string defs_, body_;
    std::string group_;  // opening tag of the open group
    int n_ids_ = 0;
    std::map<std::string, std::string> clips_;  // ids by shape
    FontFaces fonts_;
    std::map<std::filesystem::path, UsedFont, ByName> used_;
};

}  // namespace

std::string svg_of(const SheetOfPaper& paper, std::string_view title, std::string_view text) {
    SvgWriter writer;
    for (const Item& item : paper.items) std::visit(writer, item);
    const std::string body = writer.take_body();
    constexpr double mm_per_pt = 25.4 / 72.0;
    std::string svg = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
        "width=\"{0:.6g}mm\" height=\"{1:.6g}mm\" viewBox=\"0 0 {2} {3}\">\n",
        mm_per_pt * paper.width_pt, mm_per_pt * paper.height_pt, number(paper.width_pt),
        number(paper.height_pt));
    if (!title.empty()) svg += fmt::format("<title>{}</title>\n", escaped(title));
    if (!text.empty())
        svg += fmt::format("{}{}{}\n", metadata_opening, escaped(text), metadata_end);
    svg += fmt::format("<style>\n{}</style>\n", writer.style());
    svg += fmt::format("<defs>\n{}</defs>\n", writer.defs());
    return svg + body + "</svg>\n";
}

std::string svg_text(std::string_view svg) {
    const std::size_t at = svg.find(metadata_opening);
    if (at == std::string_view::npos) return {};
    const std::size_t end = svg.find(metadata_end, at);
    if (end == std::string_view::npos) return {};
    const std::size_t from = at + metadata_opening.size();
    return unescaped(svg.substr(from, end - from));
}

}  // namespace poinsot::vector
