#!/usr/bin/env bash
# Runs lanes of commands in parallel, the commands of a lane one after the other:
#
#   tools/side_by_side.sh "TITLE: COMMAND" ["TITLE: COMMAND"…] [-- "TITLE: COMMAND"…]…
#
# Prints the output of lane after lane, as early as possible in this order, then the time of each command. After a
# failure the next command still runs; the exit status is 1 if any command failed.
set -euo pipefail
set -m # a process group for each lane, so that an end ends what it started

work=$(mktemp -d)
titles=()
lanes=()
end() {
    for lane in "${lanes[@]}"; do kill -- "-$lane" 2>/dev/null || true; done
    rm -rf "$work"
}
trap end EXIT
trap 'exit 143' TERM INT HUP

# run_lane FIRST COMMAND…: their output and exit status go to $work/NUMBER.log and .status, numbered from FIRST
run_lane() {
    local number=$1 status begin
    shift
    for command in "$@"; do
        status=0
        begin=$SECONDS
        bash -c "$command" </dev/null >"$work/$number.log" 2>&1 || status=$?
        echo "$status $((SECONDS - begin))" >"$work/$number.tmp"
        mv "$work/$number.tmp" "$work/$number.status"
        number=$((number + 1))
    done
}

start_lane() {
    [ ${#commands[@]} -gt 0 ] || return 0
    run_lane $((${#titles[@]} - ${#commands[@]})) "${commands[@]}" &
    lanes+=($!)
    commands=()
}

# show NUMBER: prints a log while it grows; a lane that ends without a status has failed
show() {
    local log=$work/$1.log status=$work/$1.status shown=0 size ended
    touch "$log"
    until [ -n "${ended:-}" ]; do
        if [ -e "$status" ] || ! any_runs; then ended=yes; else sleep 0.5; fi
        size=$(stat -c %s "$log")
        head -c "$size" "$log" | tail -c "+$((shown + 1))"
        shown=$size
    done
    [ -e "$status" ] || echo "1 0" >"$status"
}

any_runs() {
    for lane in "${lanes[@]}"; do
        if kill -0 "$lane" 2>/dev/null; then return 0; fi
    done
    return 1
}

commands=()
for argument in "$@"; do
    if [ "$argument" = -- ]; then
        start_lane
    else
        titles+=("${argument%%: *}")
        commands+=("${argument#*: }")
    fi
done
start_lane

failed=()
for number in "${!titles[@]}"; do
    echo "=== ${titles[$number]}"
    show "$number"
done
echo "=== All"
for number in "${!titles[@]}"; do
    read -r status seconds <"$work/$number.status"
    if [ "$status" = 0 ]; then outcome=passed; else outcome="FAILED ($status)"; failed+=("${titles[$number]}"); fi
    printf '%-30s %5d s  %s\n' "${titles[$number]}" "$seconds" "$outcome"
done
if [ ${#failed[@]} -gt 0 ]; then
    printf 'FAILED: %s\n' "${failed[@]}" >&2
    exit 1
fi
