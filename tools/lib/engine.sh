# shellcheck shell=sh
# Chooses the Godot to use: GODOT, then one on PATH, then the one in the cache,
# which engine_fetch.sh downloads. Sets engine_path.

engine_minimum=4.6
engine_folder=$cache/engine-$(uname -m)
engine_cached=$engine_folder/usr/bin/godot

# The version that an executable reports, empty if it does not start.
engine_version() {
    "$1" --version 2>/dev/null </dev/null | tail -n 1
}

# is_good_version VERSION: 4.6 or a later 4.x.
is_good_version() {
    case $1 in
        4.[0-9]*.*)
            engine_minor=${1#4.}
            engine_minor=${engine_minor%%.*}
            case $engine_minor in
                *[!0-9]*) return 1 ;;
            esac
            [ "$engine_minor" -ge "${engine_minimum#4.}" ]
            ;;
        *) return 1 ;;
    esac
}

# Sets engine_path to an installed engine; returns 1 if there is none.
find_engine() {
    if [ -n "${GODOT:-}" ]; then
        find_given_engine
        return
    fi
    for engine_name in godot godot4; do
        engine_path=$(command -v "$engine_name") || continue
        # tools/ itself may be on PATH, and its `godot` calls this function.
        if [ "$(readlink -f "$engine_path")" != "$tools/godot" ] &&
            is_good_version "$(engine_version "$engine_path")"; then
            return
        fi
    done
    engine_path=$engine_cached
    [ -x "$engine_path" ] && is_good_version "$(engine_version "$engine_path")"
}

# If GODOT is set but unusable, setup fails instead of choosing another engine.
find_given_engine() {
    engine_path=$(command -v "$GODOT") ||
        fail "GODOT=$GODOT is not an executable: give the path of Godot $engine_minimum or newer, or unset GODOT"
    if [ "$(readlink -f "$engine_path")" = "$tools/godot" ]; then
        fail "GODOT=$GODOT is this project's own wrapper: give the path of Godot itself, or unset GODOT"
    fi
    engine_found=$(engine_version "$engine_path")
    is_good_version "$engine_found" ||
        fail "GODOT=$GODOT reports '${engine_found:-no version}': Godot $engine_minimum or newer (4.x) is needed; give its path, or unset GODOT"
}

# Environment variables with which the cache's engine finds its own graphics
# drivers. Values that the user has set stay; other engines need none.
set_engine_environment() {
    if [ "$engine_path" != "$engine_cached" ]; then
        return
    fi
    for engine_drivers in "$engine_folder"/usr/lib/*/dri; do
        export LIBGL_DRIVERS_PATH="${LIBGL_DRIVERS_PATH:-$engine_drivers}"
    done
    # A machine without fontconfig's settings (containers) uses those of the engine.
    if [ ! -e /etc/fonts/fonts.conf ]; then
        export FONTCONFIG_PATH="${FONTCONFIG_PATH:-$engine_folder/etc/fonts}"
    fi
    export __EGL_VENDOR_LIBRARY_DIRS="${__EGL_VENDOR_LIBRARY_DIRS:-$engine_folder/usr/share/glvnd/egl_vendor.d}"
    if [ -z "${VK_DRIVER_FILES:-}" ]; then
        for engine_driver in "$engine_folder"/usr/share/vulkan/icd.d/*.json; do
            VK_DRIVER_FILES=${VK_DRIVER_FILES:+$VK_DRIVER_FILES:}$engine_driver
        done
        export VK_DRIVER_FILES
    fi
}
