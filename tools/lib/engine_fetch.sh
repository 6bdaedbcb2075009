# shellcheck shell=sh
# Downloads Godot into the cache from the distribution's newer suites. apt
# downloads and verifies the packages; they are unpacked into the cache with all
# libraries and their own loader, so the system stays unchanged and no root is
# needed.

# Packages unpacked with the engine: GL and Vulkan drivers, and the tool that
# points the executable at its own loader and libraries.
engine_packages='godot libgl1 libgl1-mesa-dri libegl1 libegl-mesa0 libglx-mesa0 libvulkan1 mesa-vulkan-drivers patchelf'

# The file from which Debian's engine reads the trusted certificates at each start.
certificates=${GA_GODOT_CERTIFICATES:-/etc/ssl/certs/ca-certificates.crt}

ensure_engine() {
    # What the functions below download, and for which architecture by dpkg's names,
    # empty for that of this machine; where it is unpacked, the function that prepares
    # it there, and what starts it; for messages, its name and how to do without it.
    wanted_packages=$engine_packages
    wanted_architecture=
    wanted_folder=$engine_folder
    wanted_setup=relocate_engine
    wanted_program=$engine_cached
    sought="Godot $engine_minimum is"
    engine_by_hand="install Godot $engine_minimum or newer yourself and give its path by GODOT="
    if find_engine; then
        if [ "$engine_path" = "$engine_cached" ]; then
            ensure_system_packages certificates
        fi
        return
    fi
    if ! has_apt; then
        fail "Godot $engine_minimum or newer is missing: setup can fetch it on Debian only; on $(os_name) install it and put it on PATH or give its path by GODOT="
    fi
    ensure_system_packages certificates
    open_cache
    if find_engine; then
        return # another setup fetched it while this one waited
    fi
    from_first_suite fetch_if_offered
}

# from_first_suite COMMAND: reads the package lists of the suites until COMMAND
# succeeds with one; fails if it does with none.
from_first_suite() {
    choose_suites
    find_site
    for suite in $suites; do
        if describe_source && "$1"; then
            return
        fi
    done
    explain_no_engine
}

fetch_if_offered() {
    resolve_engine && fetch_engine
}

# Fails with the reason in apt's output why no suite provided what is sought.
explain_no_engine() {
    if grep -q 'signatures\? \(were invalid\|couldn.t be verified\)\|NO_PUBKEY' "$work/log"; then
        fail_step "the signatures of the package suites ($suites) cannot be verified" "update this system's archive keyring, or $engine_by_hand"
    fi
    if grep -q 'is expired\|is not valid yet' "$work/log"; then
        fail_step "the package lists of $suites are out of date by this machine's clock" "set the clock (it says $(date +%F)) or use a current mirror, or $engine_by_hand"
    fi
    if [ -z "$suite_answered" ]; then
        fail_step "$sought missing and the package site does not respond" "connect to the network and run the same command again, or $engine_by_hand"
    fi
    fail_step "$sought missing, and this system's package site has no Godot $engine_minimum or newer (suites: $suites)" "$engine_by_hand"
}

# Sets the suites that may contain the engine, and their keyring.
choose_suites() {
    case " $(os_field ID) $(os_field ID_LIKE) " in
        *' ubuntu '*)
            origin=Ubuntu
            suites=devel
            components='main universe'
            ;;
        *)
            origin=Debian
            suites='forky sid'
            components=main
            ;;
    esac
    suite_answered=
    keyring=
    for keyring_file in /usr/share/keyrings/"$(echo $origin | tr DU du)"-archive-keyring.*; do
        if [ -r "$keyring_file" ]; then
            keyring="signed-by=$keyring_file"
            break
        fi
    done
}

# Sets site to the server of this system's packages. apt knows it only after it
# has read the package lists; if it never has, it reads them into our folder.
find_site() {
    site=$(list_sites | head -n 1)
    if [ -n "$site" ]; then
        return
    fi
    write_apt_settings "$(apt_folder Etc)/sources.list" "$(apt_folder Etc)/sources.list.d"
    step "reading the package lists" own_apt_get update ||
        fail_step "$sought missing and the package lists cannot be read" "connect to the network and run the same command again, or $engine_by_hand"
    site=$(list_sites -c "$work/apt.conf" | head -n 1)
    if [ -z "$site" ]; then
        fail_step "no package source of $origin is set up on this system" "add one to apt's sources, or $engine_by_hand"
    fi
}

list_sites() {
    # shellcheck disable=SC2016
    apt-get "$@" indextargets --format '$(SITE)' 'Created-By: Packages' "Origin: $origin" "Label: $origin" 2>>"$work/log"
}

apt_folder() {
    apt-config shell folder "Dir::$1/d" | sed "s/^folder='\(.*\)'\$/\1/"
}

# write_apt_settings LIST PARTS [ARCHITECTURE]: settings with which apt-get works in
# $work only, uses these sources, and sees no installed package. The system's hooks
# are cleared: they serve the system's own lists.
write_apt_settings() {
    mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
    : >"$work/apt/status"
    cat >"$work/apt.conf" <<END
Dir::State "$work/apt";
Dir::State::Lists "$work/apt/lists";
Dir::State::status "$work/apt/status";
Dir::Cache "$work/apt/cache";
Dir::Etc::SourceList "$1";
Dir::Etc::SourceParts "$2";
Dir::Etc::Preferences "/dev/null";
Dir::Etc::PreferencesParts "/dev/null";
APT::Sandbox::User "$(id -un)";
APT::Install-Recommends "false";
Acquire::Languages "none";
Acquire::Retries "3";
#clear APT::Update::Pre-Invoke;
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
END
    if [ -n "${3:-}" ]; then
        echo "APT::Architecture \"$3\"; APT::Architectures { \"$3\"; };" >>"$work/apt.conf"
    fi
}

