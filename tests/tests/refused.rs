//! Host file: what the front end cannot lower, and the error that says so.

use naga_front_rust::{CrateSource, EntryDesc, Program};

#[path = "refused/otherwise.rs"]
mod otherwise;

/// A construct that must be refused.
struct Refused {
    /// What the message must say.
    phrase: &'static str,
    /// The file. The line at which the error must point ends in `// HERE`.
    source: String,
}

/// A whole file with the kernel `k`.
fn file(phrase: &'static str, source: &str) -> Refused {
    Refused {
        phrase,
        source: source.to_owned(),
    }
}

/// A kernel whose body has `line` in it, and other `items` beside it.
fn with(phrase: &'static str, items: &str, line: &str) -> Refused {
    let source = format!(
        "use glam::{{Vec2, Vec3, Vec4, UVec2}};\n{items}\n\
         pub fn k(id: u32, ints: &[u32], floats: &[f32]) -> u32 {{\n    \
         let mut x = ints[id as usize];\n    let f = floats[0];\n    {line} // HERE\n    x\n}}\n"
    );
    Refused { phrase, source }
}

/// A kernel whose body has `line` in it.
fn line(phrase: &'static str, line: &str) -> Refused {
    with(phrase, "", line)
}

fn check(list: Vec<Refused>) {
    let mut failures = Vec::new();
    for Refused { phrase, source } in list {
        let files = [("lib.rs", source.as_str())];
        let krate = CrateSource {
            name: "refused",
            files: &files,
        };
        let desc = EntryDesc {
            name: "entry",
            kernel: "refused::k",
            workgroup_size: 64,
        };
        let result = match Program::parse(&[krate]) {
            Ok(program) => program.entry(&desc),
            Err(error) => Err(error),
        };
        let Err(error) = result else {
            failures.push(format!(
                "was lowered, in silence (wanted '{phrase}'):\n{source}"
            ));
            continue;
        };
        let text = error.to_string();
        let mut say = |what: &str| failures.push(format!("{what}:\n{text}\nof\n{source}"));
        // Not the whole text, which holds the source line.
        let help = error.help.as_deref().unwrap_or_default();
        let said = format!("{} {} {help}", error.message, error.notes.join(" "));
        if !said.contains(phrase) {
            say(&format!("lacks '{phrase}'"));
        }
        if !text.contains("help: ") {
            say("has no help");
        }
        let Some(at) = &error.location else {
            say("names no place");
            continue;
        };
        let place = format!("refused/src/lib.rs:{}:{}", at.line, at.column);
        if !text.contains(&place) {
            say(&format!("lacks '{place}'"));
        }
        let line = source.lines().nth(at.line - 1).unwrap_or_default();
        if line.is_empty() || !text.contains(line) {
            say("does not show its line");
        }
        if source.contains("// HERE") && !line.contains("// HERE") {
            say("points at another line");
        }
        let caret = format!("| {}^", " ".repeat(at.column - 1));
        if !text.contains(&caret) {
            say("has no caret under its column");
        }
    }
    assert!(
        failures.is_empty(),
        "{} failures\n\n{}",
        failures.len(),
        failures.join("\n----\n")
    );
}

