//! Tables, figures and `results.json`.

use std::collections::BTreeMap;

use mo_copp::experiment::output::{
    anova_csv, figures, markdown, records_csv, relative_csv, summary_csv, write,
};
use mo_copp::experiment::records::{Entries, Entry};
use mo_copp::experiment::series::SeriesRecord;
use mo_copp::experiment::{Asked, Record, Setting, Summary, Survivors, Work};

use super::{fig3, fig4, folder};

/// A record made by hand: status, goals left to enemy and friend of five, length, seconds.
type Line = (&'static str, Option<(usize, usize, usize)>, f64);

fn entries(setting: &Setting, lines: &[(&str, Vec<Line>)]) -> Entries {
    let lines: BTreeMap<&str, &Vec<Line>> = lines.iter().map(|(name, l)| (*name, l)).collect();
    let entry = |job: &mo_copp::experiment::Job| {
        let (status, plan, seconds) = lines[job.configuration.name()][job.problem as usize - 1];
        let names = |n: usize| (1..=n).map(|goal| format!("G{goal}")).collect::<Vec<_>>();
        let asked = serde_json::from_str::<Asked>("{}").unwrap();
        let record = Record {
            domain: job.domain.domain.name().to_owned(),
            problem: job.problem,
            seed: setting.seed_of(job.problem),
            redraws: job.problem,
            candidates: 5,
            solver: job.configuration.name().to_owned(),
            options: asked,
            status: status.to_owned(),
            limit: None,
            horizon: None,
            length: plan.map(|(_, _, length)| length),
            goal_difference: plan.map(|(x, c, _)| (x as f64 - c as f64) / 4.0),
            bound: None,
            goals: plan.map(|(x, c, _)| Survivors { adversarial: names(x), cooperative: names(c) }),
            plan: plan.map(|(_, _, length)| vec!["go".to_owned(); length]),
            work: Work::default(),
            seconds,
        };
        (job.place, Entry { line: record.line(), record, number: 0 })
    };
    setting.jobs().iter().map(entry).collect()
}

/// Figure 4 with three problems. Search: GD 0.5, 0.25, none; obfuscation: 0, −0.25, 0.5;
/// legibility: 0.25, none, none; the portfolio: 0.5 each.
fn by_hand() -> (Setting, Entries) {
    let setting = fig4(3);
    let solved = |x, c, length, seconds| ("solved", Some((x, c, length)), seconds);
    let entries = entries(
        &setting,
        &[
            (
                "search",
                vec![solved(4, 2, 4, 0.25), solved(3, 2, 6, 0.5), ("infeasible", None, 1.5)],
            ),
            ("obfuscate", vec![solved(5, 5, 3, 0.5), solved(4, 5, 5, 1.0), solved(3, 1, 7, 1.5)]),
            (
                "legible",
                vec![solved(2, 1, 2, 0.5), ("limit", None, 9.0), ("infeasible", None, 2.0)],
            ),
            ("satisficing", vec![solved(4, 2, 4, 0.25); 3]),
            (
                "exact-up-to",
                vec![
                    ("optimal", Some((5, 1, 8)), 4.0),
                    ("feasible", Some((4, 2, 8)), 4.0),
                    ("optimal", Some((3, 1, 9)), 4.0),
                ],
            ),
            (
                "exact-any",
                vec![
                    ("optimal", Some((5, 1, 8)), 0.04),
                    ("optimal", Some((5, 1, 12)), 0.04),
                    ("limit", None, 9.0),
                ],
            ),
        ],
    );
    (setting, entries)
}

#[test]
fn a_summary_is_what_a_hand_computes() {
    let (setting, entries) = by_hand();
    let summary = Summary::new(&setting, &entries);
    let domain = &summary.domains[0];
    assert_eq!((domain.problems, domain.redraws), (3, 1 + 2 + 3));
    let search = &domain.solvers[0];
    assert_eq!((search.statuses.solved, search.statuses.infeasible), (2, 1));
    let difference = search.goal_difference.unwrap();
    // The deviation of 1/2 and 1/4 is 1/4 over the root of 2.
    assert_eq!((difference.n, difference.mean), (2, 0.375));
    assert!((difference.sd.unwrap() - 0.25 / 2_f64.sqrt()).abs() < 1e-12);
    // The proof that there is no plan is an answer: (0.25 + 0.5 + 1.5) / 3.
    assert_eq!((search.seconds.unwrap().n, search.seconds.unwrap().mean), (3, 0.75));
    let legible = &domain.solvers[2];
    assert_eq!((legible.statuses.limit, legible.seconds.unwrap().n), (1, 2));
    assert_eq!(legible.goal_difference.unwrap().sd, None);
    // Relative to the search where both have a plan.
    let [obfuscate, legible] = &domain.relative[..] else { panic!("two lines") };
    assert_eq!((obfuscate.n, obfuscate.mean, obfuscate.search), (2, -0.125, 0.375));
    assert!((obfuscate.percent.unwrap() + 100.0 / 3.0).abs() < 1e-9);
    // The deviation of 0 and −1/4 over 3/8.
    let deviation = 100.0 * (0.25 / 2_f64.sqrt()) / 0.375;
    assert!((obfuscate.percent_sd.unwrap() - deviation).abs() < 1e-9);
    assert_eq!((legible.n, legible.mean, legible.search), (1, 0.25, 0.5));
    assert_eq!(legible.percent, Some(50.0));
    // scipy.stats.f_oneway([0.5, 0.25], [0, -0.25, 0.5], [0.25]) of SciPy 1.17.1.
    let anova = domain.anova[0].anova.unwrap();
    assert_eq!((anova.between, anova.within), (2, 3));
    assert!((anova.f.unwrap() - F).abs() < 1e-9 && (anova.p - P).abs() < 1e-9, "{anova:?}");
    assert_eq!(domain.anova[0].groups, ["search", "obfuscate", "legible"]);
}

const F: f64 = 0.483_870_967_741_935_5;
const P: f64 = 0.657_456_094_668_95;

#[test]
fn tables_for_people() {
    let (setting, entries) = by_hand();
    let text = markdown(&Summary::new(&setting, &entries));
    assert_eq!(text, include_str!("by-hand.md"));
}

#[test]
fn tables_for_programs() {
    let (setting, entries) = by_hand();
    let summary = Summary::new(&setting, &entries);
    let csv = summary_csv(&summary);
    let mut lines = csv.lines();
    assert_eq!(
        lines.next().unwrap(),
        "domain,solver,problems,optimal,solved,feasible,infeasible,limit,goal_difference_n,\
         goal_difference_mean,goal_difference_sd,goal_difference_median,goal_difference_least,\
         goal_difference_greatest,length_n,length_mean,length_sd,length_median,length_least,\
         length_greatest,seconds_n,seconds_mean,seconds_sd,seconds_median,seconds_least,\
         seconds_greatest"
    );
    assert!(lines.next().unwrap().starts_with("delivery,search,3,0,2,0,1,0,2,0.375,0.17677669529"));
    let legible = lines.nth(1).unwrap();
    assert!(
        legible.starts_with("delivery,legible,3,0,1,0,1,1,1,0.25,,0.25,0.25,0.25,1,2,,2,2,2,2,")
    );
    let anova = anova_csv(&summary);
    assert_eq!(anova.lines().count(), 4);
    let line = anova.lines().nth(1).unwrap();
    assert!(line.starts_with("delivery,goal_difference,search obfuscate legible,2,3,0.48387"));
    let relative = relative_csv(&summary);
    assert!(relative.ends_with("delivery,legible,1,0.25,0.5,50,\n"), "{relative}");
    let records = records_csv(&entries);
    assert_eq!(records.lines().count(), 1 + 18);
    assert_eq!(
        records.lines().nth(1).unwrap(),
        "delivery,1,1,1,search,solved,,4,0.5,4,2,5,0,0,0.25"
    );
    assert_eq!(records.lines().nth(9).unwrap(), "delivery,2,2,2,legible,limit,,,,,,5,0,0,9");
}

/// Everything of an SVG that stands between `from` and `to`.
fn between<'a>(svg: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    svg.split(from).skip(1).filter_map(|rest| Some(rest.split_once(to)?.0)).collect()
}

