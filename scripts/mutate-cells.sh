#!/usr/bin/env bash
# Shows that the statistical tests of `product` and `cells` have power: injects one fault at a time (scripts/mutations-cells.txt), and
# demands that the test named beside it fails, after it has passed without.
#
# All faults are built once, into a copy of the sources below target/; a variable of the environment chooses one.
#
#   scripts/mutate-cells.sh            all faults
#   scripts/mutate-cells.sh PATTERN    faults whose line contains PATTERN
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD
copy=$root/target/mutated-cells
list=$root/scripts/mutations-cells.txt
kernels=crates/render-gpu/src/kernels
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}
export CARGO_INCREMENTAL=0
pattern=${1:-}

rm -rf "$copy"
mkdir -p "$copy"
git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
    # With the time of now: cargo would take a file older than another build's for unchanged.
    [ ! -f "$file" ] || cp --parents "$file" "$copy"
done
# Another profile, so that what is built here is never taken for the workspace's own.
for package in glimt-ball glimt-probe glimt-sampling glimt-envmap-cdf glimt-brdf glimt-light-cells glimt-smc glimt-sh glimt-executor glimt-render-gpu \
    glimt-statistics naga-front-rust glimt glimt-tests; do
    printf '\n[profile.release.package.%s]\ncodegen-units = 8\n' "$package" >>"$copy/Cargo.toml"
done
cat >>"$copy/crates/render-gpu/src/lib.rs" <<'RUST'

/// Whether this fault is injected.
pub(crate) fn fault(number: u32) -> bool {
    static CHOSEN: std::sync::LazyLock<Option<u32>> =
        std::sync::LazyLock::new(|| std::env::var("GLIMT_FAULT").ok()?.parse().ok());
    *CHOSEN == Some(number)
}
RUST

failures=0
fail() {
    echo "FAILED $1"
    failures=$((failures + 1))
}

number=0
declare -a faults
while IFS= read -r line; do
    [[ -n $line && $line != '#'* ]] || continue
    number=$((number + 1))
    faults[number]=$line
    file=$kernels/${line%% | *} rest=${line#* | }
    rest=${rest#* | } rest=${rest#* | }
    from=${rest% | *} to=${rest##* | }
    text=$(cat "$copy/$file" && printf x)
    text=${text%x}
    after=${text#*"$from"}
    if [[ $after = "$text" || $after == *"$from"* ]]; then
        fail "$file: '$from' does not stand there once"
        continue
    fi
    printf %s "${text/"$from"/"(if crate::fault($number) { $to } else { $from })"}" >"$copy/$file"
done <"$list"

# The tests, built; the path of each.
(cd "$copy" && cargo test --release --locked --no-run -p glimt-tests --test groups --test cells_memory --message-format json-render-diagnostics 2>"$copy/build.log") >"$copy/built.json" || {
    cat "$copy/build.log" >&2
    exit 1
}
binary() {
    grep -o "\"executable\":\"[^\"]*/$1-[0-9a-f]*\"" "$copy/built.json" | cut -d'"' -f4
}

cd "$copy/tests"
for test in groups cells_memory; do
    if ! "$(binary "$test")" >"$copy/run.log" 2>&1; then
        cat "$copy/run.log" >&2
        fail "$test does not pass without a fault"
    fi
done
for number in "${!faults[@]}"; do
    line=${faults[number]}
    [[ $line == *"$pattern"* ]] || continue
    rest=${line#* | }
    test=${rest%% | *} rest=${rest#* | }
    filter=${rest%% | *}
    status=0
    GLIMT_FAULT=$number "$(binary "$test")" "$filter" >"$copy/run.log" 2>&1 || status=$?
    if [ $status = 0 ] || ! grep -q '^test .* FAILED$' "$copy/run.log"; then
        fail "$line: $test $filter does not notice"
    else
        echo "noticed: $line"
    fi
done

[ "$failures" = 0 ] || {
    echo "$failures faults are not noticed"
    exit 1
}
echo "every fault is noticed"
