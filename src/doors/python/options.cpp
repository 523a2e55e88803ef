// The options of work/options.h as keywords.
#include "orders/options.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <map>

#include "compare/given_limits.h"
#include "python/bindings.h"

namespace poinsot::python {

namespace {

// "choose auto, osmesa, egl or gpu" for "auto|osmesa|egl|gpu"; "is a text" for other completions.
std::string wanted_of(std::string_view completes) {
    if (completes.find('|') == std::string_view::npos) return "is a text";
    std::string wanted = "choose ";
    const std::size_t last = completes.rfind('|');
    for (std::size_t i = 0; i < completes.size(); ++i) {
        if (completes[i] != '|')
            wanted += completes[i];
        else
            wanted += i == last ? " or " : ", ";
    }
    return wanted;
}

std::string text_of(const OptionRow& row, const py::handle& value) {
    const std::string name(row.name);
    if (!py::isinstance<py::str>(value))
        throw InputError(name + ": " + wanted_of(row.completes) + ", and this is " + shown(value));
    try {
        return value.cast<std::string>();
    } catch (const py::cast_error&) {
        throw InputError(name + ": not valid Unicode: " + shown(value) + "; give plain text");
    }
}

// Puts a keyword's value into its slot.
struct Setter {
    const OptionRow& row;
    const std::string name;
    const py::dict& options;

    void operator()(bool* value) const { *value = *option<bool>(options, name.c_str()); }
    void operator()(int* value) const { *value = *option<int>(options, name.c_str()); }
    void operator()(std::string* value) const { *value = text_of(row, options[name.c_str()]); }
    void operator()(std::optional<double>* value) const {
        *value = option<double>(options, name.c_str());
    }
    void operator()(const InstantSlot& slot) const {
        *slot.clearest = py::isinstance<py::str>(options[name.c_str()]);
        if (!*slot.clearest) *slot.time_s = option<double>(options, name.c_str());
    }
    void operator()(const FramesSlot& slot) const {
        *slot.frames = options[name.c_str()].cast<std::pair<std::int64_t, std::int64_t>>();
    }
};

// A keyword's kind and default, for signatures.
struct Describer {
    using Described = std::pair<const char*, py::object>;
    Described operator()(const bool* value) const { return {"flag", py::bool_(*value)}; }
    Described operator()(const int* value) const { return {"whole", py::int_(*value)}; }
    Described operator()(const std::string* value) const {
        if (value->empty()) return {"text", py::none()};
        return {"text", py::str(*value)};
    }
    Described operator()(const std::optional<double>*) const { return {"number", py::none()}; }
    Described operator()(const InstantSlot&) const { return {"instant", py::none()}; }
    Described operator()(const FramesSlot&) const { return {"frames", py::none()}; }
};

// The keywords of a verb, as (name, kind, default).
py::list keywords(const std::string& verb) {
    static const std::pair<const char*, unsigned> verbs[] = {{"still", Verb::still},
                                                             {"figure", Verb::figure},
                                                             {"render", Verb::film},
                                                             {"slides", Verb::slides},
                                                             {"page", Verb::page}};
    py::list answer;
    if (verb == "compare") {
        for (const NumberLimit& limit : number_limits()) {
            const char* const kind = limit.kind == LimitKind::share   ? "share"
                                     : limit.kind == LimitKind::level ? "level"
                                                                      : "number";
            answer.append(py::make_tuple(std::string(limit.name), kind, py::none()));
        }
        return answer;
    }
    GivenOptions defaults;
    for (const auto& [name, bit] : verbs) {
        if (name != verb) continue;
        for (const OptionRow& row : option_rows()) {
            if ((row.verbs & bit) == 0) continue;
            const auto [kind, value] = row.slot == nullptr
                                           ? Describer::Described{"key", py::none()}
                                           : std::visit(Describer(), row.slot(defaults));
            answer.append(py::make_tuple(std::string(row.name), kind, value));
        }
    }
    return answer;
}

}  // namespace

GivenOptions given_options(const py::dict& options) {
    GivenOptions given;
    for (const OptionRow& row : option_rows()) {
        const std::string name(row.name);
        if (!options.contains(name) || options[name.c_str()].is_none()) continue;
        if (row.slot == nullptr)
            given.overrides.push_back(
                {std::string(row.key), text_of(row, options[name.c_str()]), name});
        else
            std::visit(Setter{row, name, options}, row.slot(given));
    }
    return given;
}

std::string in_keywords(std::string text) {
    static const std::map<std::string, std::string> keyword_of = [] {
        std::map<std::string, std::string> names;
        const auto add = [&names](const std::string& name) {
            std::string flag = "--" + name;
            std::replace(flag.begin(), flag.end(), '_', '-');
            names[flag] = name;
        };
        for (const char* name :
             {"allow_outside", "antialiasing", "any_renderer", "columns", "foreign", "ignore",
              "junit", "profile", "remove", "report", "set", "single_file", "slides", "why"})
            add(name);
        for (const NumberLimit& limit : number_limits()) add(std::string(limit.name));
        for (const OptionRow& row : option_rows()) names[row.flag()] = row.name;
        return names;
    }();
    for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) {
        const bool begins =
            at == 0 || std::string_view(" (`\"").find(text[at - 1]) != std::string::npos;
        std::size_t end = at;
        while (end < text.size() && (text[end] == '-' || (text[end] >= 'a' && text[end] <= 'z')))
            ++end;
        const bool ends = end == text.size() ||
                          std::string_view(" :;,.)`\"").find(text[end]) != std::string::npos;
        const auto found = keyword_of.find(text.substr(at, end - at));
        if (begins && ends && found != keyword_of.end()) {
            text.replace(at, end - at, found->second);
            end = at + found->second.size();
        }
        at = end;
    }
    return text;
}

void add_options(py::module_& module) {
    using namespace py::literals;
    module.def("keywords", keywords, "verb"_a);
}

}  // namespace poinsot::python
