# shellcheck shell=sh
# The API descriptions of several engine versions, which tests/versions reads: a
# package of Rust's registry, pinned in tests/versions/Cargo.lock.

apis_manifest=tests/versions/Cargo.toml

# Downloads the package if it is not in the cache and sets apis_path to the folder
# of the versions. The folder's name contains a hash of the pin.
ensure_apis() {
    apis_lock=$tools/../tests/versions/Cargo.lock
    if [ ! -r "$apis_lock" ]; then
        fail "tests/versions/Cargo.lock is missing: this checkout is not complete"
    fi
    apis_folder=$cache/apis-$(sha256sum <"$apis_lock" | cut -c 1-16)
    apis_path=$apis_folder/gdextension-api/src
    if [ -d "$apis_path" ]; then
        return
    fi
    ensure_system_packages cargo
    open_cache
    if [ -d "$apis_path" ]; then
        return # another setup downloaded it while this one waited
    fi
    need_space 100 "the API descriptions of the engine"
    step "downloading the API descriptions of the engine" \
        cargo vendor --locked --manifest-path "$tools/../$apis_manifest" "$work/apis" ||
        fail_step "cargo could not download what $apis_manifest names" "check the network, and that cargo is 1.68 or newer, and run the same command again"
    rm -rf "$apis_folder"
    mv "$work/apis" "$apis_folder" || fail "cannot write $apis_folder: check who owns $cache"
}
