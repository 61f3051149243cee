//! Host file: what a comparison runs on, and the command that ran it.

/// The command line, quoted for a shell.
pub(super) fn command_line() -> String {
    let quoted = |arg: String| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+@%".contains(c);
        match !arg.is_empty() && arg.chars().all(plain) {
            true => arg,
            false => format!("'{}'", arg.replace('\'', r"'\''")),
        }
    };
    let args = std::env::args().skip(1).map(quoted);
    std::iter::once("glimt".to_owned())
        .chain(args)
        .collect::<Vec<_>>()
        .join(" ")
}

/// The processor and the system.
pub(super) fn description() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|l| {
        l.strip_prefix("model name")?
            .split_once(':')
            .map(|p| p.1.trim().to_owned())
    });
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    format!(
        "{}, {threads} threads, {} {}",
        model.unwrap_or_else(|| "a processor".to_owned()),
        std::env::consts::OS,
        std::env::consts::ARCH
    )
}
