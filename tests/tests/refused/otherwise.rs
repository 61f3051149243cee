//! Host file: what rustc reads in a way of its own, which the front end refuses rather than lower to something else.

use super::{check, file, line, with};

/// By-value receivers come before borrowed ones, somebody may have written a comparison or a macro, and floats and
/// layouts have corners.
#[test]
fn what_rustc_would_choose_otherwise() {
    let spot = "#[derive(Clone, Copy)]\npub struct Spot { a: u32 }\n";
    check(vec![
        with(
            "ambiguous",
            &format!(
                "{spot}impl Spot {{ fn get(&self) -> u32 {{ 1 }} }}\n\
                 trait Get {{ fn get(self) -> u32; }}\nimpl Get for Spot {{ fn get(self) -> u32 {{ 2 }} }}"
            ),
            "x = Spot { a: x }.get();",
        ),
        with(
            "ambiguous",
            "trait Ask { fn is_some(self) -> bool; }\nimpl Ask for Option<u32> { fn is_some(self) -> bool { false } }",
            "let y = Some(x).is_some();",
        ),
        with(
            "derive",
            "#[derive(Clone, Copy)]\nenum Way { A, B }\n\
             impl PartialEq for Way { fn eq(&self, _: &Way) -> bool { true } }",
            "let y = Way::A == Way::B;",
        ),
        with(
            "derive",
            "#[derive(Clone, Copy)]\nenum Way { A, B }",
            "let y = Way::A == Way::B;",
        ),
        with(
            "debug_assert!",
            "macro_rules! debug_assert { ($e:expr) => { if $e { return 3; } } }",
            "debug_assert!(x > 1);",
        ),
        line("NaN", "let y = f != f;"),
        line("infinite", "let y = f / 0.0;"),
        line("infinite", "let y = f + f32::MAX * 2.0;"),
        with(
            "infinite",
            "const HUGE: f32 = 1.0 / 0.0;",
            "let y = f + HUGE;",
        ),
        file(
            "align",
            "#[repr(C, align(16))] // first\npub struct Spot { a: u32 } // HERE\n\
             pub fn k(id: u32, spots: &[Spot]) -> u32 { spots[id as usize].a }\n",
        ),
        file(
            "packed",
            "#[repr(C, packed)]\npub struct Spot { a: u32 } // HERE\n\
             pub fn k(id: u32, spots: &[Spot]) -> u32 { spots[id as usize].a }\n",
        ),
    ]);
}

/// What is written through a `&mut` must reach the one place that it stands for, which is known where it is made.
#[test]
fn references_that_are_chosen_or_moved() {
    let call = |args: &str, body: &str| {
        let items = format!(
            "fn bump(a: &mut u32) {{ *a += 1; }}\n\
             fn call<'a>({args}, a: &'a mut u32, b: &'a mut u32) {{ {body} }} // HERE"
        );
        let (start, name) = match args {
            "c: bool" => ("", "x > 3"),
            "mut r: &'a mut u32" => ("let mut c = 3;", "&mut c"),
            _ => ("", "x"),
        };
        with(
            "&mut",
            &items,
            &format!("let mut a = 1; let mut b = 2; {start} call({name}, &mut a, &mut b); x = a;"),
        )
    };
    let arrays = "fn call(c: bool, a: &mut [u32; 2], b: &mut [u32; 2]) { (if c { a } else { b })[0] = 9; } // HERE";
    check(vec![
        call("c: bool", "let t = if c { a } else { b }; bump(t);"),
        call("c: bool", "bump(if c { a } else { b });"),
        call("c: bool", "*if c { a } else { b } += 1;"),
        call(
            "c: u32",
            "let t = match c { 0 => a, _ => b }; bump(&mut *t);",
        ),
        call("c: u32", "let (t, n) = (a, c); *t += n + *b;"),
        call("c: u32", "if let Some(t) = Some(a) { *t += c + *b; }"),
        call("mut r: &'a mut u32", "*r += *a; r = b; *r = 5;"),
        with(
            "&mut",
            arrays,
            "let mut a = [1; 2]; let mut b = [2; 2]; call(x > 3, &mut a, &mut b); x = a[0];",
        ),
    ]);
}

