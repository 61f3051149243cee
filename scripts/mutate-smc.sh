#!/usr/bin/env bash
# Shows that the statistical tests of resampling, importance resampling and the sequential sampler have power: tries one
# fault at a time (scripts/mutations-smc.txt), and demands that the test named beside it fails, after it has passed without.
#
# It works on a copy of the few packages that these tests need, below target/, where a changed one builds in seconds.
#
#   scripts/mutate-smc.sh            all faults
#   scripts/mutate-smc.sh PATTERN    faults whose line contains PATTERN
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD
copy=$root/target/mutated-smc
list=$root/scripts/mutations-smc.txt
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}
export CARGO_INCREMENTAL=1
pattern=${1:-}

rm -rf "$copy"
mkdir -p "$copy"
packages=(crates/probe crates/sampling crates/smc tests/statistics)
git ls-files -z --cached --others --exclude-standard Cargo.toml Cargo.lock "${packages[@]}" |
    while IFS= read -r -d '' file; do
        # With the time of now: cargo would take a file older than the last change's build for unchanged.
        [ ! -f "$file" ] || cp --parents "$file" "$copy"
    done
sed -i 's|^members = .*|members = ["crates/*", "tests/statistics"]|' "$copy/Cargo.toml"
cd "$copy"

# The workspace's lock file holds more than these packages need, and cargo takes the rest out. Nothing is downloaded that the
# workspace did not.
build() {
    cargo test --release --quiet --package "$package" --test "$1" --no-run >build.log 2>&1
}

failures=0
fail() {
    echo "FAILED $1"
    failures=$((failures + 1))
}

declare -A passed
tried=0
while IFS= read -r line; do
    [[ -n $line && $line != '#'* && $line == *"$pattern"* ]] || continue
    file=${line%% | *} rest=${line#* | }
    # The crate that the file belongs to: crates/smc/… is glimt-smc.
    package=${file#crates/} package=glimt-${package%%/*}
    test=${rest%% | *} rest=${rest#* | }
    filter=${rest%% | *} rest=${rest#* | }
    from=${rest% | *} to=${rest##* | }
    tried=$((tried + 1))
    run() { cargo test --release --quiet --package "$package" --test "$test" "$filter" >run.log 2>&1; }

    # Unchanged, there is such a test, and it passes.
    if [ -z "${passed[$package $test $filter]:-}" ]; then
        build "$test" || { cat build.log >&2; exit 1; }
        if ! run || ! grep -qE 'ok\. [1-9][0-9]* passed' run.log; then
            cat run.log >&2
            fail "$package: $test $filter: does not pass without a fault"
            passed[$package $test $filter]=no
            continue
        fi
        passed[$package $test $filter]=yes
    fi
    [ "${passed[$package $test $filter]}" = yes ] || continue

    text=$(cat "$file" && printf x)
    text=${text%x}
    if [[ $text != *"$from"* ]]; then
        fail "$file: there is no '$from'"
        continue
    fi
    printf %s "${text/"$from"/"$to"}" >"$file"
    if ! build "$test"; then
        cat build.log >&2
        fail "$file: does not build with '$to'"
    elif run; then
        fail "$file: '$from' → '$to' goes unseen by $test $filter"
    elif ! grep -q 'test result: FAILED' run.log; then
        cat run.log >&2
        fail "$file: '$from' → '$to' ends $test without a verdict"
    else
        echo "$file: $test $filter sees '$from' → '$to'"
    fi
    printf %s "$text" >"$file"
done <"$list"

[ "$failures" = 0 ] || {
    echo "$failures of $tried faults are not shown to be seen"
    exit 1
}
[ "$tried" -gt 0 ] || {
    echo "no fault matches '$pattern'"
    exit 1
}
echo "all $tried faults are seen"
