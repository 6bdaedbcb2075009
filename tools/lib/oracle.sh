# shellcheck shell=sh
# The Python environment of the oracle tests, with the packages that they pin.

oracle_requirements=$tools/../tests/oracle/requirements.txt
# Packages of which the tests use no part that needs the packages they ask for.
oracle_alone=$tools/../tests/oracle/requirements_alone.txt

# Sets oracle_python to the environment's interpreter; makes the environment if
# it is not there. Its name holds what it was made from, so other pins or
# another Python get another one.
ensure_oracle() {
    for oracle_list in "$oracle_requirements" "$oracle_alone"; do
        if [ ! -r "$oracle_list" ]; then
            fail "tests/oracle/${oracle_list##*/} is missing: this checkout is not complete"
        fi
    done
    ensure_system_packages python
    oracle_key=$({
        python3 -c 'import sys; print(sys.version, sys.prefix)'
        cat "$oracle_requirements" "$oracle_alone"
    } | sha256sum | cut -c 1-16)
    oracle_folder=$cache/oracle-$oracle_key
    oracle_python=$oracle_folder/bin/python
    if "$oracle_python" -c '' 2>/dev/null; then
        return
    fi
    ensure_system_packages venv
    open_cache
    if "$oracle_python" -c '' 2>/dev/null; then
        return # another setup made it while this one waited
    fi
    need_space 600 "the Python packages of the oracle tests"
    step "making a Python environment" python3 -m venv "$work/oracle" ||
        fail_step "python3 -m venv failed" "install python3-venv and run the same command again"
    step "installing the Python packages of the oracle tests" install_oracle_packages ||
        fail_step "pip could not install tests/oracle/requirements.txt" "check the network, and that Python is 3.11 or newer (this is $(python3 -V)), and run the same command again"
    rm -rf "$oracle_folder"
    mv "$work/oracle" "$oracle_folder" || fail "cannot write $oracle_folder: check who owns $cache"
}

install_oracle_packages() {
    oracle_pip --requirement "$oracle_requirements" &&
        oracle_pip --no-deps --requirement "$oracle_alone"
}

oracle_pip() {
    "$work/oracle/bin/python" -m pip install --disable-pip-version-check --no-input "$@"
}
