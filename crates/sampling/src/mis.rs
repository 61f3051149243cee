//! Shared file: multiple importance sampling (Veach and Guibas 1995) of two strategies.
//!
//! Strategy f takes `n_f` samples of density `pdf_f`, strategy g takes `n_g` of density `pdf_g`; both densities are of
//! the *same* direction and in the same measure. An impossible sample has density 0, weight 0, and counts all the same.

/// Weight of a sample of strategy f by the balance heuristic: `n_f p_f / (n_f p_f + n_g p_g)` (Veach and Guibas 1995,
/// Eq. 10). 0 where both densities are 0.
///
/// ```
/// use glimt_sampling::mis::balance_heuristic;
/// assert_eq!(balance_heuristic(1, 3.0, 1, 1.0), 0.75);
/// assert_eq!(balance_heuristic(1, 3.0, 3, 1.0), 0.5);
/// assert_eq!(balance_heuristic(1, 0.0, 1, 0.0), 0.0);
/// ```
#[inline]
#[must_use]
pub fn balance_heuristic(n_f: u32, pdf_f: f32, n_g: u32, pdf_g: f32) -> f32 {
    let f = n_f as f32 * pdf_f;
    let sum = f + n_g as f32 * pdf_g;
    if sum > 0.0 { f / sum } else { 0.0 }
}

/// Weight of a sample of strategy f by the power heuristic with exponent 2: `(n_f p_f)² / ((n_f p_f)² + (n_g p_g)²)`
/// (Veach and Guibas 1995, Eq. 12 with β = 2). 0 where both densities are 0; no density is too large to square.
///
/// ```
/// use glimt_sampling::mis::power_heuristic;
/// assert_eq!(power_heuristic(1, 3.0, 1, 1.0), 0.9);
/// assert_eq!(power_heuristic(1, 2.0e30, 1, 2.0e30), 0.5);
/// assert_eq!(power_heuristic(1, 0.0, 1, 0.0), 0.0);
/// ```
#[inline]
#[must_use]
pub fn power_heuristic(n_f: u32, pdf_f: f32, n_g: u32, pdf_g: f32) -> f32 {
    let f = n_f as f32 * pdf_f;
    let g = n_g as f32 * pdf_g;
    if f > g {
        let ratio = g / f;
        return 1.0 / (1.0 + ratio * ratio);
    }
    if g > 0.0 {
        let ratio = f / g;
        return ratio * ratio / (1.0 + ratio * ratio);
    }
    0.0
}

/// What divides the integrand in the multi-sample estimator under the balance heuristic: `n_f p_f + n_g p_g`, so that
/// `F = Σ f(ω_i) / (n_f p_f(ω_i) + n_g p_g(ω_i))` over all `n_f + n_g` samples (Kronander 2014, Eq. 2).
///
/// Differs from the paper, whose print omits the counts.
///
/// ```
/// use glimt_sampling::mis::multi_sample_density;
/// assert_eq!(multi_sample_density(1, 0.5, 3, 2.0), 6.5);
/// ```
#[inline]
#[must_use]
pub fn multi_sample_density(n_f: u32, pdf_f: f32, n_g: u32, pdf_g: f32) -> f32 {
    n_f as f32 * pdf_f + n_g as f32 * pdf_g
}

/// Density of the one-sample estimator, which picks strategy f with probability `pmf_f` and g otherwise: `pmf_f p_f +
/// (1 − pmf_f) p_g`, so that `F = f(ω) / density` whichever was picked (Veach and Guibas 1995, Eq. 16 with the balance
/// heuristic).
///
/// ```
/// use glimt_sampling::mis::one_sample_density;
/// assert_eq!(one_sample_density(0.25, 4.0, 8.0), 7.0);
/// ```
#[inline]
#[must_use]
pub fn one_sample_density(pmf_f: f32, pdf_f: f32, pdf_g: f32) -> f32 {
    pmf_f * pdf_f + (1.0 - pmf_f) * pdf_g
}
