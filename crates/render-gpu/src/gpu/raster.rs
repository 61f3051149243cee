//! Host file: a scene drawn into layers of 16 bits by the GPU's rasteriser.

use glam::UVec2;

use glimt_executor::gpu::{GpuBuffer, GpuContext, GpuError, GpuVec, Recording};

use crate::kernels::raster::RasterParams;

/// Layers that are drawn at once: objects, catchers, what catchers lack.
pub(super) const LAYERS: usize = 3;
/// Bytes of a pixel of one.
pub(super) const PIXEL: u64 = 8;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Rows of a copy from a texture begin at multiples of this.
const ROW_ALIGNMENT: u64 = 256;

pub(super) const WGSL: &str = concat!(
    include_str!("../generated/raster_functions.wgsl"),
    include_str!("raster.wgsl")
);

/// Storage buffers of the stages, bindings 1 to this.
pub(super) const BUFFERS: usize = 7;

/// The compiled stages, for one number of samples a pixel, and for scenes with or without surfaces that let light pass.
#[derive(Debug)]
pub(super) struct Rasteriser {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    params: wgpu::Buffer,
}

impl Rasteriser {
    pub(super) fn new(
        context: &GpuContext,
        samples: u32,
        is_see_through: bool,
    ) -> Result<Self, GpuError> {
        let limits = context.limits();
        if limits.max_storage_buffers_per_shader_stage < BUFFERS as u32 {
            return Err(context.limit_error(
                "drawing".to_owned(),
                BUFFERS as u64,
                "max_storage_buffers_per_shader_stage",
                limits.max_storage_buffers_per_shader_stage.into(),
            ));
        }
        let both = wgpu::ShaderStages::VERTEX_FRAGMENT;
        let slot = |binding: u32| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: match binding {
                0 | 1 => both,
                _ => wgpu::ShaderStages::FRAGMENT,
            },
            ty: wgpu::BindingType::Buffer {
                ty: match binding {
                    0 => wgpu::BufferBindingType::Uniform,
                    _ => wgpu::BufferBindingType::Storage { read_only: true },
                },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let slots: Vec<_> = (0..=BUFFERS as u32).map(slot).collect();
        let device = context.device();
        context.guarded(
            || format!("the stages that draw with {samples} samples"),
            || {
                let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some("raster"),
                    source: wgpu::ShaderSource::Wgsl(WGSL.into()),
                });
                let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                    label: Some("raster"),
                    entries: &slots,
                });
                let pipeline_layout =
                    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                        label: Some("raster"),
                        bind_group_layouts: &[Some(&layout)],
                        immediate_size: 0,
                    });
                let target = Some(wgpu::ColorTargetState {
                    format: FORMAT,
                    blend: None,
                    write_mask: wgpu::ColorWrites::ALL,
                });
                let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                    label: Some("raster"),
                    layout: Some(&pipeline_layout),
                    vertex: wgpu::VertexState {
                        module: &module,
                        entry_point: Some("place_corner"),
                        compilation_options: wgpu::PipelineCompilationOptions::default(),
                        buffers: &[],
                    },
                    // Triangles have two sides, as for rays.
                    primitive: wgpu::PrimitiveState::default(),
                    // Reversed: with the eye at 1, floats are as fine as they are coarse.
                    depth_stencil: Some(wgpu::DepthStencilState {
                        format: DEPTH,
                        depth_write_enabled: Some(true),
                        depth_compare: Some(wgpu::CompareFunction::Greater),
                        stencil: wgpu::StencilState::default(),
                        bias: wgpu::DepthBiasState::default(),
                    }),
                    multisample: wgpu::MultisampleState {
                        count: samples,
                        ..wgpu::MultisampleState::default()
                    },
                    fragment: Some(wgpu::FragmentState {
                        module: &module,
                        entry_point: Some(match is_see_through {
                            true => "shade_kept_layers",
                            false => "shade_layers",
                        }),
                        compilation_options: wgpu::PipelineCompilationOptions::default(),
                        targets: &[target.clone(), target.clone(), target],
                    }),
                    multiview_mask: None,
                    cache: None,
                });
                let params = device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("raster params"),
                    size: size_of::<RasterParams>() as u64,
                    usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                Self {
                    pipeline,
                    layout,
                    params,
                }
            },
        )
    }

    /// Draws `triangles` triangles of the buffers into the targets.
    pub(super) fn record(
        &self,
        recording: &mut Recording<'_>,
        targets: &Targets,
        params: &RasterParams,
        buffers: [&GpuBuffer; BUFFERS],
        triangles: u32,
    ) -> Result<(), GpuError> {
        let context = recording.context();
        let most = context.max_binding_bytes();
        for buffer in buffers {
            if buffer.len() > most {
                let limit = "max_storage_buffer_binding_size";
                let what = format!("'{}' to draw", buffer.label());
                return Err(context.limit_error(what, buffer.len(), limit, most));
            }
        }
        let raw = buffers.iter().map(|buffer| buffer.raw());
        let each = (0..).zip(std::iter::once(&self.params).chain(raw));
        let bound: Vec<_> = each
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let bind_group = context.guarded(
            || "the arguments of drawing".to_owned(),
            || {
                context
                    .queue()
                    .write_buffer(&self.params, 0, bytemuck::bytes_of(params));
                context
                    .device()
                    .create_bind_group(&wgpu::BindGroupDescriptor {
                        label: Some("raster"),
                        layout: &self.layout,
                        entries: &bound,
                    })
            },
        )?;
        let attachments = targets.attachments();
        let mut pass = recording
            .encoder()
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("raster"),
                color_attachments: &attachments,
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &targets.depth,
                    depth_ops: Some(wgpu::Operations {
                        load: wgpu::LoadOp::Clear(0.0),
                        store: wgpu::StoreOp::Discard,
                    }),
                    stencil_ops: None,
                }),
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.draw(0..3 * triangles, 0..1);
        Ok(())
    }
}

