"""The packages with which the module of pages is built: .ci/packages, CMake and the message of a program without the module name the
same ones.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def text_of(file):
    return (ROOT / file).read_text("utf-8")


section = text_of(".ci/packages").split("\n[page]\n")[1].split("\n\n")[0]
named = {
    ".ci/packages": {line.split()[0] for line in section.splitlines()},
    "src/doors/web/pack/CMakeLists.txt": {name for parts in re.findall(r"foreach\(part (.*?)\)\n", text_of("src/doors/web/pack/CMakeLists.txt"), re.S)
                                for name in re.findall(r"=([\w+.-]+)", parts)},
}
message = re.search(r"void need_module.*?\n}", text_of("src/doors/web/pack/page_job.cpp"), re.S).group()
words = "".join(re.findall(r'"(.*)"', message))
named["src/doors/web/pack/page_job.cpp"] = set(re.split(r", | and ", re.search(r"or install (.*) and build", words).group(1)))
wanted = named[".ci/packages"]
# What the program needs, too, is there already.
of_film = {line.split()[0] for line in text_of(".ci/packages").split("[film]\n")[1].split("\n\n")[0].splitlines() if line[:1] not in ("", "#")}
named["src/doors/web/pack/CMakeLists.txt"] -= of_film
sys.exit("\n".join(f"{file}: without {sorted(wanted - names)}, with {sorted(names - wanted)}"
                   for file, names in named.items() if names != wanted) or None)
