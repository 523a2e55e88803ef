// What poinsot writes over: the file that the user named, and files that it can prove to be its
// own; nothing else.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// Whether a regular file is as poinsot wrote it.
using IsOwn = std::function<bool(const std::filesystem::path& file)>;

struct WritePlace {
    std::filesystem::path path;
    // Of a file that the user did not name: its proof. Empty: the user named the file.
    IsOwn is_own{};
    // Such as "the film's captions", for messages.
    std::string_view what{};
    // Files that the same command reads, which no output replaces.
    std::vector<std::filesystem::path> inputs{};
};

// The one rule: every output is asked for here before anything is drawn. Where the user named the
// file, anything may be there but an input. Elsewhere nothing may be there, or a regular file, no
// link, that `is_own` proves. Throws InputError, one line that names the place; and as check_aside.
void check_replaceable(const WritePlace& place);

// Whether check_replaceable would accept a file that the user did not name; never throws.
bool is_own_file(const std::filesystem::path& file, const IsOwn& is_own) noexcept;

// Proof of a text that begins so and holds its own hash, see system/seal.h.
IsOwn sealed_with(std::string_view beginning);

// SHA-256 of a file. Throws as read_text does.
std::string sha256_of_file(const std::filesystem::path& file);

// A list beside files, as with_files() makes it, and whether it proves that one of them is
// unchanged since. Reads the list once; without a list, or if it was edited, it proves nothing.
class FileList {
 public:
    explicit FileList(const std::filesystem::path& list);
    bool proves(const std::filesystem::path& file) const;
    // Whether it lists a file of this name.
    bool lists(const std::string& name) const;
    // Empty if the list is not there, or was edited.
    const std::string& text() const { return text_; }

 private:
    std::string text_;
};

// A list in a folder of the files that poinsot writes there, as lines of their SHA-256 and names.
// Each line is on the list before its file is written, so that an interrupted run has listed its
// own.
class FileLog {
 public:
    // `beginning` is the first line of such a list. Throws InputError for a folder that is a link
    // or no folder, and for a list that begins otherwise. A missing folder is an empty one.
    FileLog(std::filesystem::path folder, const std::string& name, std::string beginning);

    bool proves(const std::filesystem::path& file) const;

    // Throws as check_replaceable does unless nothing has this name, or the list proves it.
    void check(const std::string& name, std::string_view what) const;

    // Begins the list anew in the folder, with the files of the old one that are still as listed.
    // Throws EnvironmentError.
    void begin();
    // Appends a file that is about to be written. Precondition: begin().
    void add(const std::string& name, std::string_view contents);

 private:
    std::filesystem::path folder_, list_;
    std::string beginning_, lines_;
};

}  // namespace poinsot
