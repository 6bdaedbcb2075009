# shellcheck shell=sh
# Python environments with pinned packages: for the oracle tests, the style suite,
# the plots, and libraries for other systems.

environment_root=$tools/..

# Packages in requirements_alone.txt are installed without their dependencies:
# the tests use no part of them that needs those.
ensure_oracle() {
    ensure_environment oracle "the oracle tests" tests/oracle/requirements.txt tests/oracle/requirements_alone.txt
}

ensure_style() {
    ensure_environment style "the style suite" tests/style/requirements.txt
}

ensure_plots() {
    ensure_environment plots "the plots" tools/lib/plot_requirements.txt
}

# The compiler for other systems, and what reads their libraries.
ensure_cross() {
    ensure_environment cross "libraries for other systems" tools/lib/cross_requirements.txt
}

# Sets zig_path.
ensure_zig() {
    ensure_cross
    zig_path=$("$environment_python" -c 'import os, ziglang; print(os.path.join(os.path.dirname(ziglang.__file__), "zig"))') ||
        fail "the environment in $environment_folder is damaged: remove it and run the same command again"
}

# ensure_environment NAME USERS REQUIREMENTS [ALONE]: creates the environment if
# it does not exist and sets environment_python to its interpreter. The folder's
# name contains a hash of the requirements and the Python version, so a change of
# either creates another environment.
ensure_environment() {
    environment_users=$2
    environment_requirements=$3
    environment_alone=${4:-}
    for environment_list in "$environment_requirements" $environment_alone; do
        if [ ! -r "$environment_root/$environment_list" ]; then
            fail "$environment_list is missing: this checkout is not complete"
        fi
    done
    ensure_system_packages python
    environment_key=$({
        python3 -c 'import sys; print(sys.version, sys.prefix)'
        cat "$environment_root/$environment_requirements" ${environment_alone:+"$environment_root/$environment_alone"}
    } | sha256sum | cut -c 1-16)
    environment_folder=$cache/$1-$environment_key
    environment_python=$environment_folder/bin/python
    if "$environment_python" -c '' 2>/dev/null; then
        return
    fi
    ensure_system_packages venv
    open_cache
    if "$environment_python" -c '' 2>/dev/null; then
        return # another setup created it while this one waited
    fi
    need_space 600 "the Python packages of $environment_users"
    step "creating a Python environment" python3 -m venv "$work/environment" ||
        fail_step "python3 -m venv failed" "install python3-venv and run the same command again"
    step "installing the Python packages of $environment_users" install_environment_packages ||
        fail_step "pip could not install $environment_requirements" "check the network, and that Python is 3.11 or newer (this is $(python3 -V)), and run the same command again"
    rm -rf "$environment_folder"
    mv "$work/environment" "$environment_folder" || fail "cannot write $environment_folder: check who owns $cache"
}

install_environment_packages() {
    environment_pip --requirement "$environment_root/$environment_requirements" &&
        { [ -z "$environment_alone" ] || environment_pip --no-deps --requirement "$environment_root/$environment_alone"; }
}

environment_pip() {
    "$work/environment/bin/python" -m pip install --disable-pip-version-check --no-input "$@"
}
