//! Host file: a kernel of one's own, on the CPU and on the GPU from the same file.
//!
//! `examples/src/gray_scott.rs` is plain Rust. Below, rayon runs it as it is; `naga-front-rust` lowers the same text to
//! WGSL, and wgpu runs that. Both grow the same pattern, which is printed.
//!
//! ```text
//! cargo run --release -p glimt-examples --example own_kernel
//! ```

use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use glam::{UVec2, Vec2};
use glimt_examples::GRAY_SCOTT;
use glimt_examples::gray_scott::{self, Grid, Rates};
use naga_front_rust::{EntryDesc, Program, Shader};
use rayon::prelude::*;

const SIZE: UVec2 = UVec2::new(192, 96);
const STEPS: usize = 4000;
const RATES: Rates = Rates {
    diffusion: Vec2::new(0.2097, 0.105),
    feed: 0.037,
    kill: 0.06,
};
/// The pattern grows from rounding errors, too: differences of 1e-7 a step are amplified.
const TOLERANCE: f32 = 0.01;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let start = seed();

    let clock = Instant::now();
    let on_cpu = run_cpu(start.clone());
    println!(
        "CPU: {STEPS} steps of {} × {} cells in {:.2} s",
        SIZE.x,
        SIZE.y,
        clock.elapsed().as_secs_f32()
    );

    let clock = Instant::now();
    let program = Program::parse(&[GRAY_SCOTT.into()])?;
    let shader = program.entry(&EntryDesc {
        name: "gray_scott",
        kernel: "gray_scott::step",
        workgroup_size: 64,
    })?;
    println!(
        "lowered to {} lines of WGSL in {:.1} ms",
        shader.wgsl.lines().count(),
        clock.elapsed().as_secs_f32() * 1e3
    );

    let Some(gpu) = Gpu::open()? else {
        println!("no GPU adapter here, so nothing to compare with");
        print_pattern(&on_cpu);
        return Ok(());
    };
    let clock = Instant::now();
    let on_gpu = gpu.run(&shader, &start)?;
    println!(
        "GPU: the same on {} in {:.2} s",
        gpu.name,
        clock.elapsed().as_secs_f32()
    );

    print_pattern(&on_gpu);
    let difference = on_cpu
        .iter()
        .zip(&on_gpu)
        .map(|(a, b)| (*a - *b).abs().max_element())
        .fold(0.0, f32::max);
    println!("largest difference between the two: {difference:e}");
    if !(difference <= TOLERANCE) {
        return Err(format!("that is more than {TOLERANCE}").into());
    }
    Ok(())
}

/// All u, with squares of v.
fn seed() -> Vec<Vec2> {
    let mut cells = vec![Vec2::X; (SIZE.x * SIZE.y) as usize];
    for (x, y) in [(40, 30), (120, 20), (90, 60), (160, 75), (20, 80)] {
        for j in 0..6 {
            for i in 0..6 {
                cells[((y + j) * SIZE.x + x + i) as usize] = Vec2::new(0.5, 0.25);
            }
        }
    }
    cells
}

fn run_cpu(mut cells: Vec<Vec2>) -> Vec<Vec2> {
    let mut next = cells.clone();
    for _ in 0..STEPS {
        let grid = Grid {
            size: SIZE,
            cells: &cells,
        };
        let rows = next.par_chunks_mut(SIZE.x as usize).enumerate();
        rows.for_each(|(y, row)| {
            for (x, cell) in row.iter_mut().enumerate() {
                *cell = gray_scott::step(y as u32 * SIZE.x + x as u32, grid, &RATES);
            }
        });
        std::mem::swap(&mut cells, &mut next);
    }
    cells
}

fn print_pattern(cells: &[Vec2]) {
    for y in (0..SIZE.y).step_by(4) {
        let shade = |x: u32| {
            let v = cells[(y * SIZE.x + x) as usize].y;
            b" .:-=+*#%@"[(v * 25.0).clamp(0.0, 9.0) as usize] as char
        };
        println!("{}", (0..SIZE.x).step_by(2).map(shade).collect::<String>());
    }
}

struct Gpu {
    name: String,
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Gpu {
    fn open() -> Result<Option<Self>, Box<dyn Error>> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let Ok(adapter) =
            pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
        else {
            return Ok(None);
        };
        let (device, queue) =
            pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
        Ok(Some(Self {
            name: adapter.get_info().name,
            device,
            queue,
        }))
    }

    fn buffer(&self, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        let size = bytes.len() as u64;
        let descriptor = wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        };
        let buffer = self.device.create_buffer(&descriptor);
        self.queue.write_buffer(&buffer, 0, bytes);
        buffer
    }

    /// The plain arguments, laid out as the shader says.
    fn params(shader: &Shader, count: u32) -> Vec<u8> {
        let mut params = vec![0; shader.params_size as usize];
        for field in &shader.params {
            let bytes = match field.path.as_str() {
                "first" => bytemuck::bytes_of(&0u32),
                "count" => bytemuck::bytes_of(&count),
                "grid.size" => bytemuck::bytes_of(&SIZE),
                "rates" => bytemuck::bytes_of(&RATES),
                other => unreachable!("the kernel has no argument '{other}'"),
            };
            let from = field.offset as usize;
            params[from..from + bytes.len()].copy_from_slice(bytes);
        }
        params
    }

    fn run(&self, shader: &Shader, start: &[Vec2]) -> Result<Vec<Vec2>, Box<dyn Error>> {
        let count = start.len() as u32;
        let module = self
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("gray_scott"),
                source: wgpu::ShaderSource::Wgsl(shader.wgsl.as_str().into()),
            });
        let pipeline = self
            .device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("gray_scott"),
                layout: None,
                module: &module,
                entry_point: Some(&shader.entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            });
        let storage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let uniform = wgpu::BufferUsages::UNIFORM;
        let params = self.buffer(&Self::params(shader, count), storage | uniform);
        let grids = [(); 2].map(|()| self.buffer(bytemuck::cast_slice(start), storage));
        // Each step reads the one and writes the other.
        let bind_groups = [[&grids[0], &grids[1]], [&grids[1], &grids[0]]].map(|[from, to]| {
            let mut entries = vec![wgpu::BindGroupEntry {
                binding: 0,
                resource: params.as_entire_binding(),
            }];
            for buffer in &shader.buffers {
                let resource = if buffer.writable { to } else { from }.as_entire_binding();
                entries.push(wgpu::BindGroupEntry {
                    binding: buffer.binding,
                    resource,
                });
            }
            let layout = pipeline.get_bind_group_layout(0);
            self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &layout,
                entries: &entries,
            })
        });
        for step in 0..STEPS {
            let mut encoder = self
                .device
                .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                pass.set_pipeline(&pipeline);
                pass.set_bind_group(0, &bind_groups[step % 2], &[]);
                pass.dispatch_workgroups(count.div_ceil(shader.workgroup_size), 1, 1);
            }
            self.queue.submit([encoder.finish()]);
        }
        self.read(&grids[STEPS % 2])
    }

    fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<Vec2>, Box<dyn Error>> {
        let staging = self.buffer(
            &vec![0; buffer.size() as usize],
            wgpu::BufferUsages::MAP_READ,
        );
        let mut encoder = self
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, buffer.size());
        self.queue.submit([encoder.finish()]);
        let (sender, receiver) = std::sync::mpsc::channel();
        staging.map_async(wgpu::MapMode::Read, .., move |result| {
            sender.send(result).unwrap_or_default()
        });
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        receiver.recv()??;
        Ok(bytemuck::pod_collect_to_vec(&staging.get_mapped_range(..)?))
    }
}
