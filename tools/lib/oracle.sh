# shellcheck shell=sh
# The Python environment of the oracle tests, with the packages that they pin.

oracle_requirements=$tools/../tests/oracle/requirements.txt

# Sets oracle_python to the environment's interpreter; makes the environment if
# it is not there. Its name holds what it was made from, so other pins or
# another Python get another one.
ensure_oracle() {
    if [ ! -r "$oracle_requirements" ]; then
        fail "tests/oracle/requirements.txt is missing: this checkout is not complete"
    fi
    ensure_system_packages python
    oracle_key=$({
        python3 -c 'import sys; print(sys.version, sys.prefix)'
        cat "$oracle_requirements"
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
    exec "$work/oracle/bin/python" -m pip install --disable-pip-version-check --no-input \
        --requirement "$oracle_requirements"
}
