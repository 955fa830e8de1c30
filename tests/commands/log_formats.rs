//! Logs as programs write them, rows without an orientation, the last line, and mutated files.

use polhode::internals::log::{Change, Judgement, Request, Said, judge_text};
use polhode::model::Quantity;
use polhode::record::Ruling;

use crate::common::program::{code, polhode, scratch, stdout};
use crate::mutated_logs::{STILL, mutate, still};

/// cos ¼ and sin ¼: half a second of it.
const COSINE: &str = "0.9689124217106447";
const SINE: &str = "0.24740395925452294";

fn judged_as(log: &str, request: &Request) -> Judgement {
    let log = log.replace("COS", COSINE).replace("SIN", SINE);
    judge_text(&log, &still(), request).unwrap_or_else(|error| panic!("{error}\n{log}"))
}

fn judged(log: &str) -> Judgement {
    judged_as(log, &Request::default())
}

fn passes(judgement: &Judgement, quantity: Quantity) -> bool {
    // Digits of the logs: 1e-15; times in nanoseconds since 1970 are good to 1.3e-7 s.
    judgement.against(quantity, 1e-6).ruling == Ruling::Pass
}

fn said(columns: &str) -> Request {
    let said = Said { columns: Some(columns.parse().expect("columns")), ..Said::default() };
    Request { said, ..Request::default() }
}

