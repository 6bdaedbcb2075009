# shellcheck shell=sh
# --help works before anything is installed: it shows the Python program's help
# or, without Python, the program's docstring.

# help_if_asked PROGRAM ARGUMENTS...: shows the help and exits if the arguments contain --help.
help_if_asked() {
    help_program=$1
    shift
    for help_argument in "$@"; do
        case $help_argument in
            -h | --help)
                if command -v python3 >/dev/null; then
                    exec python3 "$help_program" --help
                fi
                sed -n '/^"""/,/"""$/{s/"""//g;p;}' "$help_program" | sed '/^$/N;/\n$/D'
                exit
                ;;
        esac
    done
}
