# shellcheck shell=sh
# Godot's export templates for this system: those that the engine's user has
# installed, or for the engine in the cache, packages of the same distribution.

templates_cached=$cache/templates-$(uname -m)
templates_installed=${XDG_DATA_HOME:-${HOME:-}/.local/share}/godot/export_templates
case $(uname -m) in
    aarch64) templates_arch=arm64 ;;
    *) templates_arch=$(uname -m) ;;
esac

# Sets templates_path to a folder with linux_debug.ARCH and linux_release.ARCH,
# which fit the engine.
ensure_templates() {
    ensure_engine
    if find_templates; then
        return
    fi
    if [ "$engine_path" != "$engine_cached" ]; then
        fail "the export templates of Godot $(short_version "$engine_path") are missing: install them with Editor > Manage Export Templates in $engine_path"
    fi
    sought="the export templates are"
    open_cache
    if find_templates; then
        return # another setup fetched them while this one waited
    fi
    from_first_suite download_templates
    install_templates
}

find_templates() {
    templates_wanted=$(short_version "$engine_path")
    for templates_path in "$templates_installed/$templates_wanted" "$templates_cached"; do
        if [ "$(short_version "$templates_path/linux_debug.$templates_arch")" = "$templates_wanted" ] &&
            [ "$(short_version "$templates_path/linux_release.$templates_arch")" = "$templates_wanted" ]; then
            return
        fi
    done
    return 1
}

# short_version EXECUTABLE: number and status, such as 4.6.3.stable, which are the
# name of the folder in which Godot looks for templates.
short_version() {
    engine_version "$1" | sed 's/^\([0-9.]*\.[a-z]*[0-9]*\).*/\1/'
}

# If the suite has moved to another version than that of the engine in the cache,
# both are downloaded.
download_templates() {
    resolve_engine || return 1
    need_space 250 "the export templates"
    mkdir -p "$work/templates"
    step "downloading the export templates from $suite" fetch_template_packages || return 1
    case $(engine_version "$engine_path") in
        "$(offered_version | sed 's/[+-].*//')".*) ;;
        *) fetch_engine ;;
    esac
}

fetch_template_packages() {
    cd "$work/templates" && own_apt_get download godot-template-debug godot-template-release
}

install_templates() {
    step "unpacking the export templates" unpack_templates ||
        fail_step "the export templates could not be unpacked" "run the same command again"
    rm -rf "$templates_cached"
    mv "$work/templates" "$templates_cached" || fail "cannot write $templates_cached: check who owns $cache"
    find_templates ||
        fail_step "the downloaded export templates do not start on this machine" "install those of Godot and give its path by GODOT="
}

unpack_templates() {
    for archive in "$work"/templates/*.deb; do
        dpkg -x "$archive" "$work/templates" || return 1
    done
    find_own_libraries "$engine_folder"
    for kind in debug release; do
        mv "$work/templates/usr/bin/godot-template-$kind" "$work/templates/linux_$kind.$templates_arch" || return 1
        use_own_libraries "$work/templates/linux_$kind.$templates_arch" || return 1
    done
    rm -rf "$work"/templates/*.deb "$work/templates/usr"
}
