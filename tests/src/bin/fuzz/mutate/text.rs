//! Host file: changes of text: its numbers, and its lines and words.

use glimt_tests::random::Random;

/// Texts in place of a number.
const NUMBERS: [&str; 42] = [
    "0",
    "-0",
    "-1",
    "1",
    "2",
    "3",
    "7",
    "255",
    "256",
    "1000",
    "16385",
    "65535",
    "65536",
    "1000000",
    "268435457",
    "2147483647",
    "2147483648",
    "-2147483648",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "99999999999999999999999999",
    "0.5",
    "-0.5",
    "1e-45",
    "1e-320",
    "1e9",
    "1e19",
    "3.4e38",
    "3.5e38",
    "1e308",
    "-1e308",
    "1e309",
    "nan",
    "inf",
    "-inf",
    "",
    "0x10",
];

/// The text with another number in the place of one.
pub(super) fn number(text: &str, random: &mut Random) -> String {
    let mut places = Vec::new();
    let mut start = None;
    for (i, c) in text.char_indices().chain([(text.len(), ' ')]) {
        let is_part = c.is_ascii_digit() || (start.is_some() && matches!(c, '.' | 'e' | 'E'));
        match (start, is_part) {
            (None, true) => start = Some(i),
            (Some(from), false) => {
                places.push(from..i);
                start = None;
            }
            _ => {}
        }
    }
    if places.is_empty() {
        return text.to_owned();
    }
    let place = random.pick(&places).clone();
    let own = text[place.clone()].parse::<i64>().unwrap_or(0);
    let new = match random.below(5) {
        0 => own.wrapping_add(1).to_string(),
        1 => own.wrapping_sub(1).to_string(),
        _ => (*random.pick(&NUMBERS)).to_owned(),
    };
    let mut changed = text.to_owned();
    changed.replace_range(place, &new);
    changed
}

/// The text with lines or words that are gone, that come again, or that stand elsewhere.
pub(super) fn lines(text: &str, random: &mut Random) -> String {
    // Where a file has one line, its words are taken, or what stands between commas.
    let mark = match text.matches('\n').count() > 1 && !random.one_in(3) {
        true => '\n',
        false if text.contains(',') && random.one_in(2) => ',',
        false => ' ',
    };
    let mut parts: Vec<&str> = text.split(mark).collect();
    let (one, two) = (random.below(parts.len()), random.below(parts.len()));
    match random.below(6) {
        0 => drop(parts.remove(one)),
        1 => parts.insert(two, parts[one]),
        2 => parts.swap(one, two),
        3 => parts.truncate(one),
        4 => {
            let again = vec![parts[one]; random.length(12)];
            drop(parts.splice(two..two, again));
        }
        _ => {
            let marks = [
                "[", "{", "(", "\"", "/", "-", " ", "\\", "#", "\u{feff}", "a", "9",
            ];
            let run = random.pick(&marks).repeat(random.length(15));
            parts.insert(two, &run);
            return parts.join(&mark.to_string());
        }
    }
    parts.join(&mark.to_string())
}
