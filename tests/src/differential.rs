//! Host file: one kernel on both processors, and the comparison of what they give.

use bytemuck::NoUninit;
use glam::{IVec4, Mat4, UVec4, Vec4};
use glimt_executor::Entry;
use glimt_render_gpu::gpu::{Arg, GpuContext};

use crate::kernels::input::PER_ELEMENT;
use crate::kernels::structs::{Mixed, Nested};
use crate::kernels::vectors::Vec3Pair;

/// What a word of a result is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// An integer: equal, or wrong.
    Int,
    /// A float: equal within the tolerance.
    Float,
}

/// A kernel's result, as words.
pub trait Output: NoUninit + Send {
    /// The words of one value.
    fn words() -> Vec<Word>;
}

macro_rules! outputs {
    ($($type:ty: $words:expr;)*) => {
        $(impl Output for $type {
            fn words() -> Vec<Word> {
                $words
            }
        })*
    };
}

outputs! {
    u32: vec![Word::Int];
    i32: vec![Word::Int];
    f32: vec![Word::Float];
    UVec4: vec![Word::Int; 4];
    IVec4: vec![Word::Int; 4];
    Vec4: vec![Word::Float; 4];
    Mat4: vec![Word::Float; 16];
    Vec3Pair: vec![Word::Float; 8];
    Mixed: [vec![Word::Float; 4], vec![Word::Int; 4]].concat();
    Nested: [vec![Word::Int; 4], Mixed::words(), vec![Word::Float; 4]].concat();
}

impl<T: Output, const N: usize> Output for [T; N]
where
    [T; N]: NoUninit,
{
    fn words() -> Vec<Word> {
        T::words().repeat(N)
    }
}

/// The words of `value`.
pub fn words_of<T: NoUninit>(value: &T) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(bytemuck::bytes_of(value))
}

/// Runs a kernel for one element on the CPU and gives the result as words.
type RunCpu = Box<dyn Fn(u32, &[u32], &[f32]) -> Vec<u32> + Send + Sync>;

/// A kernel with its CPU function.
pub struct Case {
    /// Its path.
    pub kernel: &'static str,
    /// What each word of an element is.
    pub words: Vec<Word>,
    /// The largest difference of a float, relative to its magnitude or to 1, whichever is larger.
    pub tolerance: f32,
    /// Its CPU function.
    pub cpu: RunCpu,
}

impl Case {
    /// The kernel `cpu`, found by the front end as `kernel`.
    pub fn new<T: Output>(
        kernel: &'static str,
        tolerance: f32,
        cpu: fn(u32, &[u32], &[f32]) -> T,
    ) -> Self {
        let cpu: RunCpu = Box::new(move |id, ints, floats| words_of(&cpu(id, ints, floats)));
        Self {
            kernel,
            words: T::words(),
            tolerance,
            cpu,
        }
    }

    /// All elements' words on the CPU.
    #[must_use]
    pub fn run_cpu(&self, inputs: &Inputs) -> Vec<u32> {
        (0..inputs.count)
            .flat_map(|id| (self.cpu)(id, &inputs.ints, &inputs.floats))
            .collect()
    }

    /// All elements' words on the GPU.
    ///
    /// # Errors
    ///
    /// Where the GPU fails: its words, and the shader.
    pub fn run_gpu(
        &self,
        context: &GpuContext,
        entry: &Entry,
        inputs: &Inputs,
    ) -> Result<Vec<u32>, String> {
        let run = || {
            let ints = context.buffer_of("ints", &inputs.ints)?;
            let floats = context.buffer_of("floats", &inputs.floats)?;
            let words = self.words.len() * inputs.count as usize;
            let out = context.buffer("out", words as u64 * 4)?;
            let buffer = |path: &str| match path {
                "ints" | "_ints" => Arg::Buffer(&ints),
                "floats" | "_floats" => Arg::Buffer(&floats),
                _ => Arg::Buffer(&out),
            };
            let slots = entry.buffers.iter();
            let args: Vec<_> = slots
                .map(|slot| (&*slot.path, buffer(&slot.path)))
                .collect();
            context.launch(entry, &args, 0, inputs.count)?;
            context.read(&out, words)
        };
        run().map_err(|error| format!("{}: {error}\n{}", self.kernel, entry.wgsl))
    }

    /// The largest relative difference of floats, or a description of the first words that differ too much.
    ///
    /// # Errors
    ///
    /// That description.
    pub fn compare(&self, cpu: &[u32], gpu: &[u32], inputs: &Inputs) -> Result<f32, String> {
        compare(&self.words, self.tolerance, cpu, gpu).map_err(|wrong| {
            let at = (wrong.element * PER_ELEMENT as usize, PER_ELEMENT as usize);
            format!(
                "{}: {} of {} words differ; first element {} word {}: CPU {}, GPU {}\n  ints {:?}\n  floats {:?}",
                self.kernel,
                wrong.count,
                cpu.len(),
                wrong.element,
                wrong.word,
                show(wrong.kind, wrong.cpu),
                show(wrong.kind, wrong.gpu),
                &inputs.ints[at.0..at.0 + at.1],
                &inputs.floats[at.0..at.0 + at.1],
            )
        })
    }
}

