# shellcheck shell=sh
# Debian's Godot for arm64, with which the library for arm64 is tested under QEMU.

engine_arm64_folder=$cache/engine-arm64
engine_arm64_path=$engine_arm64_folder/godot

ensure_engine_arm64() {
    ensure_system_packages arm64 certificates
    if find_engine_arm64; then
        return
    fi
    if ! has_apt; then
        fail "Godot $engine_minimum for arm64 is missing: setup can fetch it on Debian only"
    fi
    open_cache
    if find_engine_arm64; then
        return # another setup fetched it while this one waited
    fi
    wanted_packages=godot # without drivers: it is not to draw
    wanted_architecture=arm64
    wanted_folder=$engine_arm64_folder
    wanted_setup=emulate_engine
    wanted_program=$engine_arm64_path
    sought="Godot $engine_minimum for arm64 is"
    engine_by_hand="test the library for arm64 on a Debian machine"
    from_first_suite fetch_if_offered
}

find_engine_arm64() {
    [ -x "$engine_arm64_path" ] && is_good_version "$(engine_version "$engine_arm64_path")"
}

# Writes the script that starts the engine in QEMU, which looks for each file in the
# engine's folder first, so that the engine finds its own loader and libraries.
emulate_engine() {
    ln -s usr/lib "$work/engine/lib" || return 1
    cat >"$work/engine/godot" <<'END'
#!/bin/sh
# Runs the engine of this folder in QEMU. An engine cannot start another one by
# OS.get_executable_path(): this system may not run programs for arm64.
folder=$(dirname "$(readlink -f "$0")")
qemu=$(command -v qemu-aarch64 || command -v qemu-aarch64-static)
# The processor of a Raspberry Pi 4. By default, QEMU emulates the signing of pointers,
# which takes most of its time.
exec "$qemu" -cpu cortex-a72 -L "$folder" "$folder/usr/bin/godot" "$@"
END
    chmod +x "$work/engine/godot"
}
