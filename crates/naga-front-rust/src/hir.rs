//! What the checker makes of a function body: names resolved, sugar gone, every expression with its type.
//!
//! Types may hold inference variables until the body is done; readers put them in with [`Body::ty`].

use crate::diag::Span;
use crate::items::FnId;
use crate::ty::{Substs, Table, Ty};

pub(crate) type LocalId = usize;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lit {
    F32(f32),
    I32(i32),
    U32(u32),
    Bool(bool),
}

/// A function with its generic arguments: what is lowered once.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Instance {
    pub(crate) id: FnId,
    pub(crate) substs: Substs,
    pub(crate) self_ty: Option<Ty>,
}

#[derive(Clone, Debug)]
pub(crate) struct Local {
    pub(crate) name: String,
    pub(crate) ty: Ty,
    pub(crate) mutable: bool,
}

#[derive(Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) params: Vec<LocalId>,
    pub(crate) locals: Vec<Local>,
    pub(crate) ret: Ty,
    pub(crate) value: Expr,
    pub(crate) table: Table,
    pub(crate) span: Span,
}

impl Body {
    /// The finished type: an integer that nothing constrained is `i32`.
    pub(crate) fn ty(&self, ty: &Ty) -> Ty {
        default_ints(&self.table.zonk(ty))
    }
}

