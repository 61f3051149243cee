//! Host file: changes of bytes, whatever they mean.

use super::Place;
use glimt_tests::random::Random;

/// Whole numbers that counts, sizes and offsets break at, and the bits of floats that are no numbers.
const NUMBERS: [u64; 40] = [
    0,
    1,
    2,
    3,
    4,
    7,
    8,
    16,
    32,
    64,
    127,
    128,
    255,
    256,
    0x7fff,
    0x8000,
    0xffff,
    0x1_0000,
    1 << 20,
    (1 << 24) - 1,
    1 << 24,
    1 << 28,
    (1 << 28) + 1,
    1 << 30,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0xffff_fffe,
    0xffff_ffff,
    0x1_0000_0000,
    1 << 40,
    1 << 47,
    i64::MAX as u64,
    1 << 63,
    u64::MAX - 1,
    u64::MAX,
    0x7fc0_0000,
    0x7f80_0000,
    0xff80_0000,
    0x7f7f_ffff,
];

/// One of many changes, somewhere.
pub(super) fn anywhere(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    if bytes.is_empty() {
        bytes.push(random.bits() as u8);
        return;
    }
    let at = random.below(bytes.len());
    let length = random.length(8);
    let end = (at + length).min(bytes.len());
    match random.below(9) {
        0 | 1 => bytes[at] ^= 1 << random.below(8),
        2 => bytes[at] = random.bits() as u8,
        3 => bytes.truncate(at),
        4 => drop(bytes.drain(at..end)),
        5 => {
            let again = bytes[at..end].to_vec();
            let times = random.length(8);
            drop(bytes.splice(at..at, again.repeat(times)));
        }
        6 => bytes[at..end].fill(*random.pick(&[0, 1, 0x7f, 0x80, 0xff])),
        7 if !other.is_empty() => {
            let from = random.below(other.len());
            let part = other[from..].iter().take(4 * length).copied();
            let end = (at + random.below(4 * length)).min(bytes.len());
            drop(bytes.splice(at..end, part));
        }
        _ => {
            let width = *random.pick(&[1, 2, 4, 8]);
            let at = if random.one_in(2) {
                at / width * width
            } else {
                at
            };
            let place = Place {
                at,
                width,
                is_big_endian: random.one_in(2),
            };
            number(bytes, place, random);
        }
    }
}

/// Another number at a place: one of those that readers break at, one near the old one, or any.
pub(super) fn number(bytes: &mut [u8], place: Place, random: &mut Random) {
    let Some(field) = bytes.get_mut(place.at..place.at + place.width) else {
        return;
    };
    let order = |field: &mut [u8]| {
        if place.is_big_endian {
            field.reverse();
        }
    };
    order(field);
    let mut word = [0; 8];
    word[..field.len()].copy_from_slice(field);
    let old = u64::from_le_bytes(word);
    let new = match random.below(8) {
        0 => old.wrapping_add(1),
        1 => old.wrapping_sub(1),
        2 => old.wrapping_mul(2),
        3 => random.bits() >> random.below(64),
        4 => (*random.pick(&NUMBERS)).wrapping_neg(),
        _ => *random.pick(&NUMBERS),
    };
    field.copy_from_slice(&new.to_le_bytes()[..field.len()]);
    order(field);
}