/// What a frame is drawn into.
#[derive(Debug)]
pub(super) struct Targets {
    size: UVec2,
    /// One sample a pixel: drawn into, or what several samples are resolved to.
    layers: [(wgpu::Texture, wgpu::TextureView); LAYERS],
    /// Where there are several.
    sampled: Option<[wgpu::TextureView; LAYERS]>,
    depth: wgpu::TextureView,
}

impl Targets {
    pub(super) fn new(context: &GpuContext, size: UVec2, samples: u32) -> Result<Self, GpuError> {
        let most = context.limits().max_texture_dimension_2d;
        if size.max_element() > most {
            let (limit, needed) = ("max_texture_dimension_2d", size.max_element().into());
            let what = "an image that is drawn".to_owned();
            return Err(context.limit_error(what, needed, limit, most.into()));
        }
        let texture = |label, format, samples, usage| {
            context.device().create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: extent(size),
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let view =
            |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        context.guarded(
            || format!("the layers of an image of {} × {} pixels", size.x, size.y),
            || Self {
                size,
                layers: [(); LAYERS].map(|()| {
                    let usage = drawn | wgpu::TextureUsages::COPY_SRC;
                    let layer = texture("layer", FORMAT, 1, usage);
                    let view = view(&layer);
                    (layer, view)
                }),
                sampled: (samples > 1).then(|| {
                    [(); LAYERS].map(|()| view(&texture("samples", FORMAT, samples, drawn)))
                }),
                depth: view(&texture("depth", DEPTH, samples, drawn)),
            },
        )
    }

    fn attachments(&self) -> [Option<wgpu::RenderPassColorAttachment<'_>>; LAYERS] {
        std::array::from_fn(|i| {
            let resolved = &self.layers[i].1;
            let (view, resolve_target) = match &self.sampled {
                Some(sampled) => (&sampled[i], Some(resolved)),
                None => (resolved, None),
            };
            let store = match resolve_target {
                Some(_) => wgpu::StoreOp::Discard,
                None => wgpu::StoreOp::Store,
            };
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store,
                },
            })
        })
    }

    /// Values from one row to the next in [`Targets::copy_rows`].
    pub(super) fn pitch(&self) -> u32 {
        pitch(self.size.x)
    }

    /// Copies rows `first .. first + rows` of each layer to the start of its buffer.
    pub(super) fn copy_rows(
        &self,
        recording: &mut Recording<'_>,
        first: u32,
        rows: u32,
        to: &[GpuVec<UVec2>; LAYERS],
    ) {
        for ((texture, _), buffer) in self.layers.iter().zip(to) {
            recording.encoder().copy_texture_to_buffer(
                wgpu::TexelCopyTextureInfo {
                    texture,
                    mip_level: 0,
                    origin: wgpu::Origin3d {
                        x: 0,
                        y: first,
                        z: 0,
                    },
                    aspect: wgpu::TextureAspect::All,
                },
                wgpu::TexelCopyBufferInfo {
                    buffer: buffer.raw(),
                    layout: wgpu::TexelCopyBufferLayout {
                        offset: 0,
                        bytes_per_row: Some(self.pitch() * PIXEL as u32),
                        rows_per_image: None,
                    },
                },
                extent(UVec2::new(self.size.x, rows)),
            );
        }
    }
}

/// Values of a row of so many pixels where a texture is copied to a buffer.
pub(super) fn pitch(width: u32) -> u32 {
    width.next_multiple_of((ROW_ALIGNMENT / PIXEL) as u32)
}

fn extent(size: UVec2) -> wgpu::Extent3d {
    wgpu::Extent3d {
        width: size.x,
        height: size.y,
        depth_or_array_layers: 1,
    }
}
