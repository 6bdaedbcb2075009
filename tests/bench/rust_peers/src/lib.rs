//! What a Rust programmer would write for the case interpolate_linear: a loop over pairs of poses with glam's types, and 8 pairs
//! at a time with ultraviolet's wide ones. Rows of 12 floats as a MultiMesh holds them.

use glam::{Mat3A, Quat, Vec3A};
use ultraviolet::{f32x8, Rotor3x8, Vec3x8};

/// Position, rotation (x, y, z, w) and scale, as the C++ side hands it over.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Pose {
    position: [f32; 3],
    rotation: [f32; 4],
    scale: f32,
}

#[derive(Clone, Copy)]
struct GlamPose {
    position: Vec3A,
    rotation: Quat,
    scale: f32,
}

pub struct GlamPairs(Vec<(GlamPose, GlamPose)>);

fn glam_pose(pose: &Pose) -> GlamPose {
    GlamPose {
        position: Vec3A::from_array(pose.position),
        rotation: Quat::from_array(pose.rotation),
        scale: pose.scale,
    }
}

/// # Safety
/// `poses` are 2 `count` poses.
#[no_mangle]
pub unsafe extern "C" fn glam_pairs(poses: *const Pose, count: usize) -> *mut GlamPairs {
    let poses = std::slice::from_raw_parts(poses, 2 * count);
    Box::into_raw(Box::new(GlamPairs(poses.chunks(2).map(|pair| (glam_pose(&pair[0]), glam_pose(&pair[1]))).collect())))
}

/// # Safety
/// `pairs` came from glam_pairs().
#[no_mangle]
pub unsafe extern "C" fn glam_free(pairs: *mut GlamPairs) {
    drop(Box::from_raw(pairs));
}

fn glam_blend(pairs: &GlamPairs, weight: f32, rows: &mut [f32], turn: impl Fn(Quat, Quat, f32) -> Quat) {
    for ((from, to), row) in pairs.0.iter().zip(rows.chunks_exact_mut(12)) {
        let scale = from.scale + (to.scale - from.scale) * weight;
        let basis = (Mat3A::from_quat(turn(from.rotation, to.rotation, weight)) * scale).transpose();
        let origin = from.position.lerp(to.position, weight);
        for (axis, column) in [basis.x_axis, basis.y_axis, basis.z_axis].into_iter().enumerate() {
            row[4 * axis..4 * axis + 4].copy_from_slice(&[column.x, column.y, column.z, origin[axis]]);
        }
    }
}

/// # Safety
/// `rows` has room for 12 floats a pair.
#[no_mangle]
pub unsafe extern "C" fn glam_slerp(pairs: *const GlamPairs, weight: f32, rows: *mut f32) {
    let pairs = &*pairs;
    glam_blend(pairs, weight, std::slice::from_raw_parts_mut(rows, 12 * pairs.0.len()), Quat::slerp);
}

/// # Safety
/// `rows` has room for 12 floats a pair.
#[no_mangle]
pub unsafe extern "C" fn glam_nlerp(pairs: *const GlamPairs, weight: f32, rows: *mut f32) {
    let pairs = &*pairs;
    glam_blend(pairs, weight, std::slice::from_raw_parts_mut(rows, 12 * pairs.0.len()), Quat::lerp);
}

struct WidePose {
    position: Vec3x8,
    rotation: Rotor3x8,
    scale: f32x8,
}

pub struct UltravioletPairs(Vec<(WidePose, WidePose)>);

fn wide_pose(poses: &[Pose], end: usize) -> WidePose {
    let lanes = |f: &dyn Fn(&Pose) -> f32| {
        let mut values = [0.0; 8];
        for lane in 0..8 {
            values[lane] = f(&poses[(2 * lane + end).min(poses.len() - 2 + end)]);
        }
        f32x8::from(values)
    };
    // The short way round is chosen here, once.
    let sign = |lane: usize| {
        let (from, to) = (&poses[(2 * lane).min(poses.len() - 2)], &poses[(2 * lane + 1).min(poses.len() - 1)]);
        let cosine: f32 = from.rotation.iter().zip(to.rotation).map(|(a, b)| a * b).sum();
        if end == 1 && cosine < 0.0 { -1.0 } else { 1.0 }
    };
    let signs = f32x8::from(std::array::from_fn::<f32, 8, _>(sign));
    let mut rotation = Rotor3x8::identity();
    rotation.s = lanes(&|p| p.rotation[3]) * signs;
    rotation.bv.yz = -lanes(&|p| p.rotation[0]) * signs;
    rotation.bv.xz = lanes(&|p| p.rotation[1]) * signs;
    rotation.bv.xy = -lanes(&|p| p.rotation[2]) * signs;
    WidePose {
        position: Vec3x8::new(lanes(&|p| p.position[0]), lanes(&|p| p.position[1]), lanes(&|p| p.position[2])),
        rotation,
        scale: lanes(&|p| p.scale),
    }
}

/// # Safety
/// `poses` are 2 `count` poses.
#[no_mangle]
pub unsafe extern "C" fn ultraviolet_pairs(poses: *const Pose, count: usize) -> *mut UltravioletPairs {
    let poses = std::slice::from_raw_parts(poses, 2 * count);
    Box::into_raw(Box::new(UltravioletPairs(poses.chunks(16).map(|block| (wide_pose(block, 0), wide_pose(block, 1))).collect())))
}

/// # Safety
/// `pairs` came from ultraviolet_pairs().
#[no_mangle]
pub unsafe extern "C" fn ultraviolet_free(pairs: *mut UltravioletPairs) {
    drop(Box::from_raw(pairs));
}

/// # Safety
/// `rows` has room for 96 floats a block of 8 pairs.
#[no_mangle]
pub unsafe extern "C" fn ultraviolet_nlerp(pairs: *const UltravioletPairs, weight: f32, rows: *mut f32) {
    let pairs = &*pairs;
    let rows = std::slice::from_raw_parts_mut(rows, 96 * pairs.0.len());
    let a = f32x8::splat(weight);
    let rest = f32x8::splat(1.0 - weight);
    for ((from, to), block) in pairs.0.iter().zip(rows.chunks_exact_mut(96)) {
        let rotation = (from.rotation * rest + to.rotation * a).normalized();
        let scale = from.scale * rest + to.scale * a;
        let origin = from.position * rest + to.position * a;
        let basis = rotation.into_matrix();
        let columns = [basis.cols[0] * scale, basis.cols[1] * scale, basis.cols[2] * scale, origin];
        for (column, vector) in columns.iter().enumerate() {
            for (axis, values) in [vector.x, vector.y, vector.z].into_iter().enumerate() {
                for (lane, value) in values.to_array().into_iter().enumerate() {
                    block[12 * lane + 4 * axis + column] = value;
                }
            }
        }
    }
}
