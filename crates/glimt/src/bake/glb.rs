//! Host file: a binary glTF file as a document of JSON and a run of bytes, and the numbers of its accessors.

use serde_json::Value;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

const MAGIC: u32 = 0x4654_6c67;
const JSON: u32 = 0x4e4f_534a;
const BIN: u32 = 0x004e_4942;

/// The component type of a float.
pub const FLOAT: u64 = 5126;
/// The component type of a word.
pub const UNSIGNED_INT: u64 = 5125;

/// Bytes of a vector of four floats.
const VECTOR: u64 = 16;

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
/// It is not a binary glTF file, or not whole.
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
/// It is not a binary glTF file, or its document is not whole.
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

/// Where in the file the bytes behind the document stand, at whose chunk the reader stands.
///
/// # Errors
/// There are none, or less than the file says.
pub fn bytes(file: &mut (impl Read + Seek)) -> Result<Range<u64>, Broken> {
    let [length, kind] = words(file)?;
    if kind != BIN {
        return Err(Broken::NotGlb);
    }
    let start = file.stream_position()?;
    let (there, end) = (file.seek(SeekFrom::End(0))?, start + u64::from(length));
    match there < end {
        true => Err(Broken::Short(there, end)),
        false => Ok(start..end),
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

/// Where the values of an accessor of vectors with four floats lie among the bytes of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vectors {
    first: u64,
    stride: u64,
    count: u64,
}

impl Vectors {
    /// The values of an accessor of a file with `length` bytes, however they lie; `None` where they are not such vectors, or not
    /// all there, each in a place of its own.
    #[must_use]
    pub fn find(document: &Value, accessor: u64, length: u64) -> Option<Self> {
        let item = |list: &str, index: u64| document[list].get(usize::try_from(index).ok()?);
        let accessor = item("accessors", accessor)?;
        if accessor["type"] != "VEC4" || accessor["componentType"] != FLOAT {
            return None;
        }
        let number = |value: &Value, or: u64| value.as_u64().unwrap_or(or);
        let view = item("bufferViews", accessor["bufferView"].as_u64()?)?;
        if number(&view["buffer"], 0) != 0 || !accessor["sparse"].is_null() {
            return None;
        }
        let (start, view_length) = (
            number(&view["byteOffset"], 0),
            number(&view["byteLength"], 0),
        );
        let offset = number(&accessor["byteOffset"], 0);
        let (stride, count) = (
            number(&view["byteStride"], VECTOR),
            number(&accessor["count"], 0),
        );
        if stride < VECTOR || start.checked_add(view_length)? > length {
            return None;
        }
        let end = match count {
            0 => offset,
            _ => (count - 1)
                .checked_mul(stride)?
                .checked_add(offset)?
                .checked_add(VECTOR)?,
        };
        (end <= view_length).then_some(Self {
            first: start + offset,
            stride,
            count,
        })
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Reads them, where the bytes of the file begin at `start`, and hands out one after the other.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn read(
        &self,
        file: &mut (impl Read + Seek),
        start: u64,
        mut take: impl FnMut([f32; 4]),
    ) -> io::Result<()> {
        file.seek(SeekFrom::Start(start + self.first))?;
        for i in 0..self.count {
            let mut bytes = [0; VECTOR as usize];
            if i > 0 && self.stride > VECTOR {
                file.seek_relative((self.stride - VECTOR) as i64)?;
            }
            file.read_exact(&mut bytes)?;
            let float =
                |k: usize| f32::from_le_bytes([bytes[k], bytes[k + 1], bytes[k + 2], bytes[k + 3]]);
            take([float(0), float(4), float(8), float(12)]);
        }
        Ok(())
    }
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
        let range = self::bytes(&mut file).expect("bytes");
        assert_eq!(range, whole.len() as u64 - 8..whole.len() as u64);
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
        let bytes: &[u8] = bytemuck::cast_slice(&floats);
        let find = |document: &Value, accessor| Vectors::find(document, accessor, 96);
        let mut found = Vec::new();
        let vectors = find(&document(28), 0).expect("vectors");
        let read = vectors.read(&mut Cursor::new(bytes), 0, |four| found.push(four));
        read.expect("floats");
        assert_eq!(found[0], [3.0, 4.0, 5.0, 6.0]);
        assert_eq!(found[2], [17.0, 18.0, 19.0, 20.0]);
        assert_eq!(found.len(), 3);
        // Beyond the end, or not there.
        assert!(find(&document(40), 0).is_none());
        assert!(find(&document(28), 1).is_none());
    }

    #[test]
    fn forged_counts_are_refused_unread() {
        let document = |count: u64, stride: Value| {
            json!({
                "accessors": [{
                    "bufferView": 0, "componentType": 5126, "count": count, "type": "VEC4",
                }],
                "bufferViews": [{"buffer": 0, "byteLength": 96, "byteStride": stride}],
            })
        };
        let find = |count, stride| Vectors::find(&document(count, stride), 0, 96);
        assert_eq!(find(6, Value::Null).map(|v| v.count()), Some(6));
        // Values on top of each other would be there however many there are.
        for stride in [0, 15] {
            assert!(find(6, json!(stride)).is_none());
            assert!(find(4_000_000_000, json!(stride)).is_none());
        }
        for count in [7, 4_000_000_000, u64::MAX] {
            assert!(find(count, Value::Null).is_none());
            assert!(find(count, json!(u64::MAX)).is_none());
        }
    }
}
