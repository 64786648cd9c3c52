#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks who includes whom: include_graph.py PROJECT_ROOT

src/CMakeLists.txt lists the rooms in order; a room may include only itself, the rooms above it, and the headers that
stand in include/slamicp/ itself. The core (every room but io) knows Eigen and the standard library, and reads no
clock, starts no thread, opens no file, prints nothing and draws no unseeded random number.
"""
import pathlib
import re
import sys

STANDARD_HEADERS = set("""
algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv chrono cinttypes climits
clocale cmath codecvt compare complex concepts condition_variable coroutine csetjmp csignal cstdarg cstddef cstdint
cstdio cstdlib cstring ctime cuchar cwchar cwctype deque exception execution filesystem format forward_list fstream
functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map memory
memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator semaphore
set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view syncstream
system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant vector
version""".split())

NOT_IN_CORE = {
    "iostream": "the core prints nothing", "syncstream": "the core prints nothing",
    "fstream": "files are io's", "filesystem": "files are io's",
    "chrono": "time comes in as stamps", "ctime": "time comes in as stamps",
    "thread": "threads come from the caller", "future": "threads come from the caller",
    "execution": "threads come from the caller",
    "random": "its distributions differ from library to library; use simulation/random.hpp",
}

# The one place that starts threads, as many as the caller grants.
MAY_START_THREADS = pathlib.PurePath("src/search/parallel.hpp")

# The one place that sees Highway: privately, its headers only.
VECTOR_CODE = pathlib.PurePath("src/registration/pass/vectors-inl.hpp")

# What a core file must not call, whatever it includes.
CALLS_NOT_IN_CORE = re.compile(
    r"\bstd::(?:cout|cerr|clog|rand|srand|time|clock|getenv|system|exit)\b"
    r"|(?<![\w.>])(?:printf|fprintf|puts|fputs|putchar|fopen|fwrite|rand|srand)\s*\(")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def rooms_of(root):
    """The core rooms, in order."""
    listed = re.search(r"set\(SLAMICP_CORE_ROOMS\s+([^)]*)\)", (root / "src/CMakeLists.txt").read_text())
    return listed.group(1).split()


def code_of(text):
    """The text without comments and string literals, line numbers kept."""
    return COMMENT_OR_TEXT.sub(lambda match: "\n" * match.group().count("\n"), text)


def line_of(text, match):
    return text.count("\n", 0, match.start()) + 1


class Checker:
    def __init__(self, root):
        self.root = root
        self.core = rooms_of(root)
        self.order = {room: place for place, room in enumerate([None] + self.core + ["io"])}
        self.faults = []

    def run(self):
        for top in ("include/slamicp", "src"):
            for file in sorted((self.root / top).rglob("*")):
                if file.suffix in (".hpp", ".cpp", ".h", ".inl"):
                    self.check(file, file.relative_to(self.root / top), public=top != "src")
        return self.faults

    def check(self, file, path, public):
        room = path.parts[0] if len(path.parts) > 1 else None
        text = file.read_text()

        def fault(match, words):
            self.faults.append(f"{file.relative_to(self.root)}:{line_of(text, match)}: {words}")

        if room not in self.order:
            self.faults.append(f"{file.relative_to(self.root)}:1: {room} is no room that src/CMakeLists.txt lists")
            return
        for match in INCLUDE.finditer(text):
            if match.group(2) == "thread" and file.relative_to(self.root) == MAY_START_THREADS:
                continue
            if match.group(2) == "hwy/highway.h" and file.relative_to(self.root) == VECTOR_CODE:
                continue
            for words in self.check_include(match.group(1) == '"', match.group(2), room, public):
                fault(match, words)
        if room != "io":
            code = code_of(text)
            for match in CALLS_NOT_IN_CORE.finditer(code):
                self.faults.append(f"{file.relative_to(self.root)}:{line_of(code, match)}: the core must not use "
                                   f"{match.group().rstrip('( ')}")

    def check_include(self, quoted, name, room, public):
        parts = name.split("/")
        if parts[0] == "slamicp":
            if not (self.root / "include" / name).is_file():
                yield f"{name} is no public header"
            yield from self.check_order(room, parts[1] if len(parts) > 2 else None)
        elif quoted or (len(parts) > 1 and parts[0] in self.order):
            if public:
                yield f'{name} is private; a public header includes <slamicp/...> only'
            elif not (self.root / "src" / name).is_file():
                yield f"{name} is no file of src/; write \"<room>/<name>\""
            else:
                yield from self.check_order(room, parts[0] if len(parts) > 1 else None)
        elif room != "io":
            if name in NOT_IN_CORE:
                yield f"<{name}> has no place in the core: {NOT_IN_CORE[name]}"
            elif name not in STANDARD_HEADERS and parts[0] != "Eigen":
                yield f"<{name}> is neither Eigen nor the standard library"

    def check_order(self, room, other):
        if other not in self.order:
            yield f"{other} is no room that src/CMakeLists.txt lists"
        elif self.order[other] > self.order[room]:
            yield f"{room or 'a header above all rooms'} must not include {other}, which stands below it"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    faults = Checker(pathlib.Path(sys.argv[1]).resolve()).run()
    print("\n".join(faults) or "the include graph keeps the order of the rooms")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
