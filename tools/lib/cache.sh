# shellcheck shell=sh
# The cache: downloads that all clones of this repository share.

if [ -z "${GA_GODOT_CACHE:-}" ] && [ -z "${XDG_CACHE_HOME:-}" ] && [ -z "${HOME:-}" ]; then
    fail "HOME is not set: set GA_GODOT_CACHE to a folder for the engine (about 700 MB)"
fi
cache=${GA_GODOT_CACHE:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/ga_godot}

# Locks the cache for this process and creates the folder of this run, `work`.
# The lock ends with the process that holds it, so folders of other runs found
# under the lock are leftovers.
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
            say "another setup is running in $cache; waiting for it ..."
            flock 9
        fi
        rm -rf "$cache"/partial.*
    fi
    work=$cache/partial.$$
    if ! mkdir "$work" 2>/dev/null; then
        work=
        fail "cannot create a folder in $cache: the disk is full or read-only; free some space or set GA_GODOT_CACHE"
    fi
}

# Unlocks the cache before this process executes another program.
close_cache() {
    end_of_run
    exec 9>&-
}

# need_space MEGABYTES WHAT: fails before the download if the disk of the cache
# has less free space.
need_space() {
    free_megabytes=$(df -Pk "$cache" 2>/dev/null | awk 'NR == 2 { print int($4 / 1024) }')
    if [ -n "$free_megabytes" ] && [ "$free_megabytes" -lt "$1" ]; then
        fail "$2 needs $1 MB in $cache and the disk has $free_megabytes MB free: free some space or set GA_GODOT_CACHE to a folder on another disk"
    fi
}