/// Variants have numbers of their own or go away with a `cfg`, and a name in a pattern is a constant or a new variable.
#[test]
fn variants_and_patterns() {
    let pick = "#[derive(Clone, Copy)]\nenum E { A, B }\nfn pick(a: u32) -> E { if a == 0 { E::A } else { E::B } }";
    check(vec![
        with(
            "numbered",
            "enum E { A = 10, B = 20 } // HERE",
            "x = E::B as u32;",
        ),
        with(
            "numbered",
            "enum E { A = 4, B } // HERE\nconst LIST: [u32; 2] = [E::A as u32, E::B as u32];",
            "x = LIST[0];",
        ),
        with(
            "cfg",
            "enum E { #[cfg(feature = \"a\")] A, B } // HERE",
            "x = E::B as u32;",
        ),
        with(
            "pattern",
            pick,
            "x = match pick(x) { E::A {} => 1, E::B => 2 };",
        ),
        with(
            "pattern",
            pick,
            "x = match pick(x) { E::A { .. } => 1, E::B => 2 };",
        ),
        line(
            "pattern",
            "x = match Some(x) { None {} => 99, Some(y) => y };",
        ),
        with(
            "MAX",
            "use core::u32::MAX;",
            "x = match x { MAX => 1, _ => 2 };",
        ),
        with(
            "LIMIT",
            "use other::LIMIT;",
            "x = match x { LIMIT => 1, _ => 2 };",
        ),
    ]);
}

/// A float that nothing makes an `f32` is an `f64`, and a `usize` has 64 bits on the CPU.
#[test]
fn numbers_of_64_bits() {
    check(vec![
        line("32 bits", "let y: usize = (65536usize << 20) >> 20;"),
        line("f64", "x = (0.29 * 100.0) as u32;"),
        line("f64", "x = (0.1 + 0.2 == 0.3) as u32;"),
        line("f64", "x = 16_777_217.0 as u32;"),
        line("f64", "let a = 0.29; let b = 100.0; x = (a * b) as u32;"),
        line("32", "x = ((x as usize) >> 32) as u32;"),
        with(
            "32",
            "const BIG: usize = 1 << 32; // HERE",
            "x = (BIG >> 16) as u32;",
        ),
        with(
            "32",
            "const BIG: usize = 65536 * 65536; // HERE",
            "x = (BIG >> 16) as u32;",
        ),
        line("usize", "let all: usize = !0; x = (all >> 1) as u32;"),
    ]);
}

/// Each mention of a constant is a new value, so that what is written to it is lost.
#[test]
fn constants_that_are_written() {
    let list = "const LIST: [u32; 2] = [1, 2];\nfn bump(a: &mut [u32; 2]) { a[0] += 5; }";
    let own = "struct S;\nimpl S { const LIST: [u32; 2] = [1, 2]; fn call() -> u32 { Self::LIST[0] += 1; Self::LIST[0] } } // HERE";
    check(vec![
        with("const", list, "LIST[1] = x; x = LIST[1];"),
        with("const", list, "bump(&mut LIST); x = LIST[0];"),
        with("const", own, "x = S::call();"),
    ]);
}

