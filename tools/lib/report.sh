# shellcheck shell=sh
# Setup's output: one line for each step and one line for a failure, on stderr,
# because stdout is for the result of `setup --print`.
#
# The caller sets `cache` (see cache.sh). `work` is the folder of this run; it is
# always removed, so an interrupted run leaves nothing behind.

work=
child=
clear_line=

say() {
    printf '%ssetup: %s\n' "$clear_line" "$*" >&2
}

fail() {
    say "$*"
    exit 1
}

# Ends the command of a running step and removes the folder of this run.
end_of_run() {
    if [ -n "$child" ]; then
        kill "$child" 2>/dev/null
        wait "$child" 2>/dev/null
    fi
    if [ -n "$work" ]; then
        rm -rf "$work"
    fi
}

trap end_of_run EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# step MESSAGE COMMAND...: runs the command with its output in $work/log and
# shows progress: a spinner and the seconds in a terminal, a line every 10 s
# elsewhere. If `percent_of_step` names a function, shows its output too.
step() {
    step_message=$1
    shift
    step_started=$(date +%s)
    step_reported=0
    # shellcheck disable=SC1003
    step_signs='|/-\'
    # 9 is the lock of the cache: a child that outlives this process must not hold it.
    "$@" >>"$work/log" 2>&1 </dev/null 9>&- &
    child=$!
    if [ ! -t 2 ]; then
        say "$step_message ..."
    fi
    while kill -0 "$child" 2>/dev/null; do
        show_step
        sleep 0.2
    done
    wait "$child"
    step_status=$?
    child=
    if [ -t 2 ]; then
        say "$step_message: $(($(date +%s) - step_started)) s"
        clear_line=
    fi
    return "$step_status"
}

show_step() {
    step_seconds=$(($(date +%s) - step_started))
    if [ -t 2 ]; then
        step_sign=${step_signs%"${step_signs#?}"}
        step_signs=${step_signs#?}$step_sign
        printf '\r\033[Ksetup: %s %s %s s %s' "$step_sign" "$step_message" "$step_seconds" \
            "$(${percent_of_step:-:})" >&2
        clear_line=$(printf '\r\033[K')
    elif [ $((step_seconds - step_reported)) -ge 10 ]; then
        step_reported=$step_seconds
        say "$step_message ... $step_seconds s $(${percent_of_step:-:})"
    fi
}

# fail_step WHAT HOW: fails with one line for a failed step. A full disk and a
# missing network are reported as the cause whatever the step was; the whole
# output stays in setup.log in the cache.
fail_step() {
    if grep -qi 'no space left on device\|enough free space' "$work/log" 2>/dev/null; then
        fail "$1: the disk is full; free some space and run the same command again"
    fi
    step_remedy=$2
    case $step_remedy in
        *network*) ;;
        *)
            if grep -qi 'temporary failure\|could not resolve\|could not connect\|network is unreachable\|no route to host' "$work/log" 2>/dev/null; then
                step_remedy="no network; connect and run the same command again"
            fi
            ;;
    esac
    if cp "$work/log" "$cache/setup.log" 2>/dev/null; then
        step_remedy="$step_remedy (details: $cache/setup.log)"
    fi
    fail "$1: $step_remedy"
}
