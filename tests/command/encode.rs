//! `mo-copp encode`

use crate::{EXPLICIT, GRID, mo_copp};

#[test]
fn both_encodings_print_a_program() {
    for (encoding, row) in [("paper", "c17_1:"), ("belief-flow", "tie_1_0_0:")] {
        let ran = mo_copp(EXPLICIT, &["encode", "-", "--encoding", encoding, "--horizon", "1"]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        for part in ["Maximize\n", "Subject To\n", "Bounds\n", "Binaries\n", "End\n", row] {
            assert!(ran.out.contains(part), "{encoding}: no {part} in\n{}", ran.out);
        }
    }
}

#[test]
fn no_plan_of_that_length_is_said() {
    let ran = mo_copp(GRID, &["encode", "-", "--horizon", "13"]);
    assert_eq!(ran.code, 1);
    assert!(ran.out.starts_with("\\ infeasible: there is no such plan of 13 actions\nMaximize\n"));
    assert!(ran.out.ends_with("End\n"), "a program that no solver can solve");
    assert!(ran.err.contains("no such plan of 13 actions"), "{}", ran.err);
}
