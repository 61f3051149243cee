//! Name resolution: what a path stands for, in a module. Ambiguity is an error, never a choice.

use std::collections::HashSet;

use crate::builtins;
use crate::diag::{R, Span, err};
use crate::items::{Def, Items, ModId, Named, Target};

/// Rust's two namespaces that matter here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Ns {
    Type,
    Value,
}

impl Items {
    fn in_ns(&self, def: &Def, ns: Ns) -> bool {
        match def {
            Def::Mod(_) | Def::Enum(_) | Def::Trait(_) | Def::Alias(_) => ns == Ns::Type,
            Def::Struct(id) => {
                ns == Ns::Type || !matches!(self.structs[*id].item.fields, syn::Fields::Named(_))
            }
            Def::Fn(_) | Def::Const(_) | Def::Variant(..) => ns == Ns::Value,
            Def::Extern(_) => true,
        }
    }

    /// Resolves a path of plain names, starting in `module`.
    pub(crate) fn resolve(&self, module: ModId, path: &[String], ns: Ns, span: Span) -> R<Def> {
        match self.find(module, path, ns, span, &mut HashSet::new())? {
            Some(def) => Ok(def),
            None => Err(err(
                span,
                format!(
                    "cannot find `{}` among the files given to the front end",
                    path.join("::")
                ),
                "hand its file to the front end, import it, or write a path that names its module",
            )),
        }
    }

    /// As [`Items::resolve`], with `None` where nothing has that name.
    pub(crate) fn find(
        &self,
        module: ModId,
        path: &[String],
        ns: Ns,
        span: Span,
        busy: &mut HashSet<(ModId, String, Ns)>,
    ) -> R<Option<Def>> {
        let (mut at, mut rest) = match path[0].as_str() {
            "crate" => (Some(Def::Mod(self.modules[module].krate)), &path[1..]),
            "self" => (Some(Def::Mod(self.written(module))), &path[1..]),
            "super" => {
                let up = |m: ModId| self.modules[m].parent;
                let mut m = up(self.written(module));
                let mut rest = &path[1..];
                while rest.first().is_some_and(|s| s == "super") {
                    m = m.and_then(up);
                    rest = &rest[1..];
                }
                (m.map(Def::Mod), rest)
            }
            "" => (self.extern_crate(&path[1]), &path[2..]),
            first => {
                let head = if path.len() == 1 { ns } else { Ns::Type };
                let mut found = self.lookup(module, first, head, span, busy)?;
                let mut outer = module;
                while let (None, true, Some(parent)) = (
                    &found,
                    self.modules[outer].block,
                    self.modules[outer].parent,
                ) {
                    found = self.lookup(parent, first, head, span, busy)?;
                    outer = parent;
                }
                let found = match found {
                    Some(def) => Some(def),
                    None => self.extern_crate(first),
                };
                (found, &path[1..])
            }
        };
        while let (Some(def), Some(next)) = (&at, rest.first()) {
            let ns = if rest.len() == 1 { ns } else { Ns::Type };
            at = match def {
                Def::Mod(m) => self.lookup(*m, next, ns, span, busy)?,
                Def::Extern(prefix) => Some(Def::Extern(format!("{prefix}::{next}"))),
                Def::Enum(id) => self.variant(*id, next).map(|v| Def::Variant(*id, v)),
                Def::Alias(id) => {
                    let alias = &self.aliases[*id];
                    match alias_path(&alias.item.ty) {
                        Some(path) => {
                            let target = self.find(alias.module, &path, Ns::Type, span, busy)?;
                            match target {
                                Some(Def::Enum(e)) => {
                                    self.variant(e, next).map(|v| Def::Variant(e, v))
                                }
                                _ => None,
                            }
                        }
                        None => None,
                    }
                }
                _ => None,
            };
            rest = &rest[1..];
        }
        Ok(at)
    }

    /// Why a name that `module` does not define itself cannot be looked for further: rustc might find it here.
    fn unknown_import(
        &self,
        module: ModId,
        name: &str,
        span: Span,
        busy: &mut HashSet<(ModId, String, Ns)>,
    ) -> R<Option<String>> {
        // Nobody's macro or glob takes the names that everybody uses.
        const PLAIN: [&str; 12] = [
            "f32", "i32", "u32", "usize", "bool", "Option", "Some", "None", "glam", "libm", "core",
            "std",
        ];
        let m = &self.modules[module];
        if PLAIN.contains(&name) && !m.names.contains_key(name) {
            return Ok(None);
        }
        for named in m.names.get(name).into_iter().flatten() {
            if let Target::Use(path) = &named.target {
                let mut leads = false;
                for ns in [Ns::Type, Ns::Value] {
                    leads |= self.find(module, path, ns, span, busy)?.is_some();
                }
                if !leads {
                    return Ok(Some(format!(
                        "`use {}` leads to no file given",
                        path.join("::")
                    )));
                }
            }
        }
        if m.opaque {
            return Ok(Some("a macro call beside it may define it".into()));
        }
        for glob in &m.globs {
            if let Some(gate) = &glob.gate {
                return Ok(Some(format!(
                    "`use {}::*` stands behind {gate}",
                    glob.path.join("::")
                )));
            }
            if m.block
                && self
                    .find(module, &glob.path, Ns::Type, span, busy)?
                    .is_none()
            {
                return Ok(Some(format!(
                    "`use {}::*` leads to no file given",
                    glob.path.join("::")
                )));
            }
        }
        Ok(None)
    }

