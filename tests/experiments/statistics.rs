//! Means, deviations and the analysis of variance against values of SciPy 1.17.1 and NumPy 2.4.6
//! (`scipy.stats.f_oneway`, `numpy.mean`, `numpy.std(…, ddof=1)`, `numpy.median`).

use mo_copp::experiment::statistics::{Anova, Spread};

fn near(found: f64, expected: f64) {
    let scale = expected.abs().max(1e-300);
    assert!((found - expected).abs() <= 1e-10 * scale, "found {found}, expected {expected}");
}

#[test]
fn analyses_of_variance_are_those_of_scipy() {
    type Case<'a> = (&'a [&'a [f64]], (usize, usize), f64, f64);
    let cases: [Case<'_>; 5] = [
        (
            &[
                &[6.0, 8.0, 4.0, 5.0, 3.0, 4.0],
                &[8.0, 12.0, 9.0, 11.0, 6.0, 8.0],
                &[13.0, 9.0, 11.0, 8.0, 7.0, 12.0],
            ],
            (2, 15),
            9.264_705_882_352_942,
            0.002_398_777_329_392_908_3,
        ),
        (
            &[&[0.5, 0.5, 1.0, 0.5, 0.0], &[1.0, 1.0, 1.0, 0.5], &[0.0, -0.5, 0.0, 0.0, 0.5, 0.0]],
            (2, 12),
            9.663_157_894_736_84,
            0.003_159_595_937_664_963,
        ),
        (
            &[&[4.0, 4.0, 6.0], &[12.0, 12.0, 12.0, 14.0], &[5.0, 5.0]],
            (2, 6),
            69.823_529_411_764_82,
            6.991_149_580_195_378e-5,
        ),
        (
            &[
                &[12.0, 12.0, 12.0, 14.0, 12.0, 13.0, 12.0, 12.0, 13.0, 14.0],
                &[5.0, 7.0, 6.0, 9.0, 4.0, 3.0, 8.0, 7.0, 10.0, 5.0],
                &[5.0, 6.0, 6.0, 8.0, 4.0, 3.0, 7.0, 7.0, 9.0, 5.0],
            ],
            (2, 27),
            45.757_425_742_574_284,
            2.125_584_290_696_741e-9,
        ),
        (
            &[
                &[0.0001, 0.0002, 0.00015, 0.0003],
                &[0.02, 0.05, 0.031, 0.04],
                &[0.0005, 0.0009, 0.0004, 0.0011],
            ],
            (2, 9),
            29.586_396_083_277_506,
            0.000_110_367_555_645_057_89,
        ),
    ];
    for (groups, degrees, f, p) in cases {
        let anova = Anova::of(groups).unwrap();
        assert_eq!((anova.between, anova.within), degrees);
        near(anova.f.unwrap(), f);
        near(anova.p, p);
    }
}

#[test]
fn where_there_is_nothing_to_analyse_it_says_so() {
    assert_eq!(Anova::of(&[&[1.0, 2.0]]), None, "one group");
    assert_eq!(Anova::of(&[&[1.0, 2.0], &[]]), None, "an empty group");
    assert_eq!(Anova::of(&[&[1.0], &[2.0]]), None, "no spread to compare with");
    assert_eq!(Anova::of(&[&[2.0, 2.0], &[2.0, 2.0]]), None, "all values equal");
    let apart = Anova::of(&[&[1.0, 1.0], &[2.0, 2.0]]).unwrap();
    assert_eq!((apart.f, apart.p), (None, 0.0), "no spread within, some between");
    let together = Anova::of(&[&[1.0, 3.0], &[0.0, 4.0]]).unwrap();
    assert_eq!((together.f, together.p), (Some(0.0), 1.0), "equal means");
}

#[test]
fn spreads_are_those_of_numpy() {
    for (numbers, mean, sd, median) in [
        (&[1.5, 2.25, -3.0, 8.125][..], 2.21875, 4.569_344_181_608_56, 1.875),
        (&[0.5, 0.5, 1.0, 0.5, 0.0], 0.5, 0.353_553_390_593_273_8, 0.5),
        (&[1.0, 1.0, 1.0, 0.5], 0.875, 0.25, 1.0),
        (
            &[1e9 + 1.0, 1e9 + 2.0, 1e9 + 4.0, 1e9 + 7.0],
            1e9 + 3.5,
            2.645_751_311_064_590_7,
            1e9 + 3.0,
        ),
    ] {
        let spread = Spread::of(numbers).unwrap();
        assert_eq!(spread.n, numbers.len());
        near(spread.mean, mean);
        near(spread.sd.unwrap(), sd);
        near(spread.median, median);
        let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert_eq!((spread.least, spread.greatest), (least, greatest));
    }
    assert_eq!(Spread::of(&[]), None);
    let one = Spread::of(&[3.0]).unwrap();
    assert_eq!((one.mean, one.sd), (3.0, None));
}