#[test]
fn types() {
    check(vec![
        line("u64", "let y: u64 = 1;"),
        line("i64", "let y = x as i64;"),
        line("f64", "let y = f as f64;"),
        line("u8", "x = (x as u8) as u32;"),
        line("u16", "let y: [u16; 2] = [1, 2];"),
        line("i8", "let y: Option<i8> = None;"),
        line("char", "let y: char = 'a';"),
        line("u128", "let y = x as u128;"),
        line("isize", "let y = x as isize;"),
        line("cannot be lowered", "let y = 'a';"),
        line("cannot be lowered", "let y = \"text\";"),
        line("cannot be lowered", "let y = b'a';"),
        line("u64", "let y = 1u64;"),
        line("f64", "let y = 1.0f64;"),
        line("String", "let y: String = make();"),
        line("closure", "let y = |a: u32| a + 1;"),
        line("function pointer", "let y: fn(u32) -> u32 = other;"),
        with(
            "function",
            "fn other(a: u32) -> u32 { a }",
            "let y = other;",
        ),
        line("raw pointer", "let y: *const u32 = 0;"),
        line("Vec3A", "let y: glam::Vec3A = make();"),
        line("Quat", "let y: glam::Quat = make();"),
        line("DVec3", "let y: glam::DVec3 = make();"),
        with(
            "dyn",
            "trait T { fn a(&self) -> u32; }\nfn call(t: &dyn T) -> u32 { t.a() } // HERE",
            "x = call(&3);",
        ),
        with("enum", "enum E { A(u32), B } // HERE", "let e = E::A(x);"),
        with(
            "associated type",
            "trait T { type Out; fn a(&self) -> u32; }",
            "let y: <u32 as T>::Out = 1;",
        ),
        line("Result", "let y: Result<u32, u32> = Ok(1);"),
    ]);
}

#[test]
fn references() {
    check(vec![
        line("&mut", "let y = &mut x;"),
        with(
            "&mut",
            "struct S<'a> { x: &'a mut u32 } // HERE",
            "let s = S { x: &mut x };",
        ),
        with(
            "&mut",
            "fn call<'a>(a: &'a mut u32) -> &'a mut u32 { a } // HERE",
            "let y = call(&mut x);",
        ),
        with(
            "array",
            "fn call(a: &[u32]) -> u32 { a[0] }",
            "x = call(&[1, 2, 3]);",
        ),
        line("slice", "let s = if x > 3 { ints } else { &ints[1..] };"),
        line("slice", "let s = [ints, ints];"),
        line("slice", "let mut s = ints; s = &ints[1..];"),
        line("slice", "let s = Some(&ints[1..]);"),
        with(
            "slice",
            "struct S<'a> { a: &'a [u32] }",
            "let mut s = S { a: ints }; s.a = &ints[1..];",
        ),
    ]);
}

#[test]
fn statements() {
    check(vec![
        line("label", "'outer: loop { break 'outer; }"),
        line("label", "'outer: for i in 0..3 { continue 'outer; }"),
        line("unsafe", "unsafe { x = 1; }"),
        line("async", "let y = async { 1 };"),
        line("range", "for i in ints { x += i; }"),
        line("iter", "for i in ints.iter() { x += i; }"),
        line("range", "for i in (0..10).rev() { x += i; }"),
        line("range", "for i in (0..10).step_by(2) { x += i; }"),
        line("range", "let r = 0..3;"),
        line("assert", "assert!(x > 3);"),
        line("panic", "panic!();"),
        line("println", "println!(\"{x}\");"),
        line("unreachable", "if x == 3 { unreachable!() }"),
        line("matches", "let y = matches!(x, 1 | 2);"),
        line("vec", "let y = vec![1];"),
        line("cfg", "if cfg!(debug_assertions) { x = 1; }"),
        line("todo", "todo!();"),
        with("own", "macro_rules! own { () => { 1 } }", "x = own!();"),
        line("pattern", "let [a, b] = [1, 2];"),
        line("pattern", "if let [a, ..] = [1, 2] { x = a; }"),
        line("pattern", "let ref y = x;"),
        line("this expression", "yield x;"),
        line("const", "const { assert!(true) };"),
    ]);
}

