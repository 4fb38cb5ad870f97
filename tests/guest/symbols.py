#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the objects of a library must not have: variables of the whole program, and calls that
print, end the program, catch signals or look at the environment.

    tests/guest/symbols.py SOURCES LIBRARY.a ...

SOURCES is the folder of the library's sources, in which constants (kName) are looked up. Exit
status 1 if there is a symbol that is not allowed below.
"""

import pathlib
import re
import subprocess
import sys

# Sections of variables that may change. Those of constants with addresses (.data.rel.ro) are
# read-only once the program runs.
MUTABLE = re.compile(r"^\.(data|bss|tdata|tbss)(\.|$)(?!rel\.ro)")

# Symbols by regular expressions, with the reason why they are no state of the library.
ALLOWED_VARIABLES = {
    r"^guard variable for ": "they say that a constant was made",
    r"^std::__ioinit$": "an object of <iostream>, which headers of OpenMesh include",
    r"^DW\.ref\.": "addresses for exceptions",
    r"::(sag_samples|further_samples)\(\)::samples$": "tables that are made once and are const",
    r"::formula_field_variables(\[abi:cxx11\])?\(\)::variables$": "names, const",
    r"::(mesh_formats\(\)::formats|option_names\(\)::names)$": "tables, const",
    r"^OpenMesh::property_creator_registration_object_\d+$":
        "types of ours that OpenMesh's reader of .om files is to know",
    r"::Silence::(streams\(\)::streams|mutex\(\)::mutex)$":
        "OpenMesh's readers print to streams of the whole program, which are kept silent meanwhile",
    r"^opencascade::type_instance<.*>::get\(\)::anInstance$": "types of OpenCASCADE",
    r"^surfmesh::read_cad\(.*\)::one_at_a_time$": "OpenCASCADE reads one file at a time",
    r"^surfmesh::\(anonymous namespace\)::(is_left_out|is_in_shared_call|seconds_left_out|"
    r"seconds_of_others)$": "of the calls that a thread is in, or its clock: thread_local",
}

FORBIDDEN_CALLS = re.compile(
    r"^(exit|_exit|_Exit|quick_exit|abort|atexit|signal|sigaction|sigprocmask|pthread_sigmask|"
    r"raise|kill|v?printf|puts|putchar|perror|psignal|stdout|stderr|setlocale|chdir|setenv|putenv|"
    r"(secure_)?getenv|__assert_fail|srand|rand|umask|setrlimit|fesetround|fesetenv|feenableexcept|"
    r"alarm|setitimer|system|popen|fork|vfork|execv\w*|mallopt|fmt::v\d+::v?print\b.*|"
    r"std::(cout|cerr|clog|exit|abort|quick_exit|set_terminate|set_new_handler|"
    r"locale::global)\b.*|std::terminate\(\))$")

ALLOWED_CALLS = {
    r"^std::cout$": "a default argument in headers of OpenCASCADE",
    r"^std::terminate\(\)$": "where an exception leaves a destructor, by the compiler",
}


def is_const(name, sources):
    """A constant by its name, which every declaration in the sources calls so."""
    match = re.search(r"::(k[A-Z]\w*)(\[abi:cxx11\])?$", name)
    if not match:
        return False
    declared = re.compile(rf"^[^/\n]*[\w>\]] (?:\w+::)?{match[1]}(?:\[\w*\])* ?[={{(]", re.M)
    found = [line for text in sources for line in declared.findall(text)]
    return bool(found) and all(re.match(r" *(inline |static )*(const|constexpr) ", line)
                               for line in found)


def lines_of(*command):
    run = subprocess.run(command, check=True, capture_output=True, text=True)
    return run.stdout.splitlines()


def reason(name, allowed):
    return next((why for form, why in allowed.items() if re.search(form, name)), None)


def variables(library):
    """Of each object: names of symbols in sections that may change."""
    member = ""
    for line in lines_of("objdump", "-t", "-C", library):
        if line.endswith("file format elf64-x86-64") or ":     file format" in line:
            member = line.split(":")[0]
        # Address, seven flags, section, size, name.
        match = re.match(r"^[0-9a-f]+ (.{7}) (\S+)\s+[0-9a-f]+\s+(?:\.hidden )?(.*)$", line)
        if match and MUTABLE.match(match[2]) and match[1][6] in "O " and match[1][5] != "d":
            yield member, match[2], match[3]


def calls(library):
    member = ""
    for line in lines_of("nm", "-u", "-C", library):
        if line.endswith(":"):
            member = line[:-1]
        elif line.strip():
            yield member, line.split(None, 1)[1].split("@")[0]


def main():
    found, allowed = [], {}
    sources = [path.read_text(encoding="utf-8") for path in pathlib.Path(sys.argv[1]).rglob("*")
               if path.suffix in (".cc", ".hh")]
    for library in sys.argv[2:]:
        for member, section, name in variables(library):
            why = reason(name, ALLOWED_VARIABLES)
            why = "const in the sources" if is_const(name, sources) else why
            (allowed.setdefault(why, set()).add(name) if why
             else found.append(f"{member}: {name} in {section}"))
        for member, name in calls(library):
            if FORBIDDEN_CALLS.match(name):
                why = reason(name, ALLOWED_CALLS)
                if name == "std::cout" and "surfmesh_cad" not in library:
                    why = None
                (allowed.setdefault(why, set()).add(name) if why
                 else found.append(f"{member}: calls {name}"))
    for why, names in allowed.items():
        print(f"{len(names)} allowed, {why}: {', '.join(sorted(names)[:3])}")
    print("\n".join(found) or "nothing else")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
