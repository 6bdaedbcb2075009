# shellcheck shell=sh
# The API descriptions of several engine versions, which tests/versions reads: a
# package of Rust's registry, pinned in tests/versions/Cargo.toml.

apis_manifest=tests/versions/Cargo.toml

# Downloads the package if it is not in the cache and sets apis_path to the folder
# of the versions. The folder's name contains a hash of the pin.
ensure_apis() {
    if [ ! -r "$tools/../$apis_manifest" ]; then
        fail "$apis_manifest is missing: this checkout is not complete"
    fi
    apis_folder=$cache/apis-$(sha256sum <"$tools/../$apis_manifest" | cut -c 1-16)
    apis_path=$apis_folder/src
    if [ -d "$apis_path" ]; then
        return
    fi
    ensure_system_packages cargo
    open_cache
    if [ -d "$apis_path" ]; then
        return # another setup downloaded it while this one waited
    fi
    need_space 100 "the API descriptions of the engine"
    step "downloading the API descriptions of the engine" download_apis ||
        fail_step "cargo could not download what $apis_manifest names" "check the network, and run the same command again"
    rm -rf "$apis_folder"
    mv "$work/apis" "$apis_folder" || fail "cannot write $apis_folder: check who owns $cache"
}

# cargo keeps the archives of packages. One that is too old for the package's own
# manifest fails after the download, which does not matter; the hash decides.
download_apis() {
    mkdir -p "$work/manifest" "$work/apis" && cp "$tools/../$apis_manifest" "$work/manifest" && mkdir "$work/manifest/src" &&
        touch "$work/manifest/src/lib.rs" || return 1
    # Versions before 1.68, such as that of Debian 12, ask GitHub for the packages that there are, unless told to ask the registry.
    case $(cargo --version) in
        'cargo 1.6'[0-7].*) export RUSTC_BOOTSTRAP=1 CARGO_UNSTABLE_SPARSE_REGISTRY=true ;;
    esac
    cargo fetch --manifest-path "$work/manifest/Cargo.toml"
    apis_hash=$(sed -n 's/^sha256 = "\(.*\)"$/\1/p' "$work/manifest/Cargo.toml")
    for archive in "${CARGO_HOME:-$HOME/.cargo}"/registry/cache/*/gdextension-api-*.crate; do
        if echo "$apis_hash  $archive" | sha256sum --check --status; then
            tar -xzf "$archive" -C "$work/apis" --strip-components=1
            return
        fi
    done
    echo "no archive of cargo has the SHA-256 $apis_hash"
    return 1
}