own_apt_get() {
    exec apt-get -c "$work/apt.conf" -q "$@"
}

# Reads the suite's list of packages.
describe_source() {
    rm -rf "$work/apt"
    write_apt_settings "$work/sources.list" /dev/null "$wanted_architecture"
    echo "deb [arch=${wanted_architecture:-$(dpkg --print-architecture)} target=Packages $keyring] $site $suite $components" >"$work/sources.list"
    if step "reading the package list of $suite" own_apt_get update -o APT::Update::Error-Mode=any; then
        suite_answered=yes
    else
        return 1
    fi
}

# True if the suite has an engine that is new enough, and all its dependencies.
# Sets download_megabytes.
resolve_engine() {
    is_good_version "$(offered_version)" || return 1
    # shellcheck disable=SC2086
    (own_apt_get install --print-uris -y $wanted_packages) >"$work/uris" 2>>"$work/log" || return 1
    download_megabytes=$(awk '/^.(http|https|file|copy|mirror|cdrom|ftp)/ { bytes += $3 } END { print int(bytes / 1048576) + 1 }' "$work/uris")
}

# The version of the engine's package in the suite, such as 4.6.3+ds-2.
offered_version() {
    apt-cache -c "$work/apt.conf" policy godot | sed -n 's/^ *Candidate: *\([0-9]*:\)\?//p'
}

fetch_engine() {
    need_space $((download_megabytes * 5)) "the engine"
    percent_of_step=show_download
    # shellcheck disable=SC2086
    step "downloading Godot and its libraries from $suite ($download_megabytes MB)" \
        own_apt_get install -y --download-only $wanted_packages ||
        fail_step "the download of Godot failed" "check the network and run the same command again"
    percent_of_step=show_unpacked
    step "unpacking Godot" unpack_engine ||
        fail_step "Godot could not be unpacked" "run the same command again"
    percent_of_step=
    "$wanted_setup" >>"$work/log" 2>&1 ||
        fail_step "Godot could not be set up in $wanted_folder" "run the same command again, or $engine_by_hand"
    install_engine
}

show_download() {
    downloaded=$(du -sm "$work/apt/cache/archives" 2>/dev/null | cut -f 1)
    echo "$((${downloaded:-0} * 100 / download_megabytes))%"
}

show_unpacked() {
    set -- "$work"/apt/cache/archives/*.deb
    unpacked=$(wc -l <"$work/unpacked" 2>/dev/null)
    echo "$((${unpacked:-0} * 100 / $#))%"
}

unpack_engine() {
    for archive in "$work"/apt/cache/archives/*.deb; do
        dpkg -x "$archive" "$work/engine" || return 1
        echo "$archive" >>"$work/unpacked"
    done
    rm -rf "$work/apt" "$work/engine/usr/share/doc" "$work/engine/usr/share/locale"
}

# Makes the executable use its own loader and libraries, which will be in
# engine_folder. A few libraries contain other search paths, which are removed.
relocate_engine() {
    find_own_libraries "$work/engine"
    use_own_libraries "$work/engine/usr/bin/godot" || return 1
    for library in "$libraries"/libpulse*.so* "$libraries"/pulseaudio/*.so "$libraries"/libLLVM*.so*; do
        if [ -f "$library" ] && [ ! -L "$library" ]; then
            patch_elf --remove-rpath "$library" || return 1
        fi
    done
    for driver in "$work"/engine/usr/share/vulkan/icd.d/*.json; do
        sed -i "s|\"library_path\": *\"\([^\"]*/\)\?|\"library_path\": \"$final_libraries/|" "$driver" || return 1
    done
}

# find_own_libraries FOLDER: finds the loader and the libraries of the engine in
# FOLDER, and the path that they have in engine_folder.
find_own_libraries() {
    own_files=$1
    for loader in "$own_files"/usr/lib/*/ld-linux*.so.*; do
        libraries=$(dirname "$loader")
    done
    final_libraries=$engine_folder/usr/lib/$(basename "$libraries")
}

use_own_libraries() {
    patch_elf --set-interpreter "$final_libraries/$(basename "$loader")" --force-rpath \
        --set-rpath "$final_libraries:$final_libraries/pulseaudio" "$1"
}

# The unpacked patchelf runs with the unpacked loader, too.
patch_elf() {
    "$loader" --library-path "$libraries" "$own_files/usr/bin/patchelf" "$@"
}

# Replaces the engine's folder by renaming; an old one stays usable until then.
install_engine() {
    if [ -e "$wanted_folder" ]; then
        mv "$wanted_folder" "$work/replaced" || fail "cannot replace $wanted_folder: remove it and run the same command again"
    fi
    mv "$work/engine" "$wanted_folder" || fail "cannot write $wanted_folder: check who owns $cache"
    engine_path=$wanted_program
    engine_found=$(engine_version "$engine_path")
    if ! is_good_version "$engine_found"; then
        "$engine_path" --version >>"$work/log" 2>&1
        rm -rf "$wanted_folder"
        fail_step "the downloaded Godot does not start on this machine" "$engine_by_hand"
    fi
    say "Godot $engine_found is in $wanted_folder"
}
