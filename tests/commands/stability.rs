//! `polhode stability` from outside.

use polhode::internals::study::stability::MAP_NAMES;
use polhode::record::stability::Stability;

use crate::common::program::{code, json, polhode, scratch, stderr, stdout};

#[test]
fn the_command_writes_records_a_page_and_pictures() {
    let folder = scratch();
    let out = folder.path().to_string_lossy();
    let scenes = ["--scene", "free-oblate", "--scene", "gravity-drag"];
    let sizes = ["--cells", "8", "--long", "2000", "--out", &out];
    let output =
        polhode(&[&["stability", "--quiet", "--scheme", "peskin-rk2"][..], &scenes, &sizes].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let table = stdout(&output);
    assert!(table.contains("free-oblate") && table.contains("h·ω"), "{table}");
    let study = Stability::read(&folder.path().join("stability.json")).expect("a study");
    assert!(study.complete && study.limits.len() == 6 && study.maps.len() == MAP_NAMES.len());
    for map in &study.maps {
        assert_eq!((map.values.len(), map.values[0].len()), (8, 8), "{}", map.name);
        let picture = folder.path().join("maps").join(format!("{}-peskin-rk2.png", map.name));
        assert!(picture.is_file(), "{}", picture.display());
    }
    let only = ["free-oblate", "--scheme", "euler", "--cells", "0", "--long", "0", "--format", "json"];
    let folder_of_one = scratch();
    let out = folder_of_one.path().to_string_lossy();
    let printed = json(&polhode(&[&["stability", "--quiet", "--out", &out][..], &only].concat()));
    let written = Stability::read(&folder_of_one.path().join("stability.json")).expect("a study");
    assert_eq!(printed["limits"].as_array().map(Vec::len), Some(written.limits.len()));
    for file in ["stability.md", "limits.png", "long-runs.png", "energy-law.png"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}
