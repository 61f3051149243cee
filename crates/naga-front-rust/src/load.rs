//! Takes a crate's files in: `syn` parses them, and their items are sorted into modules.

use std::collections::HashMap;

use crate::diag::{Error, R, Span, err};
use crate::items::{
    AliasItem, ConstItem, Def, EnumItem, File, FnItem, Glob, ImplItem, Items, ModId, Module, Named,
    Owner, StructItem, Target, TraitItem,
};

/// The `cfg` of an item: nothing, `cfg(test)`, or another one.
enum Cfg {
    None,
    Test,
    Other(String),
}

fn cfg_of(attrs: &[syn::Attribute]) -> Cfg {
    for attr in attrs {
        let path = attr.path();
        if path.is_ident("test") {
            return Cfg::Test;
        }
        if path.is_ident("cfg") || path.is_ident("cfg_attr") {
            let text = match &attr.meta {
                syn::Meta::List(list) => list.tokens.to_string(),
                _ => String::new(),
            };
            if path.is_ident("cfg") && text == "test" {
                return Cfg::Test;
            }
            return Cfg::Other(format!(
                "#[{}({text})]",
                if path.is_ident("cfg") {
                    "cfg"
                } else {
                    "cfg_attr"
                }
            ));
        }
    }
    Cfg::None
}

fn cfg_gate(attrs: &[syn::Attribute]) -> Option<String> {
    match cfg_of(attrs) {
        Cfg::Other(text) => Some(text),
        Cfg::None | Cfg::Test => None,
    }
}

fn is_public(vis: &syn::Visibility) -> bool {
    !matches!(vis, syn::Visibility::Inherited)
}

/// One crate's files while they are sorted into modules.
struct Loader<'a> {
    items: &'a mut Items,
    crate_name: &'a str,
    krate: usize,
    parsed: HashMap<String, (usize, Option<syn::File>)>,
}

impl Items {
    /// Parses a crate: `(path below src/, text)` pairs. The root is `lib.rs`, or the only file; where there are
    /// several files and no `lib.rs`, each is a module of the crate.
    pub(crate) fn add_crate(&mut self, name: &str, files: &[(&str, &str)]) -> R<()> {
        if self.crates.contains_key(name) || ["glam", "libm", "core", "std"].contains(&name) {
            return Err(Box::new(Error {
                message: format!("the crate name `{name}` is taken"),
                span: None,
                help: Some("give each crate a name of its own".into()),
                notes: Vec::new(),
            }));
        }
        let mut parsed = HashMap::new();
        for (path, text) in files {
            let file = self.files.len();
            self.files.push(File {
                display: format!("{name}/src/{path}"),
                text: (*text).to_string(),
            });
            let ast = syn::parse_file(text).map_err(|e| {
                let start = e.span().start();
                let span = Span {
                    file,
                    line: start.line,
                    column: start.column,
                    width: 1,
                };
                err(
                    span,
                    format!("cannot parse: {e}"),
                    "the file must compile with rustc first",
                )
            })?;
            parsed.insert((*path).to_string(), (file, Some(ast)));
        }
        let root = self.modules.len();
        self.modules.push(Module {
            krate: root,
            path: name.to_string(),
            ..Module::default()
        });
        self.crates.insert(name.to_string(), root);
        let mut loader = Loader {
            items: self,
            crate_name: name,
            krate: root,
            parsed,
        };
        if loader.parsed.contains_key("lib.rs") {
            loader.file(root, "lib.rs", "")
        } else if let [(only, _)] = files {
            loader.file(root, only, "")
        } else {
            for (path, _) in files {
                let stem = path.trim_end_matches(".rs").to_string();
                let id = loader.child(root, &stem);
                loader.file(id, path, &format!("{stem}/"))?;
            }
            Ok(())
        }
    }

    fn name(&mut self, module: ModId, name: String, target: Target, gate: Option<String>) {
        let public = self.public;
        let entry = Named {
            target,
            public,
            gate,
        };
        self.modules[module]
            .names
            .entry(name)
            .or_default()
            .push(entry);
    }
}

