//! Host file: a kernel of one's own, on the CPU and on the GPU from the same file.
//!
//! `examples/src/gray_scott.rs` is plain Rust. Rayon calls its function `step` as it is; `naga-front-rust` lowers the same
//! text to WGSL, and `glimt-executor` launches that. Both grow the same pattern, which is printed.
//!
//! ```text
//! cargo run --release --example own_kernel
//! ```

use glam::{UVec2, Vec2};
use glimt_examples::GRAY_SCOTT;
use glimt_examples::gray_scott::{Grid, Rates, step};
use glimt_executor::gpu::{AdapterPreference, Arg, GpuContext, GpuError};
use naga_front_rust::{EntryDesc, Program};
use rayon::prelude::*;

const STEPS: usize = 4000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = UVec2::new(192, 96);
    let (width, count) = (size.x as usize, size.element_product());
    let rates = Rates {
        diffusion: Vec2::new(0.2097, 0.105),
        feed: 0.037,
        kill: 0.06,
    };
    // All u, with squares of v.
    let mut start = vec![Vec2::X; count as usize];
    for (x, y) in [(40, 30), (120, 20), (90, 60), (160, 75), (20, 80)] {
        let rows = start.chunks_mut(width).skip(y).take(6);
        rows.for_each(|row| row[x..x + 6].fill(Vec2::new(0.5, 0.25)));
    }

    // On the CPU, rayon calls the kernel for each cell.
    let mut cpu = start.clone();
    for _ in 0..STEPS {
        let grid = Grid { size, cells: &cpu };
        let ids = (0..count).into_par_iter();
        cpu = ids.map(|id| step(id, grid, &rates)).collect();
    }
    for row in cpu.chunks(width).step_by(4) {
        let shade = |cell: &Vec2| b" .:-=+*#%@"[(cell.y * 25.0).clamp(0.0, 9.0) as usize] as char;
        println!("{}", row.iter().step_by(2).map(shade).collect::<String>());
    }

    // For the GPU, the kernel's text becomes a shader.
    let shader = Program::parse(&[GRAY_SCOTT.into()])?.entry(&EntryDesc {
        name: "gray_scott",
        kernel: "gray_scott::step",
        workgroup_size: 64,
    })?;
    let entry = glimt_executor::Entry::from(&shader);
    let context = match GpuContext::new(AdapterPreference::Fastest) {
        Err(GpuError::NoAdapter) => {
            println!("There is no GPU to compare with.");
            return Ok(());
        }
        opened => opened?,
    };
    // Two buffers take turns: each step reads one and writes the other. Arguments have the names that they have in the kernel.
    let mut cells = context.buffer_of("cells", &start)?;
    let mut next = context.buffer_of("next", &start)?;
    for _ in 0..STEPS {
        let args = [
            ("grid.size", Arg::Value(bytemuck::bytes_of(&size))),
            ("grid.cells", Arg::Buffer(&cells)),
            ("rates", Arg::Value(bytemuck::bytes_of(&rates))),
            ("out", Arg::Buffer(&next)),
        ];
        context.launch(&entry, &args, 0, count)?;
        std::mem::swap(&mut cells, &mut next);
    }
    let gpu: Vec<Vec2> = context.read(&cells, cpu.len())?;

    let pairs = cpu.iter().zip(&gpu);
    let differences = pairs.flat_map(|(a, b)| (*a - *b).abs().to_array());
    let largest = differences.max_by(f32::total_cmp).unwrap_or(f32::NAN);
    println!("largest difference to {}: {largest:e}", context.adapter());
    // The pattern grows from rounding errors, too.
    assert!(largest <= 0.01, "more than 0.01");
    Ok(())
}