#[test]
fn functions_that_mean_something_else() {
    check(vec![
        line("round", "x = f.round() as u32;"),
        line("signum", "x = f.signum() as u32;"),
        line("is_nan", "if f.is_nan() { x = 1; }"),
        line("is_finite", "if f.is_finite() { x = 1; }"),
        line("is_infinite", "if f.is_infinite() { x = 1; }"),
        line("INFINITY", "let y = f32::INFINITY;"),
        line("NEG_INFINITY", "let y = f32::NEG_INFINITY;"),
        line("NAN", "let y = f32::NAN;"),
        line("INFINITY", "let y = Vec3::INFINITY;"),
        line("NAN", "let y = Vec4::NAN;"),
        line("fract", "let y = f.fract();"),
        line("fract", "let y = Vec2::ONE.fract();"),
        line("round", "let y = Vec2::ONE.round();"),
        line("signum", "let y = Vec2::ONE.signum();"),
        line("is_nan", "let y = Vec2::ONE.is_nan();"),
        line("rem_euclid", "x = x.rem_euclid(3);"),
        line("rem_euclid", "let y = f.rem_euclid(3.0);"),
        line("checked_add", "let y = x.checked_add(3);"),
        line("overflowing_add", "let y = x.overflowing_add(3);"),
        line("libm", "let y = f.sqrt();"),
        line("libm", "let y = f.sin();"),
        line("libm", "let y = f.powi(2);"),
        line("libm", "let y = f.floor();"),
        line("roundf", "let y = libm::roundf(f);"),
        line("rintf", "let y = libm::rintf(f);"),
        line("sqrt", "let y = libm::sqrt(2.0);"),
        line("sincosf", "let y = libm::sincosf(f);"),
        line(
            "normalize_or_zero",
            "let y = Vec3::ONE.normalize_or_zero();",
        ),
    ]);
}

#[test]
fn unknown_functions() {
    check(vec![
        line("pow", "x = x.pow(3);"),
        line("swap_bytes", "x = x.swap_bytes();"),
        line("to_le_bytes", "let y = x.to_le_bytes();"),
        line("saturating_add", "let y = (x as i32).saturating_add(1);"),
        line("abs_diff", "let y = (x as i32).abs_diff(1);"),
        line("wrapping_add", "let y = (x as usize).wrapping_add(1);"),
        line("count_ones", "let y = (x as usize).count_ones();"),
        line("BITS", "let y = usize::BITS;"),
        line("MAX", "let y = usize::MAX;"),
        line("unwrap", "x = Some(x).unwrap();"),
        line("expect", "x = Some(x).expect(\"some\");"),
        line("map", "x = Some(x).map(|a| a + 1).unwrap_or(0);"),
        line("and_then", "let y = Some(x).and_then(None);"),
        line("angle_between", "let y = Vec3::ONE.angle_between(Vec3::X);"),
        line("cmplt", "let y = Vec3::ONE.cmplt(Vec3::X);"),
        line("inverse", "let y = glam::Mat3::IDENTITY.inverse();"),
        line("nothing", "x = nothing(x);"),
        line("nothing", "x = x.nothing();"),
        line("swap", "core::mem::swap(&mut x, &mut x);"),
        line("get", "let y = ints.get(3);"),
        line("first", "let y = ints.first();"),
        line("transmute", "let y = core::mem::transmute(x);"),
        line("Default", "let y: u32 = Default::default();"),
        line("into", "let y: usize = x.into();"),
        line("from", "let y = u32::from(true);"),
    ]);
}

#[test]
fn comparisons() {
    let spot = "#[derive(PartialEq, PartialOrd, Clone, Copy)]\nstruct Spot { a: u32 }";
    check(vec![
        with("==", spot, "let y = Spot { a: 1 } == Spot { a: 2 };"),
        with("<", spot, "let y = Spot { a: 1 } < Spot { a: 2 };"),
        line("==", "let y = Vec3::ONE == Vec3::X;"),
        line("!=", "let y = Some(x) != None;"),
        line("==", "let y = (1, 2) == (x, 2);"),
        line("==", "let y = [1, 2] == [x, 2];"),
    ]);
}