impl Loader<'_> {
    /// A new module; its name is as public as the item that is being taken in.
    fn child(&mut self, parent: ModId, name: &str) -> ModId {
        let id = self.items.modules.len();
        let path = format!("{}::{name}", self.items.modules[parent].path);
        self.items.modules.push(Module {
            krate: self.krate,
            parent: Some(parent),
            path,
            ..Module::default()
        });
        let named = Target::Def(Def::Mod(id));
        self.items.name(parent, name.to_string(), named, None);
        id
    }

    fn file(&mut self, module: ModId, path: &str, dir: &str) -> R<()> {
        let (file, ast) = self
            .parsed
            .get_mut(path)
            .expect("the caller has looked it up");
        let file = *file;
        let ast = ast.take().ok_or_else(|| {
            let span = Span {
                file,
                line: 1,
                column: 0,
                width: 1,
            };
            err(
                span,
                "the file is a module twice",
                "declare each module once",
            )
        })?;
        if let Cfg::Other(text) = cfg_of(&ast.attrs) {
            let span = Span {
                file,
                line: 1,
                column: 0,
                width: 1,
            };
            return Err(err(
                span,
                format!("the whole file stands behind {text}"),
                "hand over shared files only",
            ));
        }
        self.module(module, file, dir, ast.items)
    }

    fn module(&mut self, module: ModId, file: usize, dir: &str, list: Vec<syn::Item>) -> R<()> {
        for item in list {
            self.item(module, file, dir, item)?;
        }
        Ok(())
    }

    fn item(&mut self, module: ModId, file: usize, dir: &str, item: syn::Item) -> R<()> {
        let attrs: &[syn::Attribute] = match &item {
            syn::Item::Const(i) => &i.attrs,
            syn::Item::Enum(i) => &i.attrs,
            syn::Item::Fn(i) => &i.attrs,
            syn::Item::Impl(i) => &i.attrs,
            syn::Item::Mod(i) => &i.attrs,
            syn::Item::Struct(i) => &i.attrs,
            syn::Item::Trait(i) => &i.attrs,
            syn::Item::Type(i) => &i.attrs,
            syn::Item::Use(i) => &i.attrs,
            syn::Item::Static(i) => &i.attrs,
            _ => &[],
        };
        let gate = match cfg_of(attrs) {
            Cfg::Test => return Ok(()),
            Cfg::Other(text) => Some(text),
            Cfg::None => None,
        };
        self.items.public = match &item {
            syn::Item::Const(i) => is_public(&i.vis),
            syn::Item::Enum(i) => is_public(&i.vis),
            syn::Item::Fn(i) => is_public(&i.vis),
            syn::Item::Mod(i) => is_public(&i.vis),
            syn::Item::Struct(i) => is_public(&i.vis),
            syn::Item::Trait(i) => is_public(&i.vis),
            syn::Item::Type(i) => is_public(&i.vis),
            syn::Item::Use(i) => is_public(&i.vis),
            _ => false,
        };
        let it = &mut *self.items;
        match item {
            syn::Item::Fn(mut f) => {
                let public = self.items.public;
                let inner = self.body_items(module, file, &mut f.block)?;
                self.items.public = public;
                let it = &mut *self.items;
                let id = it.fns.len();
                let name = f.sig.ident.to_string();
                it.fns.push(FnItem {
                    module: inner,
                    outer: module,
                    public: is_public(&f.vis),
                    file,
                    owner: Owner::Free,
                    sig: f.sig,
                    body: Some(*f.block),
                    attrs: f.attrs,
                });
                it.name(module, name, Target::Def(Def::Fn(id)), gate);
            }
            syn::Item::Struct(item) => {
                let id = it.structs.len();
                let name = item.ident.to_string();
                it.structs.push(StructItem { module, file, item });
                it.name(module, name, Target::Def(Def::Struct(id)), gate);
            }
            syn::Item::Enum(item) => {
                let id = it.enums.len();
                let name = item.ident.to_string();
                it.enums.push(EnumItem { module, file, item });
                it.name(module, name, Target::Def(Def::Enum(id)), gate);
            }
            syn::Item::Const(mut c) => {
                if let syn::Expr::Block(b) = &mut *c.expr {
                    let public = self.items.public;
                    self.body_items(module, file, &mut b.block)?;
                    self.items.public = public;
                }
                let it = &mut *self.items;
                let id = it.consts.len();
                let name = c.ident.to_string();
                it.consts.push(ConstItem {
                    gate: None,
                    public: is_public(&c.vis),
                    module,
                    file,
                    owner: Owner::Free,
                    name: name.clone(),
                    ty: *c.ty,
                    value: Some(*c.expr),
                });
                it.name(module, name, Target::Def(Def::Const(id)), gate);
            }
            syn::Item::Type(item) => {
                let id = it.aliases.len();
                let name = item.ident.to_string();
                it.aliases.push(AliasItem { module, file, item });
                it.name(module, name, Target::Def(Def::Alias(id)), gate);
            }
            syn::Item::Use(u) => {
                let mut prefix = Vec::new();
                if u.leading_colon.is_some() {
                    prefix.push(String::new());
                }
                self.use_tree(module, &u.tree, prefix, gate.as_deref());
            }
            syn::Item::Mod(m) => {
                let name = m.ident.to_string();
                let below = format!("{dir}{name}/");
                let moved = m.attrs.iter().any(|a| a.path().is_ident("path"));
                let gate = gate.or(moved.then(|| "#[path]".to_string()));
                if let Some(gate) = gate {
                    it.name(module, name, Target::Absent, Some(gate));
                } else if let Some((_, list)) = m.content {
                    let id = self.child(module, &name);
                    self.module(id, file, &below, list)?;
                } else {
                    let path = [format!("{dir}{name}.rs"), format!("{dir}{name}/mod.rs")]
                        .into_iter()
                        .find(|p| self.parsed.contains_key(p));
                    match path {
                        Some(path) => {
                            let id = self.child(module, &name);
                            self.file(id, &path, &below)?;
                        }
                        None => it.name(module, name, Target::Absent, None),
                    }
                }
            }
            syn::Item::Trait(t) => {
                let id = it.traits.len();
                let name = t.ident.to_string();
                it.traits.push(TraitItem {
                    name: name.clone(),
                    generics: t.generics,
                    fns: HashMap::new(),
                    consts: HashMap::new(),
                });
                it.name(module, name, Target::Def(Def::Trait(id)), gate);
                for member in t.items {
                    match member {
                        syn::TraitItem::Fn(f) => {
                            let at = Span::of(file, &f.sig.ident);
                            let name = f.sig.ident.to_string();
                            let fn_id = it.fns.len();
                            it.fns.push(FnItem {
                                module,
                                outer: module,
                                public: true,
                                file,
                                owner: Owner::Trait(id),
                                sig: f.sig,
                                body: f.default,
                                attrs: f.attrs,
                            });
                            if it.traits[id].fns.insert(name.clone(), fn_id).is_some() {
                                return Err(err(
                                    at,
                                    format!("`{name}` is defined twice in this trait"),
                                    "shared code carries no `cfg`: keep one of them",
                                ));
                            }
                        }
                        syn::TraitItem::Const(c) if matches!(cfg_of(&c.attrs), Cfg::Test) => {}
                        syn::TraitItem::Const(c) => {
                            let name = c.ident.to_string();
                            let const_id = it.consts.len();
                            it.consts.push(ConstItem {
                                gate: cfg_gate(&c.attrs),
                                public: true,
                                module,
                                file,
                                owner: Owner::Trait(id),
                                name: name.clone(),
                                ty: c.ty,
                                value: c.default.map(|(_, e)| e),
                            });
                            if it.traits[id].consts.insert(name, const_id).is_some() {
                                it.consts[const_id].gate = Some("a second definition".into());
                            }
                        }
                        // An associated type is refused where a path names it.
                        _ => {}
                    }
                }
            }
            syn::Item::Impl(i) => {
                let id = it.impls.len();
                it.impls.push(ImplItem {
                    opaque: i.items.iter().any(|m| matches!(m, syn::ImplItem::Macro(_))),
                    gate,
                    module,
                    file,
                    generics: i.generics,
                    trait_: i.trait_.map(|(path, _)| path),
                    self_ty: *i.self_ty,
                    fns: HashMap::new(),
                    consts: HashMap::new(),
                });
                for member in i.items {
                    match member {
                        syn::ImplItem::Fn(mut f) => {
                            if matches!(cfg_of(&f.attrs), Cfg::Test) {
                                continue;
                            }
                            let inner = self.body_items(module, file, &mut f.block)?;
                            let it = &mut *self.items;
                            let name = f.sig.ident.to_string();
                            let fn_id = it.fns.len();
                            let at = Span::of(file, &f.sig.ident);
                            it.fns.push(FnItem {
                                module: inner,
                                outer: module,
                                public: is_public(&f.vis),
                                file,
                                owner: Owner::Impl(id),
                                sig: f.sig,
                                body: Some(f.block),
                                attrs: f.attrs,
                            });
                            if it.impls[id].fns.insert(name.clone(), fn_id).is_some() {
                                return Err(err(
                                    at,
                                    format!("`{name}` is defined twice in this impl"),
                                    "shared code carries no `cfg`: keep one of them",
                                ));
                            }
                        }
                        syn::ImplItem::Const(c) if matches!(cfg_of(&c.attrs), Cfg::Test) => {}
                        syn::ImplItem::Const(c) => {
                            let it = &mut *self.items;
                            let name = c.ident.to_string();
                            let const_id = it.consts.len();
                            it.consts.push(ConstItem {
                                gate: cfg_gate(&c.attrs),
                                public: is_public(&c.vis),
                                module,
                                file,
                                owner: Owner::Impl(id),
                                name: name.clone(),
                                ty: c.ty,
                                value: Some(c.expr),
                            });
                            if it.impls[id].consts.insert(name, const_id).is_some() {
                                it.consts[const_id].gate = Some("a second definition".into());
                            }
                        }
                        _ => {}
                    }
                }
            }
            syn::Item::Static(s) => {
                it.name(
                    module,
                    s.ident.to_string(),
                    Target::Unsupported("a `static`"),
                    gate,
                );
            }
            syn::Item::Union(u) => {
                it.name(
                    module,
                    u.ident.to_string(),
                    Target::Unsupported("a `union`"),
                    gate,
                );
            }
            syn::Item::Macro(m) => match m.ident {
                Some(ident) => it.name(
                    module,
                    ident.to_string(),
                    Target::Unsupported("a macro"),
                    gate,
                ),
                None => it.modules[module].opaque = true,
            },
            _ => {}
        }
        Ok(())
    }

    /// Takes the items at the top of a function's body into a module of their own, and gives that.
    fn body_items(&mut self, module: ModId, file: usize, body: &mut syn::Block) -> R<ModId> {
        if !body.stmts.iter().any(|s| matches!(s, syn::Stmt::Item(_))) {
            return Ok(module);
        }
        let id = self.items.modules.len();
        self.items.modules.push(Module {
            krate: self.krate,
            parent: Some(module),
            block: true,
            ..Module::default()
        });
        for stmt in std::mem::take(&mut body.stmts) {
            match stmt {
                syn::Stmt::Item(item) => self.item(id, file, "", item)?,
                stmt => body.stmts.push(stmt),
            }
        }
        Ok(id)
    }

    fn use_tree(
        &mut self,
        module: ModId,
        tree: &syn::UseTree,
        mut path: Vec<String>,
        gate: Option<&str>,
    ) {
        let gated = || gate.map(str::to_string);
        match tree {
            syn::UseTree::Path(p) => {
                path.push(p.ident.to_string());
                self.use_tree(module, &p.tree, path, gate);
            }
            syn::UseTree::Name(n) => {
                let mut name = n.ident.to_string();
                if name == "self" {
                    name = path
                        .last()
                        .cloned()
                        .unwrap_or_else(|| self.crate_name.to_string());
                } else {
                    path.push(name.clone());
                }
                self.items.name(module, name, Target::Use(path), gated());
            }
            syn::UseTree::Rename(r) => {
                if r.ident != "self" {
                    path.push(r.ident.to_string());
                }
                // `use Trait as _` brings methods only; they are found by type.
                if r.rename != "_" {
                    self.items
                        .name(module, r.rename.to_string(), Target::Use(path), gated());
                }
            }
            syn::UseTree::Glob(_) => {
                let gate = gated();
                self.items.modules[module].globs.push(Glob { path, gate });
            }
            syn::UseTree::Group(g) => {
                for tree in &g.items {
                    self.use_tree(module, tree, path.clone(), gate);
                }
            }
        }
    }
}