#[test]
fn figures_have_titles_axes_legends_and_a_dark_scheme() {
    let (setting, entries) = by_hand();
    let drawn = figures(&Summary::new(&setting, &entries)).unwrap();
    let names: Vec<&str> = drawn.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        ["fig4-goal-difference.svg", "fig4-length.svg", "fig4-seconds.svg", "fig4-relative.svg"]
    );
    for ((name, svg), (title, axis)) in drawn.iter().zip([
        ("Goal difference: mean and standard deviation", "goal difference"),
        ("Plan length: mean and standard deviation", "actions"),
        ("Run time: mean and standard deviation", "seconds (logarithmic)"),
        ("Goal difference relative to the search's", "per cent"),
    ]) {
        assert!(svg.contains(&format!("<title>{title}</title>")), "{name}");
        assert!(svg.contains("role=\"img\"") && svg.contains("prefers-color-scheme:dark"));
        let svg = &svg.replace("&apos;", "'");
        let texts: Vec<&str> = between(svg, "<text ", "</text>")
            .iter()
            .map(|t| t.split_once('>').unwrap().1.trim())
            .collect();
        for text in [title, axis, "Delivery", "obfuscation alone", "legibility alone"] {
            assert!(texts.contains(&text), "{name}: no {text} in {texts:?}");
        }
        // Nothing is drawn outside of the picture.
        for x in between(svg, " x=\"", "\"") {
            assert!((0..=720).contains(&x.parse::<i32>().unwrap()), "{name}: x={x}");
        }
    }
    // Heights are in proportion: GD 0.375 of the search, 1/12 of obfuscation.
    let svg = &drawn[0].1;
    let heights: Vec<f64> = between(svg, "<rect ", "/>")
        .iter()
        .filter(|rect| !rect.contains("#FFFFFE") && !rect.contains("width=\"12\""))
        .map(|rect| between(rect, "height=\"", "\"")[0].parse().unwrap())
        .collect();
    // Neither row of the exact solver is proved on all problems.
    assert_eq!(heights.len(), 3);
    assert!((heights[0] / heights[1] - 0.375 * 12.0).abs() < 0.5, "{heights:?}");
    let description = between(svg, "<desc>", "</desc>")[0];
    assert!(description.starts_with("Delivery, search: 0.375 ± 0.177; "), "{description}");
}

