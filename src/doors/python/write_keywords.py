"""Writes the keywords of the Python package from the tables of options and of limits.

In a file of the package, the lines between "# keywords of VERB" and "# end" are replaced.
Usage: write_keywords.py PACKAGE FILE... [--check]: PACKAGE is the folder of the built package; with --check
nothing is written, and the exit code is 1 if a file would change.
"""

import pathlib
import re
import sys

TYPES = {"key": "Optional[str]", "number": "Optional[float]", "text": "Optional[str]", "flag": "bool", "whole": "int",
         "frames": "Union[None, Tuple[int, int], range]", "share": "Optional[Share]", "level": "Optional[int]"}
# Keys whose values have forms of their own in Python.
OWN_TYPES = {"size": "Optional[Size]", "fps": "Any"}


def lines_of(rows, indent):
    for name, kind, default in rows:
        if kind == "instant":
            continue  # the first argument
        of_type = OWN_TYPES.get(name) or ("str" if kind == "text" and default is not None else TYPES[kind])
        value = f'"{default}"' if isinstance(default, str) else repr(default)
        yield f"{indent}{name}: {of_type} = {value},\n"


def main():
    arguments = [one for one in sys.argv[1:] if one != "--check"]
    sys.path.insert(0, arguments[0])
    import _poinsot

    stale = []
    for name in arguments[1:]:
        file = pathlib.Path(name)
        text = file.read_text("utf-8")
        written = re.sub(r"( *)# keywords of (\w+)\n.*?( *# end\n)",
                         lambda found: f"{found[1]}# keywords of {found[2]}\n{''.join(lines_of(_poinsot.keywords(found[2]), found[1]))}{found[3]}",
                         text, flags=re.S)
        if written != text:
            stale.append(name)
            if "--check" not in sys.argv:
                file.write_text(written, "utf-8")
    if stale and "--check" in sys.argv:
        sys.exit(f"{', '.join(stale)}: the keywords are not those of the tables of options and limits; run `ninja -C build/release keywords`")


main()