#[test]
fn formats_of_many_programs_are_read() {
    let logs = [
        // TUM, with and without its comment.
        "# timestamp tx ty tz qx qy qz qw\n0 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 SIN COS\n",
        "0 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 SIN COS\n",
        // EuRoC, whose b_w is a bias.
        "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],b_w_RS_S_x [rad s^-1]\n\
         1403636580000000000,0,0,0,1,0,0,0,9\n1403636580500000000,0,0,0,COS,0,0,SIN,9\n",
        // AirSim.
        "VehicleName\tTimeStamp\tPOS_X\tPOS_Y\tPOS_Z\tQ_W\tQ_X\tQ_Y\tQ_Z\tImageFile\n\
         a\t1564567273000\t0\t0\t0\t1\t0\t0\t0\ta.png\na\t1564567273500\t0\t0\t0\tCOS\t0\t0\tSIN\tb.png\n",
        // 42: the scalar is the fourth.
        "time qbn1 qbn2 qbn3 qbn4 wbn1 wbn2 wbn3\n0 0 0 0 1 0 0 1\n0.5 0 0 SIN COS 0 0 1\n",
        "time,SC[0].B[0].qn[0],SC[0].B[0].qn[1],SC[0].B[0].qn[2],SC[0].B[0].qn[3],SC[0].B[0].wn[0],SC[0].B[0].wn[1],SC[0].B[0].wn[2]\n\
         0,0,0,0,1,0,0,1\n0.5,0,0,SIN,COS,0,0,1\n",
        // Basilisk: tan(θ/4).
        "time_ns,sigma_BN[0],sigma_BN[1],sigma_BN[2],omega_BN_B[0],omega_BN_B[1],omega_BN_B[2]\n\
         0,0,0,0,0,0,1\n500000000,0,0,0.12565513657513097,0,0,1\n",
        // The check cases of NASA.
        "time,eulerAngle_deg_Yaw,eulerAngle_deg_Pitch,eulerAngle_deg_Roll,bodyAngularRateWrtEi_deg_s_Roll,bodyAngularRateWrtEi_deg_s_Pitch,bodyAngularRateWrtEi_deg_s_Yaw,mach\n\
         0,0,0,0,0,0,57.29577951308232,0\n0.5,28.64788975654116,0,0,0,0,57.29577951308232,0\n",
        // MuJoCo, with decimal commas.
        "time;qpos_0;qpos_1;qpos_2;qpos_3;qpos_4;qpos_5;qpos_6;qvel_0;qvel_1;qvel_2;qvel_3;qvel_4;qvel_5\n\
         0;0;0;0;1;0;0;0;0;0;0;0;0;1\n0,5;0;0;0;0,9689124217106447;0;0;0,24740395925452294;0;0;0;0;0;1\n",
        // Its sensors, and lines that end as on Windows.
        "time,framequat_0,framequat_1,framequat_2,framequat_3,gyro_0,gyro_1,gyro_2\r\n0,1,0,0,0,0,0,1\r\n0.5,COS,0,0,SIN,0,0,1\r\n",
        // Drake.
        "time,box_qw,box_qx,box_qy,box_qz,box_x,box_y,box_z,box_wx,box_wy,box_wz,box_vx,box_vy,box_vz\n\
         0,1,0,0,0,0,0,0,0,0,1,0,0,0\n0.5,COS,0,0,SIN,0,0,0,0,0,1,0,0,0\n",
        "time,$world_body_qw,$world_body_qx,$world_body_qy,$world_body_qz,$world_body_x,$world_body_y,$world_body_z,body_wx,body_wy,body_wz\n\
         0,1,0,0,0,0,0,0,0,0,1\n0.5,COS,0,0,SIN,0,0,0,0,0,1\n",
        // ROS.
        "%time,field.pose.orientation.x,field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n\
         1564567273000000000,0,0,0,1\n1564567273500000000,0,0,SIN,COS\n",
        // Sensors of MuJoCo in world axes, its states by name, and places of its bodies.
        "time,framepos_x,framepos_y,framepos_z,framequat_w,framequat_x,framequat_y,framequat_z,frameangvel_x,frameangvel_y,frameangvel_z\n\
         0,0,0,0,1,0,0,0,0,0,1\n0.5,0,0,0,COS,0,0,SIN,0,0,1\n",
        "time,qpos_x,qpos_y,qpos_z,qpos_qw,qpos_qx,qpos_qy,qpos_qz,qvel_x,qvel_y,qvel_z,qvel_wx,qvel_wy,qvel_wz\n\
         0,0,0,0,1,0,0,0,0,0,0,0,0,1\n0.5,0,0,0,COS,0,0,SIN,0,0,0,0,0,1\n",
        "t,xpos_0,xpos_1,xpos_2,xquat_0,xquat_1,xquat_2,xquat_3\n0,0,0,0,1,0,0,0\n0.5,0,0,0,COS,0,0,SIN\n",
        // A body whose name is body, and separators at the end of lines.
        "time,body_qw,body_qx,body_qy,body_qz,body_wx,body_wy,body_wz,\n0,1,0,0,0,0,0,1,\n0.5,COS,0,0,SIN,0,0,1,\n",
        // A bag of ROS as a table: two columns more are parts of a time.
        "Time,header.stamp.secs,header.stamp.nsecs,pose.orientation.x,pose.orientation.y,pose.orientation.z,pose.orientation.w\n\
         1564567273.0,1564567273,0,0,0,0,1\n1564567273.5,1564567273,500000000,0,0,SIN,COS\n",
        // Two names of a time, of which one is the very name.
        "t,time,qw,qx,qy,qz\n0,7,1,0,0,0\n0.5,7.5,COS,0,0,SIN\n",
        // JSBSim: rates with a unit.
        "Time,Phi (deg),Theta (deg),Psi (deg),P (deg/s),Q (deg/s),R (deg/s)\n0,0,0,0,0,0,57.29577951308232\n\
         0.5,0,0,28.64788975654116,0,0,57.29577951308232\n",
        // Exponents of Fortran, and a time of a named body.
        "SC0_TIME qw qx qy qz\n0.0D+00 1.0D+00 0.0D+00 0.0D+00 0.0D+00\n5.0D-01 COS 0.0D+00 0.0D+00 SIN\n",
        // Units in a line of their own.
        "t;qw;qx;qy;qz;wx;wy;wz\r\nms;-;-;-;-;deg/s;deg/s;deg/s\r\n0;1;0;0;0;0;0;57,29577951308232\r\n500;COS;0;0;SIN;0;0;57,29577951308232\r\n",
        // Dates and times of day.
        "timestamp,qw,qx,qy,qz\n2024-05-01T12:00:00Z,1,0,0,0\n2024-05-01T12:00:00.5Z,COS,0,0,SIN\n",
        "time,qw,qx,qy,qz\n00:00:00,1,0,0,0\n00:00:00.500,COS,0,0,SIN\n",
        // Comments and rows out of order.
        "# a run\nt,qw,qx,qy,qz\n# half\n0.5,COS,0,0,SIN\n0,1,0,0,0\n",
    ];
    for log in logs {
        let judgement = judged(log);
        assert!(passes(&judgement, Quantity::Orientation), "{log}\n{judgement:?}");
        assert!(judgement.explanations.is_empty(), "{log}\n{:?}", judgement.explanations);
        let spins = judgement.findings.iter().find(|f| f.name == "angular-velocity").expect("a finding");
        assert!(
            spins.value.is_err() || passes(&judgement, Quantity::AngularVelocity),
            "{log}\n{judgement:?}"
        );
    }
}

/// Drake's columns are named after the body, and its angular velocities are in world axes.
#[test]
fn drake_names_columns_after_the_body() {
    let judgement = judged(
        "time,$world_body_qw,$world_body_qx,$world_body_qy,$world_body_qz,$world_body_x,$world_body_y,$world_body_z,body_wx,body_wy,body_wz\n\
         0,1,0,0,0,0,0,0,0,0,1\n0.5,COS,0,0,SIN,0,0,0,0,0,1\n",
    );
    assert!(passes(&judgement, Quantity::BodyPoint), "{judgement:?}");
    assert!(!judgement.declared.spin_in_body_axes);
}

