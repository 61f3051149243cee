//! Host file: changes of a JSON document that stay JSON: members that are gone, doubled or exchanged, numbers of other sizes.

use glimt_tests::random::Random;
use serde_json::{Value, json};

/// The document with one value changed; as it is where it is no JSON.
pub(super) fn change(text: &str, random: &mut Random) -> String {
    let Ok(mut document) = serde_json::from_str::<Value>(text.trim_end()) else {
        return text.to_owned();
    };
    // The path of the document itself.
    let mut paths = vec![String::new()];
    collect(&document, &mut String::new(), &mut paths);
    let (path, other) = (random.pick(&paths).clone(), random.pick(&paths).clone());
    let other = document.pointer(&other).cloned().unwrap_or_default();
    let (parent, key) = path.rsplit_once('/').unwrap_or(("", &path));
    match random.below(8) {
        0 => match document.pointer_mut(parent) {
            Some(Value::Object(members)) => drop(members.remove(key)),
            Some(Value::Array(list)) => {
                let at = key.parse().unwrap_or(0);
                if at < list.len() {
                    list.remove(at);
                }
            }
            _ => {}
        },
        1 => match document.pointer_mut(parent) {
            Some(Value::Array(list)) => list.push(other),
            Some(Value::Object(members)) => drop(members.insert("extras".to_owned(), other)),
            _ => {}
        },
        2 => set(&mut document, &path, other),
        3 => {
            let odd = [
                json!(null),
                json!(true),
                json!(""),
                json!("pointer"),
                json!("weights"),
                json!("KHR_draco_mesh_compression"),
                json!([]),
                json!({}),
                json!([[[0]]]),
                json!("data:application/octet-stream;base64,AAAA"),
                json!("a%00b"),
                json!("../a.gltf"),
                json!("SCALAR"),
                json!("VEC4"),
                json!("MAT4"),
            ];
            set(&mut document, &path, random.pick(&odd).clone());
        }
        _ => {
            let numbers = paths
                .iter()
                .filter(|p| document.pointer(p).is_some_and(Value::is_number));
            let numbers: Vec<&String> = numbers.collect();
            if !numbers.is_empty() {
                let path = random.pick(&numbers).to_string();
                let old = document.pointer(&path).and_then(Value::as_i64).unwrap_or(0);
                let new = number(old, random);
                set(&mut document, &path, new);
            }
        }
    }
    document.to_string()
}

fn set(document: &mut Value, path: &str, new: Value) {
    if let Some(value) = document.pointer_mut(path) {
        *value = new;
    }
}

fn number(old: i64, random: &mut Random) -> Value {
    let numbers = [
        json!(0),
        json!(-1),
        json!(1),
        json!(2),
        json!(3),
        json!(5),
        json!(100),
        json!(5120),
        json!(5121),
        json!(5122),
        json!(5123),
        json!(5125),
        json!(5126),
        json!(65_536),
        json!(1u32 << 31),
        json!(u32::MAX),
        json!(1u64 << 32),
        json!(1u64 << 61),
        json!(u64::MAX),
        json!(i64::MIN),
        json!(0.5),
        json!(1e308),
        json!(-1e308),
        json!(1e-320),
        json!(3.5e38),
        json!(1e30),
    ];
    match random.below(4) {
        0 => json!(old.wrapping_add(1)),
        1 => json!(old.wrapping_sub(1)),
        _ => random.pick(&numbers).clone(),
    }
}

/// The paths of all values below the first.
fn collect(value: &Value, path: &mut String, paths: &mut Vec<String>) {
    let length = path.len();
    let mut add = |key: &str, value: &Value| {
        path.push('/');
        path.push_str(&key.replace('~', "~0").replace('/', "~1"));
        paths.push(path.clone());
        collect(value, path, paths);
        path.truncate(length);
    };
    match value {
        Value::Object(members) => members.iter().for_each(|(key, value)| add(key, value)),
        Value::Array(list) => {
            let all = list.iter().enumerate();
            all.for_each(|(i, value)| add(&i.to_string(), value));
        }
        _ => {}
    }
}
