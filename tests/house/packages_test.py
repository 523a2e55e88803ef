"""Each library that CMake asks for is included by a source, and each package of .ci/packages has a use, as packages.toml says of what kind.

Usage: packages_test.py [REPOSITORY]
"""
import pathlib
import re
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
# Files that name packages without using them, and those that are made from others.
NO_USE = (".ci/packages", "tests/house/", "tests/golden/gallery/", "tests/golden/scenes/", "tests/golden/readme/", "docs/", "scenes/")
MOST_UNSEEN = 4  # of the packages whose use nothing names; this number only falls


def files_of(repository):
    """The text of each file of the repository that may use a package, without comments."""
    listed = subprocess.run(["git", "-C", repository, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    texts = {}
    for name in filter(None, listed.split("\0")):
        if name.startswith(NO_USE) or name.endswith((".md", ".ipynb", "package-lock.json")):
            continue
        try:
            text = (repository / name).read_text("utf-8")
        except (UnicodeDecodeError, FileNotFoundError, IsADirectoryError):
            continue
        marks = r"//" if name.endswith((".cpp", ".h", ".c", ".js")) else r"#"
        texts[name] = re.sub(rf"(^|\s){marks}(?!include).*", "", text, flags=re.MULTILINE)
    return texts


def asked_by_cmake(repository):
    """The names of the libraries that CMakeLists.txt asks for."""
    text = (repository / "CMakeLists.txt").read_text("utf-8")
    return re.findall(r"\bpoinsot_needs(?:_modules)?\((\w+)", text)


def listed_packages(repository):
    lines = (repository / ".ci/packages").read_text("utf-8").splitlines()
    return {line.split()[0] for line in lines if line and line[0] not in "#["}


def as_list(words):
    return [words] if isinstance(words, str) else words


def complaints(repository, table):
    texts = files_of(repository)
    sources = [text for name, text in texts.items() if name.startswith("src/") and name.endswith((".cpp", ".h"))]
    tests = [text for name, text in texts.items() if name.startswith("tests/") and name.endswith((".cpp", ".h", ".c"))]
    scripts = [text for name, text in texts.items() if name.endswith(".py")]

    def included(header, among):
        return any(re.search(rf"^#include <{re.escape(header)}", text, re.MULTILINE) for text in among)

    def named(word):
        return any(re.search(rf"(?<![\w.-]){re.escape(word)}(?![\w])", text) for text in texts.values())

    def imported(module):
        return any(re.search(rf"\b(import|from) {module}\b|importorskip\(\"{module}\b", text) for text in scripts)

    asked = asked_by_cmake(repository)
    for name in asked:
        for header in as_list(table["libraries"].get(name, [])):
            if not included(header, sources):
                yield f"CMakeLists.txt asks for {name}, and no source includes <{header}…>"
        if name not in table["libraries"]:
            yield f"CMakeLists.txt asks for {name}; say in packages.toml, [libraries], how its headers begin"
    for name in set(table["libraries"]) - set(asked):
        yield f"packages.toml, [libraries], has {name}, for which CMakeLists.txt does not ask"

    kinds = {"headers": lambda header: included(header, sources + tests), "modules": imported, "named": named}
    packages = listed_packages(repository)
    for package in sorted(packages):
        found = [kind for kind in [*kinds, "unseen"] if package in table[kind]]
        if len(found) != 1:
            yield f".ci/packages has {package}, which stands {len(found)} times in packages.toml: say once what shows its use"
        for kind in found:
            if kind != "unseen" and not any(kinds[kind](word) for word in as_list(table[kind][package])):
                yield f".ci/packages has {package}, and nothing uses it: {table[kind][package]}, [{kind}]"
    for package in {package for kind in [*kinds, "unseen"] for package in table[kind]} - packages:
        yield f"packages.toml has {package}, which .ci/packages does not have"
    if len(table["unseen"]) != MOST_UNSEEN:
        yield f"packages.toml, [unseen], has {len(table['unseen'])} packages in place of {MOST_UNSEEN}; MOST_UNSEEN may only fall"


def main():
    repository = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parent.parent).resolve()
    table = tomllib.loads((HERE / "packages.toml").read_text("utf-8"))
    found = list(complaints(repository, table))
    assert len(asked_by_cmake(repository)) > 10 and len(listed_packages(repository)) > 80
    # A library and a package that nothing uses are found.
    unused = table | {"libraries": table["libraries"] | {"glm": "no_such_header.h"}, "named": table["named"] | {"zsh": "no_such_program"}}
    seen = "\n".join(complaints(repository, unused))
    assert "asks for glm, and no source includes" in seen and "has zsh, and nothing uses it" in seen, seen
    sys.exit("\n".join(found) or 0)


main()
