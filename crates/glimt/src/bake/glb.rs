//! Host file: a binary glTF file as a document of JSON and a run of bytes, and the numbers of its accessors.

use serde_json::Value;
use std::io::{Read, Seek, SeekFrom};

const MAGIC: u32 = 0x4654_6c67;
const JSON: u32 = 0x4e4f_534a;
const BIN: u32 = 0x004e_4942;

/// The component type of a float.
pub const FLOAT: u64 = 5126;
/// The component type of a word.
pub const UNSIGNED_INT: u64 = 5125;

/// Why a file is none.
#[derive(Debug)]
pub enum Broken {
    /// Reading failed.
    Io(std::io::Error),
    /// It is another kind of file.
    NotGlb,
    /// It has so many bytes, and says so many.
    Short(u64, u64),
}

impl From<std::io::Error> for Broken {
    fn from(error: std::io::Error) -> Self {
        Self::Io(error)
    }
}

/// The document of a file, checked to be as long as it says. The reader then stands at its chunk of bytes.
///
/// # Errors
/// It is no binary glTF file, or not whole.
pub fn read_document(file: &mut (impl Read + Seek)) -> Result<Value, Broken> {
    let (there, said) = lengths(file)?;
    if there < said {
        return Err(Broken::Short(there, said));
    }
    read_any_document(file)
}

/// The same, whether or not the bytes behind the document are all there.
///
/// # Errors
/// It is no binary glTF file, or its document is not whole.
pub fn read_any_document(file: &mut (impl Read + Seek)) -> Result<Value, Broken> {
    let (there, said) = lengths(file)?;
    file.seek(SeekFrom::Start(12))?;
    let [json_length, _] = words(file)?;
    if there < 20 + u64::from(json_length) {
        return Err(Broken::Short(there, said));
    }
    let mut json = vec![0; json_length as usize];
    file.read_exact(&mut json)?;
    serde_json::from_slice(&json).map_err(|_| Broken::NotGlb)
}

/// How long a file is, and how long it says it is.
fn lengths(file: &mut (impl Read + Seek)) -> Result<(u64, u64), Broken> {
    let there = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(0))?;
    if there < 20 {
        return Err(Broken::NotGlb);
    }
    let [magic, version, length, json_length, kind] = words(file)?;
    if magic != MAGIC || version != 2 || kind != JSON {
        return Err(Broken::NotGlb);
    }
    Ok((there, u64::from(length).max(20 + u64::from(json_length))))
}

/// The bytes behind the document, where the reader stands.
///
/// # Errors
/// There are none, or less than the file says.
pub fn read_bytes(file: &mut impl Read) -> Result<Vec<u8>, Broken> {
    let [length, kind] = words(file)?;
    if kind != BIN {
        return Err(Broken::NotGlb);
    }
    let mut bytes = Vec::new();
    let said = u64::from(length);
    let there = file.take(said).read_to_end(&mut bytes)? as u64;
    match there == said {
        true => Ok(bytes),
        false => Err(Broken::Short(there, said)),
    }
}

fn words<const N: usize>(file: &mut impl Read) -> Result<[u32; N], Broken> {
    let mut words = [0; N];
    for word in &mut words {
        let mut bytes = [0; 4];
        file.read_exact(&mut bytes)?;
        *word = u32::from_le_bytes(bytes);
    }
    Ok(words)
}

/// What stands before the document and the bytes of a file with so many of them: the document, padded. `None` where it would
/// be longer than such a file can be, 4 GiB.
#[must_use]
pub fn head(document: &Value, bytes: u64) -> Option<Vec<u8>> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = 28 + json.len() as u64 + bytes;
    let [length, bytes] = [length, bytes].map(|n| u32::try_from(n).ok());
    let mut head = Vec::with_capacity(json.len() + 28);
    for word in [MAGIC, 2, length?, json.len() as u32, JSON] {
        head.extend(word.to_le_bytes());
    }
    head.extend(json);
    for word in [bytes?, BIN] {
        head.extend(word.to_le_bytes());
    }
    Some(head)
}

/// The floats of an accessor of vectors with four components, however its values lie; `None` where they are not that, or not
/// there.
#[must_use]
pub fn vectors(document: &Value, accessor: u64, bytes: &[u8]) -> Option<Vec<[f32; 4]>> {
    let accessor = document["accessors"].get(accessor as usize)?;
    if accessor["type"] != "VEC4" || accessor["componentType"] != FLOAT {
        return None;
    }
    let number = |value: &Value, or: u64| value.as_u64().unwrap_or(or) as usize;
    let view = document["bufferViews"].get(accessor["bufferView"].as_u64()? as usize)?;
    if number(&view["buffer"], 0) != 0 || !accessor["sparse"].is_null() {
        return None;
    }
    let start = number(&view["byteOffset"], 0);
    let view_bytes = bytes.get(start..start.checked_add(number(&view["byteLength"], 0))?)?;
    let stride = number(&view["byteStride"], 16);
    let first = number(&accessor["byteOffset"], 0);
    let vector = |i: usize| {
        let from = first.checked_add(i.checked_mul(stride)?)?;
        let four = view_bytes.get(from..from.checked_add(16)?)?;
        let float = |k: usize| f32::from_le_bytes([four[k], four[k + 1], four[k + 2], four[k + 3]]);
        Some([float(0), float(4), float(8), float(12)])
    };
    (0..number(&accessor["count"], 0)).map(vector).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use std::io::Cursor;

    #[test]
    fn a_file_is_read_back_and_a_short_one_is_not() {
        let document = json!({"asset": {"version": "2.0"}, "é": [1, 2, 3]});
        let bytes = [1u8, 2, 3, 4, 5, 6, 7, 8];
        let mut whole = head(&document, 8).expect("a short file");
        whole.extend(bytes);
        let mut file = Cursor::new(&whole);
        assert_eq!(read_document(&mut file).expect("a document"), document);
        assert_eq!(read_bytes(&mut file).expect("bytes"), bytes);
        for length in [20, 40, whole.len() - 1] {
            let mut file = Cursor::new(&whole[..length]);
            let error = read_document(&mut file).expect_err("too short");
            assert!(matches!(error, Broken::Short(there, said)
                if there == length as u64 && said == whole.len() as u64));
        }
        // The document may be whole where the file is not.
        let short = |length: usize| read_any_document(&mut Cursor::new(&whole[..length]));
        assert_eq!(short(whole.len() - 8).expect("a document"), document);
        assert!(matches!(short(40), Err(Broken::Short(40, _))));
        assert!(matches!(
            read_document(&mut Cursor::new(&whole[..19])),
            Err(Broken::NotGlb)
        ));
        assert!(head(&document, u64::from(u32::MAX)).is_none());
    }

    #[test]
    fn interleaved_values_are_found() {
        let floats: Vec<f32> = (0..24).map(|i| i as f32).collect();
        let document = |stride: u64| {
            json!({
                "accessors": [{
                    "bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 3, "type": "VEC4",
                }],
                "bufferViews": [{"buffer": 0, "byteOffset": 4, "byteLength": 92, "byteStride": stride}],
            })
        };
        let found = vectors(&document(28), 0, bytemuck::cast_slice(&floats)).expect("vectors");
        assert_eq!(found[0], [3.0, 4.0, 5.0, 6.0]);
        assert_eq!(found[2], [17.0, 18.0, 19.0, 20.0]);
        // Beyond the end, or not there.
        assert!(vectors(&document(40), 0, bytemuck::cast_slice(&floats)).is_none());
        assert!(vectors(&document(28), 1, bytemuck::cast_slice(&floats)).is_none());
    }
}
