# shellcheck shell=sh
# The operating system's packages: finds which are missing and installs them.

os_release=${GA_GODOT_OS_RELEASE:-/etc/os-release}
# The compiler that SConstruct uses; may be several words.
compiler=${CXX:-g++}

# os_field NAME: a field of os-release; empty if it does not exist.
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

# True on Debian, Ubuntu and their derivatives.
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

# True if clang tool NAME of version 19 or newer is on PATH, as NAME-19 or NAME.
# tools/lib/clang_tools.py finds it in the same way.
has_clang_tool() {
    if command -v "$1-19" >/dev/null; then
        return
    fi
    clang_major=$("$1" --version 2>/dev/null | sed -n 's/.* version \([0-9]*\)\..*/\1/p')
    [ "${clang_major:-0}" -ge 19 ]
}

# True if clang++-19 or clang++ can link a program of libFuzzer.
# tools/lib/fuzzing.py finds the compiler in the same way.
has_libfuzzer() {
    fuzz_compiler=clang++
    if command -v clang++-19 >/dev/null; then
        fuzz_compiler=clang++-19
    fi
    printf 'extern "C" int LLVMFuzzerTestOneInput(const char *, unsigned long) { return 0; }\n' |
        "$fuzz_compiler" -fsanitize=fuzzer,address,undefined -x c++ - -o /dev/null 2>/dev/null
}

# missing_for PART: Debian's names of the packages that the part needs and this
# machine lacks. It looks for programs and headers, not for packages, so a SCons
# installed by other means counts.
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
        clang)
            has_clang_tool clang-format || echo clang-format-19
            has_clang_tool clang-tidy || echo clang-tidy-19
            ;;
        lld)
            has_header glm/glm.hpp || echo libglm-dev
            command -v ld64.lld-19 >/dev/null || command -v ld64.lld >/dev/null || echo lld-19
            command -v llvm-lipo-19 >/dev/null || command -v llvm-lipo >/dev/null || echo llvm-19
            ;;
        wine)
            command -v wine64 >/dev/null || command -v wine >/dev/null || [ -x /usr/lib/wine/wine64 ] || echo wine64
            ;;
        fuzz)
            has_libfuzzer || echo clang-19 libclang-rt-19-dev llvm-19 # llvm-19 has the symbolizer
            ;;
        ccache)
            command -v ccache >/dev/null || echo ccache
            ;;
        cargo)
            command -v cargo >/dev/null || echo cargo
            ;;
        bench)
            has_header benchmark/benchmark.h || echo libbenchmark-dev
            ;;
        arm64)
            command -v aarch64-linux-gnu-g++ >/dev/null || echo g++-aarch64-linux-gnu
            command -v qemu-aarch64 >/dev/null || command -v qemu-aarch64-static >/dev/null || echo qemu-user-static
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

# Installs the missing packages of the parts in one step.
ensure_system_packages() {
    missing=$(for part in "$@"; do missing_for "$part"; done | sort -u | tr '\n' ' ')
    missing=${missing% }
    if [ -z "$missing" ]; then
        return
    fi
    if ! has_apt; then
        fail "missing packages (Debian's names): $missing; setup installs packages on Debian and Ubuntu only, so install their equivalents on $(os_name) and run the same command again"
    fi
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        if ! sudo -n true 2>/dev/null; then
            fail "missing packages, and neither root nor passwordless sudo to install them: run 'sudo apt-get install $missing', then the same command again"
        fi
        as_root='sudo -n'
    fi
    open_cache
    # Package lists may be absent (containers) or outdated: update them once and retry.
    if ! apt_can_install || ! step "installing $missing" apt_install; then
        step "reading the package lists" apt_update ||
            fail_step "the system's package lists cannot be read" "no network, or a package source of this system does not respond; run 'apt-get update' to see which"
        apt_can_install ||
            fail_step "packages missing and not in this system's sources: $missing" "install their equivalents manually and run the same command again"
        step "installing $missing" apt_install ||
            fail_step "apt-get could not install $missing" "run 'apt-get install $missing' to see why"
    fi
    still_missing=$(for part in "$@"; do missing_for "$part"; done | sort -u | tr '\n' ' ')
    if [ -n "$still_missing" ]; then
        fail "installed but not usable: ${still_missing% }; check PATH and the compiler (g++)"
    fi
}

# An engine from outside the cache uses the system's OpenGL.
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
