//! Signs that boards share: a star for the true goal, a flash of lightning for a charger.

use super::svg::{Number, Svg};

/// A star of five points around a middle.
pub(super) fn star(svg: &mut Svg, [x, y]: [f64; 2], radius: f64, fill: &str, edge: &str) {
    // The ten corners of a star of radius 1, beginning at its top.
    const CORNERS: [[f64; 2]; 10] = [
        [0.0, -1.0],
        [0.24, -0.32],
        [0.95, -0.31],
        [0.38, 0.12],
        [0.59, 0.81],
        [0.0, 0.4],
        [-0.59, 0.81],
        [-0.38, 0.12],
        [-0.95, -0.31],
        [-0.24, -0.32],
    ];
    let corner = |[right, down]: [f64; 2]| {
        format!("{} {}", Number(x + radius * right), Number(y + radius * down))
    };
    svg.raw(format_args!(
        r#"<path d="M{}z" fill="{fill}" stroke="{edge}" stroke-width="0.8"/>"#,
        CORNERS.map(corner).join("L")
    ));
}

/// A flash of lightning, for the charger.
pub(super) fn bolt(svg: &mut Svg, [x, y]: [f64; 2], unit: f64, fill: &str, edge: &str) {
    let points = [(0.2, -1.0), (-0.6, 0.2), (-0.05, 0.2), (-0.2, 1.0), (0.6, -0.25), (0.05, -0.25)];
    let path: Vec<String> = points
        .iter()
        .map(|(right, down)| format!("{} {}", Number(x + unit * right), Number(y + unit * down)))
        .collect();
    svg.raw(format_args!(
        r#"<path d="M{}z" fill="{fill}" stroke="{edge}" stroke-width="1"/>"#,
        path.join("L")
    ));
}