#[test]
fn a_run_of_one_problem_and_one_without_any_plan_can_be_drawn() {
    let none = ("limit", None, 1.0);
    let setting = fig4(1);
    let names = ["search", "obfuscate", "legible", "satisficing", "exact-up-to", "exact-any"];
    let entries = entries(&setting, &names.map(|name| (name, vec![none])));
    let summary = Summary::new(&setting, &entries);
    assert!(summary.domains[0].relative.is_empty());
    assert!(figures(&summary).unwrap().iter().all(|(_, svg)| svg.ends_with("</svg>\n")));
    let text = markdown(&summary);
    assert!(text.contains("| Delivery | search | – | – | – | 1 limit |"), "{text}");
    assert!(text.contains("| Delivery | goal difference | – | – |"), "{text}");
}

#[test]
fn everything_is_written_into_the_folder() {
    let setting = fig3(2);
    let folder = folder("written");
    let path = folder.join("records.jsonl");
    super::work(&path, &setting, mo_copp::experiment::Shard::WHOLE, 2);
    let file = super::open(&path, &setting, mo_copp::experiment::Shard::WHOLE).unwrap();
    let summary = Summary::new(&setting, file.entries());
    let files = write(&folder, &summary, file.entries()).unwrap();
    for name in [
        "results.json",
        "tables.md",
        "summary.csv",
        "anova.csv",
        "records.csv",
        "fig3-goal-difference.svg",
        "fig3-length.svg",
        "fig3-seconds.svg",
    ] {
        assert!(files.contains(&folder.join(name)), "{name}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), files.len() + 1, "and the records");
    let text = std::fs::read_to_string(folder.join("results.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&json["experiment"], &json["problems"]), (&"fig3".into(), &2.into()));
    let solvers = json["domains"][0]["solvers"].as_array().unwrap();
    assert_eq!(solvers.len(), 6);
    let exact = &solvers[4];
    assert_eq!((&exact["solver"], &exact["statuses"]["optimal"]), (&"exact".into(), &2.into()));
    assert_eq!(exact["goal_difference"]["n"], 2);
    // A folder that is none.
    let error = write(&path, &summary, file.entries()).unwrap_err().to_string();
    assert!(error.contains("records.jsonl"), "{error}");
}
