"""The compiler's options for sources that are compiled for one instruction set, by the end of the file's name.

CMakeLists.txt has the same list, with the options of MSVC.
"""

X86_64 = {
    "_avx2.cpp": ["-mavx2"],
    "_avx2_fma.cpp": ["-mavx2", "-mfma", "-ffp-contract=fast"],
}
ANY = {
    "_scalar.cpp": ["-fno-tree-vectorize"],
}


def flags(source, arch):
    """What to add to the options that every source is compiled with."""
    suffixes = {**ANY, **(X86_64 if arch == "x86_64" else {})}
    return next((options for suffix, options in suffixes.items() if source.endswith(suffix)), [])
