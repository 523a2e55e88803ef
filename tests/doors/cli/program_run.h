// Runs the program as users do and keeps its output.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "places.h"

namespace poinsot::testing {

// Path of the program under test.
const std::string& program_path();

struct ProgramRun {
    int code = -1;
    std::string out;
    std::string err;
};

// A separate folder for each test, removed at its end.
class ScratchFolder {
 public:
    ScratchFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "poinsot-test-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

    // Names of all files in the folder.
    std::string listing() const {
        std::string names;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) {
            names += entry.path().filename().string() + "\n";
        }
        return names;
    }

 private:
    std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

// `arguments` in shell syntax; run inside `folder`, with another program if one is given.
inline ProgramRun run_program_in(const ScratchFolder& folder, const std::string& arguments,
                                 const std::string& runner = "") {
    const ScratchFolder logs;
    const std::string command = "cd '" + folder.path().string() + "' && " + runner + " '" +
                                program_path() + "' " + arguments + " >'" +
                                (logs.path() / "out").string() + "' 2>'" +
                                (logs.path() / "err").string() + "'";
    const int status = std::system(command.c_str());
    ProgramRun run;
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    run.out = text_of(logs.path() / "out");
    run.err = text_of(logs.path() / "err");
    return run;
}

// Path of a supplied scene.
inline std::string scene_path(const std::string& name) {
    return (source_folder() / "scenes" / (name + ".toml")).string();
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// A text without the line of its own SHA-256.
inline std::string without_seal(std::string text) {
    const std::size_t at = text.find("sha256");
    if (at == std::string::npos) return text;
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.erase(begin, text.find('\n', at) + 1 - begin);
}

inline bool is_one_line(const std::string& text) {
    return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1;
}

}  // namespace poinsot::testing
