//! Types of the subset and their unification.

use std::fmt;

use crate::items::Items;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Scalar {
    F32,
    I32,
    U32,
}

/// A type. References to immutable things are erased: `&T` is `T`, `&[T]` is a slice.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Ty {
    Unit,
    Never,
    Bool,
    F32,
    I32,
    U32,
    Usize,
    Vec(Scalar, u8),
    Mat(u8),
    Array(Box<Ty>, Box<Ty>),
    Slice(Box<Ty>),
    RefMut(Box<Ty>),
    Tuple(Vec<Ty>),
    Option(Box<Ty>),
    Struct(usize, Vec<Ty>),
    Enum(usize),
    /// A const generic argument.
    Const(u32),
    /// To be inferred.
    Var(u32),
    /// An integer literal's type, to be inferred.
    IntVar(u32),
    /// A float literal's type: f32, or f64, which is refused.
    FloatVar(u32),
}

impl Ty {
    pub(crate) fn is_int(&self) -> bool {
        matches!(self, Ty::I32 | Ty::U32 | Ty::Usize | Ty::IntVar(_))
    }

    pub(crate) fn is_unsigned(&self) -> bool {
        matches!(self, Ty::U32 | Ty::Usize)
    }

    pub(crate) fn is_number(&self) -> bool {
        self.is_int() || matches!(self, Ty::F32 | Ty::FloatVar(_))
    }

    /// The scalar of a number or of a vector's components.
    pub(crate) fn scalar(&self) -> Option<Scalar> {
        match self {
            Ty::F32 => Some(Scalar::F32),
            Ty::I32 => Some(Scalar::I32),
            Ty::U32 | Ty::Usize => Some(Scalar::U32),
            Ty::Vec(s, _) => Some(*s),
            _ => None,
        }
    }

    pub(crate) fn of_scalar(s: Scalar) -> Ty {
        match s {
            Scalar::F32 => Ty::F32,
            Scalar::I32 => Ty::I32,
            Scalar::U32 => Ty::U32,
        }
    }

    /// Whether something in it is still to be inferred.
    pub(crate) fn is_open(&self) -> bool {
        match self {
            Ty::Var(_) | Ty::IntVar(_) | Ty::FloatVar(_) => true,
            Ty::Array(t, n) => t.is_open() || n.is_open(),
            Ty::Slice(t) | Ty::RefMut(t) | Ty::Option(t) => t.is_open(),
            Ty::Tuple(list) | Ty::Struct(_, list) => list.iter().any(Ty::is_open),
            _ => false,
        }
    }

    /// Behind `&mut`, if it is one.
    pub(crate) fn behind(&self) -> &Ty {
        match self {
            Ty::RefMut(t) => t,
            t => t,
        }
    }

    pub(crate) fn show(&self, items: &Items) -> String {
        let list = |v: &[Ty]| {
            v.iter()
                .map(|t| t.show(items))
                .collect::<Vec<_>>()
                .join(", ")
        };
        match self {
            Ty::Unit => "()".into(),
            Ty::Never => "!".into(),
            Ty::Bool => "bool".into(),
            Ty::F32 => "f32".into(),
            Ty::I32 => "i32".into(),
            Ty::U32 => "u32".into(),
            Ty::Usize => "usize".into(),
            Ty::Vec(Scalar::F32, n) => format!("Vec{n}"),
            Ty::Vec(Scalar::I32, n) => format!("IVec{n}"),
            Ty::Vec(Scalar::U32, n) => format!("UVec{n}"),
            Ty::Mat(n) => format!("Mat{n}"),
            Ty::Array(t, n) => format!("[{}; {}]", t.show(items), n.show(items)),
            Ty::Slice(t) => format!("[{}]", t.show(items)),
            Ty::RefMut(t) => format!("&mut {}", t.show(items)),
            Ty::Tuple(v) => format!("({})", list(v)),
            Ty::Option(t) => format!("Option<{}>", t.show(items)),
            Ty::Struct(id, args) if args.is_empty() => items.structs[*id].item.ident.to_string(),
            Ty::Struct(id, args) => format!("{}<{}>", items.structs[*id].item.ident, list(args)),
            Ty::Enum(id) => items.enums[*id].item.ident.to_string(),
            Ty::Const(n) => n.to_string(),
            Ty::Var(_) => "_".into(),
            Ty::IntVar(_) => "{integer}".into(),
            Ty::FloatVar(_) => "{float}".into(),
        }
    }
}

