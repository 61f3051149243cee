//! Host file: H.264 by the `ffmpeg` program.

use super::super::atomic::Pending;
use crate::error::{Error, Result};
use glam::UVec2;
use std::io::{Read, Write};
use std::process::{Child, Command, Stdio};

/// A video that `ffmpeg` is encoding.
pub struct Ffmpeg {
    child: Child,
    pending: Pending,
}

/// Whether there is an `ffmpeg` that runs.
pub(super) fn is_found() -> bool {
    Command::new("ffmpeg")
        .arg("-version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

impl Ffmpeg {
    pub(super) fn start(pending: Pending, size: UVec2, fps: f32, title: &str) -> Result<Self> {
        let size = format!("{}x{}", size.x, size.y);
        let fps = fps.to_string();
        let metadata = format!("title={title}");
        let mut command = Command::new("ffmpeg");
        command.args(["-loglevel", "error", "-y"]);
        command.args([
            "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", &size, "-r", &fps, "-i", "-",
        ]);
        // H.264 in 4:2:0 has even sides.
        command.args(["-an", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"]);
        command.args(["-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p"]);
        command.args([
            "-movflags",
            "+faststart",
            "-metadata",
            &metadata,
            "-f",
            "mp4",
        ]);
        command.arg(pending.part());
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        // Signals of the terminal are for this program, which then ends the video or drops it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = command.spawn().map_err(|e| {
            Error::output(pending.target(), format!("ffmpeg cannot be started: {e}"))
                .fix("install it, or use the built-in encoder: --set output.codec=av1")
        })?;
        Ok(Self { child, pending })
    }

    pub(super) fn push(&mut self, rgb: &[u8]) -> Result<()> {
        let written = match &mut self.child.stdin {
            Some(input) => input.write_all(rgb),
            None => Ok(()),
        };
        // A closed pipe says only that it gave up; what it printed says why.
        written.map_err(|_| self.failure())
    }

    pub(super) fn finish(mut self) -> Result<()> {
        drop(self.child.stdin.take());
        match self.child.wait() {
            Ok(status) if status.success() => self.pending.commit(),
            _ => Err(self.failure()),
        }
    }

    fn failure(&mut self) -> Error {
        drop(self.child.stdin.take());
        let mut said = String::new();
        if let Some(stderr) = &mut self.child.stderr {
            let _ = stderr.read_to_string(&mut said);
        }
        let last = said.lines().last().unwrap_or("it stopped").to_owned();
        Error::output(self.pending.target(), format!("ffmpeg failed: {last}"))
            .fix("use the built-in encoder: --set output.codec=av1")
    }
}

impl Drop for Ffmpeg {
    fn drop(&mut self) {
        // Nothing to do where it has ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
