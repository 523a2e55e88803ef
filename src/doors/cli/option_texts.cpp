#include "cli/option_texts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "cli/catalogue.h"
#include "drawing/stage/overlay.h"

namespace poinsot {

namespace {

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(at), text.size());
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

// The name of a value of each kind, if the option gives none.
struct KindName {
    std::string operator()(bool* /*value*/) const { return ""; }
    std::string operator()(int* /*value*/) const { return "N"; }
    std::string operator()(std::optional<int>* /*value*/) const { return "N"; }
    std::string operator()(std::optional<double>* /*value*/) const { return "NUMBER"; }
    template <typename Text>
    std::string operator()(const Text& /*value*/) const {
        return "TEXT";
    }
};

OptionText text_of(const Option& option) {
    OptionText text{split(option.flags, ','), option.takes, option.help, option.completes};
    std::sort(text.flags.begin(), text.flags.end(),
              [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (text.takes.empty()) text.takes = std::visit(KindName{}, option.value);
    return text;
}

}  // namespace

std::string OptionText::heading() const {
    return fmt::format("{}{}{}", fmt::join(flags, ", "), takes.empty() ? "" : " ", takes);
}

std::vector<OptionText> option_texts(const Command& command) {
    std::vector<OptionText> texts;
    for (const Option& option : command.line().options) texts.push_back(text_of(option));
    texts.push_back({{"-h", "--help"}, "", "print this help", ""});
    return texts;
}

std::string usage(const Command& command) {
    std::string arguments;
    if (!command.arguments.empty()) {
        const std::string_view dots = command.most_arguments > 2 ? "..." : "";
        arguments = fmt::format("{}{}", command.arguments, dots);
        arguments = command.least_arguments > 0 ? " " + arguments : " [" + arguments + "]";
    }
    return fmt::format("poinsot {} [OPTIONS]{}", command.name, arguments);
}

std::string help_of(const Command& command) {
    std::string text = fmt::format("{}\nUsage: {}\n\nOptions:\n", command.summary, usage(command));
    const std::vector<OptionText> options = option_texts(command);
    std::size_t width = 0;
    for (const OptionText& option : options) width = std::max(width, option.heading().size());
    for (const OptionText& option : options)
        text += fmt::format("  {:{}}  {}\n", option.heading(), width, option.help);
    text += "\nExamples:\n";
    for (const Example& example : command.examples)
        text += fmt::format("  {}\n      {}\n", example.line, example.does);
    return text;
}

std::string_view completes_arguments(const Command& command) {
    const std::string_view takes = command.arguments;
    if (takes.starts_with("SCENE")) return "scenes";
    if (takes.starts_with("WHAT")) return "lists";
    if (takes.starts_with("FOLDER")) return "folder";
    return takes.empty() || takes == "NAME" ? "" : "file";
}

std::vector<std::string> words_of(std::string_view completes) {
    std::vector<std::string> words;
    if (completes.find('|') != std::string_view::npos) return split(completes, '|');
    if (completes == "lists") words.emplace_back("schema");
    for (const Catalogue& catalogue : catalogues()) {
        if (completes == "lists") words.emplace_back(catalogue.name);
        if (catalogue.name != completes || completes == "scenes") continue;
        for (const CatalogueEntry& entry : catalogue.entries()) words.push_back(entry.name);
    }
    return words;
}

std::vector<std::string> words_of(const ValueType& type) {
    if (type.kind == ValueType::Kind::boolean) return {"true", "false"};
    if (!type.names.empty()) return {type.names.begin(), type.names.end()};
    if (type.list.empty()) return {};
    std::vector<std::string> names = words_of(type.list);
    // `show` also accepts the names of overlays.
    if (type.list == "elements")
        for (const OverlayName& overlay : overlays()) names.emplace_back(overlay.name);
    return names;
}

}  // namespace poinsot