/// Generic arguments by the names of their parameters.
pub(crate) type Substs = Vec<(String, Ty)>;

/// A unification that failed.
#[derive(Debug)]
pub(crate) struct Mismatch;

/// The inference variables of one function body.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    vars: Vec<Option<Ty>>,
}

impl Table {
    pub(crate) fn var(&mut self) -> Ty {
        self.vars.push(None);
        Ty::Var(self.vars.len() as u32 - 1)
    }

    pub(crate) fn int_var(&mut self) -> Ty {
        self.vars.push(None);
        Ty::IntVar(self.vars.len() as u32 - 1)
    }

    pub(crate) fn float_var(&mut self) -> Ty {
        self.vars.push(None);
        Ty::FloatVar(self.vars.len() as u32 - 1)
    }

    /// The type with everything known put in; open variables stay.
    pub(crate) fn zonk(&self, ty: &Ty) -> Ty {
        let all = |v: &[Ty]| v.iter().map(|t| self.zonk(t)).collect();
        match ty {
            Ty::Var(v) | Ty::IntVar(v) | Ty::FloatVar(v) => match &self.vars[*v as usize] {
                Some(t) => self.zonk(t),
                None => ty.clone(),
            },
            Ty::Array(t, n) => Ty::Array(Box::new(self.zonk(t)), Box::new(self.zonk(n))),
            Ty::Slice(t) => Ty::Slice(Box::new(self.zonk(t))),
            Ty::RefMut(t) => Ty::RefMut(Box::new(self.zonk(t))),
            Ty::Option(t) => Ty::Option(Box::new(self.zonk(t))),
            Ty::Tuple(v) => Ty::Tuple(all(v)),
            Ty::Struct(id, v) => Ty::Struct(*id, all(v)),
            t => t.clone(),
        }
    }

    pub(crate) fn unify(&mut self, a: &Ty, b: &Ty) -> Result<(), Mismatch> {
        let (a, b) = (self.zonk(a), self.zonk(b));
        match (&a, &b) {
            (Ty::Never, _) | (_, Ty::Never) => Ok(()),
            _ if a == b => Ok(()),
            (Ty::Var(v), t) | (t, Ty::Var(v)) => {
                self.vars[*v as usize] = Some(t.clone());
                Ok(())
            }
            (Ty::IntVar(v), t) | (t, Ty::IntVar(v)) if t.is_int() => {
                self.vars[*v as usize] = Some(t.clone());
                Ok(())
            }
            (Ty::FloatVar(v), t @ (Ty::F32 | Ty::FloatVar(_))) | (t @ Ty::F32, Ty::FloatVar(v)) => {
                self.vars[*v as usize] = Some(t.clone());
                Ok(())
            }
            (Ty::Array(t, n), Ty::Array(u, m)) => {
                self.unify(t, u)?;
                self.unify(n, m)
            }
            (Ty::Slice(t), Ty::Slice(u))
            | (Ty::RefMut(t), Ty::RefMut(u))
            | (Ty::Option(t), Ty::Option(u)) => self.unify(t, u),
            (Ty::Tuple(v), Ty::Tuple(w)) if v.len() == w.len() => {
                v.iter().zip(w).try_for_each(|(t, u)| self.unify(t, u))
            }
            (Ty::Struct(i, v), Ty::Struct(j, w)) if i == j && v.len() == w.len() => {
                v.iter().zip(w).try_for_each(|(t, u)| self.unify(t, u))
            }
            _ => Err(Mismatch),
        }
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Scalar::F32 => "f32",
            Scalar::I32 => "i32",
            Scalar::U32 => "u32",
        })
    }
}