/// `+=` of a function takes its left side first, that of plain numbers its right side.
#[test]
fn order_of_compound_assignments() {
    let next = "struct R { s: u32 }\nimpl R { fn next(&mut self) -> u32 { self.s += 1; self.s } }";
    let generic = format!(
        "{next}\ntrait Of {{ fn of(a: u32) -> Self; }}\nimpl Of for u32 {{ fn of(a: u32) -> u32 {{ a }} }}\n\
         fn call<T: core::ops::AddAssign + Of>(a: &mut [T; 4], r: &mut R) {{ a[r.next() as usize] += T::of(r.next()); }} // HERE"
    );
    let start = "let mut r = R { s: 0 }; let mut a = [x; 4];";
    check(vec![
        with(
            "first",
            "struct R { s: u32 }\nimpl R {\n    fn next(&mut self) -> u32 { self.s += 1; self.s }\n    \
             fn r(&mut self) -> &u32 { self.s += 1; &self.s }\n}",
            "let mut r = R { s: x }; let mut a = [0u32; 4]; a[(r.next() & 3) as usize] += r.r();",
        ),
        with(
            "first",
            "struct R { s: u32 }\nimpl R { fn next(&mut self) -> u32 { self.s += 1; self.s } }",
            "let mut r = R { s: x }; let one = 1u32; let mut a = [0u32; 4]; \
             a[(r.next() & 3) as usize] += { let q = &one; r.next(); q };",
        ),
        with(
            "first",
            next,
            &format!("{start} a[r.next() as usize] += &r.next(); x = a[1];"),
        ),
        with(
            "first",
            &generic,
            &format!("{start} call(&mut a, &mut r); x = a[1];"),
        ),
    ]);
}

/// What a `use`, a `cfg` or a macro brings in is not known, so that a name found elsewhere may be the wrong one.
#[test]
fn names_from_places_that_are_unknown() {
    let other = "fn call(a: u32) -> u32 { a }";
    let glob = "mod base { pub fn call(a: u32) -> u32 { a } }\nuse base::*;";
    check(vec![
        with(
            "leads to no file",
            &format!("{glob}\nuse other::call;"),
            "x = call(x);",
        ),
        with(
            "leads to no file",
            &format!("{other}\nfn g(a: u32) -> u32 {{ use other::*; call(a) }} // HERE"),
            "x = g(x);",
        ),
        with(
            "cfg",
            &format!(
                "{other}\nmod fast {{ pub fn call(a: u32) -> u32 {{ a + 1 }} }}\n\
                 fn g(a: u32) -> u32 {{ #[cfg(feature = \"fast\")] use fast::*; call(a) }} // HERE"
            ),
            "x = g(x);",
        ),
        with(
            "cfg",
            "struct S;\nimpl S { #[cfg(not(feature = \"a\"))] const N: u32 = 1; #[cfg(feature = \"a\")] const N: u32 = 2; }",
            "x = S::N;",
        ),
        with(
            "macro",
            "macro_rules! two { () => { fn get(&self) -> u32 { 2 } } }\ntrait Get { fn get(&self) -> u32 { 1 } }\n\
             struct S;\nimpl Get for S { two!(); } // HERE",
            "x = S.get();",
        ),
        with(
            "macro",
            "mod a {\n    pub mod base { pub fn call(a: u32) -> u32 { a } }\n    use self::base::*;\n    \
             macro_rules! two { () => { fn call(a: u32) -> u32 { a + 2 } } }\n    two!();\n    \
             pub fn g(a: u32) -> u32 { call(a) } // HERE\n}",
            "x = a::g(x);",
        ),
        with(
            "private",
            "struct S;\nconst _: () = { impl S { fn get(&self) -> u32 { 2 } } };\n\
             trait Get { fn get(&self) -> u32; }\nimpl Get for S { fn get(&self) -> u32 { 1 } }",
            "x = S.get();",
        ),
    ]);
}

/// A bound's trait, and the default of a type's own module, may have the name of something else where they are used.
#[test]
fn names_that_are_others_elsewhere() {
    check(vec![
        with(
            "ambiguous",
            "trait One { fn get(&self) -> u32; }\ntrait Two { fn get(&self) -> u32; }\nstruct S;\n\
             impl One for S { fn get(&self) -> u32 { 1 } }\nimpl Two for S { fn get(&self) -> u32 { 2 } }\n\
             fn call<One: Two>(a: &One) -> u32 { One::get(a) } // HERE",
            "x = call(&S);",
        ),
        with(
            "default",
            "mod a {\n    pub struct Inner;\n    pub struct S<A, B = Inner> { pub a: A, pub b: B } // HERE\n    \
             pub trait V { const V: u32; }\n    impl V for Inner { const V: u32 = 1; }\n    \
             impl<A, B: V> S<A, B> { pub fn v() -> u32 { B::V } }\n}\n\
             struct Inner;\nimpl a::V for Inner { const V: u32 = 2; }",
            "x = a::S::<u32>::v();",
        ),
    ]);
}

