//! Shared file: operators on one's own types.

use super::input::{float, uint};
use core::ops::{Add, AddAssign, BitXor, Div, Mul, Neg, Not, Sub};

#[derive(Clone, Copy)]
struct Complex {
    re: f32,
    im: f32,
}

impl Add for Complex {
    type Output = Complex;

    fn add(self, other: Complex) -> Complex {
        Complex {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Complex {
    type Output = Complex;

    fn mul(self, other: Complex) -> Complex {
        Complex {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl Mul<f32> for Complex {
    type Output = Complex;

    fn mul(self, scale: f32) -> Complex {
        Complex {
            re: self.re * scale,
            im: self.im * scale,
        }
    }
}

impl Mul<Complex> for f32 {
    type Output = Complex;

    fn mul(self, other: Complex) -> Complex {
        other * self
    }
}

impl Div<f32> for Complex {
    type Output = Complex;

    fn div(self, by: f32) -> Complex {
        self * (1.0 / by)
    }
}

impl Neg for Complex {
    type Output = Complex;

    fn neg(self) -> Complex {
        Complex {
            re: -self.re,
            im: -self.im,
        }
    }
}

impl AddAssign for Complex {
    fn add_assign(&mut self, other: Complex) {
        self.re += other.re;
        self.im += other.im;
    }
}

/// All the operators of a complex number.
pub fn complex(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 4] {
    let a = Complex {
        re: float(id, floats, 0),
        im: float(id, floats, 1),
    };
    let b = Complex {
        re: float(id, floats, 2),
        im: 0.5,
    };
    let mut c = (a * b - b) * 0.5 + 2.0 * a / 4.0;
    c += -b;
    let d = c * Complex { re: 0.0, im: 1.0 };
    [c.re, c.im, d.re, d.im]
}

#[derive(Clone, Copy)]
struct Bits(u32);

impl BitXor<u32> for Bits {
    type Output = Bits;

    fn bitxor(self, other: u32) -> Bits {
        Bits(self.0 ^ other)
    }
}

impl Not for Bits {
    type Output = Bits;

    fn not(self) -> Bits {
        Bits(!self.0)
    }
}

/// Operators on a tuple struct.
pub fn bits(id: u32, ints: &[u32], _floats: &[f32]) -> u32 {
    (!(Bits(uint(id, ints, 0)) ^ 0xFF00)).0
}