#[test]
fn functions() {
    check(vec![
        with(
            "recurs",
            "fn call(a: u32) -> u32 { if a == 0 { 0 } else { call(a - 1) } } // HERE",
            "x = call(x);",
        ),
        with(
            "recurs",
            "fn call(a: u32) -> u32 { g(a) } // HERE\nfn g(a: u32) -> u32 { call(a) } // HERE",
            "x = call(x);",
        ),
        with(
            "unsafe",
            "unsafe fn call(a: u32) -> u32 { a } // HERE",
            "x = call(x);",
        ),
        with(
            "async",
            "async fn call(a: u32) -> u32 { a } // HERE",
            "let y = call(x);",
        ),
        with(
            "extern",
            "extern \"C\" fn call(a: u32) -> u32 { a } // HERE",
            "x = call(x);",
        ),
        with(
            "impl Trait",
            "trait T {}\nfn call(a: u32) -> impl T { a } // HERE",
            "let y = call(x);",
        ),
        with(
            "attribute",
            "#[track_caller] // HERE\nfn call(a: u32) -> u32 { a }",
            "x = call(x);",
        ),
        with(
            "attribute",
            "#[unsafe(no_mangle)] // HERE\nfn call(a: u32) -> u32 { a }",
            "x = call(x);",
        ),
        with(
            "cfg",
            "#[cfg(feature = \"fast\")]\nfn call(a: u32) -> u32 { a }",
            "x = call(x);",
        ),
        with(
            "cfg",
            "#[cfg(debug_assertions)]\nconst A: u32 = 1;",
            "x = A;",
        ),
        with("static", "static A: u32 = 1;", "x = A;"),
        with("absent", "mod absent;", "x = absent::call(x);"),
        with(
            "ambiguous",
            "trait T<A> { fn t(&self, a: A) -> u32; }\nimpl T<u32> for u32 { fn t(&self, a: u32) -> u32 { a } }\n\
             impl T<i32> for u32 { fn t(&self, a: i32) -> u32 { 7 } }",
            "x = x.t(1i32);",
        ),
    ]);
}

/// rustc chooses by the bound, where the front end sees the concrete type.
#[test]
fn a_method_that_a_bound_would_choose() {
    let items = "struct S;\nimpl S { fn t(&self) -> u32 { 1 } }\ntrait T { fn t(&self) -> u32; }\n\
                 impl T for S { fn t(&self) -> u32 { 2 } }\nfn call<A: T>(a: &A) -> u32 { a.t() } // HERE";
    check(vec![with("ambiguous", items, "x = call(&S);")]);
}

/// Slices of two buffers cannot be told apart when the kernel runs.
#[test]
fn slices_that_a_condition_chooses() {
    let pick = "fn pick<'a>(a: &'a [u32], b: &'a [u32], c: bool) -> &'a [u32] { if c { a } else { b } } // HERE";
    let view = "struct V<'a> { s: &'a [u32] }\nfn pick<'a>(a: V<'a>, b: V<'a>, c: bool) -> V<'a> { if c { a } else { b } } // HERE";
    let early =
        "fn pick<'a>(a: &'a [u32], c: bool) -> &'a [u32] { if c { return &a[1..]; } a } // HERE";
    check(vec![
        with("slice", pick, "x = pick(ints, &ints[1..], x > 3)[0];"),
        with(
            "slice",
            view,
            "x = pick(V { s: ints }, V { s: &ints[1..] }, x > 3).s[0];",
        ),
        with("slice", early, "x = pick(ints, x > 3)[0];"),
        line("slice", "let s = match x { 1 => ints, _ => &ints[1..] };"),
        line(
            "slice",
            "let s; if x > 1 { s = ints; } else { s = &ints[1..]; }",
        ),
        line("slice", "let s = loop { break ints; };"),
    ]);
}

#[test]
fn ambiguous_names() {
    let two = "mod a { pub fn call(a: u32) -> u32 { a } }\nmod b { pub fn call(a: u32) -> u32 { a + 1 } }\nuse a::*;\nuse b::*;";
    let twice = "trait A { fn t(&self) -> u32; }\ntrait B { fn t(&self) -> u32; }\n\
                 impl A for u32 { fn t(&self) -> u32 { 1 } }\nimpl B for u32 { fn t(&self) -> u32 { 2 } }";
    check(vec![
        with("ambiguous", two, "x = call(x);"),
        with("ambiguous", twice, "x = x.t();"),
        with(
            "ambiguous",
            "fn call(a: u32) -> u32 { a }\nfn call(a: u32) -> u32 { a + 1 }",
            "x = call(x);",
        ),
        with("call", "mod a { fn g() {} }", "x = a::call(x);"),
        with("other_crate", "use other_crate::call;", "x = call(x);"),
    ]);
}

