#include "vector/lettering.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "vector/font_face.h"

namespace poinsot::vector {

namespace {

Path placed(const Path& outline, const PlacedLetter& letter) {
    const auto place = [&letter](const Eigen::Vector2d& p) -> Eigen::Vector2d {
        return Eigen::Vector2d(letter.x_pt, letter.y_pt) + letter.em_pt * p;
    };
    Path path = outline;
    for (Step& step : path.steps) {
        step.control_1 = place(step.control_1);
        step.control_2 = place(step.control_2);
        step.to = place(step.to);
    }
    return path;
}

}  // namespace

SheetOfPaper with_outlined_type(SheetOfPaper paper) {
    FontFaces fonts;
    std::vector<Item> items;
    items.reserve(paper.items.size());
    for (Item& item : paper.items) {
        const Type* type = std::get_if<Type>(&item);
        if (type == nullptr) {
            items.push_back(std::move(item));
            continue;
        }
        // Each colour is filled on its own.
        Path letters;
        std::vector<Fill> fills{{type->rules, type->ink, false}};
        for (const PlacedLetter& letter : type->letters) {
            const Path outline = placed(fonts.of(*letter.font_file).outline(letter.glyph), letter);
            const Colour colour = letter.colour.value_or(type->ink.colour);
            const auto of_colour = std::find_if(fills.begin(), fills.end(), [&](const Fill& fill) {
                return std::get<PaperInk>(fill.paint).colour == colour;
            });
            Fill& fill =
                of_colour != fills.end()
                    ? *of_colour
                    : fills.emplace_back(Fill{{}, PaperInk{colour, type->ink.alpha}, false});
            fill.path.add(outline);
            letters.add(outline);
        }
        letters.add(type->rules);
        if (type->halo.alpha > 0.0 && type->halo_pt > 0.0) {
            Stroke halo;
            halo.path = std::move(letters);
            halo.ink = type->halo;
            halo.width_pt = 1.5 * type->halo_pt;
            items.emplace_back(std::move(halo));
        }
        for (Fill& fill : fills)
            if (!fill.path.steps.empty()) items.emplace_back(std::move(fill));
    }
    paper.items = std::move(items);
    return paper;
}

std::vector<Type> take_type(SheetOfPaper& paper) {
    std::vector<Type> taken;
    std::vector<Item> left;
    for (Item& item : paper.items) {
        Type* type = std::get_if<Type>(&item);
        if (type != nullptr && !type->letters.empty())
            taken.push_back(std::move(*type));
        else
            left.push_back(std::move(item));
    }
    paper.items = std::move(left);
    return taken;
}

}  // namespace poinsot::vector