/// A method is rustc's only where it may be seen, and a trait's may come before one of core, of glam, or of a derive.
#[test]
fn methods_that_rustc_would_not_choose() {
    let get = "trait Get { fn get(&self) -> u32; }";
    let spot = "#[derive(Clone, Copy)]\nstruct Spot { a: u32 }";
    check(vec![
        with(
            "private",
            &format!(
                "{get}\nmod a {{ pub struct S; impl S {{ fn get(&self) -> u32 {{ 1 }} pub fn own(&self) -> u32 {{ self.get() }} }} }}\n\
                 impl Get for a::S {{ fn get(&self) -> u32 {{ 2 }} }}"
            ),
            "x = a::S.get();",
        ),
        with(
            "private",
            "mod a { pub struct S; impl S { const N: u32 = 1; pub fn own(&self) -> u32 { S::N } } }\n\
             trait Get { const N: u32; }\nimpl Get for a::S { const N: u32 = 2; }",
            "x = a::S::N;",
        ),
        with(
            "&mut",
            &format!(
                "{spot}\ntrait Get {{ fn get(self) -> u32; }}\nimpl Get for Spot {{ fn get(self) -> u32 {{ self.a }} }}\n\
                 impl Get for &mut Spot {{ fn get(self) -> u32 {{ self.a += 7; self.a }} }}\n\
                 fn call(r: &mut Spot) -> u32 {{ r.get() }} // HERE"
            ),
            "let mut s = Spot { a: x }; x = call(&mut s) + s.a;",
        ),
        with(
            "Deref",
            &format!(
                "{spot}\nimpl Spot {{ fn get(&self) -> u32 {{ self.a }} }}\n\
                 #[derive(Clone, Copy)]\nstruct W {{ i: Spot }}\nimpl W {{ fn get(&self) -> u32 {{ 100 }} }}\n\
                 impl core::ops::Deref for W {{ type Target = Spot; fn deref(&self) -> &Spot {{ &self.i }} }}"
            ),
            "let w = W { i: Spot { a: x } }; x = (*w).get();",
        ),
        with(
            "ambiguous",
            "trait Num { const DIGITS: u32; }\nimpl Num for f32 { const DIGITS: u32 = 7; }",
            "x = f32::DIGITS;",
        ),
        with(
            "ambiguous",
            "trait Make { fn from_angle(a: f32) -> Vec2; }\nimpl Make for Vec2 { fn from_angle(a: f32) -> Vec2 { Vec2::new(a, a) } }",
            "let y = Vec2::from_angle(f);",
        ),
        with(
            "ambiguous",
            "trait Or { fn or(self, o: Option<u32>) -> Option<u32>; }\n\
             impl Or for Option<u32> { fn or(self, o: Option<u32>) -> Option<u32> { o } }",
            "x = Some(x).or(Some(5)).unwrap_or(0);",
        ),
        with(
            "ambiguous",
            "trait Len { fn len(&self) -> usize; }\nimpl Len for [u32; 4] { fn len(&self) -> usize { 1 } }",
            "x = [x; 4].len() as u32;",
        ),
        with(
            "ambiguous",
            "trait Nil { fn is_empty(&self) -> bool; }\nimpl<const N: usize> Nil for [u32; N] { fn is_empty(&self) -> bool { self[0] == 0 } }",
            "if [x; 3].is_empty() { x = 1; }",
        ),
        with(
            "ambiguous",
            "#[derive(Clone, Copy, PartialEq, PartialOrd, Eq, Ord)]\nstruct S { a: u32 }\ntrait Least { fn min(&self, o: S) -> S; }\n\
             impl Least for S { fn min(&self, o: S) -> S { S { a: self.a + o.a } } }",
            "x = S { a: x }.min(S { a: 3 }).a;",
        ),
    ]);
}