#[test]
fn columns_units_and_sequences_can_be_said() {
    let list = judged_as("0 9 1 0 0 0\n0.5 9 COS 0 0 SIN\n", &said("t,-,qw,qx,qy,qz"));
    let pairs = judged_as("a,b,c,d,e\n0,1,0,0,0\n0.5,COS,0,0,SIN\n", &said("t=a,qw=b,qx=c,qy=4,qz=e"));
    let mut request = said("t=a,roll=b,pitch=c,yaw=d");
    request.said.time_unit = Some(polhode::internals::log::TimeUnit::Milliseconds);
    request.said.angle_unit = Some(polhode::internals::log::AngleUnit::Degrees);
    request.said.sequence = Some("xyz".parse().expect("a sequence"));
    let angles = judged_as("a,b,c,d\n0,0,0,0\n500,0,0,28.64788975654116\n", &request);
    for judgement in [list, pairs, angles] {
        assert!(passes(&judgement, Quantity::Orientation), "{judgement:?}");
    }
    assert!("t,qx=3".parse::<polhode::internals::log::Columns>().is_err());
    assert!("t,spin".parse::<polhode::internals::log::Columns>().is_err());
    for log in ["a,b\n1,2\n", "1,2,3\n4,5,6\n", "t,x_a,x_b\n1,2,3\n"] {
        let error = judge_text(log, &still(), &Request::default()).expect_err("no trajectory").to_string();
        assert!(error.contains("--columns"), "{error}");
    }
}

/// The option that a refusal ends in reads the file.
#[test]
fn a_line_that_is_offered_works_when_it_is_pasted() {
    let long = "n".repeat(60);
    for log in [
        // 42 writes no header.
        "0 0 0 0 1 0 0 1\n0.5 0 0 SIN COS 0 0 1\n".to_owned(),
        "0 0 0 0 1 0 0 0 0 0 0 0 0 1\n0.5 0 0 0 COS 0 0 SIN 0 0 0 0 0 1\n".to_owned(),
        // A state of Drake without names.
        "time,state[0],state[1],state[2],state[3],state[4]\n0,1,0,0,0,9\n0.5,COS,0,0,SIN,9\n".to_owned(),
        // Two bodies.
        "#timestamp [us],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],q_CS_w [],q_CS_x [],q_CS_y [],q_CS_z []\n\
         0,1,0,0,0,0,1,0,0\n500000,COS,0,0,SIN,0,1,0,0\n"
            .to_owned(),
        format!("t,{long}1,{long}2,{long}3,{long}4\n0,1,0,0,0\n0.5,COS,0,0,SIN\n"),
    ] {
        let text = log.replace("COS", COSINE).replace("SIN", SINE);
        let error = judge_text(&text, &still(), &Request::default()).expect_err("a refusal").to_string();
        let (_, option) = error.rsplit_once("--columns ").expect("an option");
        let judgement = judged_as(&log, &said(option.trim_matches('\'')));
        assert!(passes(&judgement, Quantity::Orientation), "{error}\n{judgement:?}");
    }
}

#[test]
fn columns_that_are_not_read_are_listed_where_a_quantity_is_missing() {
    let notes = |log: &str| judged(log).notes;
    let unread = notes("t,attitude_a,wx,wy,wz\n0,1,0,0,1\n1,1,0,0,1\n");
    assert!(unread.iter().any(|note| note.contains("attitude_a")), "{unread:?}");
    let whole = notes(
        "t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,other\n0,0,0,0,1,0,0,0,0,0,0,0,0,1,5\n0.5,0,0,0,COS,0,0,SIN,0,0,0,0,0,1,5\n",
    );
    assert!(!whole.iter().any(|note| note.contains("other")), "{whole:?}");
}