/// A kernel of another shape.
fn kernel(phrase: &'static str, items: &str, signature: &str, body: &str) -> Refused {
    file(
        phrase,
        &format!(
            "use glam::{{Vec2, Vec3, Vec4}};\n{items}\npub fn k{signature} {{ // HERE\n    {body}\n}}\n"
        ),
    )
}

#[test]
fn kernels() {
    check(vec![
        kernel("u32", "", "(id: f32) -> u32", "1"),
        kernel("u32", "", "() -> u32", "1"),
        kernel("bool", "", "(id: u32) -> bool", "true"),
        kernel("usize", "", "(id: u32) -> usize", "1"),
        kernel("(u32, u32)", "", "(id: u32) -> (u32, u32)", "(1, 2)"),
        kernel("Option", "", "(id: u32) -> Option<u32>", "None"),
        kernel(
            "E",
            "#[derive(Clone, Copy)]\npub enum E { A, B }",
            "(id: u32) -> E",
            "E::A",
        ),
        kernel("bool", "", "(id: u32, flag: bool) -> u32", "flag as u32"),
        kernel(
            "usize",
            "",
            "(id: u32, list: &[usize]) -> u32",
            "list[0] as u32",
        ),
        kernel("Vec3", "", "(id: u32, list: &[Vec3]) -> f32", "list[0].x"),
        kernel("Vec3", "", "(id: u32) -> Vec3", "Vec3::X"),
        kernel("first", "", "(id: u32, first: u32) -> u32", "first"),
        kernel("count", "", "(id: u32, count: u32) -> u32", "count"),
        kernel("out", "", "(id: u32, out: &[u32]) -> u32", "out[0]"),
        kernel(
            "a_len",
            "",
            "(id: u32, a_len: u32, a: &mut [u32]) -> u32",
            "a_len + a[0]",
        ),
        kernel("nothing", "", "(id: u32)", "let _ = id;"),
        kernel("&mut", "", "(id: u32, a: &mut u32) -> u32", "*a"),
    ]);
}

/// Enums lie in buffers as `u32`, and only where the host writes and the GPU reads.
#[test]
fn enums_in_buffers() {
    let e = "#[derive(Clone, Copy)]\n#[repr(u32)]\npub enum E { A, B }\n\
             #[derive(Clone, Copy)]\n#[repr(C)]\npub struct S { pub n: u32, pub list: [E; 2] }";
    let s = "S { n: 1, list: [E::A, E::B] }";
    let written = |signature, body| kernel("store a `u32`", e, signature, body);
    let chunk = "the chunk `a` holds the enum `E`";
    let read = |attribute: &str, argument: &str, value: &str| {
        let source = format!(
            "#[derive(Clone, Copy)]\n{attribute}\npub enum E {{ A, B }} // HERE\n\
             #[derive(Clone, Copy)]\n#[repr(C)]\npub struct S {{ pub e: E }}\n\
             pub fn k(id: u32, {argument}) -> u32 {{\n    {value} as u32\n}}\n"
        );
        file("add #[repr(u32)]", &source)
    };
    let numbers = |number| {
        let source = format!(
            "#[derive(Clone, Copy)]\n#[repr(u32)]\npub enum E {{\n    A = {number}, // HERE\n    B,\n}}\n\
             pub fn k(id: u32, e: E) -> u32 {{\n    e as u32\n}}\n"
        );
        file("write it as a literal", &source)
    };
    check(vec![
        written("(id: u32) -> E", "E::A"),
        written("(id: u32) -> [E; 2]", "[E::A, E::B]"),
        written("(id: u32) -> S", s),
        written("(id: u32, a: &mut [E])", "a[0] = E::A;"),
        kernel(chunk, e, "(id: u32, a: &mut [E])", "a[0] = E::A;"),
        kernel(
            chunk,
            e,
            "(id: u32, a: &mut [S]) -> u32",
            "a[0].list[0] as u32",
        ),
        read("", "e: E", "e"),
        read("", "list: &[E]", "list[0]"),
        read("", "s: &S", "s.e"),
        read("#[repr(u8)]", "list: &[E]", "list[0]"),
        read("#[repr(i32)]", "list: &[E]", "list[0]"),
        read("#[repr(C)]", "list: &[S]", "list[0].e"),
        read("#[repr(C, u32)]", "e: E", "e"),
        numbers("-1"),
        numbers("BASE"),
        numbers("1 << 3"),
        numbers("0x1_0000_0000"),
    ]);
}

