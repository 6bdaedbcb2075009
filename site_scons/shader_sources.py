"""Embeds the shader files, which src/playground/drawing/shader.cpp assembles into shaders."""

import os


def embed(target, source, env):
    """SCons action: writes a C++ source that holds each file as a string named like the file."""
    namespace = "playground::drawing::shader_sources"
    text = '#include "playground/drawing/shader_sources.hpp"\n\nnamespace {} {{\n\n'.format(namespace)
    for node in sorted(source, key=str):
        name = os.path.splitext(os.path.basename(str(node)))[0].upper()
        with open(str(node), encoding="utf-8") as file:
            text += 'const char *const {} = R"shader({})shader";\n\n'.format(name, file.read())
    with open(str(target[0]), "w", encoding="utf-8") as file:
        file.write(text + "}} // namespace {}\n".format(namespace))