#[test]
fn bytes_that_are_no_log_are_refused_in_visible_letters() {
    let folder = scratch();
    let path = folder.path().join("log.csv");
    let log = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n";
    let utf16: Vec<u8> = [0xfeff].into_iter().chain(log.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    // The first 64 KiB are looked at for zero bytes.
    let late = format!("{}2,1,\0,0,0\n", log.to_owned() + &"2,1,0,0,0\n".repeat(10_000));
    let long = format!("{log}2,1,0,0,0{}", ",0".repeat(9 << 20));
    for (bytes, line) in [
        (utf16, 1),
        (log.replace('\n', "\r").into_bytes(), 1),
        (log.replace("0,1,", "0,\u{1b}[31m,").into_bytes(), 2),
        (late.into_bytes(), 10_004),
        (long.into_bytes(), 4),
    ] {
        std::fs::write(&path, &bytes).expect("written");
        let output = polhode(&["judge", &path.to_string_lossy(), "--scene", "free-rod"]);
        let said = String::from_utf8(output.stderr.clone()).expect("text");
        assert_eq!(code(&output), 65, "{said}");
        assert!(said.contains(&format!("log.csv:{line}:")), "{said}");
        assert!(said.len() < 1000 && !said.trim_end().contains(char::is_control), "{said:?}");
    }
}

#[test]
fn a_row_without_an_orientation_never_passes() {
    let (turned, none) = ("2,0.5403023058681398,0,0,0.8414709848078965\n", "0,0,0,0\n");
    let between =
        judged(&format!("t,qw,qx,qy,qz\n0,1,0,0,0\n1,{none}{turned}")).against(Quantity::Orientation, 1e-9);
    assert_eq!((between.ruling, between.rows), (Ruling::Pass, (2, 3)));
    for log in [
        format!("t,qw,qx,qy,qz\n0,1,0,0,0\n1,COS,0,0,SIN\n2,{none}"),
        "t,qw,qx,qy,qz\n0,1,0,0,0\n1,nan,0,0,0\n".to_owned(),
        format!("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,{none}"),
        format!(
            "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,{none}1.5,0,0,0,{none}2,0,0,0,0.5403023058681398,0,0,0.8414709848078965\n1.8,0,0,0,{none}"
        ),
    ] {
        let verdict = judged(&log).against(Quantity::Orientation, 10.0);
        assert_eq!(verdict.ruling, Ruling::Inconclusive, "{log}: {verdict:?}");
    }
}

#[test]
fn known_cases_are_named() {
    let changes = |log: &str| judged(log).explanations.iter().map(|e| e.change).collect::<Vec<_>>();
    assert_eq!(
        changes("t,wx,wy,wz\n0,0,0,1\n0.5,0,0,1\n1.0,0,0,0.9\n1.5,0,0,0.9\n2.0,0,0,0.9\n"),
        [Change::Clipped]
    );
    let turned = "t,qw,qx,qy,qz,wx,wy,wz\n0,0,1,0,0,0,0,1\n0.5,0,COS,SIN,0,0,0,1\n\
                  1.0,0,0.8775825618903728,0.479425538604203,0,0,0,1\n1.5,0,0.7316888688738209,0.6816387600233341,0,0,0,1\n";
    assert_eq!(changes(turned), [Change::BodyAxes, Change::Start]);
    let from_log = judged_as(turned, &Request { from_log: Some(1), ..Request::default() });
    assert!(passes(&from_log, Quantity::Orientation) && from_log.explanations.is_empty());
    let epoch =
        judged("t,qw,qx,qy,qz,wx,wy,wz\n1564567273.0,1,0,0,0,0,0,1\n1564567273.5,COS,0,0,SIN,0,0,1\n");
    assert!(passes(&epoch, Quantity::Orientation) && epoch.explanations.is_empty());
}

#[test]
fn the_last_line_is_the_verdict() {
    let folder = scratch();
    let (log, scene) = (folder.path().join("log.csv"), folder.path().join("still.toml"));
    std::fs::write(&scene, STILL).expect("written");
    std::fs::write(&log, format!("t,qw,qx,qy,qz\n0,1,0,0,0\n0.5,{COSINE},0,0,0.2474\n")).expect("written");
    let (log, scene) = (log.to_string_lossy(), scene.to_string_lossy());
    for (limit, word, exit) in [("1e-3", "PASS", 0), ("1e-6", "FAIL", 1)] {
        let output =
            polhode(&["judge", &log, "--scene", &scene, "--tolerance", limit, "--quantity", "orientation"]);
        let all = stdout(&output);
        let words: Vec<&str> = all.lines().last().expect("a line").split_whitespace().collect();
        assert_eq!((words[0], code(&output)), (word, exit), "{all}");
        assert!(words.contains(&limit) && words.contains(&"0.5"), "{all}");
    }
}

#[test]
fn mutated_logs_are_read_or_refused() {
    // 912 measured.
    let refused = mutate(1000);
    assert!((500..1000).contains(&refused), "{refused}");
}

#[test]
fn long_fields_and_lines_are_refused_in_few_words() {
    let long = "9".repeat(1 << 20);
    let name = "n".repeat(1 << 20);
    for log in [
        format!("t,x,y,z\n0,0,0,{name}\n"),
        format!("{name},x,y,z\n0,0,0,0\n"),
        format!("t,{name}\n0,0\n"),
        ",".repeat(1 << 20),
        format!("{}\n{}\n", "t,".repeat(1 << 18), "0,".repeat(1 << 18)),
    ] {
        let error = judge_text(&log, &still(), &Request::default()).expect_err("no trajectory");
        assert!(error.to_string().len() < 4000);
    }
    // Digits without end are a number, if an infinite one: the row has no position.
    assert!(judge_text(&format!("t,x,y,z\n0,0,0,{long}\n1,0,0,0\n"), &still(), &Request::default()).is_ok());
}
