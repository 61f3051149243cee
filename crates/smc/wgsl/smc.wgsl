// Made from Rust by naga-front-rust; do not edit. This command writes it: cargo run --release -p glimt-generate

struct Bridge {
    path: u32,
    intermediate: u32,
}

struct Endpoints {
    previous: f32,
    current: f32,
}

struct Split {
    first: bool,
    word: u32,
}

struct Particle {
    state: vec3<f32>,
    log_weight: f32,
}

// glimt_smc/src/metropolis.rs:25
fn smc_accept(u: f32, density: f32, forward: f32, proposed_density: f32, backward: f32) -> bool {

    // glimt_smc/src/metropolis.rs:26
    return ((forward > 0f) && ((u * (density * forward)) < (proposed_density * backward)));
}

// glimt_smc/src/bridge.rs:48
fn smc_bridge_steps(this_: Bridge) -> u32 {

    // glimt_smc/src/bridge.rs:49
    return (this_.intermediate + 1u);
}

// glimt_smc/src/bridge.rs:65
fn smc_bridge_density(this_1: Bridge, k: u32, ends: Endpoints) -> f32 {

    // glimt_smc/src/bridge.rs:66
    if (k == 0u) {
        // glimt_smc/src/bridge.rs:67
        return ends.previous;
    }
    // glimt_smc/src/bridge.rs:69
    let _e10 = smc_bridge_steps(this_1);
    if (k >= _e10) {
        // glimt_smc/src/bridge.rs:70
        return ends.current;
    }
    // glimt_smc/src/bridge.rs:72
    let _e16 = smc_bridge_steps(this_1);
    let beta = (f32(k) / f32(_e16));
    // glimt_smc/src/bridge.rs:73
    if (this_1.path == 0u) {
        // glimt_smc/src/bridge.rs:74
        return (((1f - beta) * ends.previous) + (beta * ends.current));
    }
    // glimt_smc/src/bridge.rs:76
    if (!((ends.previous > 0f)) || !((ends.current > 0f))) {
        // glimt_smc/src/bridge.rs:77
        return 0f;
    }
    // glimt_smc/src/bridge.rs:79
    return (pow(ends.previous, (1f - beta)) * pow(ends.current, beta));
}

// glimt_smc/src/proposal.rs:136
fn smc_split_word(word: u32, pmf_first: f32) -> Split {
    var chosen: u32;
    var chosen_1: u32;

    // glimt_smc/src/proposal.rs:138
    let edge = u32((clamp(pmf_first, 0f, 1f) * 65536f));
    // glimt_smc/src/proposal.rs:139
    let first = ((word >> 16u) < edge);
    // glimt_smc/src/proposal.rs:140
    if first {
        chosen = edge;
    } else {
        chosen = (65536u - edge);
    }
    let width = chosen;
    // glimt_smc/src/proposal.rs:142
    if first {
        // glimt_smc/src/proposal.rs:143
        chosen_1 = word;
    } else {
        // glimt_smc/src/proposal.rs:145
        chosen_1 = (word - (edge << 16u));
    }
    let place = chosen_1;
    // glimt_smc/src/proposal.rs:147
    let width_1 = max(width, 1u);
    // glimt_smc/src/proposal.rs:148
    let upper = (place / width_1);
    // glimt_smc/src/proposal.rs:149
    let lower = (((place % width_1) * 65536u) / width_1);
    // glimt_smc/src/proposal.rs:150
    return Split(first, ((upper << 16u) + lower));
}

// glimt_smc/src/particle.rs:25
fn smc_particle_weight(this_2: Particle) -> f32 {

    // glimt_smc/src/particle.rs:26
    return exp(this_2.log_weight);
}

// glimt_smc/src/particle.rs:33
fn smc_is_log_zero(log_weight: f32) -> bool {

    // glimt_smc/src/particle.rs:34
    return !((log_weight > (0.5f * -1000000000000000000000000000000f)));
}