#[test]
fn buffer_structs() {
    let of = |phrase, attribute: &str, fields: &str| {
        let source = format!(
            "use glam::{{Vec2, Vec3, Vec4}};\n#[derive(Clone, Copy)]\n{attribute}\npub struct S {{ {fields} }}\n\
             pub fn k(id: u32, list: &[S]) -> u32 {{\n    let s = list[id as usize];\n    1\n}}\n"
        );
        file(phrase, &source)
    };
    let c = "#[repr(C)]";
    check(vec![
        of("repr(C)", "", "pub a: u32, pub b: u32"),
        of("offset", c, "pub a: u32, pub b: Vec2"),
        of("offset", c, "pub a: Vec2, pub b: Vec4"),
        of("offset", c, "pub a: Vec3, pub b: Vec3, pub c: Vec2"),
        of("size", c, "pub a: Vec4, pub b: u32"),
        of("size", c, "pub a: Vec3"),
        of("bool", c, "pub a: bool, pub b: u32"),
        of("usize", c, "pub a: usize"),
        of("u8", c, "pub a: [u8; 4]"),
        of("Vec3", c, "pub a: [Vec3; 2], pub b: Vec2"),
        of("Option", c, "pub a: Option<u32>"),
    ]);
}

#[test]
fn files() {
    check(vec![
        file("parse", "pub fn k(id: u32) -> u32 {\n    1 +\n}\n"),
        file("parse", "pub fn k(id: u32 -> u32 { // HERE\n    1\n}\n"),
    ]);
}

#[test]
fn what_has_no_place_is_still_an_error() {
    let files = [("lib.rs", "pub fn k(id: u32) -> u32 { id }")];
    let krate = || CrateSource {
        name: "one",
        files: &files,
    };
    let program = Program::parse(&[krate()]).unwrap();
    let desc = |kernel| EntryDesc {
        name: "entry",
        kernel,
        workgroup_size: 64,
    };
    for (kernel, phrase) in [
        ("one::missing", "missing"),
        ("two::k", "two"),
        ("", ""),
        ("one::k::k", "k"),
    ] {
        let Err(error) = program.entry(&desc(kernel)) else {
            panic!("'{kernel}' was found");
        };
        assert!(
            error.help.is_some() && error.message.contains(phrase),
            "{kernel}: {error}"
        );
    }
    assert!(program.entry(&desc("one::k")).is_ok());
    let error = Program::parse(&[krate(), krate()]).map(drop).unwrap_err();
    assert!(
        error.to_string().contains("taken") && error.help.is_some(),
        "{error}"
    );
}

/// WGSL would rename the entry point, and whoever asks for it by its name would not find it.
#[test]
fn entry_points_that_wgsl_would_rename() {
    let files = [("lib.rs", "pub fn k(id: u32) -> u32 { id }")];
    let program = Program::parse(&[CrateSource {
        name: "one",
        files: &files,
    }])
    .unwrap();
    let desc = |name| EntryDesc {
        name,
        kernel: "one::k",
        workgroup_size: 64,
    };
    for name in [
        "step",
        "fn",
        "pass1",
        "1st",
        "two words",
        "a-b",
        "",
        "_",
        "__a",
        "array",
        "Params",
    ] {
        let Err(error) = program.entry(&desc(name)) else {
            panic!("'{name}' was taken")
        };
        assert!(
            error.message.contains(name) && error.help.is_some(),
            "{error}"
        );
    }
    for name in ["main", "k", "shade_mis", "Shade", "pass_1_a"] {
        let shader = program
            .entry(&desc(name))
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(
            shader.wgsl.contains(&format!("fn {name}(")),
            "{}",
            shader.wgsl
        );
    }
}
