# shellcheck shell=sh
# The operating system's packages: which of them are missing, and getting them.

os_release=${GA_GODOT_OS_RELEASE:-/etc/os-release}
# The compiler as SConstruct takes it; may be several words.
compiler=${CXX:-g++}

# os_field NAME: a field of os-release, empty where there is none.
os_field() {
    if [ -r "$os_release" ]; then
        # shellcheck disable=SC1090
        (. "$os_release" && eval "printf '%s' \"\${$1:-}\"")
    fi
}

# The name for messages: "Debian GNU/Linux 12 (bookworm)", "Darwin".
os_name() {
    os_pretty_name=$(os_field PRETTY_NAME)
    printf '%s' "${os_pretty_name:-$(uname -s)}"
}

# True on Debian, Ubuntu and systems made from them.
has_apt() {
    case " $(os_field ID) $(os_field ID_LIKE) " in
        *' debian '* | *' ubuntu '*) command -v apt-get >/dev/null && command -v dpkg >/dev/null ;;
        *) return 1 ;;
    esac
}

has_header() {
    printf '#if !__has_include(<%s>)\n#error missing\n#endif\n' "$1" |
        $compiler -std=c++17 -E -x c++ - >/dev/null 2>&1
}

# missing_for PART: the packages that the part needs and this machine lacks, by
# Debian's names. It asks for the things themselves, not for packages: whoever
# has SCons from elsewhere is served.
missing_for() {
    case $1 in
        python)
            command -v python3 >/dev/null || echo python3
            ;;
        build)
            command -v python3 >/dev/null || echo python3
            command -v "${compiler%% *}" >/dev/null || echo "${compiler%% *}"
            command -v scons >/dev/null || echo scons
            has_header glm/glm.hpp || echo libglm-dev
            ;;
        unit)
            has_header doctest/doctest.h || echo doctest-dev
            ;;
        bench)
            has_header benchmark/benchmark.h || echo libbenchmark-dev
            ;;
        package)
            command -v cmake >/dev/null || echo cmake
            ;;
        display)
            command -v Xvfb >/dev/null || echo xvfb
            ;;
        graphics)
            /sbin/ldconfig -p 2>/dev/null | grep -q 'libGL\.so\.1' || echo libgl1 libgl1-mesa-dri
            ;;
        certificates)
            [ -e "$certificates" ] || echo ca-certificates
            ;;
        venv)
            python3 -c 'import ensurepip, venv' 2>/dev/null || echo python3-venv
            ;;
    esac
}

# Installs what the parts lack, in one go.
ensure_system_packages() {
    missing=$(for part in "$@"; do missing_for "$part"; done | sort -u | tr '\n' ' ')
    missing=${missing% }
    if [ -z "$missing" ]; then
        return
    fi
    if ! has_apt; then
        fail "missing here (Debian's names): $missing; setup installs them on Debian and Ubuntu only, on $(os_name) install their counterparts and run the same command again"
    fi
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        if ! sudo -n true 2>/dev/null; then
            fail "missing packages, and neither root nor sudo without a password to install them: run 'sudo apt-get install $missing', then the same command again"
        fi
        as_root='sudo -n'
    fi
    open_cache
    # Lists may be absent (containers) or old: then one update, and once more.
    if ! apt_can_install || ! step "installing $missing" apt_install; then
        step "reading the package lists" apt_update ||
            fail_step "the system's package lists cannot be read" "no network, or a package source of this system does not answer; run 'apt-get update' to see which"
        apt_can_install ||
            fail_step "packages missing and not in this system's sources: $missing" "install their counterparts by hand and run the same command again"
        step "installing $missing" apt_install ||
            fail_step "apt-get could not install $missing" "run 'apt-get install $missing' to see why"
    fi
    still_missing=$(for part in "$@"; do missing_for "$part"; done | sort -u | tr '\n' ' ')
    if [ -n "$still_missing" ]; then
        fail "installed, yet not usable: ${still_missing% }; check PATH and the compiler (g++)"
    fi
}

# An engine that is not the cache's draws with the system's own GL.
ensure_graphics() {
    ensure_engine
    if [ "$engine_path" != "$engine_cached" ]; then
        ensure_system_packages graphics
    fi
}

apt_can_install() {
    # shellcheck disable=SC2086
    apt-get install --simulate --no-install-recommends $missing >>"$work/log" 2>&1
}

apt_update() {
    # shellcheck disable=SC2086
    exec $as_root apt-get -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 -q update
}

apt_install() {
    # shellcheck disable=SC2086
    exec $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o Acquire::Retries=3 \
        -o DPkg::Lock::Timeout=300 -q -y --no-install-recommends install $missing
}
