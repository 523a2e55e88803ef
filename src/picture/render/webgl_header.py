"""Writes <glad/gl.h> for a page: the part of OpenGL ES 3.0 that the SOURCEs call, as imports from
src/doors/web/page/program.js, which calls WebGL. It stands in for the loader of the native program.

    webgl_header.py REGISTRY.xml HEADER SOURCE…

Constants and prototypes are those of Khronos's registry, which python3-glad brings along.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

HEAD = """#pragma once

#include <cstddef>
#include <cstdint>

using GLenum = unsigned;
using GLboolean = unsigned char;
using GLbitfield = unsigned;
using GLint = int;
using GLuint = unsigned;
using GLsizei = int;
using GLfloat = float;
using GLchar = char;
using GLubyte = unsigned char;
using GLsizeiptr = std::ptrdiff_t;

"""


def text_of(element):
    return " ".join("".join(element.itertext()).split())


def main(registry, header, *sources):
    used = set(re.findall(r"\b(?:gl[A-Z]|GL_)\w+", "".join(pathlib.Path(source).read_text("utf-8") for source in sources)))
    root = xml.etree.ElementTree.parse(registry).getroot()
    lines = [f"#define {enum.get('name')} {enum.get('value')}"
             for enum in root.iter("enum") if enum.get("name") in used and enum.get("value")]
    for command in root.find("commands"):
        name = command.findtext("proto/name")
        if name in used:
            parameters = ", ".join(text_of(parameter) for parameter in command.findall("param"))
            lines.append(f'extern "C" __attribute__((import_module("gl"), import_name("{name}"))) '
                         f"{text_of(command.find('proto'))}({parameters});")
    pathlib.Path(header).write_text(HEAD + "\n".join(lines) + "\n", "utf-8")


main(*sys.argv[1:])
