//! From [`hir`](crate::hir) to naga IR.
//!
//! Each function instance becomes one naga function. A slice never becomes a value there: which buffer it is part of is
//! known while lowering (its [`Shape`]), and only its start and length, where they are not the whole buffer's, travel
//! as numbers. So a function that takes slices is lowered once for each combination of buffers.

mod builtin;
mod control;
mod expr;
mod function;
mod place;
mod tables;
mod types;

use std::collections::HashMap;
use std::rc::Rc;

use naga::{Expression, Handle};

use crate::check::{check_const, check_fn};
use crate::diag::{R, Span, err};
use crate::hir::{Body, ConstKey, Instance};
use crate::items::Items;
use crate::ty::Ty;

pub(crate) use function::FnLowerer;

/// The name of the variable whose stores mark source lines.
pub(crate) fn marker() -> &'static str {
    function::MARKER
}

pub(crate) type H = Handle<Expression>;

/// A buffer that slices are part of.
#[derive(Clone, Debug)]
pub(crate) struct Global {
    pub(crate) handle: Handle<naga::GlobalVariable>,
}

/// A part of a buffer; the whole of it where there is no extent.
#[derive(Clone, Debug)]
pub(crate) struct SliceVal {
    pub(crate) global: usize,
    /// Start and length.
    pub(crate) extent: Option<(H, H)>,
}

/// What an expression has become.
#[derive(Clone, Debug)]
pub(crate) enum Val {
    /// `()`, or the value of what never ends.
    Unit,
    Plain(H),
    /// `&mut T`.
    Ptr(H),
    Slice(SliceVal),
    /// A struct or tuple that holds slices.
    Parts(Vec<Val>),
}

/// What is known of a value while lowering.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shape {
    Unit,
    Plain,
    Ptr,
    Slice { global: usize, whole: bool },
    Parts(Vec<Shape>),
}

impl Val {
    pub(crate) fn shape(&self) -> Shape {
        match self {
            Val::Unit => Shape::Unit,
            Val::Plain(_) => Shape::Plain,
            Val::Ptr(_) => Shape::Ptr,
            Val::Slice(s) => Shape::Slice {
                global: s.global,
                whole: s.extent.is_none(),
            },
            Val::Parts(list) => Shape::Parts(list.iter().map(Val::shape).collect()),
        }
    }

    /// The numbers that travel, in order.
    pub(crate) fn flatten(&self, out: &mut Vec<H>) {
        match self {
            Val::Unit => {}
            Val::Plain(h) | Val::Ptr(h) => out.push(*h),
            Val::Slice(s) => {
                if let Some((start, len)) = s.extent {
                    out.push(start);
                    out.push(len);
                }
            }
            Val::Parts(list) => list.iter().for_each(|v| v.flatten(out)),
        }
    }
}

impl Shape {
    /// The value of this shape whose numbers `next` gives, in order.
    pub(crate) fn build(&self, next: &mut impl FnMut() -> H) -> Val {
        match self {
            Shape::Unit => Val::Unit,
            Shape::Plain => Val::Plain(next()),
            Shape::Ptr => Val::Ptr(next()),
            Shape::Slice { global, whole } => Val::Slice(SliceVal {
                global: *global,
                extent: if *whole {
                    None
                } else {
                    let start = next();
                    Some((start, next()))
                },
            }),
            Shape::Parts(list) => Val::Parts(list.iter().map(|s| s.build(next)).collect()),
        }
    }
}

/// A function that was lowered.
#[derive(Clone, Debug)]
pub(crate) struct Lowered {
    pub(crate) handle: Handle<naga::Function>,
    pub(crate) ret: Shape,
    pub(crate) ret_ty: Ty,
}

/// A module being made.
pub(crate) struct Lowerer<'p> {
    pub(crate) items: &'p Items,
    pub(crate) module: naga::Module,
    pub(crate) globals: Vec<Global>,
    /// Write line markers, and where functions stand, for the WGSL's comments.
    pub(crate) markers: bool,
    functions: HashMap<(Instance, Vec<Shape>), Lowered>,
    busy: Vec<Instance>,
    bodies: HashMap<Instance, Rc<Body>>,
    consts: HashMap<ConstKey, Rc<Body>>,
    tables: HashMap<ConstKey, Handle<naga::GlobalVariable>>,
    types: HashMap<Ty, Handle<naga::Type>>,
    fields: HashMap<Ty, Vec<Ty>>,
    layouter: naga::proc::Layouter,
    /// The structs that lie in buffers.
    pub(crate) buffer_structs: std::collections::BTreeMap<String, crate::StructLayout>,
}

impl<'p> Lowerer<'p> {
    pub(crate) fn new(items: &'p Items, markers: bool) -> Self {
        Lowerer {
            items,
            module: naga::Module::default(),
            globals: Vec::new(),
            markers,
            functions: HashMap::new(),
            busy: Vec::new(),
            bodies: HashMap::new(),
            consts: HashMap::new(),
            tables: HashMap::new(),
            types: HashMap::new(),
            fields: HashMap::new(),
            layouter: naga::proc::Layouter::default(),
            buffer_structs: std::collections::BTreeMap::new(),
        }
    }

    pub(crate) fn body(&mut self, instance: &Instance) -> R<Rc<Body>> {
        if let Some(body) = self.bodies.get(instance) {
            return Ok(body.clone());
        }
        let body = Rc::new(check_fn(self.items, instance)?);
        self.bodies.insert(instance.clone(), body.clone());
        Ok(body)
    }

    fn const_body(&mut self, key: &ConstKey) -> R<Rc<Body>> {
        if let Some(body) = self.consts.get(key) {
            return Ok(body.clone());
        }
        let body = Rc::new(check_const(self.items, key)?);
        self.consts.insert(key.clone(), body.clone());
        Ok(body)
    }

    /// Lowers an instance for arguments of the given shapes, once. `at` is the call.
    pub(crate) fn function(
        &mut self,
        instance: &Instance,
        shapes: &[Shape],
        name: Option<&str>,
        at: Span,
    ) -> R<Lowered> {
        let key = (instance.clone(), shapes.to_vec());
        if let Some(done) = self.functions.get(&key) {
            return Ok(done.clone());
        }
        if self.busy.contains(instance) {
            return Err(err(
                at,
                format!(
                    "`{}` calls itself, directly or by way of others",
                    self.items.fns[instance.id].sig.ident
                ),
                "WGSL has no recursion: write a loop, with an array as its stack",
            ));
        }
        self.busy.push(instance.clone());
        let body = self.body(instance)?;
        let lowered = FnLowerer::lower(self, body, shapes, name)?;
        self.busy.pop();
        self.functions.insert(key, lowered.clone());
        Ok(lowered)
    }
}
