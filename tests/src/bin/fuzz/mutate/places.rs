//! Host file: where formats keep the numbers that readers trust: lengths, counts, sizes, offsets.

use super::{Kind, Place};

/// The places of a file; none where its format has none, or the file is no longer of it.
pub(super) fn find(kind: Kind, bytes: &[u8]) -> Vec<Place> {
    let mut places = Places {
        bytes,
        is_big_endian: false,
        list: Vec::new(),
    };
    // Where a file ends in the middle of something, what was found before that counts.
    let _ = match kind {
        Kind::Exr => places.exr(),
        Kind::Png => places.png(),
        Kind::Jpeg => places.jpeg(),
        Kind::Tiff => places.tiff(),
        Kind::WebP => places.webp(),
        Kind::Stl => places.row(80, 4, 1),
        Kind::Glb => places.glb(),
        Kind::State => places.row(super::repair::STATE_MAGIC, 4, 1),
        _ => None,
    };
    places.list
}

struct Places<'a> {
    bytes: &'a [u8],
    is_big_endian: bool,
    list: Vec<Place>,
}

/// The most of a kind that are taken of one file.
const MOST: usize = 24;

impl Places<'_> {
    /// Some numbers beside each other.
    fn row(&mut self, at: usize, width: usize, count: usize) -> Option<()> {
        for i in 0..count {
            let at = at.checked_add(i * width)?;
            self.bytes.get(at..at.checked_add(width)?)?;
            self.list.push(Place {
                at,
                width,
                is_big_endian: self.is_big_endian,
            });
        }
        Some(())
    }

    fn read(&self, at: usize, width: usize) -> Option<usize> {
        let field = self.bytes.get(at..at.checked_add(width)?)?;
        let mut word = [0; 8];
        word[..width].copy_from_slice(field);
        if self.is_big_endian {
            word[..width].reverse();
        }
        usize::try_from(u64::from_le_bytes(word)).ok()
    }

    /// Where a text that ends with 0 has its end, behind that.
    fn after_text(&self, at: usize) -> Option<usize> {
        let length = self.bytes.get(at..)?.iter().position(|b| *b == 0)?;
        Some(at + length + 1)
    }

    fn exr(&mut self) -> Option<()> {
        self.row(4, 1, 4)?;
        let is_multipart = self.read(5, 1)? & 0x10 != 0;
        let mut at = 8;
        loop {
            // A header: attributes until an empty name; of several parts, headers until an empty one.
            if is_multipart && self.read(at, 1)? == 0 {
                at += 1;
                break;
            }
            while self.read(at, 1)? != 0 {
                let name_end = self.after_text(at)?;
                let value = self.after_text(name_end)? + 4;
                let size = self.read(value - 4, 4)?;
                self.row(value - 4, 4, 1)?;
                match &self.bytes[name_end..value - 5] {
                    b"chlist" => self.exr_channels(value)?,
                    _ if size < 4 => self.row(value, 1, size)?,
                    _ => self.row(value, 4, (size / 4).min(MOST))?,
                }
                at = value + size;
            }
            at += 1;
            if !is_multipart {
                break;
            }
        }
        // The table of offsets ends where the first block begins.
        let first = self.read(at, 8)?;
        let blocks = first.checked_sub(at)? / 8;
        self.row(at, 8, blocks.min(MOST))?;
        for i in 0..blocks.min(MOST) {
            let block = self.read(at + 8 * i, 8)?;
            self.row(block, 4, if is_multipart { 6 } else { 5 })?;
            // What is packed may have a head of its own, as that of DWA has.
            self.row(block + 8, 8, 11)?;
        }
        Some(())
    }

    fn exr_channels(&mut self, mut at: usize) -> Option<()> {
        while self.read(at, 1)? != 0 {
            at = self.after_text(at)?;
            self.row(at, 4, 4)?;
            at += 16;
        }
        Some(())
    }

    fn png(&mut self) -> Option<()> {
        self.is_big_endian = true;
        let mut at = 8;
        while let Some(length) = self.read(at, 4) {
            self.row(at, 4, 1)?;
            self.row(at + 8, 4, (length / 4).min(3))?;
            self.row(at + 8, 1, length.min(13))?;
            at = at.checked_add(length.checked_add(12)?)?;
        }
        Some(())
    }

    fn jpeg(&mut self) -> Option<()> {
        self.is_big_endian = true;
        let mut at = 2;
        while self.read(at, 1)? == 0xff {
            let marker = self.read(at + 1, 1)?;
            let length = self.read(at + 2, 2)?;
            self.row(at + 1, 1, 1)?;
            self.row(at + 2, 2, 1)?;
            // A frame's size; the tables' and the scan's numbers.
            if matches!(marker, 0xc0..=0xc2) {
                self.row(at + 5, 2, 2)?;
            }
            self.row(at + 4, 1, (length - 2).min(MOST))?;
            at = at.checked_add(2 + length)?;
        }
        Some(())
    }

    fn tiff(&mut self) -> Option<()> {
        self.is_big_endian = self.bytes.starts_with(b"MM");
        self.row(4, 4, 1)?;
        let directory = self.read(4, 4)?;
        let count = self.read(directory, 2)?;
        self.row(directory, 2, 1)?;
        for i in 0..count.min(MOST) {
            let entry = directory + 2 + 12 * i;
            self.row(entry, 2, 2)?;
            self.row(entry + 4, 4, 2)?;
            self.row(entry + 8, 2, 1)?;
        }
        self.row(directory + 2 + 12 * count, 4, 1)
    }

    fn webp(&mut self) -> Option<()> {
        self.row(4, 4, 1)?;
        let mut at = 12;
        while let Some(length) = self.read(at + 4, 4) {
            self.row(at + 4, 4, 1)?;
            self.row(at + 8, 1, length.min(16))?;
            at = at.checked_add(8 + length.next_multiple_of(2))?;
        }
        Some(())
    }

    fn glb(&mut self) -> Option<()> {
        self.row(4, 4, 4)?;
        let binary = 20usize.checked_add(self.read(12, 4)?)?;
        self.row(binary, 4, 2)
    }
}