/// The first of the words that differ too much, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrong {
    /// How many words differ.
    pub count: usize,
    /// The first one's element.
    pub element: usize,
    /// The first one's place in it.
    pub word: usize,
    /// What it is.
    pub kind: Word,
    /// Its bits on the CPU.
    pub cpu: u32,
    /// Its bits on the GPU.
    pub gpu: u32,
}

fn show(kind: Word, bits: u32) -> String {
    match kind {
        Word::Int => format!("{bits} ({bits:#x})"),
        Word::Float => format!("{:e}", f32::from_bits(bits)),
    }
}

/// Compares results of many elements. Returns the largest relative difference of floats.
///
/// # Errors
///
/// The first word that is wrong, also where the lengths differ.
pub fn compare(words: &[Word], tolerance: f32, cpu: &[u32], gpu: &[u32]) -> Result<f32, Wrong> {
    let mut largest = 0.0f32;
    let mut wrong: Option<Wrong> = None;
    for (i, &a) in cpu.iter().enumerate() {
        let kind = words[i % words.len()];
        let b = gpu.get(i).copied();
        let fine = match (kind, b) {
            (_, None) => false,
            (Word::Int, Some(b)) => a == b,
            (Word::Float, Some(b)) => {
                let (a, b) = (f32::from_bits(a), f32::from_bits(b));
                let difference = (a - b).abs() / a.abs().max(1.0);
                largest = largest.max(difference);
                // Also false for a NaN on either side.
                difference <= tolerance
            }
        };
        if !fine {
            let first = Wrong {
                count: 0,
                element: i / words.len(),
                word: i % words.len(),
                kind,
                cpu: a,
                gpu: b.unwrap_or(0),
            };
            wrong.get_or_insert(first).count += 1;
        }
    }
    wrong.map_or(Ok(largest), Err)
}

/// Random values for many elements.
#[derive(Clone, Debug)]
pub struct Inputs {
    /// Elements.
    pub count: u32,
    /// [`PER_ELEMENT`] integers each: a quarter edge values, a quarter small, the rest uniform.
    pub ints: Vec<u32>,
    /// [`PER_ELEMENT`] floats each within ±10: an eighth edge values, the rest uniform.
    pub floats: Vec<f32>,
}

/// Where integer operations go wrong.
const EDGES: [u32; 16] = [
    0,
    1,
    2,
    3,
    5,
    31,
    32,
    33,
    0x7FFF_FFFF,
    0x8000_0000,
    0x8000_0001,
    0xFFFF_FFFF,
    0xFFFF_FFFE,
    0xFFFF_0000,
    0x00FF_FFFF,
    0x0100_0001,
];

const FLOAT_EDGES: [f32; 8] = [0.0, 1.0, -1.0, 0.5, -0.5, 10.0, -10.0, 1e-3];

impl Inputs {
    /// Inputs for `count` elements.
    #[must_use]
    pub fn new(count: u32, seed: u64) -> Self {
        let mut state = seed;
        // SplitMix64 (Steele, Lea, Flood 2014).
        let mut random = || {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^ (z >> 31)
        };
        let len = count * PER_ELEMENT;
        let ints = (0..len)
            .map(|_| {
                let (choice, value) = (random(), random() as u32);
                match choice % 4 {
                    0 => EDGES[value as usize % EDGES.len()],
                    1 => value % 64,
                    _ => value,
                }
            })
            .collect();
        let floats = (0..len)
            .map(|_| {
                let (choice, value) = (random(), random());
                match choice % 8 {
                    0 => FLOAT_EDGES[value as usize % FLOAT_EDGES.len()],
                    _ => (value >> 40) as f32 / (1u32 << 24) as f32 * 20.0 - 10.0,
                }
            })
            .collect();
        Self {
            count,
            ints,
            floats,
        }
    }
}

macro_rules! kernel_files {
    ($($path:literal),* $(,)?) => {
        &[
            ("lib.rs", "pub mod kernels;"),
            $((concat!("kernels/", $path), include_str!(concat!("kernels/", $path)))),*
        ]
    };
}

/// This crate's name and its kernels' files, for the front end.
pub const SHADER_SOURCE: (&str, &[(&str, &str)]) = (
    "glimt_tests",
    kernel_files![
        "mod.rs",
        "chunks.rs",
        "consts.rs",
        "control.rs",
        "corners.rs",
        "deep/mod.rs",
        "deep/constants.rs",
        "deep/names.rs",
        "enums.rs",
        "floats.rs",
        "generics.rs",
        "hidden.rs",
        "input.rs",
        "ints.rs",
        "matches.rs",
        "matrices.rs",
        "modules.rs",
        "muts.rs",
        "operators.rs",
        "options.rs",
        "order.rs",
        "slices.rs",
        "structs.rs",
        "traits.rs",
        "vectors.rs",
    ],
);