fn default_ints(ty: &Ty) -> Ty {
    let all = |v: &[Ty]| v.iter().map(default_ints).collect();
    match ty {
        Ty::IntVar(_) => Ty::I32,
        Ty::Array(t, n) => Ty::Array(Box::new(default_ints(t)), n.clone()),
        Ty::Slice(t) => Ty::Slice(Box::new(default_ints(t))),
        Ty::RefMut(t) => Ty::RefMut(Box::new(default_ints(t))),
        Ty::Option(t) => Ty::Option(Box::new(default_ints(t))),
        Ty::Tuple(v) => Ty::Tuple(all(v)),
        Ty::Struct(id, v) => Ty::Struct(*id, all(v)),
        t => t.clone(),
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Expr {
    pub(crate) kind: Kind,
    pub(crate) ty: Ty,
    pub(crate) span: Span,
}

impl Expr {
    /// Refuses to change what a const gives: Rust would change a copy.
    pub(crate) fn no_const(&self) -> crate::diag::R<()> {
        match &self.kind {
            Kind::Field(base, _) | Kind::Component(base, _) | Kind::Index(base, _) => {
                base.no_const()
            }
            Kind::Const(_) => Err(crate::diag::err(
                self.span,
                "a const cannot be changed: Rust would change a copy",
                "bind it with `let mut` first",
            )),
            _ => Ok(()),
        }
    }

    /// Whether nothing notices when it is computed: no call, no assignment, no control flow.
    pub(crate) fn is_quiet(&self) -> bool {
        self.computes(true)
    }

    /// Whether it can be computed where Rust would not: quiet, and nothing that may lie outside its bounds.
    pub(crate) fn is_pure(&self) -> bool {
        self.computes(false)
    }

    fn computes(&self, may_index: bool) -> bool {
        let all = |list: &[Expr]| list.iter().all(|e| e.computes(may_index));
        match &self.kind {
            Kind::Lit(_)
            | Kind::Int(_)
            | Kind::Unit
            | Kind::Local(_)
            | Kind::Const(_)
            | Kind::None => true,
            Kind::Field(e, _)
            | Kind::Component(e, _)
            | Kind::Deref(e)
            | Kind::Unary(_, e)
            | Kind::Cast(e)
            | Kind::Len(e)
            | Kind::Some(e)
            | Kind::Repeat(e, _) => e.computes(may_index),
            Kind::Index(a, b) => may_index && a.computes(true) && b.computes(true),
            Kind::Binary(_, a, b) | Kind::AndAnd(a, b) | Kind::OrOr(a, b) => {
                a.computes(may_index) && b.computes(may_index)
            }
            Kind::Builtin(_, list) | Kind::Tuple(list) | Kind::Array(list) => all(list),
            _ => false,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BinOp {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

impl BinOp {
    /// As it is written.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            BinOp::Add => "+",
            BinOp::Sub => "-",
            BinOp::Mul => "*",
            BinOp::Div => "/",
            BinOp::Rem => "%",
            BinOp::And => "&",
            BinOp::Or => "|",
            BinOp::Xor => "^",
            BinOp::Shl => "<<",
            BinOp::Shr => ">>",
            BinOp::Eq => "==",
            BinOp::Ne => "!=",
            BinOp::Lt => "<",
            BinOp::Le => "<=",
            BinOp::Gt => ">",
            BinOp::Ge => ">=",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnOp {
    Neg,
    Not,
}

#[derive(Clone, Debug)]
pub(crate) enum Kind {
    Lit(Lit),
    /// An integer literal whose type is not known yet.
    Int(u32),
    Unit,
    Local(LocalId),
    /// A `const` item or an associated const, by its checked value.
    Const(ConstKey),
    /// Field of a struct or a tuple.
    Field(Box<Expr>, usize),
    /// Component of a vector or column of a matrix.
    Component(Box<Expr>, u32),
    Index(Box<Expr>, Box<Expr>),
    SubSlice(Box<Expr>, Option<Box<Expr>>, Option<Box<Expr>>),
    Len(Box<Expr>),
    RefMut(Box<Expr>),
    Deref(Box<Expr>),
    /// Fields in the order in which they are evaluated; then `..base`.
    Struct(Vec<(usize, Expr)>, Option<Box<Expr>>),
    Tuple(Vec<Expr>),
    Array(Vec<Expr>),
    Repeat(Box<Expr>, u32),
    Some(Box<Expr>),
    None,
    Unary(UnOp, Box<Expr>),
    Binary(BinOp, Box<Expr>, Box<Expr>),
    AndAnd(Box<Expr>, Box<Expr>),
    OrOr(Box<Expr>, Box<Expr>),
    Cast(Box<Expr>),
    Builtin(Builtin, Vec<Expr>),
    Call(Instance, Vec<Expr>),
    Block(Vec<Stmt>, Option<Box<Expr>>),
    If(Box<Expr>, Box<Expr>, Option<Box<Expr>>),
    /// `let PAT = EXPR` in a condition: true where it matches, and binds.
    Let(Box<Pat>, Box<Expr>),
    Match(Box<Expr>, Vec<Arm>),
    Loop(Box<Expr>),
    ForRange {
        pat: Box<Pat>,
        lo: Box<Expr>,
        hi: Box<Expr>,
        inclusive: bool,
        body: Box<Expr>,
    },
    Break(Option<Box<Expr>>),
    Continue,
    Return(Option<Box<Expr>>),
    Assign(Box<Expr>, Box<Expr>),
    AssignOp(BinOp, Box<Expr>, Box<Expr>),
}

#[derive(Clone, Debug)]
pub(crate) struct Arm {
    pub(crate) pat: Pat,
    pub(crate) guard: Option<Expr>,
    pub(crate) body: Expr,
}

#[derive(Clone, Debug)]
pub(crate) enum Stmt {
    Expr(Expr),
    Let {
        pat: Pat,
        init: Option<Box<Expr>>,
        otherwise: Option<Box<Expr>>,
        span: Span,
    },
}

#[derive(Clone, Debug)]
pub(crate) enum Pat {
    Wild,
    Bind(LocalId),
    /// `name @ pattern`.
    At(LocalId, Box<Pat>),
    /// A literal or a const, of the scrutinee's type.
    Value(Box<Expr>),
    /// From, to, whether the end is included; open ends are `None`.
    Range(Option<Box<Expr>>, Option<Box<Expr>>, bool),
    Variant(u32),
    Some(Box<Pat>),
    None,
    /// Fields of a tuple or struct.
    Fields(Vec<(usize, Pat)>),
    Or(Vec<Pat>),
}

/// Which const, for which types.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct ConstKey {
    pub(crate) id: usize,
    pub(crate) substs: Substs,
    pub(crate) self_ty: Option<Ty>,
}

/// Operations that the language, core, libm and glam give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Builtin {
    Math(naga::MathFunction),
    /// Compose the result type from the arguments (vector or matrix).
    Compose,
    Splat,
    Swizzle([u8; 4], u8),
    /// Bit pattern as the result type.
    Bitcast,
    /// Componentwise `as`.
    Convert,
    /// `1 / x`, componentwise.
    Recip,
    ElementSum,
    ElementProduct,
    MinElement,
    MaxElement,
    /// The sign bits of a vector's components, the first component's in bit 0.
    SignMask,
    LengthSquared,
    DistanceSquared,
    Lerp,
    MulAdd,
    Copysign,
    SaturatingAdd,
    SaturatingSub,
    AbsDiff,
    RotateLeft,
    RotateRight,
    DivCeil,
    IsPowerOfTwo,
    IsSome,
    IsNone,
    UnwrapOr,
    /// A vector with one component replaced.
    With(u32),
    /// Drop the last component.
    Truncate,
    /// A diagonal matrix from a vector.
    FromDiagonal,
    ToArray,
    FromArray,
    Ldexp,
    /// `a * b`, `a + b`, `a - b` with wrapping, and shifts: the plain operator.
    Op(BinOp),
    WrappingNeg,
    IsEmpty,
}
