//! Host file: the four resampling schemes: means, variances, bounds, streams.

use glimt_sampling::resample::{Scheme, ancestors_into, skip, words};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_statistics::stats::{Mean, Verdict, sidak, z_test};

const SCHEMES: [Scheme; 4] = [
    Scheme::Systematic,
    Scheme::Stratified,
    Scheme::Multinomial,
    Scheme::Residual,
];

/// Weights with the number of picks. Expected copies are small and large, whole and fractional; weights are 0 at both ends and
/// between, and there are more and fewer of them than picks.
const CASES: [(&[f32], usize); 6] = [
    (&[1.0, 2.0, 3.0, 4.0], 4),
    (&[0.0, 0.125, 0.0, 0.25, 0.875, 0.0, 0.0], 5),
    (&[0.3], 7),
    (&[5.0, 0.2, 0.3, 0.5, 0.1, 0.15, 0.25, 0.05], 8),
    (&[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0], 3),
    (&[2e-6, 5e-6, 1e-6, 0.0, 3e-6], 64),
];

fn expected(weights: &[f32], n: usize) -> Vec<f64> {
    let total: f64 = weights.iter().map(|w| f64::from(*w)).sum();
    let copies = |w: &f32| f64::from(*w) / total * n as f64;
    weights.iter().map(copies).collect()
}

fn copies<U: UniformSource>(scheme: Scheme, weights: &[f32], n: usize, source: &mut U) -> Vec<u32> {
    let mut ancestors = vec![u32::MAX; n];
    assert!(ancestors_into(scheme, weights, &mut ancestors, source));
    assert!(ancestors.is_sorted());
    let mut copies = vec![0; weights.len()];
    for a in ancestors {
        copies[a as usize] += 1;
    }
    copies
}

/// Many independent resamplings of a case.
fn runs(scheme: Scheme, case: usize) -> Vec<Vec<u32>> {
    let (weights, n) = CASES[case];
    let stream = |i| Xoshiro128PlusPlus::stream(3, case as u32, i);
    (0..20_000)
        .map(|i| copies(scheme, weights, n, &mut stream(i)))
        .collect()
}

/// Share of the comb's stratum `s` that item `i` covers: where expected copies run from one whole number to the next.
fn overlap(expected: &[f64], i: usize, s: usize) -> f64 {
    let begin: f64 = expected[..i].iter().sum();
    let end = begin + expected[i];
    (end.min(s as f64 + 1.0) - begin.max(s as f64)).max(0.0)
}

/// Covariance of the copies of two items, where the scheme has a closed form: picks that are independent of each other.
fn covariance(scheme: Scheme, e: &[f64], n: usize, i: usize, j: usize) -> Option<f64> {
    let picks = |shares: Vec<(f64, f64)>| {
        let one = |(a, b): (f64, f64)| if i == j { a * (1.0 - a) } else { -a * b };
        shares.into_iter().map(one).sum::<f64>()
    };
    let whole = |x: f64| (x + 1e-9).floor();
    match scheme {
        Scheme::Systematic => {
            let rest = e[i] - whole(e[i]);
            (i == j).then_some(rest * (1.0 - rest))
        }
        Scheme::Stratified => Some(picks(
            (0..n)
                .map(|s| (overlap(e, i, s), overlap(e, j, s)))
                .collect(),
        )),
        Scheme::Multinomial => {
            let n = n as f64;
            Some(picks(vec![(e[i] / n, e[j] / n); n as usize]))
        }
        Scheme::Residual => {
            let rest = |k: usize| e[k] - whole(e[k]);
            let teeth: f64 = (0..e.len()).map(rest).sum::<f64>().round();
            let share = |k| if teeth > 0.0 { rest(k) / teeth } else { 0.0 };
            Some(picks(vec![(share(i), share(j)); teeth as usize]))
        }
    }
}

fn near_or_z(mean: Mean, value: f64, alpha: f64) -> Verdict {
    // Where every run gives the same, the value is known to rounding only.
    let value = if mean.standard_error == 0.0 && (mean.mean - value).abs() < 1e-6 {
        mean.mean
    } else {
        value
    };
    z_test(mean, value, alpha)
}

/// Means, variances and covariances of all schemes are those of theory.
#[test]
fn copies_have_the_moments_of_theory() {
    let alpha = sidak(0.01, 1000);
    let mut tests = 0;
    for scheme in SCHEMES {
        for case in 0..CASES.len() {
            let (weights, n) = CASES[case];
            let e = expected(weights, n);
            let runs = runs(scheme, case);
            let check = |value: f64, what: String, f: &dyn Fn(&[u32]) -> f64| {
                let mean = Mean::of(runs.iter().map(|copies| f(copies)));
                if let Err(evidence) = near_or_z(mean, value, alpha) {
                    panic!("{scheme:?}, case {case}, {what}: {evidence}");
                }
            };
            for i in 0..e.len() {
                check(e[i], format!("mean of {i}"), &|c| f64::from(c[i]));
                tests += 1;
                for j in 0..=i {
                    let product = |c: &[u32]| (f64::from(c[i]) - e[i]) * (f64::from(c[j]) - e[j]);
                    if let Some(value) = covariance(scheme, &e, n, i, j) {
                        check(value, format!("covariance of {i} and {j}"), &product);
                        tests += 1;
                    }
                }
            }
        }
    }
    assert!(
        (500..=1000).contains(&tests),
        "{tests} tests share the level"
    );
}

