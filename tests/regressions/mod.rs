//! One file for each bug found.

mod approximate_beliefs_close_exact_ones;
mod last_horizon_taken_for_a_proof;
mod limits_moved_with_slices;
mod longer_of_two_best_pairs;
mod proved_without_a_reason;
mod remedies_counted_work_again;
mod start_again_after_one_step;
