#include "production/cluster/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "error/error.h"
#include "system/files/file_contents.h"
#include "system/run_program.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr int default_largest_array = 1001;  // slurm.conf(5), MaxArraySize

// "1-3,7": indices from 1, relative to an offset, of unfinished lines within an array's size; empty
// if there are none.
std::string indices_of(const std::vector<SubmittedTask>& tasks, std::size_t offset,
                       std::size_t most) {
    std::string text;
    const std::size_t end = std::min(tasks.size(), offset + most);
    for (std::size_t k = offset; k < end; ++k) {
        if (tasks[k].is_done) continue;
        const std::size_t first = k;
        while (k + 1 < end && !tasks[k + 1].is_done) ++k;
        text += text.empty() ? "" : ",";
        text += first == k ? fmt::format("{}", k - offset + 1)
                           : fmt::format("{}-{}", first - offset + 1, k - offset + 1);
    }
    return text;
}

void add_calls(std::vector<SlurmCall>& calls, const Submission& submission,
               const std::vector<SubmittedTask>& tasks, const char* list,
               const std::vector<std::string>& options, int largest_array) {
    const std::string folder = submission.folder.string();
    // Slurm's indices start at 1 here and must be less than largest_array.
    const auto most = static_cast<std::size_t>(std::max(1, largest_array - 1));
    for (std::size_t offset = 0; offset < tasks.size(); offset += most) {
        const std::string indices = indices_of(tasks, offset, most);
        if (indices.empty()) continue;
        SlurmCall& call = calls.emplace_back();
        call.after_parts = list == std::string("joins");
        call.words = {"sbatch",
                      "--parsable",
                      "--array=" + indices,
                      "--job-name=" + submission.folder.stem().string(),
                      "--cpus-per-task=1",
                      "--requeue",
                      "--open-mode=append",
                      "--output=" + folder + "/logs/array.log",
                      fmt::format("--export=ALL,POINSOT_OFFSET={}", offset)};
        call.words.insert(call.words.end(), options.begin(), options.end());
        call.words.push_back(folder + "/task.sh");
        call.words.emplace_back(list);
    }
}

std::string joined(const std::vector<std::string>& ids) {
    std::string text;
    for (const std::string& id : ids) text += ":" + id;
    return text;
}

// The id in "1234;cluster\n".
std::string id_of(const std::string& answer) {
    return answer.substr(0, answer.find_first_of(";\n \t"));
}

[[noreturn]] void give_up(const SlurmIds& ids, const std::string& why) {
    std::vector<std::string> cancel{"scancel"};
    for (const auto* list : {&ids.parts, &ids.joins})
        cancel.insert(cancel.end(), list->begin(), list->end());
    std::string what_was;
    if (cancel.size() > 1) {
        const bool cancelled = run_program(cancel).code == 0;
        what_was = fmt::format("; {}{}", cancelled ? "cancelled:" : "still submitted:",
                               joined({cancel.begin() + 1, cancel.end()}));
    }
    throw EnvironmentError(why + what_was);
}

// A Slurm command's message as one line, without the command's name and "error:".
std::string words_of(const std::string& said) {
    std::string words;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        for (const std::string_view before : {"sbatch: ", "error: "})
            if (line.starts_with(before)) line.erase(0, before.size());
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (!line.empty()) words += (words.empty() ? "" : "; ") + line;
    }
    return words.empty() ? "no message" : printable(words, most_of_a_message);
}

}  // namespace

std::vector<SlurmCall> slurm_calls(const Submission& submission,
                                   const std::vector<std::string>& options, int largest_array) {
    std::vector<SlurmCall> calls;
    add_calls(calls, submission, submission.parts, "tasks", options, largest_array);
    add_calls(calls, submission, submission.joins, "joins", options, largest_array);
    return calls;
}

std::string in_shell(const std::vector<SlurmCall>& calls) {
    std::string text;
    bool any_parts = false;
    for (const SlurmCall& call : calls) {
        std::string line;
        for (std::size_t k = 0; k < call.words.size(); ++k) {
            line += (k > 0 ? " " : "") + shell_word(call.words[k]);
            if (k == 1 && call.after_parts && any_parts)
                line += " --dependency=afterok$parts --kill-on-invalid-dep=yes";
        }
        if (call.after_parts) {
            text += line + "\n";
        } else {
            text += fmt::format("parts=$parts:$({})\n", line);
            any_parts = true;
        }
    }
    return text;
}

std::vector<std::string> site_options() {
    std::vector<std::filesystem::path> files{"/etc/poinsot/slurm.options"};
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder != nullptr && *folder != 0)
        files.push_back(std::filesystem::path(folder) / "poinsot/slurm.options");
    else if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0)
        files.push_back(std::filesystem::path(home) / ".config/poinsot/slurm.options");
    std::vector<std::string> options;
    for (const auto& file : files) {
        std::istringstream text(read_text_if_there(file));
        for (std::string line; std::getline(text, line);)
            for (const std::string& word : shell_words(line.substr(0, line.find('#'))))
                options.push_back(word);
    }
    return options;
}

int largest_array() {
    const ProgramOutcome answer = run_program({"scontrol", "show", "config"});
    const std::size_t at = answer.out.find("MaxArraySize");
    const std::size_t equals = at == std::string::npos ? at : answer.out.find('=', at);
    if (equals == std::string::npos) return default_largest_array;
    const int size = std::atoi(answer.out.c_str() + equals + 1);
    return size > 1 ? size : default_largest_array;
}

SlurmIds submit(const std::vector<SlurmCall>& calls) {
    SlurmIds ids;
    for (const SlurmCall& call : calls) {
        std::vector<std::string> words = call.words;
        if (call.after_parts && !ids.parts.empty()) {
            const std::vector<std::string> after{"--dependency=afterok" + joined(ids.parts),
                                                 "--kill-on-invalid-dep=yes"};
            words.insert(words.begin() + 1, after.begin(), after.end());
        }
        const ProgramOutcome answer = run_program(words);
        if (!answer.found)
            give_up(ids,
                    "sbatch: this machine has no such program; submit on a machine with Slurm, or "
                    "use --dry-run and run the tasks yourself");
        const std::string id = id_of(answer.out);
        if (answer.code != 0 || id.empty())
            give_up(ids, fmt::format("sbatch refused: {}", words_of(answer.err)));
        (call.after_parts ? ids.joins : ids.parts).push_back(id);
    }
    return ids;
}

}  // namespace poinsot