    /// Whether a glob in `to` sees `name` of module `from`: public names, and private ones below it.
    fn shows(&self, from: ModId, name: &str, to: ModId) -> bool {
        if self.is_below(to, from) {
            return true;
        }
        match self.modules[from].names.get(name) {
            Some(list) => list.iter().any(|n| n.public),
            None => true,
        }
    }

    /// Whether `inner` is `outer` or below it.
    pub(crate) fn is_below(&self, inner: ModId, outer: ModId) -> bool {
        let mut at = Some(inner);
        while let Some(m) = at {
            if m == outer {
                return true;
            }
            at = self.modules[m].parent;
        }
        false
    }

    /// The path by which `module` imports `name`, whether it leads anywhere or not.
    pub(crate) fn import_of(&self, module: ModId, name: &str) -> Option<String> {
        let mut at = Some(module);
        while let Some(m) = at {
            for named in self.modules[m].names.get(name).into_iter().flatten() {
                if let Target::Use(path) = &named.target {
                    return Some(path.join("::"));
                }
            }
            at = self.modules[m].parent.filter(|_| self.modules[m].block);
        }
        None
    }

    /// The module that is written in the source around a function body's items.
    fn written(&self, mut module: ModId) -> ModId {
        while let (true, Some(parent)) = (self.modules[module].block, self.modules[module].parent) {
            module = parent;
        }
        module
    }

    fn variant(&self, id: usize, name: &str) -> Option<u32> {
        let at = self.enums[id]
            .item
            .variants
            .iter()
            .position(|v| v.ident == name)?;
        Some(at as u32)
    }

    fn extern_crate(&self, name: &str) -> Option<Def> {
        if let Some(root) = self.crates.get(name) {
            return Some(Def::Mod(*root));
        }
        match name {
            "glam" | "libm" | "core" => Some(Def::Extern(name.to_string())),
            "std" => Some(Def::Extern("core".to_string())),
            _ => None,
        }
    }

    /// A name as seen from inside a module.
    fn lookup(
        &self,
        module: ModId,
        name: &str,
        ns: Ns,
        span: Span,
        busy: &mut HashSet<(ModId, String, Ns)>,
    ) -> R<Option<Def>> {
        if !busy.insert((module, name.to_string(), ns)) {
            return Ok(None);
        }
        let mut found: Vec<Def> = Vec::new();
        let mut refused = None;
        for named in self.modules[module].names.get(name).into_iter().flatten() {
            match self.target(module, named, ns, span, busy)? {
                _ if named.gate.is_some() => refused = named.gate.clone(),
                Some(def) if !found.contains(&def) => found.push(def),
                Some(_) => {}
                None => match &named.target {
                    Target::Absent if ns == Ns::Type => {
                        refused = Some(format!("mod {name}; (no such file given)"));
                    }
                    Target::Unsupported(what) => refused = Some((*what).to_string()),
                    _ => {}
                },
            }
        }
        if let (true, Some(why)) = (found.is_empty(), &refused) {
            busy.remove(&(module, name.to_string(), ns));
            return Err(err(
                span,
                format!("`{name}` is host code here: {why}"),
                "shared code reaches only items without `cfg`, in files handed to the front end",
            ));
        }
        if let (false, Some(why)) = (found.is_empty(), refused) {
            return Err(err(
                span,
                format!("`{name}` is ambiguous: one of its definitions is {why}"),
                "shared code carries no `cfg`: give the variants different names",
            ));
        }
        if found.is_empty() {
            let beyond = self.unknown_import(module, name, span, busy)?;
            if let Some(why) = beyond {
                busy.remove(&(module, name.to_string(), ns));
                return Err(err(
                    span,
                    format!("cannot tell what `{name}` is here: {why}"),
                    "import it by name, from a file that is handed to the front end",
                ));
            }
            for glob in &self.modules[module].globs {
                let target = self.find(module, &glob.path, Ns::Type, span, busy)?;
                let def = match target {
                    Some(Def::Extern(prefix)) => {
                        let full = format!("{prefix}::{name}");
                        builtins::is_known_extern(&full).then_some(Def::Extern(full))
                    }
                    Some(Def::Mod(from)) if !self.shows(from, name, module) => None,
                    Some(_) => {
                        let mut path = glob.path.clone();
                        path.push(name.to_string());
                        self.find(module, &path, ns, span, busy)?
                    }
                    None => None,
                };
                if let Some(def) = def.filter(|d| self.in_ns(d, ns))
                    && !found.contains(&def)
                {
                    found.push(def);
                }
            }
        }
        busy.remove(&(module, name.to_string(), ns));
        if found.len() > 1 {
            return Err(err(
                span,
                format!(
                    "`{name}` is ambiguous: it has {} meanings here",
                    found.len()
                ),
                "write the whole path, or import one of them by name",
            ));
        }
        Ok(found.pop())
    }

    fn target(
        &self,
        module: ModId,
        named: &Named,
        ns: Ns,
        span: Span,
        busy: &mut HashSet<(ModId, String, Ns)>,
    ) -> R<Option<Def>> {
        let def = match &named.target {
            Target::Def(def) => Some(def.clone()),
            Target::Use(path) => self.find(module, path, ns, span, busy)?,
            Target::Absent | Target::Unsupported(_) => None,
        };
        Ok(def.filter(|d| self.in_ns(d, ns)))
    }
}

/// The names of a plain path type.
fn alias_path(ty: &syn::Type) -> Option<Vec<String>> {
    match ty {
        syn::Type::Path(p) if p.qself.is_none() => Some(
            p.path
                .segments
                .iter()
                .map(|s| s.ident.to_string())
                .collect(),
        ),
        _ => None,
    }
}
