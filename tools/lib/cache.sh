# shellcheck shell=sh
# The cache: what is fetched once and shared by all clones of this repository.

if [ -z "${GA_GODOT_CACHE:-}" ] && [ -z "${XDG_CACHE_HOME:-}" ] && [ -z "${HOME:-}" ]; then
    fail "HOME is not set: set GA_GODOT_CACHE to a folder for the engine (about 700 MB)"
fi
cache=${GA_GODOT_CACHE:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/ga_godot}

# Takes the cache for this process and makes the folder of this run, `work`.
# The lock belongs to an open file, so it goes with the process that held it,
# and folders of other runs that are found under the lock are left-overs.
open_cache() {
    if [ -n "$work" ]; then
        return
    fi
    if ! mkdir -p "$cache" 2>/dev/null || [ ! -w "$cache" ]; then
        fail "cannot write to the cache folder $cache: set GA_GODOT_CACHE to a folder that you can write to"
    fi
    if command -v flock >/dev/null; then
        exec 9>"$cache/lock"
        if ! flock -n 9; then
            say "another setup is at work in $cache; waiting for it ..."
            flock 9
        fi
        rm -rf "$cache"/partial.*
    fi
    work=$cache/partial.$$
    if ! mkdir "$work" 2>/dev/null; then
        work=
        fail "cannot make a folder in $cache: the disk is full or read-only; free some space or set GA_GODOT_CACHE"
    fi
}

# Gives the cache back before this process becomes another program.
close_cache() {
    end_of_run
    exec 9>&-
}

# need_space MEGABYTES WHAT: fails before anything is fetched if the disk of the
# cache cannot hold it.
need_space() {
    free_megabytes=$(df -Pk "$cache" 2>/dev/null | awk 'NR == 2 { print int($4 / 1024) }')
    if [ -n "$free_megabytes" ] && [ "$free_megabytes" -lt "$1" ]; then
        fail "$2 needs $1 MB in $cache and the disk has $free_megabytes MB free: free some space or set GA_GODOT_CACHE to a folder on another disk"
    fi
}