/// Douc, Cappé, Moulines 2005: a count cannot vary less than under systematic resampling; residual and stratified picks vary
/// less than independent ones.
#[test]
fn variances_are_ordered() {
    let mut strict = [0; 3];
    for case in 0..CASES.len() {
        let (weights, n) = CASES[case];
        let e = expected(weights, n);
        let [systematic, stratified, multinomial, residual] = SCHEMES.map(|scheme| {
            let runs = runs(scheme, case);
            let variance = |i: usize| {
                let squares = runs.iter().map(|c| (f64::from(c[i]) - e[i]).powi(2));
                Mean::of(squares)
            };
            (0..e.len()).map(variance).collect::<Vec<_>>()
        });
        for i in 0..e.len() {
            let pairs = [
                (systematic[i], stratified[i]),
                (stratified[i], multinomial[i]),
                (residual[i], multinomial[i]),
            ];
            for (pair, (less, more)) in pairs.into_iter().enumerate() {
                let error = less.standard_error.hypot(more.standard_error);
                let excess = less.mean - more.mean;
                assert!(
                    excess <= 5.0 * error + 1e-12,
                    "case {case}, item {i}, pair {pair}: {less:?} {more:?}"
                );
                strict[pair] += u32::from(-excess > 5.0 * error);
            }
        }
    }
    // The order is seen, not only not contradicted.
    assert!(strict.iter().all(|s| *s >= 5), "{strict:?}");
}

#[test]
fn copies_keep_their_bounds() {
    for scheme in SCHEMES {
        for case in 0..CASES.len() {
            let (weights, n) = CASES[case];
            let e = expected(weights, n);
            for copies in runs(scheme, case) {
                assert_eq!(copies.iter().sum::<u32>() as usize, n);
                for (e, c) in e.iter().zip(copies) {
                    let c = f64::from(c);
                    let (floor, ceil) = ((e - 1e-5).floor().max(0.0), (e + 1e-5).ceil());
                    let fine = match scheme {
                        Scheme::Systematic => floor <= c && c <= ceil,
                        Scheme::Residual => floor <= c,
                        Scheme::Stratified => floor - 1.0 <= c && c <= ceil + 1.0,
                        Scheme::Multinomial => true,
                    };
                    assert!(fine && (*e > 0.0 || c == 0.0), "{scheme:?} {case}: {e} {c}");
                }
            }
        }
    }
}

/// Words of a list, and how many were drawn.
struct Counting<'a> {
    words: &'a [u32],
    drawn: usize,
}

impl UniformSource for Counting<'_> {
    fn next_u32(&mut self) -> u32 {
        let word = self.words[self.drawn % self.words.len()];
        self.drawn += 1;
        word
    }
}

#[test]
fn a_resampling_draws_the_same_number_of_words_whatever_the_weights() {
    let edges: [&[u32]; 5] = [
        &[0],
        &[u32::MAX],
        &[0, u32::MAX],
        &[u32::MAX, 0, 1 << 31],
        &[0x1234_5678, 0x9abc_def0, 0x0fed_cba9],
    ];
    for scheme in SCHEMES {
        for words_of in edges {
            let source = || Counting {
                words: words_of,
                drawn: 0,
            };
            for (weights, n) in CASES {
                let mut drawing = source();
                let copies = copies(scheme, weights, n, &mut drawing);
                assert_eq!(drawing.drawn, words(scheme, n as u32) as usize);
                for (w, c) in weights.iter().zip(copies) {
                    assert!(*w > 0.0 || c == 0, "{scheme:?} {words_of:?} {weights:?}");
                }
                let mut skipping = source();
                skip(scheme, n as u32, &mut skipping);
                assert_eq!(skipping.drawn, drawing.drawn);
                let mut black = source();
                let mut untouched = vec![7; n];
                assert!(!ancestors_into(
                    scheme,
                    &[0.0; 3],
                    &mut untouched,
                    &mut black
                ));
                assert_eq!((black.drawn, untouched), (drawing.drawn, vec![7; n]));
            }
        }
    }
}

/// Weights have no unit: neither sums that overflow nor weights below the smallest normal number change a pick.
#[test]
fn the_scale_of_the_weights_does_not_matter() {
    let weights = [3.0f32, 0.0, 0.5, 1.25, 2.0, 0.75];
    for scheme in SCHEMES {
        for key in 0..200 {
            let run = |power: i32| {
                let scale = |w: f32| (f64::from(w) * 2f64.powi(power)) as f32;
                let mut source = Xoshiro128PlusPlus::stream(5, 0, key);
                copies(scheme, &weights.map(scale), 9, &mut source)
            };
            let base = run(0);
            for power in [-140, -130, -100, 100, 126] {
                assert_eq!(run(power), base, "{scheme:?} 2^{power}");
            }
        }
    }
}
